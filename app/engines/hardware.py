"""The real devices: a glove on a serial port and a side-by-side stereo camera."""

from __future__ import annotations

import time
from pathlib import Path

from app.engines.camera_choice import choose
from app.engines.engine import EngineSetup
from app.engines.recording import recorder_maker
from app.engines.warm_up import warm_up
from app.platform.tasks import JobProgress
from app.storage.settings import AppSettings
from tracker import library
from tracker.calibration.stereo.files import ImportForm, load_rig
from tracker.clock import ClockAnchor
from tracker.config import to_toml
from tracker.errors import DeviceError
from tracker.live.runner import LiveTracker
from tracker.pipeline import Pipeline
from tracker.sensors.camera import StereoCamera
from tracker.sensors.discovery import PortReport, find_gloves, serial_ports
from tracker.sensors.glove_link import GloveLink, serial_port
from tracker.session.description import SessionInfo
from tracker.vision.colours import ColourProfile, parse_profile
from tracker.vision.detector import Detector
from tracker.vision.rig import StereoRig

WIDTH, HEIGHT, FPS = 1280, 720, 60.0


def hardware_setup(progress: JobProgress, settings: AppSettings) -> EngineSetup:
    """Find the devices and build an engine on them. Raises DeviceError with what is missing."""
    port = find_port(progress, settings.port)
    progress(0.5, "camera")
    rig = rig_of(settings.calibration)
    chosen = choose(settings, rig.left.width, rig.left.height, FPS)
    progress(0.7, "engine")
    hand, glove = library.load(settings.glove, settings.hand)
    pipeline = Pipeline(hand, glove, rig)
    colours_text = library.text("colours", library.DEFAULT_COLOURS)
    info = _info(settings, pipeline, colours_text)
    profile = parse_profile(colours_text)

    def make_detector(colours: ColourProfile) -> Detector:
        return Detector(colours, float(glove.marker_size.mean()), rig.fx)

    warm_up(hand, glove, make_detector(profile))
    link = GloveLink(serial_port(port), len(glove.imus))
    camera = StereoCamera(chosen.source, rig)
    tracker = LiveTracker(pipeline, profile, make_detector, link, camera)
    return EngineSetup(
        name=f"glove at {port}",
        engine=tracker,
        hand=hand,
        glove=glove,
        rig=rig,
        profile=profile,
        anchor=info.anchor,
        close=lambda: None,
        make_recorder=recorder_maker(tracker, info),
        vibrate=link.vibrate,
        command=tracker.command,
        reference_tracking=tracker,
        # a calibration file's name holds a ZED's serial number
        camera=f"{chosen.title} {Path(settings.calibration).stem}",
        camera_controls=chosen.controls,
    )


def _info(settings: AppSettings, pipeline: Pipeline, colours_text: str) -> SessionInfo:
    """What a recording of these devices is about."""
    return SessionInfo(
        hand=pipeline.hand,
        glove=pipeline.glove,
        hand_text=library.text("hands", settings.hand),
        glove_text=library.text("gloves", settings.glove),
        anchor=ClockAnchor(time.time_ns(), time.monotonic_ns()),
        rig=pipeline.rig,
        colours_text=colours_text,
        settings_text=to_toml(pipeline.settings),
        engine=pipeline.settings.engine,
    )


def find_port(progress: JobProgress, last: str) -> str:
    """The first port with a glove behind it; the last one used is asked first."""
    # one that is not on USB is on no list, and was chosen by hand
    ports = [*([last] if last else []), *(p for p in serial_ports() if p != last)]
    troubles = []
    for i, path in enumerate(ports):
        progress(0.4 * i / len(ports), path)
        report: PortReport = find_gloves([path])[0]
        if report.is_glove:
            return path
        troubles.append(report.trouble)
    if not troubles:
        raise DeviceError("No glove was found: no USB serial port is there. Is it plugged in?")
    raise DeviceError(f"No glove was found. {' '.join(troubles)}")


def rig_of(calibration: str) -> StereoRig:
    """The stereo calibration that the user chose."""
    if not calibration:
        raise DeviceError(
            "The camera has no stereo calibration yet: make or import one under "
            "Set-up, Stereo calibration."
        )
    return load_rig(Path(calibration), ImportForm(WIDTH, HEIGHT))
