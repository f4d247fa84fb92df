"""Alignments in a TOML file, a table for each side."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

from extensions.room.alignment import Alignment
from tracker.base.errors import ConfigError, FileError
from tracker.base.files import write_whole
from tracker.base.notices import failure
from tracker.base.toml_reader import parse_toml, read_text
from tracker.hand.names import SIDES

HEAD = """# Where trackers of another system are fixed to the hands (glovetrack room align).
# Pose of the tracker in the frame of the back of the hand: x to the fingers, z dorsal, y = z × x;
# the delay is that of the tracker's poses against the glove.
"""


def to_toml(alignments: Mapping[str, Alignment]) -> str:
    """The text of a file, by side."""
    tables = [HEAD]
    for side, a in alignments.items():
        tables.append(
            f"\n[{side}]\n"
            f"position_m = {_list(a.p_BT)}\n"
            f"rotation_xyzw = {_list(a.q_BT)}\n"
            f"delay_s = {a.delay:.6f}\n"
        )
    return "".join(tables)


def _list(values: Any) -> str:
    return "[" + ", ".join(f"{v:.9f}" for v in values) + "]"


def write(path: Path, alignments: Mapping[str, Alignment], force: bool = False) -> None:
    """Raises FileError for a file that exists, unless it is replaced."""
    write_whole(path, to_toml(alignments), force)


def read(path: Path) -> dict[str, Alignment]:
    """By side. Raises FileError and ConfigError."""
    try:
        table = parse_toml(read_text(path), str(path))
    except FileError:
        raise
    return {side: _alignment(path, side, value) for side, value in table.items()}


def _alignment(path: Path, side: str, value: object) -> Alignment:
    if side not in SIDES or not isinstance(value, Mapping):
        raise _bad(path, f"{side!r} is not a side")
    if value.keys() - {"position_m", "rotation_xyzw", "delay_s"}:
        raise _bad(path, "it has unknown keys")
    p, q = (_numbers(path, value, k, n) for k, n in (("position_m", 3), ("rotation_xyzw", 4)))
    (delay,) = _numbers(path, {"delay_s": [value.get("delay_s", 0.0)]}, "delay_s", 1)
    length = float(np.linalg.norm(q))
    if abs(length - 1) > 0.01:
        raise _bad(path, "rotation_xyzw is not of unit length")
    return Alignment(p, q / length, float(delay))


def _numbers(path: Path, table: Mapping[str, Any], key: str, count: int) -> np.ndarray:
    given = table.get(key)
    if not isinstance(given, list) or len(given) != count:
        raise _bad(path, f"{key} is not a list of {count} numbers")
    if not all(isinstance(v, int | float) and not isinstance(v, bool) for v in given):
        raise _bad(path, f"{key} has values that are not numbers")
    return np.array(given, float)


def _bad(path: Path, why: str) -> ConfigError:
    return ConfigError(failure("room.bad_alignment", file=path, why=why))
