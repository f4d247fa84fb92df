"""The demo: one or two simulated wearers, gloves and a camera, tracked by the real engine."""

from __future__ import annotations

import pickle
import time
from collections.abc import Callable, Iterable, Mapping
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from app.engines.demo_camera import (
    DURATION,
    FILES,
    DemoChoice,
    demo_spec,
    glove_mark,
    start_camera,
)
from app.engines.engine import (
    Built,
    CameraPart,
    EngineSetup,
    GlovePart,
    LivePart,
    Send,
    seen_from_main,
)
from app.engines.protocols import ReferenceHand
from app.engines.recording import recorder_maker
from app.engines.warm_up import warm_up
from app.platform.tasks import JobProgress
from app.storage.own_gloves import own_name
from app.words import tr
from tracker.base.clock import ClockAnchor
from tracker.base.errors import DeviceError
from tracker.base.notices import notice
from tracker.engine.hands import Hands
from tracker.engine.kinds import WITHOUT_CAMERA, settings_text
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.glove import library
from tracker.hand.names import FINGERS
from tracker.live.listeners import ListenerKind
from tracker.live.recording import Recorder
from tracker.live.runner import LiveTracker
from tracker.sensors.glove_link import GloveLink, serial_port
from tracker.session.description import SessionInfo, describe, of_hands
from tracker.session.recording.process import RecorderProcesses
from tracker.simulation.camera_device import DemoCamera
from tracker.simulation.demo import DemoSpec, ask, build_scene, hands_of, requests_to
from tracker.simulation.gestures import gesture_angles
from tracker.simulation.glove_process import GloveProcess
from tracker.simulation.guided import HeldHand, HoldParams
from tracker.simulation.posture_requests import AHEAD, MOVE, PostureRequest, RequestedMotion
from tracker.simulation.scenario import Simulation
from tracker.simulation.shows import shown_application
from tracker.simulation.smooth import rng_for
from tracker.simulation.truth_recorder import Prepare, WithTruth
from tracker.vision.colours import ColourProfile, parse_profile
from tracker.vision.detector import Detector
from tracker.vision.rig import StereoRig

if TYPE_CHECKING:
    from app.engines.protocols import Plan

LEAD = 0.25  # s until the devices begin: a recording begun at once is complete
START_TIMEOUT = 120.0  # s, for a process that starts on a loaded machine
CAMERA = "simulated camera"
TURNING = 6.0  # s per turn of the wrist from side to side
HIDDEN_PINCHES = "pinch_ring", "pinch_little"  # below the palm, where the back faces the camera
OUTER_SIDE = np.deg2rad(-90.0)  # roll of a right hand, whose outer side then faces the camera


class DemoGlove:
    """The glove of one simulated hand on the serial line ``path``, and the link to it."""

    def __init__(self, simulation: Simulation, path: str) -> None:
        self.simulation = simulation
        self.link = GloveLink(serial_port(path), len(simulation.glove.imus))


def demo_setup(
    progress: JobProgress,
    seed: int,
    choice: DemoChoice,
    camera: DemoCamera | None = None,
) -> EngineSetup:
    """Build the demo; takes about a minute if no kernel is compiled yet.

    ``camera`` was started already, for the same seed and choice.
    """
    return build_demo(progress, seed, choice, camera).setup


def build_demo(
    progress: JobProgress,
    seed: int,
    choice: DemoChoice,
    camera: DemoCamera | None = None,
    kinds: Iterable[ListenerKind] | None = None,
) -> Built:
    """As `demo_setup`, with the way to the simulated wearer. Listeners of ``kinds``, by
    default of all, are attached to the hands."""
    progress(0.1, tr("a simulated wearer and camera"))
    spec = demo_spec(seed, choice)
    camera = camera or start_camera(seed, choice)  # starts in a process of its own
    glove_process = GloveProcess(spec)  # and so do the gloves
    try:
        return _built_with(progress, spec, choice.has_camera, (camera, glove_process), kinds)
    except BaseException:  # also after Ctrl+C no process may remain
        camera.close()
        glove_process.close()
        raise


