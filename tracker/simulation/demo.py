"""The specification of a demo, in a form that can be sent to another process."""

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
from tracker.simulation.camera_errors import WEBCAM, ZED, CameraErrors
from tracker.simulation.desk.renderer import DeskParams
from tracker.simulation.motion import SimulatedMotion
from tracker.simulation.posture_requests import PostureRequest, RequestedMotion
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.recorded.load import load_motion
from tracker.simulation.rooms import room_of
from tracker.simulation.scenario import Simulation, SimulationParams
from tracker.simulation.scripted import show
from tracker.simulation.shows import WORD
from tracker.simulation.two_hands import GlovedHand, TwoHandsSimulation
from tracker.simulation.wearer import Wearer
from tracker.vision.lenses import with_one_camera
from tracker.vision.rig import StereoRig, default_pose, ideal_rig


class HandTexts(NamedTuple):
    """The texts of the hand file and the glove file."""

    hand: str
    glove: str


TABLE = 0.75
"""m: height of a table if the origin is on the floor, as in OpenXR's stage space."""
BACKGROUNDS = 6  # of a desk, drawn once: half the time per image is spent on the background


@dataclass(frozen=True)
class DemoSpec:
    """Texts of the hand file and the glove file; ``motion`` is a recording, ``show:`` plus the name
    of an application that is used repeatedly, or empty.

    With a glove of the other side in ``others``, two hands meet in front of a plain wall.
    """

    hand_text: str
    glove_text: str
    seed: int = 1
    duration: float = 3600.0
    fps: float = 30.0
    motion: str = ""
    exposures: int = 1  # per image: no motion blur, half the drawing time
    light: str = ""  # of a desk with objects; a plain wall if empty
    scene: str = ""  # of `tracker.simulation.rooms.KINDS`, in place of both
    others: tuple[HandTexts, ...] = ()
    one_camera: bool = False  # only the left of two
    right_late: float = 0.0  # s by which the right camera exposes after the left one
    table: float = 0.0  # m from the origin to the top of the table with the camera
    camera_errors: CameraErrors | None = None  # a ZED's, or with one lens those of a webcam
    alone: bool = False  # the finger of a requested pinch bends, and no other

    @property
    def worn(self) -> tuple[HandTexts, ...]:
        """The texts of all hands, the main one's first."""
        return HandTexts(self.hand_text, self.glove_text), *self.others

    @property
    def rig(self) -> StereoRig:
        """The cameras of the scene."""
        stand = default_pose()
        camera = CameraPose(stand.R_GC, stand.p_GC + np.array([0.0, 0.0, self.table]))
        rig = ideal_rig(pose=camera)
        return self.errors_of_camera.rig(
            with_one_camera(rig) if self.one_camera else rig, self.seed
        )

    @property
    def errors_of_camera(self) -> CameraErrors:
        """``camera_errors``, or those of the usual camera."""
        return self.camera_errors or (WEBCAM if self.one_camera else ZED)


def build(spec: DemoSpec) -> Simulation:
    """The simulation described by a spec: the same in every process."""
    hand = parse_hand(spec.hand_text)
    glove = parse_glove(spec.glove_text, hand)
    if spec.motion:
        motion: SimulatedMotion = _motion_of(spec, hand, glove)
    else:
        own = RandomPostures(hand, spec.seed, duration=spec.duration, camera=spec.rig.pose)
        motion = RequestedMotion(own, spec.seed)
    scene = spec.scene or ("desk" if spec.light else "plain")
    seen_by = spec.errors_of_camera.true_rig(spec.rig, spec.seed)
    room = room_of(scene, spec.light, seed=spec.seed, rig=seen_by)
    render = replace(room.render, exposures=spec.exposures)
    if isinstance(render, DeskParams):
        render = replace(render, backgrounds=BACKGROUNDS)
    params = spec.errors_of_camera.params(
        SimulationParams(render=render, right_late=spec.right_late)
    )
    return Simulation(
        hand, glove, motion, spec.seed, params, fps=spec.fps, rig=spec.rig, extras=room.extras
    )


def build_scene(spec: DemoSpec) -> Simulation | TwoHandsSimulation:
    """The complete scene in view of the camera."""
    if not spec.others:
        return build(spec)
    dressed = {}
    for texts in spec.worn:
        hand = parse_hand(texts.hand)
        dressed[hand.side] = GlovedHand(hand, parse_glove(texts.glove, hand))
    room = room_of("plain", "", seed=spec.seed)
    render = replace(room.render, exposures=spec.exposures)
    params = spec.errors_of_camera.params(
        SimulationParams(render=render, right_late=spec.right_late)
    )
    return TwoHandsSimulation(dressed, spec.seed, spec.duration, spec.fps, params, spec.rig)


def hands_of(scene: Simulation | TwoHandsSimulation) -> dict[str, Simulation]:
    """Each hand of a scene, by its side; the left one first."""
    return scene.hands if isinstance(scene, TwoHandsSimulation) else {scene.hand.side: scene}


def ask(simulation: Simulation | TwoHandsSimulation, request: PostureRequest) -> None:
    """Request a posture; ignored by a wearer who plays a recording or meets another."""
    if isinstance(simulation, Simulation) and isinstance(simulation.motion, RequestedMotion):
        simulation.motion.ask(request)


def requests_to(simulation: Simulation) -> tuple[PostureRequest, ...]:
    """All postures requested so far."""
    return simulation.motion.request if isinstance(simulation.motion, RequestedMotion) else ()


def _motion_of(spec: DemoSpec, hand: HandModel, glove: GloveModel) -> SimulatedMotion:
    """Imports on demand: these modules load all of scipy, which would delay the start of the
    demo."""
    if spec.motion.startswith(WORD):
        wearer = Wearer.random(hand, glove, spec.seed)
        return RequestedMotion(show(spec.motion, hand, wearer, spec.duration), spec.seed)
    return load_motion(Path(spec.motion), hand, spec.rig.pose)
