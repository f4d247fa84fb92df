"""A glove and a stereo camera on the caller's clock, with all faults of cables and cameras.

`glove_device` simulates a glove in real time on a pseudo-terminal; here the port itself is
simulated, so that hours of faults are simulated in minutes and are reproducible.

The camera's images are drawn in a millisecond: an ellipse for each visible marker, on sensor noise.
They are processed by the ordinary camera code and detector; `render` draws realistic images.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator

import cv2
import numpy as np

from tracker.base.errors import DeviceError
from tracker.base.notices import notice
from tracker.messages import Blobs, ImuSample
from tracker.sensors.decoder import FrameDecoder
from tracker.sensors.image_input import Image, Pair
from tracker.sensors.protocol import (
    BAUD,
    BITS_PER_BYTE,
    Frame,
    GloveStatus,
    Haptic,
    Hello,
    HelloRequest,
    Samples,
    Start,
    Stop,
    encode,
)
from tracker.simulation.backgrounds import fabric_bgr
from tracker.simulation.electric import ELECTRIC_FAULTS, REFUSALS, ElectricFault
from tracker.simulation.glove_device import ACCEL_RANGE_G, GYRO_RANGE_DPS, quantised
from tracker.simulation.scene import SimulatedScene

GLOVE_FAULTS = ("lose", "corrupt", "garbage", "unplug", "stall", "silence", "reset", "clock jump")
BOOT = 0.3  # s for the chip to start after power returns
LONGEST_JUMP = 30.0  # s
BUFFER_BYTES = 20_000  # size of the system's buffer for a stalled line; more is lost


class VirtualGlove:
    """Also its own `Port`. ``source`` gives samples whose t = 0 is the clock's zero."""

    timeout: float | None = 0.0
    wire_baud = BAUD  # a packet is delayed by the transmission of its bytes

    def __init__(self, source: Iterator[ImuSample], imu_count: int, seed: int = 0) -> None:
        self._source, self._imu_count = source, imu_count
        self._rng = np.random.default_rng(seed)
        self._next = next(source, None)
        self._wire = BITS_PER_BYTE * (12 * imu_count + 11) / BAUD
        self._fault = ""
        self._electric = ElectricFault("", 0.0, self._rng)
        self._out = b""
        self._sent: deque[int] = deque(maxlen=1000)
        self.now = self._ready_at = 0.0
        self._restart()

    def _restart(self) -> None:
        self._started, self._jumped, self._seq, self._streaming = self.now, 0.0, 0, False
        self._next_hello, self._next_status = max(self._ready_at, self.now), self.now + 1.0
        self._decoder = FrameDecoder()

    # ---- the caller's side

    def next_event(self) -> float:
        """Time at which the next packet is completely sent, s."""
        return self._next.t + self._wire if self._next is not None else float("inf")

    def advance(self, now: float) -> None:
        """Advance the time to ``now`` (s)."""
        self.now = now
        while self._next is not None and self._next.t + self._wire <= now:
            if self._electric.is_reset_due(now):
                self._reset()
            if self._streaming:
                self._send(self._packet(self._next))
            self._next = next(self._source, None)
        self._send_all()

    def _send_all(self) -> None:
        """HELLO until START, STATUS once a second after it."""
        if self._streaming and self.now >= self._next_status:
            self._next_status = self.now + 1.0
            self._send(GloveStatus(3700, 2900, (1 << self._imu_count) - 1, 0))
        elif not self._streaming and self.now >= self._next_hello:
            self._next_hello = self.now + 1.0
            self._put(encode(self._hello()))

    def fail(self, kind: str) -> None:
        """Start one of `GLOVE_FAULTS` or `ELECTRIC_FAULTS`."""
        if kind in ELECTRIC_FAULTS:
            self._electric = ElectricFault(kind, self.now, self._rng)
            return
        self._fault = kind
        if kind == "unplug":
            self._out, self._streaming = b"", False
        elif kind == "reset":
            self._reset()
        elif kind == "garbage":
            self._out += self._rng.bytes(int(self._rng.integers(1, 600)))
        elif kind == "clock jump":
            self._jumped += float(self._rng.uniform(-1, 1)) * LONGEST_JUMP

    def heal(self) -> None:
        """End the fault: the cable is plugged in, the line works."""
        if self._fault == "unplug":
            self._ready_at = self.now + BOOT
            self._restart()
        self._fault = ""
        self._electric = ElectricFault("", self.now, self._rng)

    def _reset(self) -> None:
        self._ready_at = self.now + BOOT
        self._restart()

    # ---- the firmware

    def _send(self, frame: Frame) -> None:
        self._put(encode(self._electric.frame(frame, self.now)))

    def _packet(self, sample: ImuSample) -> Samples:
        t_us = round((sample.t - self._started + self._jumped + 100.0) * 1e6)
        seq, self._seq = self._seq, (self._seq + 1) % 65536
        return Samples(seq, t_us % 2**32, quantised(sample))

    def _hello(self) -> Hello:
        return Hello(1, self._imu_count, GYRO_RANGE_DPS, ACCEL_RANGE_G)

    def _put(self, data: bytes) -> None:
        if self._fault in ("unplug", "silence") or self.now < self._ready_at:
            return
        if self._fault == "lose" and self._rng.random() < 0.5:
            return
        if self._fault == "corrupt" and self._rng.random() < 0.5:
            damaged = bytearray(data)
            damaged[int(self._rng.integers(len(data)))] ^= 1 << int(self._rng.integers(8))
            data = bytes(damaged)
        if len(self._out) < BUFFER_BYTES:
            self._out += self._electric.wire(data, self.now)

    # ---- the port's side

    def open(self) -> VirtualGlove:
        """Opens the port."""
        if self._fault == "unplug":
            raise FileNotFoundError(2, "No such file")
        if self._electric.kind in REFUSALS:
            raise REFUSALS[self._electric.kind]
        return self

    @property
    def is_suspended(self) -> bool:
        """Whether the system has suspended the adapter."""
        return self._electric.kind == "usb suspend"

    @property
    def in_waiting(self) -> int:
        return 0 if self._fault == "stall" else len(self._out)

    def read(self, size: int) -> bytes:
        if self._fault == "unplug":
            raise OSError(5, "Input/output error")
        size = min(size, self.in_waiting)
        data, self._out = self._out[:size], self._out[size:]
        return data

    def write(self, data: bytes) -> int:
        if self.now < self._ready_at:
            return len(data)
        for frame in self._decoder.feed(data):
            if isinstance(frame, HelloRequest):
                self._put(encode(self._hello()))
            elif isinstance(frame, Haptic) and self._electric.kind == "motor reset":
                self._reset()
            elif isinstance(frame, Start | Stop):
                self._streaming = isinstance(frame, Start)
        return len(data)

    def close(self) -> None:
        """Does nothing: the device continues to run."""


