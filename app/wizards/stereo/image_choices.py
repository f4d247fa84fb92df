"""Sources of images for the stereo calibration."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from pathlib import Path

from app.engines.camera_choice import NAME, PAIR, choose
from app.engines.engine_host import EngineHost
from app.engines.hardware import FPS, HEIGHT, WIDTH
from app.storage.settings import AppSettings
from app.wizards.stereo.board import ImageChoice
from app.words import tr
from tracker.base.errors import DeviceError
from tracker.base.notices import notice
from tracker.sensors.image_input import (
    CameraName,
    ImageInput,
    Pair,
    SequenceInput,
)
from tracker.vision.rig import ideal_rig

SUFFIXES = (".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff")


@dataclass(eq=False)
class SessionImages:
    """An `ImageInput` of the images of the open session."""

    host: EngineHost
    live: bool = True
    name: str = field(default_factory=lambda: tr("camera in use"))
    fps: float = 0.0
    _last: int = -1
    _unfit: Pair | None = None

    def open(self) -> None:
        """The session has opened it."""

    def read(self) -> Pair | None:
        setup = self.host.setup
        if setup is None:
            raise DeviceError(notice("camera.closed"))
        unfit = setup.camera.device.unfit if setup.camera.device is not None else None
        if unfit is not None:  # the calibration of another camera does not fit
            return self._once(unfit.pair)
        latest = setup.tracked.latest_frame()
        if latest is None or latest[0].index == self._last:
            return None
        frame = latest[0]
        self._last = frame.index
        if frame.left is None or (frame.right is None and not setup.camera.is_single(frame)):
            return None
        return frame.left, frame.right

    def _once(self, pair: Pair) -> Pair | None:
        before, self._unfit = self._unfit, pair
        return None if before is pair else pair

    def close(self) -> None:
        """The session closes it."""


class ChosenImages:
    """An `ImageInput` that is opened here until the session opens the same camera: a camera can
    only be opened once."""

    def __init__(self, host: EngineHost, own: ImageInput) -> None:
        self._own, self._used = own, SessionImages(host)
        self._host, self._opened = host, False
        self.name, self.live, self.fps = own.name, own.live, own.fps

    def open(self) -> None:
        if not camera_in_use(self._host):
            self._own.open()
            self._opened, self.live = True, self._own.live

    def read(self) -> Pair | None:
        if camera_in_use(self._host):
            self.close()
            self.live = True
            return self._used.read()
        if not self._opened:
            self.open()
        return self._own.read()

    def close(self) -> None:
        if self._opened:
            self._own.close()
            self._opened = False


def camera_in_use(host: EngineHost) -> bool:
    """Whether the open session uses a real camera."""
    setup = host.setup
    if setup is None or setup.player is not None or setup.simulated:
        return False
    return setup.camera.present


def image_choices(
    host: EngineHost, settings: AppSettings, cameras: list[CameraName]
) -> list[ImageChoice]:
    """All sources, the most likely first."""
    # deferred: only the demo has a simulated camera
    from tracker.simulation.board_camera import BoardCamera

    setup = host.setup
    rig = ideal_rig()
    if setup is not None and setup.simulated:
        rig = setup.camera.true_rig or setup.camera.rig
    simulated = ImageChoice(tr("Simulated board (demo)"), lambda spec: BoardCamera(rig, spec), True)

    def choice(title: str, camera: str) -> ImageChoice:
        wanted = replace(settings, camera=camera)
        return ImageChoice(title, lambda _spec: choose(wanted, WIDTH, HEIGHT, FPS, cameras).source)

    found = [
        # the camera of a plug-in has no index
        choice(f"{c.name} ({c.path or c.index})", str(c.index) if c.index >= 0 else c.path)
        for c in cameras
    ]
    if settings.camera:
        words = settings.camera.removeprefix(NAME).removeprefix(PAIR).replace("|", " + ")
        chosen = choice(tr("Selected camera: {}").format(words), settings.camera)
        make = chosen.make
        found.insert(0, replace(chosen, make=lambda spec: ChosenImages(host, make(spec))))
    if camera_in_use(host):
        return [ImageChoice(tr("Camera in use"), lambda _spec: SessionImages(host)), simulated]
    in_demo = setup is not None and setup.simulated and setup.camera.present
    return [simulated, *found] if in_demo else [*found, simulated]


def folder_choice(folder: Path) -> ImageChoice:
    """Images on disk: names that contain left and right, sorted by name; all of one camera if no
    name contains either."""
    return ImageChoice(tr("Folder {}").format(folder.name), lambda _spec: folder_input(folder))


def folder_input(folder: Path) -> ImageInput:
    """Raises DeviceError if the numbers of left and right images differ."""
    files = sorted(p for p in folder.iterdir() if p.suffix.lower() in SUFFIXES)
    sides = [[p for p in files if side in p.name.lower()] for side in ("left", "right")]
    if not any(sides):
        return SequenceInput(files, None, fps=0.0)
    return SequenceInput(sides[0], sides[1], fps=0.0)
