"""The record of edits in a session: which estimates were interpolated, how, and from which file.

It is the attachment ``edits.json``. Edited estimates have the state *inferred* in their messages;
readers report them as *interpolated* because of this record. They are never reported as measured.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracker.base.clock import NS
from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.messages import IntArray

NAME, MEDIA_TYPE, SCHEMA = "edits.json", "application/json", 1
WORD = "interpolated"
"""What exports call the state of an edited estimate."""
MOST_FILLS = 100_000
Mask = NDArray[np.bool_]


@dataclass(frozen=True)
class Filled:
    """One filled gap of a hand. ``start_ns`` and ``stop_ns`` (since 1970) are the stamps of the
    estimates before and after it, which are unchanged; what is between them was interpolated."""

    side: str
    keypoints: tuple[str, ...]
    joints: tuple[str, ...]
    start_ns: int
    stop_ns: int
    kind: str  # hole, lost or inferred: the state before
    cause: str

    @property
    def length(self) -> float:
        """s"""
        return (self.stop_ns - self.start_ns) / NS


@dataclass(frozen=True)
class Edit:
    """One command's changes: ``method`` and ``parameters``, its user (``who``), ``when`` (ISO 8601)
    and ``program``; the name and the SHA-256 of the file that was read."""

    method: str
    who: str
    when: str
    program: str
    source: str
    source_sha256: str
    parameters: Mapping[str, Any] = field(default_factory=dict)
    filled: tuple[Filled, ...] = ()


def edits_text(edits: Sequence[Edit]) -> str:
    """Returns the text of the attachment."""
    value = {"schema": SCHEMA, "edits": [asdict(edit) for edit in edits]}
    return json.dumps(value, indent=1, ensure_ascii=False) + "\n"


def parse_edits(text: str, where: str) -> tuple[Edit, ...]:
    """The inverse of `edits_text`. Raises FileError that names ``where``."""
    try:
        stored = json.loads(text)
        if stored["schema"] != SCHEMA:
            raise FileError(
                notice("edits.schema", file=where, schema=stored["schema"], expected=SCHEMA)
            )
        edits = tuple(map(edit_of, stored["edits"]))
        count = sum(len(edit.filled) for edit in edits)
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
        raise FileError(notice("edits.invalid", file=where, why=error)) from error
    if count > MOST_FILLS:
        raise FileError(notice("edits.too_many", file=where, fills=count, most=MOST_FILLS))
    return edits


def edit_of(stored: Mapping[str, Any]) -> Edit:
    """Creates an Edit from JSON. Raises KeyError, TypeError or ValueError if it is not valid."""
    texts = {
        n: str(stored.get(n, ""))
        for n in ("method", "who", "when", "program", "source", "source_sha256")
    }
    return Edit(
        **texts,
        parameters=dict(stored.get("parameters", {})),
        filled=tuple(_filled(each) for each in stored["filled"]),
    )


def _filled(stored: Mapping[str, Any]) -> Filled:
    return Filled(
        side=str(stored["side"]),
        keypoints=tuple(map(str, stored["keypoints"])),
        joints=tuple(map(str, stored["joints"])),
        start_ns=int(stored["start_ns"]),
        stop_ns=int(stored["stop_ns"]),
        kind=str(stored.get("kind", "")),
        cause=str(stored.get("cause", "")),
    )


def without_person(text: str) -> str:
    """The record without the user and without the source's name, which may identify the wearer."""
    stored = json.loads(text)
    for edit in stored.get("edits", ()):
        edit |= {"who": "", "source": ""}
    return json.dumps(stored, indent=1, ensure_ascii=False) + "\n"


def masks(
    edits: Sequence[Edit],
    side: str,
    stamp_ns: IntArray,
    keypoint_names: Sequence[str],
    joint_names: Sequence[str],
) -> tuple[Mask, Mask]:
    """(N, K) and (N, J): which keypoints and angles of the estimates stamped ``stamp_ns`` (N,),
    rising, were interpolated."""
    points = np.zeros((len(stamp_ns), len(keypoint_names)), bool)
    angles = np.zeros((len(stamp_ns), len(joint_names)), bool)
    for each in (f for edit in edits for f in edit.filled if f.side == side):
        first = np.searchsorted(stamp_ns, each.start_ns, side="right")
        last = np.searchsorted(stamp_ns, each.stop_ns, side="left")
        points[first:last, _columns(keypoint_names, each.keypoints)] = True
        angles[first:last, _columns(joint_names, each.joints)] = True
    return points, angles


def _columns(names: Sequence[str], wanted: Sequence[str]) -> list[int]:
    return [i for i, name in enumerate(names) if name in wanted]


def lines(edits: Iterable[Edit]) -> list[str]:
    """Returns a sentence for each edit."""
    out = []
    for edit in edits:
        total = sum(f.length for f in edit.filled)
        who = f" by {edit.who}" if edit.who else ""
        count = f"{len(edit.filled)} gap{'s' * (len(edit.filled) != 1)}"
        source = f", read from {edit.source}" if edit.source else ""
        out.append(
            f"edited: {count} interpolated ({edit.method}, {total:.2f} s in all){who}, "
            f"{edit.when}{source}"
        )
    return out
