"""Writes marker positions and IMU mountings into the text of a glove file.

The remaining text is unchanged.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.geometry import so3
from tracker.messages import Array

_TABLE = re.compile(r"^[ \t]*\[", re.MULTILINE)
_KIND = re.compile(r"\s*\[\[\s*(imu|marker)\s*\]\]")
_NAME = re.compile(r"""^[ \t]*name\s*=\s*["'](.*?)["']""", re.MULTILINE)
_ID = re.compile(r"^[ \t]*id\s*=\s*(\d+)", re.MULTILINE)
_POSITION = re.compile(r"^([ \t]*position\s*=\s*)\[[^\]]*\]", re.MULTILINE)
_MOUNTING = re.compile(r"^([ \t]*orientation_xyzw\s*=\s*)\[[^\]]*\]", re.MULTILINE)


class Fitted(NamedTuple):
    """Positions (3,) m of markers by their ids, and R_BI (3, 3) of IMUs by their names."""

    positions: Mapping[int, Array]
    mountings: Mapping[str, Array]


def with_fit(text: str, fitted: Fitted) -> str:
    """The text of a glove file with other marker positions and mountings.

    Raises FileError if the file does not have one of the markers or IMUs as a table of its own.
    """
    positions, mountings, out = dict(fitted.positions), dict(fitted.mountings), []
    for table in _tables(text):
        kind = _KIND.match(table)
        if kind and kind[1] == "marker" and (found := _ID.search(table)):
            if (marker := int(found[1])) in positions:
                table = _put(table, _POSITION, positions.pop(marker), 5)
        elif kind and (found := _NAME.search(table)) and found[1] in mountings:
            quat = so3.quat_from_matrix(mountings.pop(found[1]))
            table = _put(table, _MOUNTING, quat, 6)
        out.append(table)
    if positions or mountings:
        raise FileError(notice("fit_glove.no_table", names=[*map(str, positions), *mountings]))
    return "".join(out)


def _tables(text: str) -> Iterable[str]:
    """The text, divided before the header of each table."""
    starts = [0, *(m.start() for m in _TABLE.finditer(text)), len(text)]
    return (text[a:b] for a, b in pairwise(starts))


def _put(table: str, key: re.Pattern[str], values: Array, digits: int) -> str:
    row = ", ".join(f"{x:.{digits}f}" for x in np.ravel(values))
    return key.sub(lambda found: f"{found[1]}[{row}]", table, count=1)
