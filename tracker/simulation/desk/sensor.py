"""Converts linear light to a camera's image: noise, tone curve and JPEG."""

from __future__ import annotations

from typing import NamedTuple

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.kernels import kernel
from tracker.kernels.arrays import (
    ByteStack,
    ByteVector,
    Float32Stack,
    Float32Vector,
    IntVector,
    Written,
)
from tracker.messages import Array
from tracker.simulation.desk.lights import RoomLight, tone_curve

Image = NDArray[np.uint8]
LEVELS = 4096


class Sensor(NamedTuple):
    """For each channel BGR: variance per linear value (3,) and in darkness (3,); the tone curve
    (LEVELS,) for 0..2; a tile of noise (n, n, 3) of unit variance."""

    shot: Float32Vector
    dark: Float32Vector
    curve: ByteVector
    noise: Float32Stack


def sensor_of(light: RoomLight, rng: np.random.Generator) -> Sensor:
    """The sensor in a light: a channel amplified by white balance has more noise."""
    gain = np.array([1.35, 0.85, 1.15])  # of white balance: a sensor is most sensitive to green
    return Sensor(
        (light.shot * gain).astype(np.float32),
        ((light.read * gain) ** 2).astype(np.float32),
        tone_curve(light.shoulder, LEVELS),
        bayer_noise(rng),
    )


def bayer_noise(rng: np.random.Generator, side: int = 512) -> NDArray[np.float32]:
    """(side, side, 3) noise of a colour sensor of unit variance, periodic.

    Every pixel measures one colour and interpolates the others from its neighbours (bilinear
    demosaicing of the pattern BGGR), so that noise is correlated over two pixels.
    """
    raw = rng.standard_normal((side, side)).astype(np.float32)
    out = np.empty((side, side, 3), np.float32)
    cross = np.array([[1, 2, 1], [2, 4, 2], [1, 2, 1]], np.float32) / 4
    plus = np.array([[0, 1, 0], [1, 4, 1], [0, 1, 0]], np.float32) / 4
    row, column = np.indices((side, side)) % 2
    masks = (row + column == 0, (row + column) == 1, (row * column) == 1)
    for c, (mask, spread) in enumerate(zip(masks, (cross, plus, cross), strict=True)):
        padded = np.pad(raw * mask, 1, mode="wrap")
        plane = cv2.filter2D(padded, -1, spread)[1:-1, 1:-1]
        out[..., c] = plane / plane.std()
    return out


@kernel(fastmath=True)
def develop(light: Float32Stack, s: Sensor, shift: IntVector, out: Written[ByteStack]) -> None:
    """Converts linear ``light`` (h, w, 3) with noise and the tone curve to ``out`` (h, w, 3).

    shift (2,) is the image's origin in the tile of noise.
    """
    noise, curve = s.noise, s.curve
    rows, columns = noise.shape[0], noise.shape[1]
    top, scale = np.int32(len(curve) - 1), np.float32((len(curve) - 1) / 2)
    zero, half = np.float32(0.0), np.float32(0.5)
    for v in range(light.shape[0]):
        row = (v + shift[0]) % rows
        begin = 0
        while begin < light.shape[1]:
            first = (begin + shift[1]) % columns
            end = min(begin + columns - first, light.shape[1])
            for u in range(begin, end):
                for c in range(3):
                    x = max(light[v, u, c], zero)
                    x += np.sqrt(s.shot[c] * x + s.dark[c]) * noise[row, first + u - begin, c]
                    k = np.int32(max(x * scale + half, zero))
                    out[v, u, c] = curve[min(k, top)]
            begin = end


def through_jpeg(image: Image, quality: int) -> Image:
    """The image after a camera's compression: colour at half the resolution (4:2:0)."""
    sampling = int(cv2.IMWRITE_JPEG_SAMPLING_FACTOR_420)
    flags = [cv2.IMWRITE_JPEG_QUALITY, quality, cv2.IMWRITE_JPEG_SAMPLING_FACTOR, sampling]
    packed = cv2.imencode(".jpg", image, flags)[1]
    return np.asarray(cv2.imdecode(packed, cv2.IMREAD_COLOR), np.uint8)


def leaked(light: Array, share: float) -> Array:
    """Linear colours (…, 3) with a ``share`` of the other channels added to red."""
    return light + share * (light[..., :1] + light[..., 1:2]) * np.array([0.0, 0.0, 1.0])
