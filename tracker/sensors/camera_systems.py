"""Differences between operating systems in listing, opening and locking cameras.

Tested on Linux; Windows and macOS follow the documentation of OpenCV and cv2_enumerate_cameras and
are tested with fakes.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Protocol

import cv2

from tracker.base.errors import DeviceError
from tracker.base.notices import notice

LINUX, WINDOWS, MACOS = "linux", "win32", "darwin"  # prefix of `sys.platform`


@dataclass(frozen=True)
class CameraName:
    """A camera of the system: ``index`` for opening, ``name`` for display.

    An index is valid only for the ``backend`` that returned it.
    """

    index: int
    name: str
    path: str
    backend: int = cv2.CAP_ANY


class Listed(Protocol):
    """The part of `cv2_enumerate_cameras.CameraInfo` that is used."""

    @property
    def index(self) -> int: ...

    @property
    def name(self) -> str: ...

    @property
    def path(self) -> str | None: ...


def backends(system: str = sys.platform) -> tuple[int, ...]:
    """OpenCV's backends for the system's cameras, the preferred one first.

    DirectShow opens at once where Media Foundation may take half a minute (opencv issue 17687).
    """
    if system.startswith(LINUX):
        return (cv2.CAP_V4L2,)
    if system == WINDOWS:
        return (cv2.CAP_DSHOW, cv2.CAP_MSMF)
    if system == MACOS:
        return (cv2.CAP_AVFOUNDATION,)
    return ()


def exposure_switch(system: str = sys.platform) -> tuple[float, float]:
    """`cv2.CAP_PROP_AUTO_EXPOSURE` for manual and for automatic: V4L2 has its own numbers."""
    return (1.0, 3.0) if system.startswith(LINUX) else (0.0, 1.0)


def is_device_path(source: str, system: str = sys.platform) -> bool:
    """Whether a camera's address is a device of the system; only Linux has them as files."""
    return system.startswith(LINUX) and source.startswith("/dev/")


def _enumerate(backend: int) -> Iterable[Listed]:
    # deferred: on macOS the package does not load without AVFoundation's bindings
    from cv2_enumerate_cameras import enumerate_cameras

    cameras: Iterable[Listed] = enumerate_cameras(backend)
    return cameras


def list_cameras(
    system: str = sys.platform, enumerate_with: Callable[[int], Iterable[Listed]] = _enumerate
) -> list[CameraName]:
    """All cameras of the system by name, of the first backend that has any.

    Raises DeviceError where the system's cameras cannot be listed; they still open by number.
    """
    problem = "nothing here knows how"
    answered = False
    for backend in backends(system):
        try:
            found = [
                CameraName(c.index, c.name, c.path or "", backend) for c in enumerate_with(backend)
            ]
        except (NotImplementedError, ImportError, OSError, RuntimeError) as error:
            problem = str(error).rstrip(".!") or type(error).__name__
            continue
        answered = True
        if found:
            return found
    if answered:
        return []
    raise DeviceError(notice("camera.not_listed", why=problem))
