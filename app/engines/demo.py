"""The demo: a simulated wearer, glove and camera, tracked by the real engine."""

from __future__ import annotations

import time
from pathlib import Path

from app.engines.demo_camera import DURATION, demo_spec, start_camera
from app.engines.demo_guide import DemoGuide
from app.engines.engine import EngineSetup, ReferenceHand
from app.engines.recording import recorder_maker
from app.engines.warm_up import warm_up
from app.platform.tasks import JobProgress
from app.words import tr
from tracker import library
from tracker.applications.sinks import all_sinks
from tracker.clock import ClockAnchor
from tracker.config import to_toml
from tracker.errors import DeviceError
from tracker.live.recording import Recorder
from tracker.live.runner import LiveTracker
from tracker.pipeline import Pipeline
from tracker.sensors.glove_link import GloveLink, serial_port
from tracker.session.description import SessionInfo
from tracker.session.recording.process import RecorderProcesses
from tracker.simulation.camera_device import SimulatedCamera
from tracker.simulation.demo import DemoSpec, asked_for, build
from tracker.simulation.glove_device import SimulatedGlove
from tracker.simulation.scenario import Simulation
from tracker.simulation.truth_recorder import Prepare, WithTruth
from tracker.vision.colours import ColourProfile, parse_profile
from tracker.vision.detector import Detector

LEAD = 0.25  # s until the devices begin: a recording asked for at once misses nothing
CAMERA_TIMEOUT = 120.0
CAMERA = "simulated camera"


def demo_setup(
    progress: JobProgress, seed: int, fps: float, camera: SimulatedCamera | None = None
) -> EngineSetup:
    """Build everything; takes a minute or so the first time where no kernel is compiled.

    ``camera``: one that was started before, for the same seed and rate.
    """
    progress(0.1, tr("a simulated wearer and camera"))
    camera = camera or start_camera(seed, fps)  # its own process gets ready beside us
    try:
        return _setup_with(progress, demo_spec(seed, fps), camera)
    except BaseException:  # Ctrl+C too must not leave the camera's process behind
        camera.close()
        raise


def _setup_with(progress: JobProgress, spec: DemoSpec, camera: SimulatedCamera) -> EngineSetup:
    simulation = build(spec)
    colours_text = library.text("colours", library.DEFAULT_COLOURS)
    profile = parse_profile(colours_text)
    pipeline = Pipeline(simulation.hand, simulation.glove, simulation.rig)

    def make_detector(colours: ColourProfile) -> Detector:
        size = float(simulation.glove.marker_size.mean())
        return Detector(colours, size, simulation.rig.fx)

    progress(0.5, tr("first image"))
    warm_up(simulation.hand, simulation.glove, make_detector(profile))
    progress(0.9, tr("devices"))
    if not camera.wait_ready(CAMERA_TIMEOUT):
        raise DeviceError(tr("The simulated camera did not start."))
    count = len(simulation.glove.imus)
    device = SimulatedGlove(simulation.imu_samples(), count)
    link = GloveLink(serial_port(device.path), count)
    t_0 = time.monotonic() + LEAD
    camera.begin(t_0)
    device.begin(t_0)
    tracker = LiveTracker(pipeline, profile, make_detector, link, camera)
    tracker.stage.sinks += all_sinks(link.vibrate, tracker.stage.tell)
    info = _info(spec, simulation, pipeline, colours_text)
    recorders = RecorderProcesses(Prepare(spec))
    recorders.warm()

    def truth(t: float) -> ReferenceHand:
        true = simulation.truth(min(max(t - t_0, 0.0), DURATION - 0.1))
        return ReferenceHand(true.keypoints, true.R_GB, true.p_GB)

    def record(path: Path, about: SessionInfo) -> Recorder:
        companion = WithTruth(spec, t_0, asked_for(simulation))
        return recorders.record(path, about, companion=companion)

    guide = DemoGuide(tracker, simulation, camera, lambda: time.monotonic() - t_0)

    def close() -> None:
        guide.close()
        device.stop()
        recorders.close()

    return EngineSetup(
        name="demo",
        engine=tracker,
        hand=simulation.hand,
        glove=simulation.glove,
        rig=simulation.rig,
        profile=profile,
        anchor=info.anchor,
        close=close,
        make_recorder=recorder_maker(tracker, info, record),
        truth=truth,
        simulated=True,
        followed=tracker,
        vibrate=link.vibrate,
        guide=guide,
        command=tracker.command,
        stage=tracker.stage,
        reference_tracking=tracker,
        camera=CAMERA,
        image_rate=lambda: spec.fps,
    )


def _info(
    spec: DemoSpec, simulation: Simulation, pipeline: Pipeline, colours_text: str
) -> SessionInfo:
    """What a recording of the demo is about."""
    return SessionInfo(
        hand=simulation.hand,
        glove=simulation.glove,
        hand_text=spec.hand_text,
        glove_text=spec.glove_text,
        anchor=ClockAnchor(time.time_ns(), time.monotonic_ns()),
        rig=simulation.rig,
        colours_text=colours_text,
        settings_text=to_toml(pipeline.settings),
        engine=pipeline.settings.engine,
        simulated=True,
    )
