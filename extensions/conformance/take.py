"""One hand's records as arrays, and the windows of the scripted steps."""

from __future__ import annotations

import json
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from extensions.conformance.isaac.record import HandRecord
from tracker.base.clock import NS
from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.base.toml_reader import read_text
from tracker.hand.names import FINGERS
from tracker.hand.openxr import JOINTS
from tracker.messages import Array, IntArray

ROW = {name: i for i, name in enumerate(JOINTS)}
WRIST, PALM = ROW["wrist"], ROW["palm"]
PHALANGES = ("proximal", "intermediate", "distal", "tip")
CHAINS: dict[str, list[int]] = {
    "thumb": [ROW[f"thumb_{p}"] for p in ("metacarpal", "proximal", "distal", "tip")],
    **{f: [ROW[f"{f}_{p}"] for p in PHALANGES] for f in FINGERS},
}
METACARPALS = {f: ROW[f"{f}_metacarpal"] for f in FINGERS}
KNUCKLES = {f: CHAINS[f][0] for f in FINGERS}
TIPS = {d: CHAINS[d][-1] for d in CHAINS}
REQUIRED = [WRIST, *(j for chain in CHAINS.values() for j in chain)]
"""The 21 joints that are judged."""


@dataclass(frozen=True, eq=False)
class RecordTake:
    """N records of one hand: available and sample times (N,) ns, active (N,); position (N, 26, 3)
    m, orientation (N, 26, 4) xyzw and radius (N, 26) m, NaN where ``valid`` (N, 26) is not set.
    """

    side: str
    available: IntArray
    sample: IntArray
    active: NDArray[np.bool_]
    valid: NDArray[np.bool_]
    position: Array
    orientation: Array
    radius: Array

    def __len__(self) -> int:
        return len(self.sample)

    @cached_property
    def t(self) -> Array:
        """Time (N,) s from the first record."""
        return (self.sample - self.sample[0]) / NS

    @cached_property
    def local(self) -> Array:
        """Positions (N, 26, 3) m relative to the wrist, in its axes."""
        from_wrist = self.position - self.position[:, WRIST, None]
        return np.asarray(from_wrist @ rotations(self.orientation[:, WRIST]))

    @cached_property
    def straightness(self) -> Array:
        """(N,) distance from knuckle to tip divided by the length along the bones, mean over the
        four fingers."""
        shares = []
        for f in FINGERS:
            p = self.position[:, CHAINS[f]]
            along = np.linalg.norm(np.diff(p, axis=1), axis=2).sum(axis=1)
            shares.append(np.linalg.norm(p[:, -1] - p[:, 0], axis=1) / np.maximum(along, 1e-9))
        return np.asarray(np.mean(shares, axis=0))

    @cached_property
    def pinch(self) -> Array:
        """Distances (N, 4) m from the thumb's tip to each fingertip."""
        tips = self.position[:, [TIPS[f] for f in FINGERS]]
        return np.asarray(np.linalg.norm(tips - self.position[:, TIPS["thumb"], None], axis=2))


def rotations(q: Array) -> Array:
    """Rotations (N, 3, 3) of quaternions xyzw, which are normalised; NaN stays NaN."""
    x, y, z, w = (q / np.linalg.norm(q, axis=1, keepdims=True)).T
    rows = [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]
    return np.moveaxis(np.array(rows), 2, 0)


def take_of(side: str, records: Sequence[HandRecord]) -> RecordTake:
    """Arrays of a hand's records, in their order."""
    n, k = len(records), len(JOINTS)
    active = np.array([r.joints is not None for r in records], bool)
    valid = np.zeros((n, k), bool)
    position, q = np.full((n, k, 3), np.nan), np.full((n, k, 4), np.nan)
    radius = np.full((n, k), np.nan)
    if active.any():
        joints = np.array([r.joints for r in records if r.joints is not None])
        valid[active] = joints["is_valid"].astype(bool)
        position[active], q[active] = joints["position"], joints["orientation"]
        radius[active] = joints["radius"]
        position[~valid], q[~valid], radius[~valid] = np.nan, np.nan, np.nan
    stamps = np.array([(r.stamps.available, r.stamps.sample) for r in records], np.int64)
    available, sample = stamps.reshape(-1, 2).T
    return RecordTake(side, available, sample, active, valid, position, q, radius)


class ScriptStep(NamedTuple):
    """A window of sample times in ns for the gesture ``label``."""

    label: str
    start_ns: int
    end_ns: int


PINCHES = {f"pinch_{f}": f for f in FINGERS}
GRASPS = {"right_grasps_left_fist": "left", "left_grasps_right_fist": "right"}
"""The hand that makes the fist."""
OPENS = ("open_hand_open", "open_hand_close")
SCRIPT: dict[str, float] = {
    "open_hand_open": 4.0,
    "fist": 4.0,
    **dict.fromkeys(GRASPS, 4.0),
    **dict.fromkeys(PINCHES, 3.0),
    "wrist_rotate": 6.0,
    "open_hand_close": 4.0,
}
"""Duration of each step in s."""
BEATS, BEAT = 3, 0.8  # before each step; s
SETTLED = 0.4
"""Share of a window that may contain the transition into it."""


def labels_path(path: Path) -> Path:
    """Path of the file with the windows of a take."""
    return path.with_name(f"{path.stem}.labels.json")


def write_labels(path: Path, take: str, steps: Sequence[ScriptStep], first_ns: int) -> str:
    """Write the sidecar of the file ``take`` and return its text."""
    rows = [
        {
            "index": i,
            "label": s.label,
            "start_ns": s.start_ns,
            "end_ns": s.end_ns,
            "start_s_from_first_sample": round((s.start_ns - first_ns) / NS, 6),
            "end_s_from_first_sample": round((s.end_ns - first_ns) / NS, 6),
            "is_still_window": s.label != "wrist_rotate",
        }
        for i, s in enumerate(steps)
    ]
    clock = "sample_time_local_common_clock (system monotonic, nanoseconds)"
    text = json.dumps({"clock_domain": clock, "mcap": take, "steps": rows}, indent=2) + "\n"
    path.write_text(text, "utf-8")
    return text


def read_labels(path: Path) -> list[ScriptStep]:
    """Windows of a sidecar; empty without a file. Raises FileError for invalid content."""
    if not path.is_file():
        return []
    try:
        rows: Iterable[dict[str, Any]] = json.loads(read_text(path))["steps"]
        return [ScriptStep(str(r["label"]), int(r["start_ns"]), int(r["end_ns"])) for r in rows]
    except (ValueError, KeyError, TypeError) as error:
        raise FileError(notice("conformance.labels", path=path)) from error
