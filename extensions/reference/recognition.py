"""What a reference file contains, before it is imported; and a mapping file to begin with."""

from __future__ import annotations

import csv
import itertools
import json
import re
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from extensions.reference.formats.read import read_lines, read_reference
from extensions.reference.mapping import PointMapping, as_keypoints, by_names, read_mapping
from extensions.reference.recording import number
from tracker.base.errors import FileError
from tracker.base.notices import Notice

MEASURED = ("BVH", "CSV")
"""Formats without a unit of their own."""
_HEADER_LINES = 200  # in which the header of a CSV is searched
_AXIS = re.compile(r"(?i)^(.*?)[\s_.:\-]*([xyz])(?:\s*[(\[].*)?$")
_TIMES = ("t", "time", "timestamp", "seconds", "time (s)", "time [s]")


@dataclass(frozen=True)
class RecognisedPoints:
    """``points`` of the file and ``keypoints`` of the hand among them, ``assigned`` to each its
    points; ``missing`` keypoints.

    ``duration`` s at ``rate`` Hz; ``has_clock``: the file has the time of its start; ``pulses``:
    the number of events; ``problem``: why it cannot be imported, None if it can."""

    kind: str
    rate: float
    duration: float
    points: tuple[str, ...]
    keypoints: tuple[str, ...]
    assigned: tuple[tuple[str, ...], ...]
    missing: tuple[str, ...]
    has_clock: bool
    pulses: int
    problem: Notice | None


def recognise(
    path: Path,
    keypoints: Sequence[str],
    side: str,
    mapping_file: Path | None = None,
    pulse: str = "",
) -> RecognisedPoints:
    """``keypoints`` and ``side`` of the hand. Raises FileError for a file or mapping file that
    cannot be read."""
    mapping = PointMapping() if mapping_file is None else read_mapping(mapping_file)
    found = read_reference(path, mapping, pulse)
    known = dict(mapping.keypoints) or by_names(found.names, side, keypoints)
    problem = None
    try:
        as_keypoints(found, keypoints, side, mapping, path)
    except FileError as error:
        problem = error.notice
    names = tuple(k for k in keypoints if k in known)
    return RecognisedPoints(
        found.kind,
        found.rate,
        float(found.t[-1] - found.t[0]),
        found.names,
        names,
        tuple(tuple(known[k]) for k in names),
        tuple(k for k in keypoints if k not in known),
        found.start is not None,
        len(found.pulses),
        problem,
    )


def mapping_template(path: Path, keypoints: Sequence[str], side: str) -> str:
    """A mapping file for this recording, with what its names show; the rest is commented out.

    Raises FileError for a file that cannot be read.
    """
    try:
        found = read_reference(path)
    except FileError as error:
        if error.notice.code != "reference.unknown_format":
            raise
        return _of_table(path, keypoints, side)
    head = ['units = "mm"'] if found.kind in MEASURED else []
    return _template(path, head, keypoints, side, found.names)


def _of_table(path: Path, keypoints: Sequence[str], side: str) -> str:
    header, delimiter = _header(read_lines(path))
    points = _points(header)
    time = next((c for c in header if c.lower() in _TIMES), None)
    columns = ["", "[columns]"]
    columns += [f"time = {_text(time)}"] if time is not None else ['# time = "t"', "rate = 100"]
    columns += [
        'time_unit = "s"  # or "ms", "us", "ns"',
        *([f"delimiter = {_text(delimiter)}"] if delimiter != "," else []),
        '# pulse = "sync"  # a column whose rising edges are events',
        f"# columns of the file: {', '.join(header)}",
        "",
        "[columns.points]  # point = its columns x, y and z",
        *(f"{_text(name)} = [{', '.join(map(_text, axes))}]" for name, axes in points.items()),
        *([] if points else ['# index_tip = ["column x", "column y", "column z"]']),
    ]
    return _template(path, ['units = "mm"'], keypoints, side, tuple(points)) + _joined(columns)


def _template(
    path: Path, head: Sequence[str], keypoints: Sequence[str], side: str, points: Sequence[str]
) -> str:
    known = by_names(points, side, keypoints)
    used = {point for each in known.values() for point in each}
    others = [p for p in points if p not in used]
    lines = [
        f"# Mapping file for {path.name}. Lines that begin with # are not read.",
        *head,
        "",
        "[keypoints]  # keypoint = its point, or several points whose mean it is",
    ]
    if others:
        lines.append(f"# not assigned: {', '.join(map(_text, others))}")
    for name in keypoints:
        words = ", ".join(map(_text, known.get(name, ("",))))
        lines.append(f"{'' if name in known else '# '}{name} = [{words}]")
    return _joined(lines)


def _joined(lines: Sequence[str]) -> str:
    return "\n".join(lines) + "\n"


def _text(value: str) -> str:
    """As TOML, whose basic strings have JSON's escapes."""
    return json.dumps(value, ensure_ascii=False)


def _header(lines: Sequence[str]) -> tuple[list[str], str]:
    """The cells above the first line of numbers, and what separates them."""
    best: tuple[list[str], str] = [], ","
    for delimiter in (",", ";", "\t"):
        rows = list(csv.reader(lines[:_HEADER_LINES], delimiter=delimiter))
        tops = (above for above, row in itertools.pairwise(rows) if _is_header(above, row))
        header = next(tops, [])
        if len(header) > max(len(best[0]), 1):
            best = [cell.strip() for cell in header], delimiter
    return best


def _is_header(above: Sequence[str], row: Sequence[str]) -> bool:
    """Whether ``row`` has numbers and the line above it names as many columns."""
    numeric = sum(bool(np.isfinite(number(cell))) for cell in row)
    named = not any(np.isfinite(number(cell)) for cell in above)
    return len(above) == len(row) and named and numeric > len(row) / 2


def _points(header: Sequence[str]) -> dict[str, tuple[str, str, str]]:
    """Columns that differ in a last letter x, y or z, by what is before it."""
    axes: dict[str, dict[str, str]] = {}
    for column in header:
        found = _AXIS.match(column)
        if found is not None and found[1]:
            axes.setdefault(found[1], {}).setdefault(found[2].lower(), column)
    return {n: (a["x"], a["y"], a["z"]) for n, a in axes.items() if len(a) == 3}
