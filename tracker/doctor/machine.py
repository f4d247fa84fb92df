"""How the checks reach the computer and its devices; tests replace parts of it with fakes."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from tracker.base.urgency import may_run_first
from tracker.sensors.camera_controls import HasCaptures
from tracker.sensors.camera_plugins import all_cameras
from tracker.sensors.image_input import CameraName, CaptureFormat, StreamInput
from tracker.sensors.serial_line import Port, UsbPort, serial_port, usb_ports


def is_accessible(path: str) -> bool:
    """Whether this user may read and write a device file."""
    return os.access(path, os.R_OK | os.W_OK)


def open_camera(camera: CameraName, want: CaptureFormat) -> HasCaptures:
    """The images of one device; two side by side count as one image."""
    return StreamInput(camera.index, want, cameras=1)


def writing_speed(folder: Path, size_mb: int) -> float:
    """MB/s at which a new file reaches the disk. Raises OSError if it cannot be written."""
    block = os.urandom(1 << 20)
    path = folder / f".glovetrack-doctor-{os.getpid()}"
    try:
        with path.open("wb", buffering=0) as file:
            start = time.perf_counter()
            for _ in range(size_mb):
                file.write(block)
            os.fsync(file.fileno())
            return size_mb / max(time.perf_counter() - start, 1e-6)
    finally:
        path.unlink(missing_ok=True)


@dataclass(frozen=True)
class Machine:
    """A computer with its devices. Times in s."""

    folder: Path
    """Where recordings are written."""
    system: str = sys.platform
    root: Path = Path("/")
    """Parent of ``dev``, ``sys`` and ``etc``."""
    usb_ports: Callable[[], Sequence[UsbPort]] = usb_ports
    open_port: Callable[[str, int], Callable[[], Port]] = serial_port
    is_accessible: Callable[[str], bool] = is_accessible
    cameras: Callable[[], Sequence[CameraName]] = all_cameras
    open_camera: Callable[[CameraName, CaptureFormat], HasCaptures] = open_camera
    may_run_first: Callable[[], bool] = may_run_first
    writing_speed: Callable[[Path, int], float] = writing_speed
    clock: Callable[[], float] = time.monotonic
    timeout: float = 4.0
    """For a device that is starting."""
    duration: float = 2.0
    """For the measurement of each device."""
    fps: float = 30.0
    """Images per second that a camera is asked for."""
    in_use: frozenset[str] = frozenset()
    """Paths of the devices that this program itself has open."""

    @property
    def is_linux(self) -> bool:
        return self.system.startswith("linux")
