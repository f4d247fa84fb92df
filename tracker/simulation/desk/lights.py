"""Lights of a room and what a camera makes of them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracker.base.errors import ConfigError
from tracker.messages import Array

BGR = tuple[float, float, float]


@dataclass(frozen=True)
class RoomLight:
    """Light of a room, and the camera's answer to it. Colours are linear BGR after the camera's
    white balance, which is never quite right; 1 is what white cloth gives at full scale.

    Noise is that of a sensor: its variance is ``shot`` times the linear value and ``read`` squared.
    """

    main: BGR  # of the lamp or window, square on at the middle of the desk
    place: tuple[float, float, float]  # m, from below the camera: forward, left, over the desk
    softness: float  # half angle under which the lamp is seen, rad
    sky: BGR  # from everywhere
    second: BGR  # another light in the room, which throws no shadow
    second_place: tuple[float, float, float]
    shot: float
    read: float
    vignetting: float = 0.12
    leak: float = 0.0  # of blue and green through the sensor's red filter
    shoulder: float = 0.0  # 0..1: how gently the tone curve comes to white
    blur_px: float = 0.75  # of the lens, standard deviation


LIGHTS = {
    "window": RoomLight(
        (0.96, 0.76, 0.69), (0.35, 0.85, 0.75), 0.20,
        (0.29, 0.225, 0.20), (0.02, 0.02, 0.02), (0.5, -1.5, 1.5), 8e-5, 0.0023,
    ),
    "lamp": RoomLight(
        (0.92, 1.75, 2.25), (0.36, -0.36, 0.52), 0.07,
        (0.14, 0.17, 0.21), (0.30, 0.15, 0.09), (0.4, 1.2, 0.8), 3.5e-4, 0.0030,
        leak=0.03, shoulder=0.55,
    ),
    "led": RoomLight(
        (0.80, 0.80, 0.80), (0.32, 0.18, 1.10), 0.10,
        (0.26, 0.26, 0.26), (0.0, 0.0, 0.0), (0.5, 1.5, 1.5), 8e-5, 0.0022, vignetting=0.5,
    ),
    "dim": RoomLight(
        (0.112, 0.145, 0.262), (0.75, 0.80, 0.55), 0.25,
        (0.072, 0.067, 0.092), (0.05, 0.05, 0.035), (0.3, -1.2, 0.8), 1.2e-3, 0.0036,
        leak=0.03,
    ),
}  # fmt: skip
"""By name: daylight from a window, a lamp of 2700 K beside the hand with some daylight from the
other side, LEDs under the ceiling, and a dim room with the sensor's gain turned up."""


def light_of(name: str) -> RoomLight:
    """A room's light. Raises ConfigError for a name that is none."""
    if name not in LIGHTS:
        raise ConfigError(f"The light can be {', '.join(LIGHTS)}, not {name!r}.")
    return LIGHTS[name]


def linear(srgb: Array | BGR) -> Array:
    """Linear 0..1 of colours 0..255 as they are stored (IEC 61966-2-1)."""
    c = np.asarray(srgb, float) / 255
    return np.where(c <= 0.04045, c / 12.92, ((np.maximum(c, 0.04045) + 0.055) / 1.055) ** 2.4)


def tone_curve(shoulder: float, levels: int = 4096) -> NDArray[np.uint8]:
    """(levels,) what each linear value 0..2 is stored as, white coming slowly with ``shoulder``."""
    x = np.linspace(0.0, 2.0, levels)
    knee = 1.0 - 0.5 * shoulder
    rest = np.maximum(1.0 - knee, 1e-6)
    over = np.maximum(x - knee, 0.0)
    x = np.clip(np.where(x > knee, knee + rest * -np.expm1(-over / rest), x), 0.0, 1.0)
    stored = np.where(x <= 0.0031308, 12.92 * x, 1.055 * np.maximum(x, 1e-9) ** (1 / 2.4) - 0.055)
    return np.round(255 * np.clip(stored, 0, 1)).astype(np.uint8)
