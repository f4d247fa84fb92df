"""Identifies the position of each IMU: one finger moves at a time, with the IMUs on it.

Angular rates alone identify the finger; along a finger they add up from joint to joint, so the IMU
that rotates fastest is the outermost. The axis of rotation of an IMU shows its mounting: a bending
finger rotates about its flexion axis, y of its B.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tracker.base.notices import Notice, notice, warning
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array, ImuSample

DEGREE = np.pi / 180
HAND = "hand"
INSTRUCTIONS = {HAND: notice("wiggle.hand"), "thumb": notice("wiggle.thumb")}


@dataclass(frozen=True)
class WiggleParams:
    """``moved`` rad/s RMS above which an IMU moves; ``share`` of the fastest one's rate for one
    that moves with it; ``distinct`` minimum ratio of its motion in one step to that in all
    others."""

    duration: float = 4.0  # s
    moved: float = 20.0 * DEGREE
    share: float = 0.35
    distinct: float = 1.4
    tilted: float = 50.0 * DEGREE


@dataclass(frozen=True)
class WiggleStep:
    """``part`` is "hand" or a finger; ``imus`` rows of the IMUs on it according to the glove file,
    from the knuckle outwards."""

    part: str
    instruction: Notice
    imus: tuple[int, ...]


@dataclass(frozen=True)
class WiggleRow:
    """One IMU: ``state`` is "right", "elsewhere", "turned", "still", "silent" or "unclear";
    ``segment`` where it was found, empty if unknown."""

    name: str
    state: str
    segment: str
    what: Notice


@dataclass(frozen=True)
class WiggleResult:
    """A row per IMU in the glove's order, and what to do."""

    rows: tuple[WiggleRow, ...]
    summary: Notice

    @property
    def ok(self) -> bool:
        return all(r.state == "right" for r in self.rows)


def wiggle_steps(hand: HandModel, glove: GloveModel) -> list[WiggleStep]:
    """One step per finger that has IMUs, then the whole hand."""
    parts: dict[str, list[int]] = {}
    for i, imu in enumerate(glove.imus):
        parts.setdefault(_part(imu.segment), []).append(i)
    steps = []
    for part in sorted(parts, key=lambda p: (p == HAND, parts[p])):
        rows = sorted(parts[part], key=lambda i: _depth(hand, glove.imus[i].segment))
        asked = INSTRUCTIONS.get(part) or notice("wiggle.finger", finger=part)
        steps.append(WiggleStep(part, asked, tuple(rows)))
    return steps


def imu_motion(samples: Sequence[ImuSample]) -> Array:
    """(n,) rad/s RMS of each IMU's angular rate about its mean, which is bias; NaN if invalid."""
    if len(samples) < 2:
        return np.zeros(len(samples[0].gyro)) if samples else np.zeros(0)
    gyro = np.array([s.gyro for s in samples])
    valid = np.array([s.valid for s in samples])
    out = np.full(gyro.shape[1], np.nan)
    for i in range(gyro.shape[1]):
        rows = gyro[valid[:, i], i]
        if len(rows) > 1:
            out[i] = np.sqrt(np.mean(np.sum((rows - rows.mean(axis=0)) ** 2, axis=1)))
    return out


def moving(motion: Array, params: WiggleParams | None = None) -> list[int]:
    """Rows of the IMUs moving at present, the fastest first."""
    p = params or WiggleParams()
    known = np.nan_to_num(motion)
    if len(known) == 0 or known.max() < p.moved:
        return []
    return [int(i) for i in np.argsort(-known) if known[i] >= max(p.share * known.max(), p.moved)]


