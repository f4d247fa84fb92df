"""The background of the hand: plain, painted clutter or a photograph, on a distant plane."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.base.errors import ConfigError, FileError
from tracker.base.notices import notice
from tracker.simulation.smooth import rng_for

Image = NDArray[np.uint8]

FABRIC_HSV = {
    "red": (0, 215, 215),
    "orange": (13, 225, 230),
    "yellow": (28, 215, 225),
    "green": (65, 200, 175),
    "cyan": (90, 210, 205),
    "blue": (110, 215, 205),
    "purple": (135, 190, 190),
    "magenta": (150, 205, 215),
    "pink": (165, 150, 235),
}
"""Fabric under full light, by hue name, in OpenCV units."""


def fabric_bgr(hue: str) -> tuple[float, float, float]:
    """BGR 0..255 of a marker's fabric. Raises ConfigError for a name without a colour."""
    if hue not in FABRIC_HSV:
        raise ConfigError(notice("simulate.no_fabric", hue=hue, known=tuple(FABRIC_HSV)))
    pixel = cv2.cvtColor(np.array([[FABRIC_HSV[hue]]], np.uint8), cv2.COLOR_HSV2BGR)[0, 0]
    return float(pixel[0]), float(pixel[1]), float(pixel[2])


@dataclass(frozen=True)
class BackgroundParams:
    """``kind``: plain, painted, photograph (``path`` is then the image file) or given (``given``
    are then the images (h, w, 3) of the left and the right camera)."""

    kind: str = "plain"
    path: str = ""
    distance: float = 0.75  # m, of the plane it is painted on
    grey: float = 128.0
    blobs: int = 60  # number of coloured ones in a painted background
    given: tuple[Image, Image] | None = field(default=None, compare=False)


def make_background(
    params: BackgroundParams, width: int, height: int, disparity: int, seed: int
) -> tuple[Image, Image]:
    """Left and right background (height, width, 3), the right one shifted by ``disparity`` px."""
    if params.given is not None:
        return params.given
    size = (width + disparity, height)
    if params.kind == "plain":
        canvas = _plain(params.grey, *size)
    elif params.kind == "painted":
        canvas = _painted(params, *size, rng_for(seed, "background"))
    elif params.kind == "photograph":
        canvas = _photograph(Path(params.path), *size)
    else:
        raise ConfigError(
            notice(
                "option.choice",
                option="background",
                known=("plain", "painted", "photograph"),
                value=params.kind,
            )
        )
    left, right = canvas[:, :width], canvas[:, disparity : disparity + width]
    return np.ascontiguousarray(left), np.ascontiguousarray(right)


def _plain(grey: float, width: int, height: int) -> Image:
    """A wall, brighter at the top."""
    ramp = np.linspace(1.15, 0.85, height)[:, None, None] * grey
    return np.clip(np.broadcast_to(ramp, (height, width, 3)), 0, 255).astype(np.uint8)


def _painted(params: BackgroundParams, width: int, height: int, rng: np.random.Generator) -> Image:
    """Soft colours, furniture edges, and objects with the markers' hues and sizes."""
    coarse = rng.uniform(70, 170, (6, 10, 3)).astype(np.float32)
    canvas = cv2.resize(coarse, (width, height), interpolation=cv2.INTER_CUBIC)
    canvas = np.clip(canvas * 0.6 + 0.4 * canvas.mean(axis=2, keepdims=True), 0, 255)
    image: Image = np.ascontiguousarray(canvas.astype(np.uint8))
    for _ in range(25):
        _box(image, rng)
    for _ in range(params.blobs):
        _blob(image, rng)
    return cv2.GaussianBlur(image, (0, 0), 0.8).astype(np.uint8)


def _box(image: Image, rng: np.random.Generator) -> None:
    h, w = image.shape[:2]
    x, y = int(rng.integers(0, w)), int(rng.integers(0, h))
    dx, dy = int(rng.integers(20, 260)), int(rng.integers(20, 180))
    grey = rng.uniform(40, 200) + rng.normal(0, 8, 3)
    cv2.rectangle(image, (x, y), (x + dx, y + dy), tuple(map(float, np.clip(grey, 0, 255))), -1)


def _blob(image: Image, rng: np.random.Generator) -> None:
    """A coloured ellipse, about as large as a marker at 25 to 60 cm."""
    h, w = image.shape[:2]
    name = str(rng.choice(["red", "yellow", "green", "blue"]))
    bright = rng.uniform(0.6, 1.0)
    colour = tuple(float(c * bright) for c in fabric_bgr(name))
    axes = (int(rng.integers(5, 16)), int(rng.integers(5, 16)))
    centre = (int(rng.integers(0, w)), int(rng.integers(0, h)))
    cv2.ellipse(image, centre, axes, float(rng.uniform(0, 180)), 0, 360, colour, -1, cv2.LINE_AA)


def _photograph(path: Path, width: int, height: int) -> Image:
    image = cv2.imread(str(path), cv2.IMREAD_COLOR) if path.is_file() else None
    if image is None:
        raise FileError(notice("images.not_readable", path=path))
    scale = max(width / image.shape[1], height / image.shape[0])
    size = (round(image.shape[1] * scale + 0.5), round(image.shape[0] * scale + 0.5))
    resized = cv2.resize(image, size, interpolation=cv2.INTER_AREA)
    return np.ascontiguousarray(resized[:height, :width]).astype(np.uint8)