def _built_with(
    progress: JobProgress,
    spec: DemoSpec,
    has_camera: bool,
    devices: tuple[DemoCamera, GloveProcess],
    kinds: Iterable[ListenerKind] | None,
) -> Built:
    camera, glove_process = devices
    wearers = hands_of(build_scene(spec))
    first = next(iter(wearers.values()))
    colours_text = library.text("colours", library.DEFAULT_COLOURS)
    profile = parse_profile(colours_text)

    def make_detector(colours: ColourProfile) -> Detector:
        return Detector(colours, float(first.glove.marker_size.mean()), first.rig.fx)

    progress(0.5, tr("first image"))
    warm_up(first.hand, first.glove, make_detector(profile))
    progress(0.9, tr("devices"))
    if not camera.wait_ready(START_TIMEOUT):
        raise DeviceError(notice("window.demo_camera"))
    gloves = _gloves(wearers, glove_process)
    t_0 = time.monotonic() + LEAD
    camera.begin(t_0)
    glove_process.begin(t_0)
    links = {side: glove.link for side, glove in gloves.items()}
    tracker = LiveTracker(_hands(wearers, has_camera), profile, make_detector, links, camera)
    info = _info(spec, spec.rig if has_camera else None, colours_text, tracker.settings)
    recorders = RecorderProcesses(Prepare(spec))
    recorders.warm()

    def send(request: PostureRequest, pose: str) -> None:
        ask(first, request)
        glove_process.ask(request)
        camera.ask(request, pose)

    wearer = None
    if len(wearers) == 1:  # two wearers follow no guidance
        wearer = GuidedWearer(lambda: first, send, t_0, alone=spec.alone)

    def close() -> None:
        if wearer is not None:
            wearer.close()
        glove_process.close()
        recorders.close()

    def record(path: Path, about: SessionInfo) -> Recorder:
        companion = WithTruth(spec, t_0, requests_to(first))
        return recorders.record(path, about, companion=companion)

    make_recorder = recorder_maker(tracker, info, record)
    camera_part = _camera(first, spec.fps if has_camera else 0.0)
    setup = seen_from_main(
        [
            replace(
                _seen_from(glove, tracker, camera_part, profile, close),
                live=LivePart(tracker, tracker.hand(side), make_recorder, wearer),
                truth=SimulatedTruth(glove.simulation, t_0),
                listeners=tracker.hand(side).attach_listeners(glove.link.vibrate, kinds),
                application=shown_application(spec.motion),
                anchor=info.anchor,
            )
            for side, glove in gloves.items()
        ]
    )
    return Built(setup, send, t_0, pickle.dumps(spec))


def _gloves(wearers: Mapping[str, Simulation], glove_process: GloveProcess) -> dict[str, DemoGlove]:
    paths = glove_process.paths(START_TIMEOUT)
    return {side: DemoGlove(simulation, paths[side]) for side, simulation in wearers.items()}


def _seen_from(
    glove: DemoGlove,
    tracker: LiveTracker,
    camera: CameraPart,
    profile: ColourProfile,
    close: Callable[[], None],
) -> EngineSetup:
    simulation = glove.simulation
    hand = tracker.hand(simulation.glove.side)
    alone = tr("The hand is tracked by its IMUs alone, so its position is unknown.")
    return EngineSetup(
        name="demo",
        engine=tracker,
        tracked=hand,
        hand=simulation.hand,
        glove=simulation.glove,
        camera=camera,
        profile=profile,
        close=close,
        connection=_connection(glove),
        simulated=True,
        missing="" if camera.present else alone,
    )


def _connection(glove: DemoGlove) -> GlovePart:
    file = FILES[glove.simulation.glove.side][1]
    own = own_name(file, glove_mark(glove.simulation.seed))
    return GlovePart(device=glove.link, file=file, own_file=own)


@dataclass(frozen=True)
class SimulatedRate:
    """The device of a `CameraPart`: a simulated camera delivers the rate that it was set to."""

    fps: float
    unfit: None = None


def _camera(seen: Simulation, fps: float) -> CameraPart:
    """``fps``: 0 without a camera."""
    if not fps:
        return CameraPart(seen.rig, present=False, calibrated=False)
    device, true_rig = SimulatedRate(fps), seen.scene.rig
    return CameraPart(seen.rig, name=CAMERA, device=device, true_rig=true_rig)


class SimulatedTruth:
    """The simulated hand; ``t_0`` (s) is when its motion begins."""

    is_measured = False

    def __init__(self, simulation: Simulation, t_0: float) -> None:
        self._simulation, self._t_0 = simulation, t_0

    def at(self, t: float) -> ReferenceHand:
        true = self._simulation.truth(min(max(t - self._t_0, 0.0), DURATION - 0.1))
        return ReferenceHand(true.keypoints, true.R_GB, true.p_GB)


def _hands(wearers: Mapping[str, Simulation], has_camera: bool) -> Hands:
    settings = Settings() if has_camera else Settings(engine=WITHOUT_CAMERA)
    make = {
        side: partial(Pipeline, s.hand, s.glove, s.rig if has_camera else None, settings)
        for side, s in wearers.items()
    }
    return Hands(make)