class WiggleTest:
    """Collects the steps' samples; `result` evaluates those collected so far."""

    def __init__(
        self, hand: HandModel, glove: GloveModel, params: WiggleParams | None = None
    ) -> None:
        self.hand, self.glove, self.params = hand, glove, params or WiggleParams()
        self.steps = wiggle_steps(hand, glove)
        n = len(glove.imus)
        self._motion = np.full((len(self.steps), n), np.nan)
        self._axis = np.full((len(self.steps), n, 3), np.nan)

    def add(self, step: int, samples: Sequence[ImuSample]) -> Notice | None:
        """Add a step's samples. Returns None if they can be used, else the reason why not."""
        motion = imu_motion(samples)
        if not moving(motion, self.params):
            return warning("wiggle.nothing_moved", instruction=self.steps[step].instruction)
        self._motion[step] = motion
        self._axis[step] = _axes(samples)
        return None

    def result(self) -> WiggleResult:
        """The combined result of the steps."""
        parts = [self._found_part(i) for i in range(len(self.glove.imus))]
        places = self._places(parts)
        rows = tuple(self._row(i, parts[i], places.get(i, "")) for i in range(len(parts)))
        return WiggleResult(rows, _summary(rows, self.glove))

    # --- positions

    def _found_part(self, i: int) -> str:
        """The part with which IMU ``i`` moves; "" if the steps do not agree."""
        p, motion = self.params, np.nan_to_num(self._motion[:, i])
        fingers = [k for k, s in enumerate(self.steps) if s.part != HAND]
        best = max(fingers, key=lambda k: motion[k], default=None)
        hand = next((k for k, s in enumerate(self.steps) if s.part == HAND), None)
        if best is None or motion[best] < p.moved:
            return HAND if hand is not None and motion[hand] >= p.moved else ""
        others = [motion[k] for k in fingers if k != best]
        if others and motion[best] < p.distinct * max(others):
            return ""
        return self.steps[best].part

    def _places(self, parts: list[str]) -> dict[int, str]:
        """Segment of each IMU whose part has as many IMUs as in the glove file."""
        out = {}
        for k, step in enumerate(self.steps):
            found = [i for i, part in enumerate(parts) if part == step.part]
            if len(found) != len(step.imus):
                continue
            found.sort(key=lambda i: self._motion[k, i])
            for i, j in zip(found, step.imus, strict=True):
                out[i] = self.glove.imus[j].segment
        return out

    # --- texts

    def _row(self, i: int, part: str, segment: str) -> WiggleRow:
        imu = self.glove.imus[i]
        if np.all(np.isnan(self._motion[:, i])):
            return WiggleRow(imu.name, "silent", "", warning("wiggle.silent"))
        if not part:
            still = np.nanmax(self._motion[:, i]) < self.params.moved
            if still:
                return WiggleRow(imu.name, "still", "", warning("wiggle.still"))
            return WiggleRow(imu.name, "unclear", "", warning("wiggle.unclear"))
        own = _part(imu.segment)
        if part != own or (segment and segment != imu.segment):
            where = _display_name(segment) if segment else _display_name(part)
            what = warning("wiggle.elsewhere", found=where, expected=_display_name(imu.segment))
            return WiggleRow(imu.name, "elsewhere", segment or part, what)
        angle = self._turned(i, part)
        if angle > self.params.tilted:
            what = warning("wiggle.turned", angle_deg=angle / DEGREE)
            return WiggleRow(imu.name, "turned", imu.segment, what)
        return WiggleRow(imu.name, "right", imu.segment, notice("wiggle.right"))

    def _turned(self, i: int, part: str) -> float:
        """Angle (rad, up to 90°) between its axis of rotation and the flexion axis."""
        k = next(k for k, s in enumerate(self.steps) if s.part == part)
        axis_B = self.glove.imus[i].R_BI @ self._axis[k, i]
        return float(np.arccos(min(1.0, abs(float(axis_B[1])))))


def _axes(samples: Sequence[ImuSample]) -> Array:
    """(n, 3): the main axis of rotation of each IMU in I; NaN if invalid."""
    gyro = np.array([s.gyro for s in samples])
    out = np.full(gyro.shape[1:], np.nan)
    for i in range(gyro.shape[1]):
        rows = gyro[np.isfinite(gyro[:, i, 0]), i]
        if len(rows) > 2:
            out[i] = np.linalg.svd(rows - rows.mean(axis=0), full_matrices=False)[2][0]
    return out


def _part(segment: str) -> str:
    return HAND if segment == "dorsum" else segment.split("_")[0]


def _depth(hand: HandModel, segment: str) -> int:
    """Number of joints between a segment and the dorsum."""
    depth, row = 0, hand.index[segment]
    while hand.parent[row] >= 0:
        depth, row = depth + 1, hand.parent[row]
    return depth


def _display_name(name: str) -> str:
    return "back of the hand" if name in (HAND, "dorsum") else name.replace("_", " ")


def _summary(rows: Sequence[WiggleRow], glove: GloveModel) -> Notice:
    """What to do."""
    if all(r.state == "right" for r in rows):
        return notice("wiggle.all_right")
    place = {i.segment: i.name for i in glove.imus}
    found = {r.name: place.get(r.segment, "") for r in rows if r.state == "elsewhere"}
    for name, other in found.items():
        if other != name and found.get(other) == name:
            return warning(
                "wiggle.exchanged", first=_display_name(name), second=_display_name(other)
            )
    wrong = [r for r in rows if r.state != "right"]
    imus = [warning("wiggle.imu", imu=_display_name(r.name), state=r.state) for r in wrong]
    return warning("wiggle.look_at", imus=imus)
