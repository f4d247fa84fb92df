"""The real devices: gloves on serial ports, one or two cameras, or a part of these."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import TypeVar

import platformdirs

from app.engines.camera_choice import NAME, ChosenCamera, choose, stated_count
from app.engines.engine import (
    CameraPart,
    EngineSetup,
    GlovePart,
    LivePart,
    seen_from_main,
)
from app.engines.found_gloves import HandGlove, find_hand_gloves
from app.engines.recording import recorder_maker
from app.engines.warm_up import warm_up
from app.platform.tasks import JobProgress
from app.storage.own_gloves import UNNUMBERED, own_name
from app.storage.settings import AppSettings
from app.words import notice_text, tr
from tracker.base.clock import ClockAnchor
from tracker.base.errors import DeviceError, GlovetrackError
from tracker.base.notices import Notice, notice
from tracker.calibration.stereo.files import MissingFacts, load_rig
from tracker.engine.hands import Hands
from tracker.engine.kinds import WITHOUT_CAMERA, settings_text
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.firmware.versions import advice
from tracker.glove import library
from tracker.live.listeners import ListenerKind
from tracker.live.runner import LiveTracker
from tracker.sensors.camera import StereoCamera, UnfitImages
from tracker.sensors.camera_plugins import all_cameras
from tracker.sensors.glove_link import GloveLink
from tracker.sensors.image_input import ImageInput
from tracker.sensors.rig_files import find_zed_file
from tracker.sensors.sources import CameraSource, GloveSource, NoCamera, NoGlove
from tracker.sensors.zed_registers import is_zed, zed_serial
from tracker.session.description import SessionInfo, of_hands
from tracker.session.recording.process import RecorderProcesses
from tracker.vision.colours import ColourProfile, parse_profile
from tracker.vision.detector import Detector
from tracker.vision.rig import StereoRig

WIDTH, HEIGHT, FPS = 1280, 720, 60.0
T = TypeVar("T")
INERTIAL = Settings(engine=WITHOUT_CAMERA)


@dataclass(frozen=True)
class FoundDevices:
    """The devices that were found; ``missing`` lists those that were not, and why."""

    gloves: tuple[HandGlove, ...]
    camera: ChosenCamera | None
    rig: StereoRig | None
    missing: tuple[str, ...]
    calibration: str = ""
    """Path of the calibration's file."""

    @property
    def name(self) -> str:
        """For the window's title."""
        paths = [glove.report.path for glove in self.gloves if glove.report is not None]
        if len(paths) > 1:
            return tr("gloves at {}").format(", ".join(paths))
        return tr("glove at {}").format(paths[0]) if paths else tr("camera alone")

    @property
    def whole(self) -> bool:
        return bool(self.gloves and self.camera is not None and self.rig is not None)

    def used_gloves(self, settings: AppSettings) -> tuple[HandGlove, ...]:
        """The gloves; without any, that of the settings, whose markers a camera may see."""
        if self.gloves:
            return self.gloves
        hand, glove = library.load(settings.glove, settings.hand)
        return (HandGlove(settings.glove, settings.hand, hand, glove, None, None),)


def hardware_setup(
    progress: JobProgress, settings: AppSettings, kinds: Iterable[ListenerKind] | None = None
) -> EngineSetup:
    """Find the devices and build an engine for them, even if the glove or the camera is missing.

    Listeners of ``kinds``, by default of all, are attached to the hands.

    Raises DeviceError if both are missing.
    """
    found = find_devices(progress, settings)
    progress(0.7, tr("engine"))
    gloves = found.used_gloves(settings)
    engine = Settings() if found.whole else INERTIAL
    make = {g.side: partial(Pipeline, g.hand, g.glove, found.rig, engine) for g in gloves}
    hands = Hands(make)
    colours_text = library.text("colours", library.DEFAULT_COLOURS)
    profile = parse_profile(colours_text)
    pipeline = hands.pipelines[gloves[0].side]

    def make_detector(colours: ColourProfile) -> Detector:
        return Detector(colours, float(pipeline.glove.marker_size.mean()), pipeline.rig.fx)

    warm_up(pipeline.hand, pipeline.glove, make_detector(profile))
    rate_hz = settings.glove_rate
    links: dict[str, GloveLink] = {g.side: g.link(rate_hz) for g in found.gloves}
    sources: dict[str, GloveSource] = {g.side: links.get(g.side) or NoGlove() for g in gloves}
    camera = StereoCamera(found.camera.source, found.rig) if found.camera else None
    source: CameraSource = camera or NoCamera()
    tracker = LiveTracker(hands, profile, make_detector, sources, source)
    info = _info(gloves, pipeline, colours_text)
    recorders = RecorderProcesses()
    recorders.warm()
    camera_part = _camera_part(found, camera, pipeline.rig, found.calibration)
    make_recorder = recorder_maker(tracker, info, recorders.record)

    def seen_from(glove: HandGlove) -> EngineSetup:
        hand, link = tracker.hand(glove.side), links.get(glove.side)
        hello = glove.report.hello if glove.report else None
        firmware_advice = advice(hello.firmware) if hello else None
        mark = UNNUMBERED if glove.glove_id is None else str(glove.glove_id)
        connection = GlovePart(
            link is not None,
            glove.glove_id,
            firmware_advice,
            link,
            glove.glove_name,
            own_name(glove.glove_name, mark),
        )
        return EngineSetup(
            name=found.name,
            engine=tracker,
            tracked=hand,
            hand=glove.hand,
            glove=glove.glove,
            camera=camera_part,
            profile=profile,
            close=recorders.close,
            connection=connection,
            live=LivePart(tracker, hand, make_recorder),
            listeners=hand.attach_listeners(link.vibrate if link else None, kinds),
            missing=" ".join(found.missing),
            anchor=info.anchor,
        )

    return seen_from_main([seen_from(glove) for glove in gloves])


