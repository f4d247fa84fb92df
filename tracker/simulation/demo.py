"""What the demo simulates, in a form that can be handed to another process."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import NamedTuple

import numpy as np

from tracker.glove.files import parse_glove
from tracker.glove.model import GloveModel
from tracker.hand.files import parse_hand
from tracker.hand.model import HandModel
from tracker.messages import CameraPose
from tracker.simulation.asked import Asked, AskedMotion
from tracker.simulation.desk.renderer import DeskParams
from tracker.simulation.motion import Motion
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.rooms import room_of
from tracker.simulation.scenario import Simulation, SimulationParams
from tracker.simulation.shows import WORD
from tracker.simulation.two_hands import Dressed, TwoHandsSimulation
from tracker.simulation.wearer import Wearer
from tracker.vision.lenses import with_one_camera
from tracker.vision.rig import StereoRig, default_pose, ideal_rig


class WornTexts(NamedTuple):
    """Of the hand's and the glove's file."""

    hand: str
    glove: str


TABLE = 0.75
"""m: height of a table, where the origin lies on the floor, as OpenXR's stage has it."""
BACKGROUNDS = 6  # of a desk, drawn once: half the time an image takes goes into what does not move


@dataclass(frozen=True)
class DemoSpec:
    """Texts of the hand's and the glove's file; ``motion`` a recording, ``show:`` and the name of
    an application that is used again and again, or empty.

    With a glove of the other side in ``others``, two hands meet before a plain wall.
    """

    hand_text: str
    glove_text: str
    seed: int = 1
    duration: float = 3600.0
    fps: float = 30.0
    motion: str = ""
    exposures: int = 1  # per image: no motion blur, half the time to draw
    light: str = ""  # over a desk with things on it; before a plain wall if empty
    others: tuple[WornTexts, ...] = ()
    one_camera: bool = False  # of two: the left one alone
    right_late: float = 0.0  # s that the right camera exposes after the left one
    table: float = 0.0  # m from the origin up to the table that the camera stands on

    @property
    def worn(self) -> tuple[WornTexts, ...]:
        """The texts of all hands, the main one's first."""
        return WornTexts(self.hand_text, self.glove_text), *self.others

    @property
    def rig(self) -> StereoRig:
        """What looks at the scene."""
        stand = default_pose()
        camera = CameraPose(stand.R_GC, stand.p_GC + np.array([0.0, 0.0, self.table]))
        rig = ideal_rig(pose=camera)
        return with_one_camera(rig) if self.one_camera else rig


def build(spec: DemoSpec) -> Simulation:
    """The simulation that a spec describes: the same in every process."""
    hand = parse_hand(spec.hand_text)
    glove = parse_glove(spec.glove_text, hand)
    if spec.motion:
        motion: Motion = _motion_of(spec, hand, glove)
    else:
        own = RandomPostures(hand, spec.seed, duration=spec.duration, camera=spec.rig.pose)
        motion = AskedMotion(own, spec.seed)
    room = room_of("desk" if spec.light else "plain", spec.light, seed=spec.seed)
    render = replace(room.render, exposures=spec.exposures)
    if isinstance(render, DeskParams):
        render = replace(render, backgrounds=BACKGROUNDS)
    params = SimulationParams(render=render, right_late=spec.right_late)
    return Simulation(
        hand, glove, motion, spec.seed, params, fps=spec.fps, rig=spec.rig, extras=room.extras
    )


def build_scene(spec: DemoSpec) -> Simulation | TwoHandsSimulation:
    """Everything that the camera sees."""
    if not spec.others:
        return build(spec)
    dressed = {}
    for texts in spec.worn:
        hand = parse_hand(texts.hand)
        dressed[hand.side] = Dressed(hand, parse_glove(texts.glove, hand))
    room = room_of("plain", "", seed=spec.seed)
    render = replace(room.render, exposures=spec.exposures)
    params = SimulationParams(render=render, right_late=spec.right_late)
    return TwoHandsSimulation(dressed, spec.seed, spec.duration, spec.fps, params, spec.rig)


def hands_of(scene: Simulation | TwoHandsSimulation) -> dict[str, Simulation]:
    """Each hand of a scene, by its side; of two the left one first."""
    return scene.hands if isinstance(scene, TwoHandsSimulation) else {scene.hand.side: scene}


def ask(simulation: Simulation | TwoHandsSimulation, asked: Asked) -> None:
    """Ask the wearer for a posture. Who plays a recording, or meets another, does not hear it."""
    if isinstance(simulation, Simulation) and isinstance(simulation.motion, AskedMotion):
        simulation.motion.ask(asked)


def asked_for(simulation: Simulation) -> tuple[Asked, ...]:
    """All that the wearer was asked for."""
    return simulation.motion.asked if isinstance(simulation.motion, AskedMotion) else ()


def _motion_of(spec: DemoSpec, hand: HandModel, glove: GloveModel) -> Motion:
    """Imported when asked for: what these need brings all of scipy, and the demo starts first."""
    from tracker.simulation.recorded.load import load_motion
    from tracker.simulation.scripted import show

    if spec.motion.startswith(WORD):
        wearer = Wearer.random(hand, glove, spec.seed)
        return AskedMotion(show(spec.motion, hand, wearer, spec.duration), spec.seed)
    return load_motion(Path(spec.motion), hand, spec.rig.pose)
