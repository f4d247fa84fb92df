"""A stereo camera on a clock of the caller's own, with every fault of a camera.

Its images are drawn in a millisecond: an ellipse for each marker that the scene shows, on sensor
noise. They go through the ordinary camera code and detector; `render` draws what is to look real.
"""

from __future__ import annotations

import cv2
import numpy as np

from tracker.base.errors import DeviceError
from tracker.messages import Blobs
from tracker.sensors.image_input import Image, Pair
from tracker.simulation.backgrounds import fabric_bgr
from tracker.simulation.scene import SimulatedScene

FAULTS = (
    "drop images", "torn", "unplug camera", "stall camera", "frozen", "black", "black left",
    "swapped", "lens up", "lens turned", "knocked",
)  # fmt: skip
MOVED = 0.005  # m
NOISE_IMAGES = 4
GREY, NOISE = 60, 12  # levels of the background and of its noise
SUBPIXEL = 4  # bits that OpenCV draws with


class VirtualCamera:
    """An `ImageInput` that shows ``scene`` at the instant set last."""

    name, live = "virtual camera", True

    def __init__(self, scene: SimulatedScene, fps: float, seed: int = 0) -> None:
        self._scene, self.fps = scene, fps
        self._rng = np.random.default_rng(seed)
        rig = scene.rig
        sizes = [(camera.height, camera.width, 3) for camera in (rig.left, rig.right)]
        made = {size: self._noise_of(size) for size in sizes}  # once where both have one size
        self._noise = [made[size] for size in sizes]
        self._bgr = [fabric_bgr(hue) for hue in scene.wearer.glove.hues]
        self._fault = ""
        self._last: Pair | None = None
        self.t = 0.0
        """Exposure of the next image, s."""

    def fail(self, kind: str) -> None:
        """Begin one of `FAULTS`."""
        self._fault = kind

    def heal(self) -> None:
        """End the fault: what was moved stands where it stood."""
        self._fault = ""

    def _noise_of(self, shape: tuple[int, int, int]) -> list[Image]:
        return [
            self._rng.integers(GREY - NOISE, GREY + NOISE, shape, np.uint8)
            for _ in range(NOISE_IMAGES)
        ]

    @property
    def gives(self) -> bool:
        """Whether a read of this exposure would come back at all."""
        if self._fault == "drop images":
            return bool(self._rng.random() < 0.5)
        return self._fault != "stall camera"

    # ---- an image input

    def open(self) -> None:
        if self._fault == "unplug camera":
            raise DeviceError(f"The {self.name} cannot be opened: it is not there.")

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
        """Where a camera that has moved by 5 mm sees the hand: (u, v) px of left and right."""
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
        """From some row on the decoder had no data."""
        row = int(self._rng.integers(image.shape[0] // 4, image.shape[0]))
        image[row:] = 128