CAMERA_FAULTS = (
    "drop images", "torn", "unplug camera", "stall camera", "frozen", "black", "black left",
    "swapped", "lens up", "lens turned", "knocked",
)  # fmt: skip
MOVED = 0.005  # m
NOISE_IMAGES = 4
GREY, NOISE = 60, 12  # levels of the background and of its noise
SUBPIXEL = 4  # fractional bits of OpenCV's drawing functions


class VirtualCamera:
    """An `ImageInput` that shows ``scene`` at the time that was set last."""

    name, live = "virtual camera", True

    def __init__(self, scene: SimulatedScene, fps: float, seed: int = 0) -> None:
        self._scene, self.fps = scene, fps
        self._rng = np.random.default_rng(seed)
        rig = scene.rig
        sizes = [(camera.height, camera.width, 3) for camera in (rig.left, rig.right)]
        made = {size: self._noise_of(size) for size in sizes}  # once if both have the same size
        self._noise = [made[size] for size in sizes]
        self._bgr = [fabric_bgr(hue) for hue in scene.wearer.glove.hues]
        self._fault = ""
        self._last: Pair | None = None
        self.t = 0.0
        """Exposure of the next image, s."""

    def fail(self, kind: str) -> None:
        """Start one of `CAMERA_FAULTS`."""
        self._fault = kind

    def heal(self) -> None:
        """End the fault: a moved camera returns to its position."""
        self._fault = ""

    def _noise_of(self, shape: tuple[int, int, int]) -> list[Image]:
        return [
            self._rng.integers(GREY - NOISE, GREY + NOISE, shape, np.uint8)
            for _ in range(NOISE_IMAGES)
        ]

    @property
    def gives(self) -> bool:
        """Whether a read of this exposure would return."""
        if self._fault == "drop images":
            return bool(self._rng.random() < 0.5)
        return self._fault != "stall camera"

    # ---- an image input

    def open(self) -> None:
        if self._fault == "unplug camera":
            raise DeviceError(notice("camera.not_there", camera=self.name))

    def read(self) -> Pair | None:
        if self._fault == "unplug camera":
            return None
        if self._fault == "frozen" and self._last is not None:
            return self._last
        self._last = self._pair()
        return self._last

    def close(self) -> None:
        self._last = None

    # ---- drawing

    def _pair(self) -> Pair:
        frame = self._scene.blobs(self.t)
        assert frame.left is not None and frame.right is not None
        left, right = (
            self._draw(blobs, shift, noise)
            for blobs, shift, noise in zip(
                (frame.left, frame.right), self._shifts(), self._noise, strict=True
            )
        )
        if self._fault in ("black", "black left"):
            left = np.zeros_like(left)
        if self._fault == "black":
            right = np.zeros_like(right)
        if self._fault == "torn":
            self._tear(left)
        return (right, left) if self._fault == "swapped" else (left, right)

    def _shifts(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Displacement of the hand in a camera that has moved by 5 mm: (u, v) px of left and
        right."""
        if self._fault not in ("lens up", "lens turned", "knocked"):
            return (0.0, 0.0), (0.0, 0.0)
        wrist_C = self._scene.instant(self.t).p_CB[0]
        px = self._scene.rig.fx * MOVED / float(wrist_C[2])
        if self._fault == "lens up":
            return (0.0, 0.0), (0.0, px)
        if self._fault == "lens turned":
            return (0.0, 0.0), (-px, 0.0)
        return (px, 0.0), (px, 0.0)

    def _draw(self, blobs: Blobs, shift: tuple[float, float], noise: list[Image]) -> Image:
        image = noise[int(self._rng.integers(NOISE_IMAGES))].copy()
        one = 1 << SUBPIXEL
        for uv, size, hue in zip(blobs.uv + np.array(shift), blobs.size, blobs.hue, strict=True):
            centre = (round(uv[0] * one), round(uv[1] * one))
            axes = (round(size[0] * one / 2), round(size[1] * one / 2))
            cv2.ellipse(image, centre, axes, 0, 0, 360, self._bgr[hue], -1, cv2.LINE_8, SUBPIXEL)
        return image

    def _tear(self, image: Image) -> None:
        """Simulates missing data of the decoder from a random row on."""
        row = int(self._rng.integers(image.shape[0] // 4, image.shape[0]))
        image[row:] = 128
