"""The lights of a room and the camera's response to them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.messages import Array

BGR = tuple[float, float, float]


@dataclass(frozen=True)
class RoomLight:
    """Light of a room, and the camera's response to it. Colours are linear BGR after the camera's
    white balance, which is always imperfect; 1 is white cloth at full scale.

    Noise is that of a sensor: its variance is ``shot`` times the linear value plus ``read``
    squared.
    """

    main: BGR  # of the lamp or window, at normal incidence at the centre of the desk
    position: tuple[float, float, float]  # m, from below the camera: forward, left, over the desk
    softness: float  # half angle subtended by the lamp, rad
    sky: BGR  # from everywhere
    second: BGR  # another light in the room, without shadows
    second_position: tuple[float, float, float]
    shot: float
    read: float
    vignetting: float = 0.12
    leak: float = 0.0  # of blue and green into the sensor's red channel
    shoulder: float = 0.0  # 0..1: smoothness of the tone curve near white
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
"""By name: daylight from a window, a lamp of 2700 K next to the hand with some daylight from the
other side, LEDs on the ceiling, and a dim room with a high sensor gain."""


def light_of(name: str) -> RoomLight:
    """A room's light. Raises ConfigError for an unknown name."""
    if name not in LIGHTS:
        raise ConfigError(
            notice("option.choice", option="--light", known=tuple(LIGHTS), value=name)
        )
    return LIGHTS[name]


def linear(srgb: Array | BGR) -> Array:
    """Linear 0..1 from stored colours 0..255 (IEC 61966-2-1)."""
    c = np.asarray(srgb, float) / 255
    return np.where(c <= 0.04045, c / 12.92, ((np.maximum(c, 0.04045) + 0.055) / 1.055) ** 2.4)


def tone_curve(shoulder: float, levels: int = 4096) -> NDArray[np.uint8]:
    """(levels,) stored values for linear values 0..2, approaching white slowly with
    ``shoulder``."""
    x = np.linspace(0.0, 2.0, levels)
    knee = 1.0 - 0.5 * shoulder
    rest = np.maximum(1.0 - knee, 1e-6)
    over = np.maximum(x - knee, 0.0)
    x = np.clip(np.where(x > knee, knee + rest * -np.expm1(-over / rest), x), 0.0, 1.0)
    stored = np.where(x <= 0.0031308, 12.92 * x, 1.055 * np.maximum(x, 1e-9) ** (1 / 2.4) - 0.055)
    return np.round(255 * np.clip(stored, 0, 1)).astype(np.uint8)