def _camera_part(
    found: FoundDevices, camera: StereoCamera | None, rig: StereoRig, calibration: str
) -> CameraPart:
    """``rig`` is an ideal one if there is no calibration; ``calibration`` the path of its file."""
    chosen = found.camera
    return CameraPart(
        rig=rig,
        present=chosen is not None,
        calibrated=found.rig is not None,
        # the name of a ZED's calibration file contains its serial number
        name=f"{chosen.title} {Path(calibration).stem}" if chosen else "",
        calibration_file=calibration,
        device=OpenCamera(chosen.source, camera) if chosen and camera else None,
        controls=chosen.controls if chosen else None,
    )


class OpenCamera:
    """A camera that the engine reads from: its nominal rate, and images that do not fit."""

    def __init__(self, source: ImageInput, camera: StereoCamera) -> None:
        self._source, self._camera = source, camera

    @property
    def fps(self) -> float:
        return self._source.fps

    @property
    def unfit(self) -> UnfitImages | None:
        return self._camera.unfit


def find_devices(progress: JobProgress, settings: AppSettings) -> FoundDevices:
    """Search gloves, calibration and camera. Raises DeviceError if there is no device."""
    missing: list[Notice] = []
    found = _unless_missing(lambda: find_hand_gloves(progress, settings), missing)
    gloves = found.gloves if found is not None else ()
    progress(0.5, tr("camera"))
    calibration = settings.calibration or zed_calibration(settings.camera)
    rig = _unless_missing(lambda: rig_of(calibration), missing)
    width, height = (rig.left.width, rig.left.height) if rig else (WIDTH, HEIGHT)
    count = len(rig.sides) if rig else 0
    right = (rig.right.width, rig.right.height) if rig else None
    camera = _unless_missing(
        lambda: choose(settings, width, height, FPS, count=count, right_size=right), missing
    )
    if not gloves and camera is None:
        raise DeviceError(notice("window.no_devices", problems=missing))
    if rig is not None and camera is not None and camera.source.fps > 0:
        rig = rig_of(calibration, camera.source.fps)
    if gloves and not (rig and camera):
        missing.append(notice("window.imus_alone"))
    remarks = found.remarks if found is not None else ()
    return FoundDevices(gloves, camera, rig, (*map(notice_text, missing), *remarks), calibration)


def _unless_missing(find: Callable[[], T], missing: list[Notice]) -> T | None:
    try:
        return find()
    except GlovetrackError as error:
        missing.append(error.notice)
        return None


def _info(gloves: Sequence[HandGlove], pipeline: Pipeline, colours_text: str) -> SessionInfo:
    """The description of a recording of these devices."""
    anchor = ClockAnchor(time.time_ns(), time.monotonic_ns())
    return of_hands(
        [
            SessionInfo(
                hand=w.hand,
                glove=w.glove,
                hand_text=library.text("hands", w.hand_name),
                glove_text=library.text("gloves", w.glove_name),
                anchor=anchor,
                rig=pipeline.calibrated_rig,
                colours_text=colours_text,
                settings_text=settings_text(pipeline.settings),
                engine=pipeline.settings.engine,
            )
            for w in gloves
        ]
    )


def zed_calibration(chosen: str, folders: Sequence[Path] | None = None) -> str:
    """The path of the factory calibration of the connected ZED that is ``chosen``, or of the first
    one, by its serial number; empty without a camera or a file."""
    wanted = stated_count(chosen)[1].removeprefix(NAME)
    for camera in all_cameras():
        is_other = bool(wanted) and wanted not in (camera.name, str(camera.index))
        if is_other or not is_zed(camera.path):
            continue
        serial = zed_serial(camera.path)
        where = zed_folders() if folders is None else folders
        found = find_zed_file(serial, list(where)) if serial is not None else None
        if found is not None:
            return str(found)
    return ""


def zed_folders() -> list[Path]:
    """Where calibrations of ZED cameras are looked for: ours, and those of Stereolabs' software."""
    return [
        platformdirs.user_data_path("glovetrack", appauthor=False) / "calibrations",
        Path("/usr/local/zed/settings"),
        Path.home() / "zed" / "settings",
    ]


def rig_of(calibration: str, fps: float = FPS) -> StereoRig:
    """The calibration that the user chose, of a stereo or a single camera. Raises DeviceError."""
    if not calibration:
        raise DeviceError(notice("window.no_rig"))
    return load_rig(Path(calibration), MissingFacts(WIDTH, HEIGHT, fps=fps))
