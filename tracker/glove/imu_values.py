"""Writes measured values of IMUs into the text of a glove file; the remaining text is unchanged."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import fields

import numpy as np

from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.glove.model import ImuAxes, ImuDrift, ImuNoise, ImuVibration

Values = ImuNoise | ImuDrift | ImuAxes | ImuVibration
_TABLE = re.compile(r"^\s*\[")
_IMU = re.compile(r"^\s*\[\[\s*imu\s*\]\]")
_NAME = re.compile(r"""^\s*name\s*=\s*["'](.*?)["']""")


def with_noise(text: str, noise: Mapping[str, ImuNoise]) -> str:
    """The text of a glove file with the ``noise`` of IMUs by name, replacing earlier values.

    Raises FileError if the file does not have an IMU of one of the names.
    """
    return _with(text, "noise", noise)


def with_drift(text: str, drift: Mapping[str, ImuDrift]) -> str:
    """`with_noise` for the ``drift`` of biases with the temperature."""
    return _with(text, "drift", drift)


def with_axes(text: str, axes: Mapping[str, ImuAxes]) -> str:
    """`with_noise` for the correction of scale and cross-axis errors."""
    return _with(text, "axes", axes)


def with_vibration(text: str, vibration: Mapping[str, ImuVibration]) -> str:
    """`with_noise` for the vibration of motors."""
    return _with(text, "vibration", vibration)


def _with(text: str, key: str, values: Mapping[str, Values]) -> str:
    out: list[str] = []
    own = re.compile(rf"^\s*{key}\s*=")
    left, in_imu, written = dict(values), False, False
    for line in text.splitlines():
        if _TABLE.match(line):
            in_imu, written = bool(_IMU.match(line)), False
        if in_imu and written and own.match(line):
            continue
        out.append(line)
        name = _NAME.match(line) if in_imu else None
        if name and name[1] in left:
            out.append(f"{key} = {{ {_inline(left.pop(name[1]))} }}")
            written = True
    if left:
        raise FileError(notice("noise.unknown_imu", names=left))
    return "\n".join(out) + "\n"


def _inline(values: Values) -> str:
    count = [f"motors = {len(values.gyro)}"] if isinstance(values, ImuVibration) else []
    return ", ".join(
        [*count, *(f"{f.name} = {_number(getattr(values, f.name))}" for f in fields(values))]
    )


def _number(value: float | np.ndarray) -> str:
    if isinstance(value, np.ndarray):
        return f"[{', '.join(f'{x:.8g}' for x in value.ravel())}]"
    return f"{value:.4g}"
