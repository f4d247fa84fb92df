"""Cameras with a driver package of their own: depthai, pyrealsense2, the ZED SDK.

Such a package is a plug-in: it names a `CameraDriver` under the entry-point group
``glovetrack.cameras`` and is installed beside Glovetrack. See docs/camera-plugins.md.
"""

from __future__ import annotations

import logging
from collections.abc import Sequence
from typing import Protocol

from tracker.base.errors import ConfigError, DeviceError
from tracker.base.notices import notice
from tracker.base.registry import Registry
from tracker.sensors.image_input import CameraName, CaptureFormat, ImageInput, list_cameras

DRIVERS = Registry("cameras", "camera plug-in", type)
"""Classes of `CameraDriver`."""
_log = logging.getLogger(__name__)


class CameraDriver(Protocol):
    """A plug-in's interface; created without arguments for each query."""

    def cameras(self) -> Sequence[tuple[str, str]]:
        """The connected cameras: a persistent id and a display name for each."""

    def open(self, camera: str, want: CaptureFormat) -> ImageInput:
        """The camera with this id, not yet open. ``want`` is for one eye's image."""


def plugin_cameras() -> list[CameraName]:
    """All cameras of all plug-ins. ``path`` is ``driver://id``; a driver that fails has none."""
    out: list[CameraName] = []
    for plugin, driver in DRIVERS.all().items():
        try:
            found = _made(driver).cameras()
            out += [CameraName(-1, name, f"{plugin}://{camera}") for camera, name in found]
        except Exception as error:  # noqa: BLE001 - an error in a plug-in must not stop the program
            _log.warning("The camera plug-in %s does not work: %s", plugin, error)
    return out


def all_cameras() -> list[CameraName]:
    """The system's cameras and those of plug-ins, also if the system's cannot be listed."""
    try:
        known = list_cameras()
    except DeviceError as error:
        _log.warning("%s", error)
        known = []
    return [*known, *plugin_cameras()]


def is_plugin(address: str) -> bool:
    """Whether an address such as ``folder:///srv/images`` is a plug-in's."""
    return address.partition("://")[0] in DRIVERS.names()


def open_plugin(address: str, want: CaptureFormat) -> ImageInput:
    """The image input behind ``driver://id``. Raises DeviceError in words."""
    name, _, camera = address.partition("://")
    if name not in DRIVERS.names():
        raise DeviceError(notice("camera.no_plugin", name=name))
    try:
        return _made(DRIVERS.get(name)).open(camera, want)
    except DeviceError:
        raise
    except ConfigError as error:
        raise DeviceError(error.notice) from error
    except Exception as error:
        raise DeviceError(notice("camera.plugin_failed", name=name, why=error)) from error


def _made(driver: type) -> CameraDriver:
    made: CameraDriver = driver()
    return made
