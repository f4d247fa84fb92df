"""The camera that the user chose, as the settings store it, and how it is opened.

``""`` the first camera; ``name:NAME`` a camera by its name, so that it is found on another port;
``pair:LEFT|RIGHT`` two cameras by name, or two addresses; a number an index; ``driver://id`` a
plug-in's camera;
anything else a file or an address. The prefix ``one:`` states that its images are of one camera,
``two:`` that they are two side by side; else the calibration decides, or their shape.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace
from pathlib import Path

from app.storage.settings import AppSettings
from tracker.base.errors import DeviceError
from tracker.base.notices import Notice, notice
from tracker.sensors.camera_controls import ControlledInput, Locks, locks_from
from tracker.sensors.camera_plugins import all_cameras, is_plugin, open_plugin
from tracker.sensors.camera_stamps import HasStamps
from tracker.sensors.image_input import (
    CameraName,
    CaptureFormat,
    HasShortfalls,
    ImageInput,
    Pair,
    StreamInput,
    TwoCameraInput,
)

NAME, PAIR = "name:", "pair:"
ONE, TWO = "one:", "two:"


@dataclass(frozen=True)
class ChosenCamera:
    """An image input that is not open yet; ``title`` is shown; ``controls`` only of devices."""

    source: ImageInput
    title: str
    controls: ControlledInput | None


class Exchanged:
    """An image input whose left and right images are exchanged."""

    def __init__(self, inner: ImageInput) -> None:
        self._inner = inner
        self.name, self.live, self.fps = inner.name, inner.live, inner.fps

    def open(self) -> None:
        self._inner.open()
        self.fps = self._inner.fps  # known only now for some devices

    def read(self) -> Pair | None:
        pair = self._inner.read()
        if pair is None or pair[1] is None:
            return pair  # a single camera has nothing to exchange
        return pair[1], pair[0]

    def stamp(self) -> float:
        """s, the driver's time stamp of the last image; NaN where there is none."""
        return self._inner.stamp() if isinstance(self._inner, HasStamps) else math.nan

    def shortfalls(self) -> list[Notice]:
        """Requests that the devices do not fulfil."""
        inner = self._inner
        return inner.shortfalls() if isinstance(inner, HasShortfalls) else []

    def close(self) -> None:
        self._inner.close()


def by_name(camera: CameraName) -> str:
    """The settings' text for a camera by its name."""
    return NAME + camera.name


def by_names(left: CameraName, right: CameraName) -> str:
    """The settings' text for two; cameras of the same model are distinguished by index."""
    if left.name == right.name:
        return f"{PAIR}{left.index}|{right.index}"
    return f"{PAIR}{left.name}|{right.name}"


def is_address(text: str) -> bool:
    """Whether it is a file or a stream, not the name or number of a camera."""
    return "://" in text or Path(text).is_absolute()


def stated_count(camera: str) -> tuple[int, str]:
    """The number of cameras that the prefix of the settings' text states (0 without one), and
    the text without it."""
    for count, prefix in ((1, ONE), (2, TWO)):
        if camera.startswith(prefix):
            return count, camera.removeprefix(prefix)
    return 0, camera


def choose(
    settings: AppSettings,
    width: int,
    height: int,
    fps: float,
    cameras: list[CameraName] | None = None,
    count: int = 0,
    right_size: tuple[int, int] | None = None,
) -> ChosenCamera:
    """The camera that the settings name, for images of ``width`` by ``height`` px each; the right
    one of two devices may have another ``right_size``.

    ``count`` is the number of cameras of its calibration, 0 without one. Raises DeviceError
    if it is not connected.
    """
    known = all_cameras() if cameras is None else cameras
    stated, chosen = stated_count(settings.camera)
    each = CaptureFormat(width, height, fps)
    right = replace(each, width=right_size[0], height=right_size[1]) if right_size else each
    wanted = _Wanted(each, stated or count, right)
    found = _choose(chosen, wanted, locks_from(settings.camera_locks), known)
    if not settings.camera_exchanged:
        return found
    return replace(found, source=Exchanged(found.source))


@dataclass(frozen=True)
class _Wanted:
    """The format of one camera's image, the number of cameras (0: unknown), and the format of a
    right camera that is a device of its own."""

    each: CaptureFormat
    count: int
    right: CaptureFormat

    def stream(self, source: int | str, backend: int = 0, live: bool = True) -> StreamInput:
        """The input of a stream that contains them."""
        columns = 1 if self.count == 1 else 2
        want = replace(self.each, width=columns * self.each.width, backend=backend)
        return StreamInput(source, want, live, self.count)


def _choose(chosen: str, wanted: _Wanted, locks: Locks, known: list[CameraName]) -> ChosenCamera:
    if chosen.startswith(PAIR):
        left, _, right = chosen.removeprefix(PAIR).partition("|")
        if is_address(left):
            streams = TwoCameraInput(left, right, wanted.each, wanted.right)
            return ChosenCamera(streams, streams.name, None)
        pair = [_find(name, known) for name in (left, right)]
        formats = (
            replace(wanted.each, backend=pair[0].backend),
            replace(wanted.right, backend=pair[1].backend),
        )
        two = TwoCameraInput(pair[0].index, pair[1].index, *formats)
        controls = ControlledInput(two, locks, tuple(camera.path for camera in pair))
        return ChosenCamera(controls, f"{pair[0].name} and {pair[1].name}", controls)
    if is_plugin(chosen):
        return ChosenCamera(open_plugin(chosen, wanted.each), chosen, None)
    if chosen and not chosen.isdigit() and not chosen.startswith(NAME):
        live = not Path(chosen).is_file()
        return ChosenCamera(wanted.stream(chosen, live=live), chosen, None)
    camera = _find(chosen.removeprefix(NAME), known)
    if is_plugin(camera.path):
        return ChosenCamera(open_plugin(camera.path, wanted.each), camera.name, None)
    stream = wanted.stream(camera.index, camera.backend)
    controls = ControlledInput(stream, locks, (camera.path,))
    return ChosenCamera(controls, camera.name, controls)


def _find(wanted: str, cameras: list[CameraName]) -> CameraName:
    """Find a camera by name or index; the first one for an empty text."""
    if wanted.isdigit():
        index = int(wanted)
        named = (c for c in cameras if c.index == index)
        # a system that lists no names still opens cameras by number
        return next(named, CameraName(index, f"camera {index}", ""))
    if not cameras:
        raise DeviceError(notice("camera.none_found"))
    if not wanted:
        return cameras[0]
    for camera in cameras:
        if camera.name == wanted:
            return camera
    raise DeviceError(
        notice("camera.not_among", camera=wanted, connected=[c.name for c in cameras])
    )
