"""A computer with fake devices, each broken in one way."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from pathlib import Path

import cv2
import numpy as np

from tests.sensors.scripted_glove import N, Scripted
from tracker.doctor.machine import Machine
from tracker.sensors.camera_systems import CameraName
from tracker.sensors.image_input import CaptureFormat
from tracker.sensors.protocol import Hello
from tracker.sensors.serial_line import UsbPort

PORT = UsbPort("/dev/ttyUSB0", 0x0403, 0x6001, "A1")
CAMERA = CameraName(0, "Test camera", "/dev/video0")
HELLO = Hello(glove_id=5, imu_count=N, firmware=(99, 0, 0))


class TunableGlove(Scripted):
    """A scripted glove on a line with a fixed speed: at another one it is garbage."""

    baudrate = 250_000
    own_baud = 250_000

    def read(self, size: int) -> bytes:
        data = super().read(size)
        return data if self.baudrate == self.own_baud else bytes(b ^ 0x5A for b in data)

    def write(self, data: bytes) -> int:
        if self.baudrate != self.own_baud:
            self.out += b"\x37\x13"  # what a UART makes of it
            return len(data)
        return super().write(data)


@dataclass
class FakeCapture:
    """The OpenCV properties of a camera: granted format, lockable exposure, timestamps."""

    values: dict[int, float]
    has_exposure: bool = True
    keeps_lock: bool = True

    def get(self, prop: int) -> float:
        if prop in (cv2.CAP_PROP_EXPOSURE, cv2.CAP_PROP_AUTO_EXPOSURE) and not self.has_exposure:
            return -1.0
        return self.values.get(prop, -1.0)

    def set(self, prop: int, value: float) -> bool:
        if not self.has_exposure or prop not in self.values:
            return False
        if prop == cv2.CAP_PROP_AUTO_EXPOSURE and not self.keeps_lock:
            return True  # accepts it and remains automatic
        self.values[prop] = value
        return True


@dataclass(eq=False)
class FakeCamera:
    """Gives an image each ``1 / fps`` s of the fake clock."""

    clock: FakeClock
    fps: float = 30.0
    granted: tuple[int, int, float] = (1280, 720, 30.0)
    capture: FakeCapture = field(default_factory=lambda: FakeCapture({}))
    stamps: bool = True
    dark: bool = False
    images: int = 10**6
    name: str = "fake"
    live: bool = True

    def open(self) -> None:
        width, height, fps = self.granted
        self.capture.values |= {
            cv2.CAP_PROP_FRAME_WIDTH: width,
            cv2.CAP_PROP_FRAME_HEIGHT: height,
            cv2.CAP_PROP_FPS: fps,
            cv2.CAP_PROP_FOURCC: cv2.VideoWriter.fourcc(*"YUYV"),
            cv2.CAP_PROP_EXPOSURE: 157.0,
            cv2.CAP_PROP_AUTO_EXPOSURE: 3.0,
        }
        self.number = 0

    def read(self):
        if self.number >= self.images:
            return None
        self.clock.t += 1 / self.fps
        self.number += 1
        ms = 1000 * self.clock.t if self.stamps else 0.0
        self.capture.values[cv2.CAP_PROP_POS_MSEC] = ms
        level = 0 if self.dark else 100 + self.number % 100
        return np.full((90, 160, 3), level, np.uint8), None

    def captures(self):
        return [self.capture]

    def close(self) -> None: ...


@dataclass
class FakeClock:
    t: float = 5.0

    def __call__(self) -> float:
        self.t += 1e-4
        return self.t


def refuse(number: int) -> Callable[[str, int], Callable[[], object]]:
    """Ports that cannot be opened."""

    def open_port(path: str, baud: int) -> Callable[[], object]:
        def fail() -> object:
            raise OSError(number, "no")

        return fail

    return open_port


def bare(folder: Path, **changes: object) -> Machine:
    """A computer without devices; ``changes`` adds some."""
    machine = Machine(
        folder,
        system="linux",
        root=folder,
        usb_ports=list,
        cameras=list,
        is_accessible=lambda path: True,
        writing_speed=lambda where, size: 500.0,
        timeout=2.0,
        duration=1.0,
    )
    return replace(machine, **changes)


def with_glove(folder: Path, glove: Scripted, **changes: object) -> Machine:
    def clock() -> float:
        glove.step()
        return glove.t

    return bare(
        folder,
        usb_ports=lambda: [PORT],
        open_port=lambda path, baud: lambda: opened(glove, baud),
        clock=clock,
        **changes,
    )


def opened(glove: Scripted, baud: int) -> Scripted:
    if isinstance(glove, TunableGlove):
        glove.baudrate = baud
    return glove


def with_camera(folder: Path, camera: FakeCamera, **changes: object) -> Machine:
    def open_camera(name: CameraName, want: CaptureFormat) -> FakeCamera:
        return camera

    return bare(
        folder,
        cameras=lambda: [CAMERA],
        open_camera=open_camera,
        clock=camera.clock,
        **changes,
    )
