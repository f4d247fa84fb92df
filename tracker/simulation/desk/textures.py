"""Surfaces: wood and laminate, prints, and the texture of knitted cloth."""

from __future__ import annotations

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.simulation.backgrounds import FABRIC_HSV
from tracker.simulation.desk.lights import linear

Texture = NDArray[np.float32]

FELT_HSV = {
    **FABRIC_HSV,
    "red": (174, 250, 191),
    "yellow": (25, 248, 228),
    "green": (67, 238, 142),
    "blue": (107, 242, 170),
}
"""Felt of the markers' hues in uniform light, in OpenCV units."""
OTHERS_BGR = {
    "teal": (125, 120, 30),
    "orange": (15, 95, 215),
    "pink": (150, 90, 215),
    "note": (45, 200, 205),
    "paper": (200, 200, 200),
    "black": (32, 30, 28),
    "rose": (110, 90, 190),
}


def felt(hue: str) -> NDArray[np.float64]:
    """Linear BGR (3,) of felt, or of paint, of a hue or other colour name."""
    if hue in OTHERS_BGR:
        return linear(OTHERS_BGR[hue])
    hsv = np.array([[FELT_HSV[hue]]], np.uint8)
    return linear(np.asarray(cv2.cvtColor(hsv, cv2.COLOR_HSV2BGR)[0, 0], float))


def _noise(rng: np.random.Generator, shape: tuple[int, int], sd_px: tuple[float, float]) -> Texture:
    """Smooth noise (h, w) of unit variance; sd_px across (down, along)."""
    down, along = (max(s, 0.3) for s in sd_px)
    coarse = (int(np.ceil(shape[0] / down)) + 4, int(np.ceil(shape[1] / along)) + 4)
    small = cv2.GaussianBlur(rng.standard_normal(coarse).astype(np.float32), (0, 0), 1.0)
    big = cv2.resize(small, (shape[1], shape[0]), interpolation=cv2.INTER_CUBIC)
    return np.asarray(big / big.std(), np.float32)


def wood(rng: np.random.Generator, shape: tuple[int, int], texel: float) -> Texture:
    """(h, w, 3) linear BGR of planks with vertical grain."""
    mm = 1e-3 / texel
    grain = 0.5 * _noise(rng, shape, (90 * mm, 2.2 * mm)) + 0.35 * _noise(
        rng, shape, (25 * mm, 0.9 * mm)
    )
    cloud = _noise(rng, shape, (160 * mm, 45 * mm))
    plank = rng.uniform(0.11, 0.2) / texel
    number = (np.arange(shape[1]) / plank).astype(int)
    tone = rng.normal(1.0, 0.05, number.max() + 1)[number]
    bright = np.exp(0.13 * grain + 0.08 * cloud) * tone.astype(np.float32)
    seam = np.abs((np.arange(shape[1]) / plank) % 1 - 0.5) > 0.5 - 0.0011 / texel / plank
    bright[:, seam] *= 0.35
    base = np.array([0.0945, 0.203, 0.378]) * rng.uniform(0.85, 1.1)
    warm = np.exp(0.05 * cloud)
    return np.asarray(
        np.dstack([base[0] * bright / warm, base[1] * bright, base[2] * bright * warm]), np.float32
    )


def laminate(rng: np.random.Generator, shape: tuple[int, int], texel: float) -> Texture:
    """(h, w, 3) linear BGR of a grey desk."""
    mm = 1e-3 / texel
    fine, cloud = _noise(rng, shape, (2 * mm, 2 * mm)), _noise(rng, shape, (60 * mm, 60 * mm))
    bright = np.exp(0.06 * fine + 0.03 * cloud)
    return np.asarray(np.array([0.15, 0.165, 0.165]) * bright[..., None], np.float32)


SURFACES = {"wood": wood, "laminate": laminate}


def picture(rng: np.random.Generator, size: int = 96) -> Texture:
    """(size, size, 3) linear BGR of a print: soft colours, objects of the marker hues."""
    coarse = rng.uniform(20, 150, (4, 4, 3)).astype(np.float32)
    page = np.clip(cv2.resize(coarse, (size, size), interpolation=cv2.INTER_CUBIC), 5, 240)
    page = np.ascontiguousarray(page.astype(np.uint8))
    for _ in range(9):
        name = str(rng.choice(["red", "yellow", "green", "blue", "orange", "paper", "black"]))
        colour = 255 * felt(name) ** (1 / 2.2) * rng.uniform(0.7, 1.1)
        middle, axes = rng.integers(0, size, 2).tolist(), rng.integers(4, size // 4, 2).tolist()
        shade = tuple(float(c) for c in np.clip(colour, 0, 255))
        turn = float(rng.uniform(0, 180))
        cv2.ellipse(page, middle, axes, turn, 0, 360, shade, -1, cv2.LINE_AA)
    return np.asarray(linear(cv2.GaussianBlur(page, (0, 0), 1.2).astype(float)), np.float32)


def knit(rng: np.random.Generator, side: int = 256, texel: float = 0.0004) -> Texture:
    """(side, side) brightness of knitted cloth about 1, periodic."""
    white = rng.standard_normal((side, side)).astype(np.float32)
    fine = _wrapped_blur(white, 0.75)
    uneven = _wrapped_blur(rng.standard_normal((side, side)).astype(np.float32), 9.0)
    ribs = np.round(side * texel / 0.0021) * np.arange(side) / side
    rib = np.sin(2 * np.pi * ribs)[:, None]
    bright = np.exp(0.30 * fine + 0.10 * uneven + 0.06 * rib)
    return np.asarray(bright / bright.mean(), np.float32)


def wandering(rng: np.random.Generator, side: int = 256, sd: float = 0.00035) -> Texture:
    """(side, side) m: displacement of the edges of hand-cut patches, periodic."""
    white = rng.standard_normal((side, side)).astype(np.float32)
    return np.asarray(sd * _wrapped_blur(white, 3.5), np.float32)


def _wrapped_blur(noise: Texture, sd: float) -> Texture:
    pad = int(4 * sd) + 1
    soft = cv2.GaussianBlur(np.pad(noise, pad, mode="wrap"), (0, 0), sd)[pad:-pad, pad:-pad]
    return np.asarray(soft / soft.std(), np.float32)
