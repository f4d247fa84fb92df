"""Writes the noise of IMUs into the text of a glove file; the remaining text is unchanged."""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import fields

from tracker.base.errors import FileError
from tracker.glove.model import ImuNoise

_TABLE = re.compile(r"^\s*\[")
_IMU = re.compile(r"^\s*\[\[\s*imu\s*\]\]")
_NAME = re.compile(r"""^\s*name\s*=\s*["'](.*?)["']""")
_NOISE = re.compile(r"^\s*noise\s*=")


def with_noise(text: str, noise: Mapping[str, ImuNoise]) -> str:
    """The text of a glove file with the ``noise`` of IMUs by name, replacing earlier values.

    Raises FileError if the file does not have an IMU of one of the names.
    """
    out: list[str] = []
    left, in_imu, written = dict(noise), False, False
    for line in text.splitlines():
        if _TABLE.match(line):
            in_imu, written = bool(_IMU.match(line)), False
        if in_imu and written and _NOISE.match(line):
            continue
        out.append(line)
        name = _NAME.match(line) if in_imu else None
        if name and name[1] in left:
            out.append(f"noise = {{ {_inline(left.pop(name[1]))} }}")
            written = True
    if left:
        raise FileError(f"The glove file has no IMU named {', '.join(left)}.")
    return "\n".join(out) + "\n"


def _inline(noise: ImuNoise) -> str:
    return ", ".join(f"{f.name} = {getattr(noise, f.name):.4g}" for f in fields(noise))
