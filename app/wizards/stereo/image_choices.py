"""Where the stereo calibration may take its images from."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from pathlib import Path

from app.engines.camera_choice import NAME, PAIR, choose
from app.engines.engine import one_camera
from app.engines.engine_host import EngineHost
from app.engines.hardware import FPS, HEIGHT, WIDTH
from app.storage.settings import AppSettings
from app.wizards.stereo.board import ImageChoice
from app.words import tr
from tracker.errors import DeviceError
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
    """An `ImageInput` of the images that the open session receives."""

    host: EngineHost
    live: bool = True
    name: str = field(default_factory=lambda: tr("camera in use"))
    fps: float = 0.0
    _last: int = -1

    def open(self) -> None:
        """The session has opened it."""

    def read(self) -> Pair | None:
        setup = self.host.setup
        if setup is None:
            raise DeviceError(tr("The camera in use was closed: start glove and camera again."))
        latest = setup.tracked.latest_frame()
        if latest is None or latest[0].index == self._last:
            return None
        frame = latest[0]
        self._last = frame.index
        if frame.left is None or (frame.right is None and not one_camera(setup, frame)):
            return None
        return frame.left, frame.right

    def close(self) -> None:
        """The session closes it."""


def image_choices(
    host: EngineHost, settings: AppSettings, cameras: list[CameraName]
) -> list[ImageChoice]:
    """All of them, the likeliest first."""
    from tracker.simulation.board_camera import BoardCamera

    setup = host.setup
    rig = setup.rig if setup is not None and setup.simulated else ideal_rig()
    simulated = ImageChoice(tr("Simulated board (demo)"), lambda spec: BoardCamera(rig, spec), True)

    def choice(title: str, camera: str) -> ImageChoice:
        wanted = replace(settings, camera=camera)
        return ImageChoice(title, lambda _spec: choose(wanted, WIDTH, HEIGHT, FPS, cameras).source)

    found = [
        # a plug-in's camera has no index
        choice(f"{c.name} ({c.path or c.index})", str(c.index) if c.index >= 0 else c.path)
        for c in cameras
    ]
    if settings.camera:
        words = settings.camera.removeprefix(NAME).removeprefix(PAIR).replace("|", " + ")
        found.insert(0, choice(tr("Chosen camera: {}").format(words), settings.camera))
    if setup is None or setup.player is not None or not setup.has_camera:
        return [*found, simulated]
    if setup.simulated:
        return [simulated, *found]
    return [ImageChoice(tr("Camera in use"), lambda _spec: SessionImages(host)), simulated]


def folder_choice(folder: Path) -> ImageChoice:
    """Images on disk: names with left and right in them, in the order of their names; all of them
    one camera's where no name has either."""
    return ImageChoice(tr("Folder {}").format(folder.name), lambda _spec: folder_input(folder))


def folder_input(folder: Path) -> ImageInput:
    """Raises DeviceError where there are not as many left as right images."""
    files = sorted(p for p in folder.iterdir() if p.suffix.lower() in SUFFIXES)
    sides = [[p for p in files if side in p.name.lower()] for side in ("left", "right")]
    if not any(sides):
        return SequenceInput(files, None, fps=0.0)
    return SequenceInput(sides[0], sides[1], fps=0.0)
