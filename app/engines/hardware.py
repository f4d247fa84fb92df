"""The real devices: a glove on a serial port, a stereo camera, or what there is of them."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

from app.engines.camera_choice import ChosenCamera, choose
from app.engines.engine import EngineSetup
from app.engines.guide import WearersGuide
from app.engines.recording import recorder_maker
from app.engines.warm_up import warm_up
from app.platform.tasks import JobProgress
from app.storage.bound_gloves import as_bound
from app.storage.settings import AppSettings
from app.words import told, tr
from tracker import library
from tracker.applications.sinks import all_sinks
from tracker.calibration.stereo.files import ImportForm, load_rig
from tracker.clock import ClockAnchor
from tracker.config import to_toml
from tracker.errors import DeviceError, GlovetrackError
from tracker.firmware.versions import advice
from tracker.live.runner import LiveTracker
from tracker.pipeline import Pipeline
from tracker.sensors.camera import StereoCamera
from tracker.sensors.discovery import PortReport, find_gloves, serial_ports
from tracker.sensors.glove_link import GloveLink, LinkParams
from tracker.sensors.glove_port import GlovePort
from tracker.sensors.protocol import BAUDS
from tracker.sensors.sources import CameraSource, NoCamera, NoGlove
from tracker.session.description import SessionInfo
from tracker.session.recording.process import RecorderProcesses
from tracker.settings import Settings
from tracker.vision.colours import ColourProfile, parse_profile
from tracker.vision.detector import Detector
from tracker.vision.rig import StereoRig

WIDTH, HEIGHT, FPS = 1280, 720, 60.0
T = TypeVar("T")
INERTIAL = Settings(engine="inertial")


@dataclass(frozen=True)
class Found:
    """What there is of a rig; ``missing`` says what is not there, and why."""

    glove: PortReport | None
    camera: ChosenCamera | None
    rig: StereoRig | None
    missing: tuple[str, ...]

    @property
    def name(self) -> str:
        """For the window's title."""
        return tr("glove at {}").format(self.glove.path) if self.glove else tr("camera alone")

    @property
    def whole(self) -> bool:
        return self.glove is not None and self.camera is not None and self.rig is not None


def hardware_setup(progress: JobProgress, settings: AppSettings) -> EngineSetup:
    """Find the devices and build an engine on them: half a rig is shown as far as it goes.

    Raises DeviceError with what is missing where there is neither glove nor camera.
    """
    found = find_devices(progress, settings)
    progress(0.7, tr("engine"))
    hello = found.glove.hello if found.glove else None
    settings, recalled = as_bound(settings, hello.glove_id if hello else None)
    hand, glove = library.load(settings.glove, settings.hand)
    pipeline = Pipeline(hand, glove, found.rig, Settings() if found.whole else INERTIAL)
    colours_text = library.text("colours", library.DEFAULT_COLOURS)
    info = _info(settings, pipeline, colours_text)
    profile = parse_profile(colours_text)

    def make_detector(colours: ColourProfile) -> Detector:
        return Detector(colours, float(glove.marker_size.mean()), pipeline.rig.fx)

    warm_up(hand, glove, make_detector(profile))
    link = _link(found.glove, len(glove.imus)) if found.glove else None
    chosen = found.camera
    camera: CameraSource = StereoCamera(chosen.source, found.rig) if chosen else NoCamera()
    tracker = LiveTracker(pipeline, profile, make_detector, link or NoGlove(), camera)
    tracker.stage.sinks += all_sinks(link.vibrate if link else None, tracker.stage.tell)
    recorders = RecorderProcesses()
    recorders.warm()
    return EngineSetup(
        name=found.name,
        engine=tracker,
        hand=hand,
        glove=glove,
        rig=pipeline.rig,
        profile=profile,
        anchor=info.anchor,
        firmware_advice=advice(hello.firmware) if hello else "",
        close=recorders.close,
        make_recorder=recorder_maker(tracker, info, recorders.record),
        followed=tracker,
        vibrate=link.vibrate if link else None,
        guide=WearersGuide(tracker),
        command=tracker.command,
        stage=tracker.stage,
        reference_tracking=tracker if found.whole else None,
        # a calibration file's name holds a ZED's serial number
        camera=f"{chosen.title} {Path(settings.calibration).stem}" if chosen else "",
        camera_controls=chosen.controls if chosen else None,
        has_glove=link is not None,
        has_camera=chosen is not None,
        camera_calibrated=found.rig is not None,
        missing=" ".join((*found.missing, *((recalled,) if recalled else ()))),
        image_rate=(lambda: chosen.source.fps) if chosen else None,
    )


def _link(found: PortReport, imu_count: int) -> GloveLink:
    place = GlovePort(found.path, found.baud)
    return GloveLink(place, imu_count, LinkParams(baud=found.baud))


def find_devices(progress: JobProgress, settings: AppSettings) -> Found:
    """Look for glove, calibration and camera. Raises DeviceError where neither device is there."""
    missing: list[str] = []
    glove = _unless_missing(lambda: find_port(progress, settings.port, settings.baud), missing)
    progress(0.5, tr("camera"))
    rig = _unless_missing(lambda: rig_of(settings.calibration), missing)
    width, height = (rig.left.width, rig.left.height) if rig else (WIDTH, HEIGHT)
    camera = _unless_missing(lambda: choose(settings, width, height, FPS), missing)
    if glove is None and camera is None:
        raise DeviceError(" ".join(missing))
    if glove is not None and not (rig and camera):
        missing.append(tr("The hand is shown by its IMUs alone, without a place."))
    return Found(glove, camera, rig, tuple(missing))


def _unless_missing(find: Callable[[], T], missing: list[str]) -> T | None:
    try:
        return find()
    except GlovetrackError as error:
        missing.append(told(str(error)))
        return None


def _info(settings: AppSettings, pipeline: Pipeline, colours_text: str) -> SessionInfo:
    """What a recording of these devices is about."""
    return SessionInfo(
        hand=pipeline.hand,
        glove=pipeline.glove,
        hand_text=library.text("hands", settings.hand),
        glove_text=library.text("gloves", settings.glove),
        anchor=ClockAnchor(time.time_ns(), time.monotonic_ns()),
        rig=pipeline.calibrated_rig,
        colours_text=colours_text,
        settings_text=to_toml(pipeline.settings),
        engine=pipeline.settings.engine,
    )


def find_port(progress: JobProgress, last: str, baud: int = 0) -> PortReport:
    """The first port with a glove behind it; the last one used is asked first.

    It is asked at ``baud``, or at all that a glove may speak. Raises DeviceError if none answers.
    """
    # one that is not on USB is on no list, and was chosen by hand
    ports = [*([last] if last else []), *(p for p in serial_ports() if p != last)]
    troubles = []
    for i, path in enumerate(ports):
        progress(0.4 * i / len(ports), path)
        report = find_gloves([path], bauds=(baud,) if baud else BAUDS)[0]
        if report.is_glove:
            return report
        troubles.append(report.trouble)
    if not troubles:
        raise DeviceError(tr("No glove was found: no USB serial port is there. Is it plugged in?"))
    raise DeviceError(tr("No glove was found. {}").format(" ".join(troubles)))


def rig_of(calibration: str) -> StereoRig:
    """The stereo calibration that the user chose."""
    if not calibration:
        raise DeviceError(
            tr(
                "The camera has no stereo calibration yet: make or import one under "
                "Set-up, Stereo calibration."
            )
        )
    return load_rig(Path(calibration), ImportForm(WIDTH, HEIGHT))
