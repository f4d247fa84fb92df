"""Which point of a recording is which keypoint: by their names, or by a mapping file."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

import numpy as np

from extensions.reference.recording import UNITS, ReferenceRecording
from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.base.toml_reader import TomlTable, read_text, read_toml, texts
from tracker.hand.names import FINGERS, KEYPOINTS

LEAST = 3  # points that determine a registration
_PARTS = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+")
_SIDES = {"r": "right", "right": "right", "l": "left", "left": "left"}
_NOISE = {"hand", "finger", "joint", "marker"}
_DIGITS = {"pinky": "little", "pinkie": "little", "middle": "middle"} | {f: f for f in FINGERS}
_THUMB = ("cmc", "mcp", "ip", "tip")
_FINGER = ("mcp", "pip", "dip", "tip")
_WRIST = {"", "wrist"}


@dataclass(frozen=True)
class TableColumns:
    """Columns of a generic CSV: ``time`` (in ``time_unit`` s) or a fixed ``rate`` (Hz), and the
    x, y and z columns of each point by its name."""

    time: str | None
    time_unit: float
    rate: float
    points: Mapping[str, tuple[str, str, str]]
    pulse: str | None = None
    delimiter: str = ","


@dataclass(frozen=True)
class PointMapping:
    """``keypoints``: names of the points whose mean is a keypoint, by its name; empty: by names.
    ``unit`` in m replaces the format's default unit for a file without one."""

    keypoints: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    unit: float | None = None
    table: TableColumns | None = None


def read_mapping(path: Path) -> PointMapping:
    """Reads a mapping file (TOML). Raises FileError that names file and line."""
    root = read_toml(read_text(path), str(path))
    unit = UNITS[root.text("units", among=UNITS)] if root.has("units") else None
    keypoints = {}
    if root.has("keypoints"):
        group = root.table("keypoints")
        names = group.keys()
        for name in names:
            keypoints[name] = texts(group, name)
        group.finish()
    table = _columns(root.table("columns")) if root.has("columns") else None
    root.finish()
    return PointMapping(keypoints, unit, table)


def _columns(table: TomlTable) -> TableColumns:
    time = table.text("time") if table.has("time") else None
    unit = {"s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9}
    scale = unit[table.text("time_unit", "s", among=unit)]
    rate = table.number("rate", 0.0, low=0.0)
    if (time is None) == (rate == 0.0):
        raise table.fail("time", notice("reference.time_and_rate"))
    pulse = table.text("pulse") if table.has("pulse") else None
    delimiter = table.text("delimiter", ",")
    points = {}
    group = table.table("points")
    names = group.keys()
    for name in names:
        axes = texts(group, name)
        if len(axes) != 3:
            raise group.fail(name, notice("reference.three_columns"))
        points[name] = (axes[0], axes[1], axes[2])
    group.finish()
    table.finish()
    return TableColumns(time, scale, rate, points, pulse, delimiter)


def as_keypoints(
    recording: ReferenceRecording,
    keypoints: Sequence[str],
    side: str,
    mapping: PointMapping,
    path: Path,
) -> ReferenceRecording:
    """The recording with the points of the hand, in the order of ``keypoints``; absent ones are
    omitted. Raises FileError if fewer than `LEAST` are known."""
    of = dict(mapping.keypoints) or by_names(recording.names, side, keypoints)
    unknown = [name for name in of if name not in keypoints]
    if unknown:
        raise FileError(notice("reference.no_keypoint", name=unknown[0], known=tuple(keypoints)))
    column = {name: i for i, name in enumerate(recording.names)}
    missing = [p for points in of.values() for p in points if p not in column]
    if missing:
        raise FileError(
            notice("reference.no_point", file=path, point=missing[0], known=recording.names[:60])
        )
    names = [k for k in keypoints if k in of]
    if len(names) < LEAST:
        raise FileError(
            notice("reference.few_points", file=path, found=len(names), known=recording.names[:60])
        )
    each = [recording.points[:, [column[p] for p in of[k]]].mean(axis=1) for k in names]
    return replace(recording, names=tuple(names), points=np.stack(each, axis=1))


def by_names(
    names: Sequence[str], side: str, keypoints: Sequence[str] = tuple(KEYPOINTS)
) -> dict[str, tuple[str, ...]]:
    """Points that are named like keypoints of a hand of ``side``; the first of two of one name."""
    out: dict[str, tuple[str, ...]] = {n: (n,) for n in names if n in keypoints}
    for name in names:
        keypoint, of_side = keypoint_of(name)
        if keypoint in keypoints and of_side in ("", side):
            out.setdefault(keypoint, (name,))
    return out


def keypoint_of(name: str) -> tuple[str, str]:
    """The keypoint, and the side if any, that a name such as ``Ann:R_IndexTip`` or
    ``RightHandIndex4`` means; empty for another one."""
    parts = [p.lower() for p in _PARTS.findall(name.rsplit(":", 1)[-1])]
    side = next((_SIDES[p] for p in parts if p in _SIDES), "")
    parts = [p for p in parts if p not in _SIDES]
    has_hand = "hand" in parts
    rest = [p for p in parts if p not in _NOISE]
    if "".join(rest) in _WRIST:
        return ("wrist" if rest or has_hand else ""), side
    if len(rest) > 2 and rest[-1] == "end":  # an end site of BVH
        rest = [rest[0], "tip"]
    if len(rest) != 2:
        return "", side
    digit, joint = _DIGITS.get(rest[0], rest[0]), rest[1]
    order = _THUMB if digit == "thumb" else _FINGER
    if joint in ("1", "2", "3", "4"):
        joint = order[int(joint) - 1]
    keypoint = f"{digit}_{joint}"
    return (keypoint if keypoint in KEYPOINTS else ""), side
