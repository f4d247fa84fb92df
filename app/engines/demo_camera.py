"""The demo's camera, a process that is started before the window is loaded.

The simulator is imported by the functions that need it: a window without a demo does not load it.
"""

from __future__ import annotations

import os
from dataclasses import dataclass
from typing import TYPE_CHECKING

from app.storage.own_gloves import SIMULATED, own_or
from tracker.base.registry import names_of
from tracker.glove import library
from tracker.simulation.shows import WORD

if TYPE_CHECKING:
    from tracker.simulation.camera_device import DemoCamera
    from tracker.simulation.demo import DemoSpec

DURATION = 900.0
"""s of motion; the hand then stays at rest."""
FILES = {
    "right": ("reference-right", "vist-small"),
    "left": ("reference-left", "vist-small-left"),
}
"""A hand's and a glove's file for each side."""
SEED, FPS = 1, 30.0
LIGHT = "led"  # over the desk, of `tracker.simulation.desk.lights.LIGHTS`
DESK_FPS, DESK_CORES = 30.0, 4
"""By default there is a desk up to this frame rate and from this number of cores on: it takes twice
as long to render as a wall, and on two cores half of 30 images per second were missing."""
OTHER_SCENES = tuple(names_of("scenes"))
"""For `tracker.simulation.rooms.KINDS`."""
SCENES = ("auto", "desk", "plain", *OTHER_SCENES)
HANDS = ("right", "left", "both")
LENSES = ("both", "one", "none")


@dataclass(frozen=True)
class DemoChoice:
    """Images per second of the simulated camera, the hands in view (of `HANDS`), the motion of one
    hand (see `DemoSpec.motion`), the lenses of the camera (of `LENSES`), the scene behind one hand
    (of `SCENES`), the errors of the camera (see `errors_named`), and whether the wearer moves each
    finger independently of the others in a pinch."""

    fps: float = FPS
    hands: str = "right"
    motion: str = ""
    lenses: str = "both"
    scene: str = "auto"
    camera_errors: str = "all"
    independent_fingers: bool = False

    def has_desk(self, cores: int) -> bool:
        """Whether the hand is over a desk; ``cores`` of this computer decide for "auto"."""
        if self.hands == "both" or self.scene != "auto":
            return self.hands != "both" and self.scene == "desk"
        return self.fps <= DESK_FPS and cores >= DESK_CORES

    @property
    def has_camera(self) -> bool:
        return self.lenses != "none"

    @property
    def uses_application(self) -> bool:
        """Whether the simulated wearer uses one of the applications."""
        return self.motion.startswith(WORD)


def demo_spec(seed: int = SEED, choice: DemoChoice | None = None) -> DemoSpec:
    """Returns the specification of the simulated wearers and the camera.

    Raises ConfigError for errors of the camera that do not exist.
    """
    # deferred: the simulator
    from tracker.simulation.camera_errors import errors_named
    from tracker.simulation.demo import TABLE, DemoSpec, HandTexts
    from tracker.simulation.two_hands import hand_seed

    choice = choice or DemoChoice()
    sides = ("right", "left") if choice.hands == "both" else (choice.hands,)
    seeds = {side: hand_seed(seed, side) if len(sides) > 1 else seed for side in sides}
    texts = [
        HandTexts(library.text("hands", hand), library.text("gloves", own_or(glove, mark)))
        for (hand, glove), mark in ((FILES[side], glove_mark(own)) for side, own in seeds.items())
    ]
    desk = choice.has_desk(os.cpu_count() or 1)
    return DemoSpec(
        *texts[0],
        seed,
        DURATION,
        choice.fps,
        choice.motion,
        light=LIGHT if desk else "",
        scene=choice.scene if choice.scene in OTHER_SCENES and choice.hands != "both" else "",
        others=tuple(texts[1:]),
        one_camera=choice.lenses != "both",
        camera_errors=errors_named(choice.camera_errors, choice.lenses != "both"),
        table=0.0 if choice.uses_application else TABLE,
        alone=choice.independent_fingers,
    )


def glove_mark(seed: int) -> str:
    """Mark of the simulated glove's own file: each seed has another glove."""
    return SIMULATED if seed == SEED else f"{SIMULATED}-{seed}"


def start_camera(seed: int = SEED, choice: DemoChoice | None = None, drawn: int = 0) -> DemoCamera:
    """Starts the process that renders images; the caller has to close it.

    ``drawn``: see `SimulatedCamera`.
    """
    from tracker.simulation.camera_device import (  # deferred: loads the simulator
        NoSimulatedCamera,
        SimulatedCamera,
    )

    choice = choice or DemoChoice()
    if not choice.has_camera:
        return NoSimulatedCamera()
    return SimulatedCamera(demo_spec(seed, choice), drawn=drawn)
