"""Which camera the user chose, as the settings hold it, and how it is opened.

``""`` the first camera; ``name:NAME`` a camera by its name, so that it is found on another port;
``pair:LEFT|RIGHT`` two cameras by name; a number an index; ``driver://id`` a plug-in's camera;
anything else a file or an address.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

from app.storage.settings import AppSettings
from app.words import tr
from tracker.errors import DeviceError
from tracker.sensors.camera_controls import ControlledInput, Locks, locks_from
from tracker.sensors.camera_plugins import all_cameras, is_plugin, open_plugin
from tracker.sensors.image_input import (
    CameraName,
    CaptureFormat,
    ImageInput,
    Pair,
    SideBySideInput,
    TwoCameraInput,
)

NAME, PAIR = "name:", "pair:"


@dataclass(frozen=True)
class ChosenCamera:
    """An image input that is not open yet; ``title`` for people; ``controls`` of devices only."""

    source: ImageInput
    title: str
    controls: ControlledInput | None


class Exchanged:
    """An image input whose left and right images change places."""

    def __init__(self, inner: ImageInput) -> None:
        self._inner = inner
        self.name, self.live, self.fps = inner.name, inner.live, inner.fps

    def open(self) -> None:
        self._inner.open()
        self.fps = self._inner.fps  # some devices know it only now

    def read(self) -> Pair | None:
        pair = self._inner.read()
        return None if pair is None else (pair[1], pair[0])

    def close(self) -> None:
        self._inner.close()


def by_name(camera: CameraName) -> str:
    """The settings' text for one camera."""
    return NAME + camera.name


def by_names(left: CameraName, right: CameraName) -> str:
    """The settings' text for two; cameras of one model are told apart by their index."""
    if left.name == right.name:
        return f"{PAIR}{left.index}|{right.index}"
    return f"{PAIR}{left.name}|{right.name}"


def choose(
    settings: AppSettings,
    width: int,
    height: int,
    fps: float,
    cameras: list[CameraName] | None = None,
) -> ChosenCamera:
    """The camera that the settings name, for images of ``width`` by ``height`` px each.

    Raises DeviceError where it is not there.
    """
    known = all_cameras() if cameras is None else cameras
    locks = locks_from(settings.camera_locks)
    found = _choose(settings.camera, width, height, fps, locks, known)
    if not settings.camera_exchanged:
        return found
    return replace(found, source=Exchanged(found.source))


def _choose(
    chosen: str, width: int, height: int, fps: float, locks: Locks, known: list[CameraName]
) -> ChosenCamera:
    side_by_side = CaptureFormat(2 * width, height, fps)
    if chosen.startswith(PAIR):
        left, _, right = chosen.removeprefix(PAIR).partition("|")
        pair = [_find(name, known) for name in (left, right)]
        one_eye = CaptureFormat(width, height, fps, backend=pair[0].backend)
        two = TwoCameraInput(pair[0].index, pair[1].index, one_eye)
        controls = ControlledInput(two, locks)
        return ChosenCamera(controls, f"{pair[0].name} and {pair[1].name}", controls)
    one_eye = CaptureFormat(width, height, fps)
    if is_plugin(chosen):
        return ChosenCamera(open_plugin(chosen, one_eye), chosen, None)
    if chosen and not chosen.isdigit() and not chosen.startswith(NAME):
        live = not Path(chosen).is_file()
        return ChosenCamera(SideBySideInput(chosen, side_by_side, live), chosen, None)
    camera = _find(chosen.removeprefix(NAME), known)
    if is_plugin(camera.path):
        return ChosenCamera(open_plugin(camera.path, one_eye), camera.name, None)
    wanted = replace(side_by_side, backend=camera.backend)
    controls = ControlledInput(SideBySideInput(camera.index, wanted), locks)
    return ChosenCamera(controls, camera.name, controls)


def _find(wanted: str, cameras: list[CameraName]) -> CameraName:
    """By name or index; the first of all for an empty wish."""
    if wanted.isdigit():
        index = int(wanted)
        named = (c for c in cameras if c.index == index)
        # a system that lists no names still opens cameras by number
        return next(named, CameraName(index, f"camera {index}", ""))
    if not cameras:
        raise DeviceError(
            tr(
                "No camera was found. Plug in the stereo camera and look again, or, where the "
                "system lists no cameras, enter its number under Set-up, Camera "
                "(0 is the first one)."
            )
        )
    if not wanted:
        return cameras[0]
    for camera in cameras:
        if camera.name == wanted:
            return camera
    there = ", ".join(c.name for c in cameras)
    raise DeviceError(
        tr(
            "The camera {} is not there; there are: {}. Plug it in, or choose another one "
            "under Set-up, Camera."
        ).format(wanted, there)
    )
