"""What the demo simulates, in a form that can be handed to another process."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

from tracker.glove.files import parse_glove
from tracker.hand.files import parse_hand
from tracker.hand.model import HandModel
from tracker.simulation.asked import Asked, AskedMotion
from tracker.simulation.desk.renderer import DeskParams
from tracker.simulation.motion import Motion
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.rooms import room_of
from tracker.simulation.scenario import Simulation, SimulationParams

BACKGROUNDS = 6  # of a desk, drawn once: half the time an image takes goes into what does not move


@dataclass(frozen=True)
class DemoSpec:
    """Texts of the hand's and the glove's file; ``motion`` a recording or empty."""

    hand_text: str
    glove_text: str
    seed: int = 1
    duration: float = 3600.0
    fps: float = 30.0
    motion: str = ""
    exposures: int = 1  # per image: no motion blur, half the time to draw
    light: str = ""  # over a desk with things on it; before a plain wall if empty


def build(spec: DemoSpec) -> Simulation:
    """The simulation that a spec describes: the same in every process."""
    hand = parse_hand(spec.hand_text)
    glove = parse_glove(spec.glove_text, hand)
    motion: Motion
    if spec.motion:
        motion = _recorded(Path(spec.motion), hand)
    else:
        own = RandomPostures(hand, spec.seed, duration=spec.duration)
        motion = AskedMotion(own, spec.seed)
    room = room_of("desk" if spec.light else "plain", spec.light, seed=spec.seed)
    render = replace(room.render, exposures=spec.exposures)
    if isinstance(render, DeskParams):
        render = replace(render, backgrounds=BACKGROUNDS)
    params = SimulationParams(render=render)
    return Simulation(hand, glove, motion, spec.seed, params, fps=spec.fps, extras=room.extras)


def ask(simulation: Simulation, asked: Asked) -> None:
    """Ask the wearer for a posture. One who plays a recording does not hear it."""
    if isinstance(simulation.motion, AskedMotion):
        simulation.motion.ask(asked)


def asked_for(simulation: Simulation) -> tuple[Asked, ...]:
    """All that the wearer was asked for."""
    return simulation.motion.asked if isinstance(simulation.motion, AskedMotion) else ()


def _recorded(path: Path, hand: HandModel) -> Motion:
    """Imported when asked for: its filters bring all of scipy.signal, and the demo starts first."""
    from tracker.simulation.recorded import load_motion

    return load_motion(path, hand)