def _info(
    spec: DemoSpec, rig: StereoRig | None, colours_text: str, settings: Settings
) -> SessionInfo:
    """The description of a recording of the demo."""
    anchor = ClockAnchor(time.time_ns(), time.monotonic_ns())
    infos = [
        describe(
            texts.hand,
            texts.glove,
            anchor,
            rig=rig,
            colours_text=colours_text,
            settings_text=settings_text(settings),
            engine=settings.engine,
            simulated=True,
        )
        for texts in spec.worn
    ]
    return of_hands(infos)


class GuidedWearer:
    """Moves the hand that the simulated glove and camera see.

    What is asked for is carried out in turn on one thread. Pinches, which take up to several
    seconds to solve on a loaded computer, are solved in advance on another one.
    """

    def __init__(
        self, simulation: Callable[[], Simulation], send: Send, t_0: float, alone: bool = False
    ) -> None:
        """``simulation`` is called when it is needed; ``t_0`` (s) is when its motion begins;
        ``alone``: in a pinch, no finger bends but the one that it is named after."""
        self._simulation, self._send, self._t_0 = simulation, send, t_0
        self._alone = alone
        self._held: HeldHand | None = None
        self._pinches: dict[str, Future[tuple[float, ...]]] = {}
        self._thread = ThreadPoolExecutor(1, "glovetrack-demo-guide")
        self._solver = ThreadPoolExecutor(1, "glovetrack-demo-pinches")
        self._closed = False

    def _clock(self) -> float:
        """s of simulated time."""
        return time.monotonic() - self._t_0

    def show(self, pose: str) -> None:
        """Take the pose within about two seconds; empty: resume the motion."""
        self._submit(self._ask, pose)

    def show_gesture(self, gesture: str) -> None:
        """Make the gesture within about 2.5 s; empty: resume the motion."""
        if not self._pinches and not self._closed:
            names = [f"pinch_{finger}" for finger in FINGERS]
            self._pinches = {n: self._solver.submit(self._solve, n) for n in names}
        self._submit(self._ask_gesture, gesture)

    def follow(self, plan: Plan, name: str) -> None:
        """Carry out the postures of ``plan``, which is called with the simulation and the first
        time (s) that can be changed."""
        self._submit(self._ask_plan, plan, name)

    def _ask_plan(self, plan: Plan, name: str) -> None:
        for request in plan(self._simulation(), self._clock() + AHEAD):
            self._send(request, name)

    def _submit(self, work: Callable[..., object], *args: object) -> None:
        """A dialog may still ask while the demo is closed; nothing moves any more."""
        if not self._closed:
            self._thread.submit(work, *args)

    def _solve(self, name: str) -> tuple[float, ...]:
        """(J,) rad of a gesture."""
        simulation = self._simulation()
        angles = gesture_angles(simulation.hand, name, simulation.wearer, self._alone)
        return tuple(angles.tolist())

    def _gesture(self, name: str) -> tuple[float, ...]:
        pinch = self._pinches.get(name)
        return pinch.result() if pinch is not None else self._solve(name)

    def _ask_gesture(self, gesture: str) -> None:
        angles = self._gesture(gesture) if gesture else ()
        turning = TURNING if gesture == "turn" else 0.0
        place = self._turned() if self._alone and gesture in HIDDEN_PINCHES else ()
        asked = PostureRequest(self._clock() + AHEAD, angles, turning, place)
        self._send(asked, gesture)

    def _turned(self) -> tuple[float, ...]:
        """The place of a hand whose outer side the camera sees, where the palm hides no finger."""
        simulation = self._simulation()
        motion = simulation.motion
        if not isinstance(motion, RequestedMotion):
            return ()
        side = 1.0 if simulation.hand.side == "right" else -1.0
        return motion.turned(side * OUTER_SIDE, simulation.hand.length)

    def _ask(self, pose: str) -> None:
        angles = self._angles(pose) if pose else ()
        self._send(PostureRequest(self._clock() + AHEAD, angles), pose)

    def _angles(self, pose: str) -> tuple[float, ...]:
        """(J,) rad."""
        if self._held is None:
            simulation = self._simulation()
            rng = rng_for(simulation.seed, "postures asked for")
            self._held = HeldHand(simulation.wearer, HoldParams(), rng)
        then = self._clock() + AHEAD + MOVE
        return tuple(self._held.angles(pose, then).tolist())

    def close(self) -> None:
        """End the threads."""
        self._closed = True
        for thread in (self._solver, self._thread):
            thread.shutdown(wait=True, cancel_futures=True)
