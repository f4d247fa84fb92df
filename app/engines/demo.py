"""The demo: a simulated wearer or two, gloves and a camera, tracked by the real engine."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

from app.engines.demo_camera import DURATION, DemoChoice, demo_spec, start_camera
from app.engines.demo_guide import DemoGuide
from app.engines.engine import EngineSetup, RecordingRequest, ReferenceHand, seen_from_main
from app.engines.guide import WearersGuide
from app.engines.recording import recorder_maker
from app.engines.warm_up import warm_up
from app.platform.tasks import JobProgress
from app.words import tr
from tracker.base.clock import ClockAnchor
from tracker.base.errors import DeviceError
from tracker.engine.hands import Hands
from tracker.engine.kinds import WITHOUT_CAMERA, settings_text
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.glove import library
from tracker.live.recording import Recorder
from tracker.live.runner import LiveTracker
from tracker.sensors.glove_link import GloveLink, serial_port
from tracker.session.description import SessionInfo, describe, of_hands
from tracker.session.recording.process import RecorderProcesses
from tracker.simulation.camera_device import DemoCamera
from tracker.simulation.demo import DemoSpec, asked_for, build_scene, hands_of
from tracker.simulation.glove_process import GloveProcess
from tracker.simulation.scenario import Simulation
from tracker.simulation.shows import shown_application
from tracker.simulation.truth_recorder import Prepare, WithTruth
from tracker.vision.colours import ColourProfile, parse_profile
from tracker.vision.detector import Detector
from tracker.vision.rig import StereoRig

LEAD = 0.25  # s until the devices begin: a recording asked for at once misses nothing
START_TIMEOUT = 120.0  # s, for a process that is just starting on a busy machine
CAMERA = "simulated camera"


class DemoGlove:
    """The glove of one simulated hand at the line ``path``, and the link to it."""

    def __init__(self, simulation: Simulation, path: str) -> None:
        self.simulation = simulation
        self.link = GloveLink(serial_port(path), len(simulation.glove.imus))


def demo_setup(
    progress: JobProgress,
    seed: int,
    choice: DemoChoice,
    camera: DemoCamera | None = None,
) -> EngineSetup:
    """Build everything; takes a minute or so the first time where no kernel is compiled.

    ``camera``: one that was started before, for the same seed and choice.
    """
    progress(0.1, tr("a simulated wearer and camera"))
    spec = demo_spec(seed, choice)
    camera = camera or start_camera(seed, choice)  # its own process gets ready beside us
    worn = GloveProcess(spec)  # and so do the gloves
    try:
        return _setup_with(progress, spec, choice.has_camera, camera, worn)
    except BaseException:  # Ctrl+C too must not leave processes behind
        camera.close()
        worn.close()
        raise


def _setup_with(
    progress: JobProgress, spec: DemoSpec, has_camera: bool, camera: DemoCamera, worn: GloveProcess
) -> EngineSetup:
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
        raise DeviceError(tr("The simulated camera did not start."))
    paths = worn.paths(START_TIMEOUT)
    gloves = {side: DemoGlove(simulation, paths[side]) for side, simulation in wearers.items()}
    t_0 = time.monotonic() + LEAD
    camera.begin(t_0)
    worn.begin(t_0)
    links = {side: glove.link for side, glove in gloves.items()}
    hands = _hands(wearers, has_camera)
    tracker = LiveTracker(hands, profile, make_detector, links, camera)
    rig = spec.rig if has_camera else None
    info = _info(spec, rig, colours_text, tracker.settings)
    recorders = RecorderProcesses(Prepare(spec))
    recorders.warm()

    guide = None
    if len(wearers) == 1:  # two who meet are asked for nothing
        tracked = tracker.hand(first.glove.side)
        guide = DemoGuide(tracked, first, (camera, worn), lambda: time.monotonic() - t_0)

    def close() -> None:
        if guide is not None:
            guide.close()
        worn.close()
        recorders.close()

    def record(path: Path, about: SessionInfo) -> Recorder:
        companion = WithTruth(spec, t_0, asked_for(first))
        return recorders.record(path, about, companion=companion)

    make_recorder = recorder_maker(tracker, info, record)
    fps = spec.fps if has_camera else 0.0
    used = shown_application(spec.motion)
    shared = SharedSetup(profile, info.anchor, close, make_recorder, fps, guide, used)
    return seen_from_main([_seen_from(g, tracker, t_0, shared) for g in gloves.values()])


@dataclass(frozen=True, eq=False)
class SharedSetup:
    """What of an `EngineSetup` is the same for both hands; ``fps`` is 0 without a camera."""

    profile: ColourProfile
    anchor: ClockAnchor
    close: Callable[[], None]
    make_recorder: Callable[[RecordingRequest], Recorder]
    fps: float
    guide: DemoGuide | None
    application: tuple[str, Mapping[str, Any]]


def _seen_from(
    glove: DemoGlove, tracker: LiveTracker, t_0: float, shared: SharedSetup
) -> EngineSetup:
    simulation = glove.simulation
    tracked = tracker.hand(simulation.glove.side)

    def truth(t: float) -> ReferenceHand:
        true = simulation.truth(min(max(t - t_0, 0.0), DURATION - 0.1))
        return ReferenceHand(true.keypoints, true.R_GB, true.p_GB)

    return EngineSetup(
        name="demo",
        engine=tracker,
        tracked=tracked,
        hand=simulation.hand,
        glove=simulation.glove,
        rig=simulation.rig,
        profile=shared.profile,
        anchor=shared.anchor,
        close=shared.close,
        make_recorder=shared.make_recorder,
        truth=truth,
        simulated=True,
        followed=tracked,
        right_of_way=tracker.right_of_way,
        vibrate=glove.link.vibrate,
        glove_settings=glove.link,
        guide=shared.guide or WearersGuide(tracked),
        command=tracked.command,
        reset_pose=tracked.reset_pose,
        listeners=tracked.attach_listeners(glove.link.vibrate),
        application=shared.application,
        reference_tracking=tracked if shared.fps else None,
        camera=CAMERA if shared.fps else "",
        image_rate=(lambda: shared.fps) if shared.fps else None,
        has_camera=bool(shared.fps),
        camera_calibrated=bool(shared.fps),
        missing="" if shared.fps else tr("The hand is shown by its IMUs alone, without a place."),
    )


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
    """What a recording of the demo is about."""
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
