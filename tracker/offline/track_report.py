"""The report of tracking a session, counted during tracking."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterable
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from tracker.base.notices import Notice, to_json
from tracker.hand.names import MARKED_KEYPOINTS
from tracker.messages import Array, BlobFrame, Estimate, ImuSample, Status, Tracking

STATUS_PERIOD, STATUS_WINDOW = 0.95, 3.0  # s: at least one a second; what rates are counted over


@dataclass(eq=False)
class TrackReport:
    """``error_mm`` and ``error_deg`` are filled where the session contains the truth, the former
    where positions were found too; ``hands``, by side, where it is a session of both."""

    duration_s: float = 0.0
    wall_s: float = 0.0
    estimates: int = 0
    frames: int = 0
    losses: dict[str, int] = field(default_factory=dict)
    lost_s: float = 0.0
    error_mm: dict[str, float] = field(default_factory=dict)
    error_deg: float | None = None  # mean absolute error of the joint angles
    hands: dict[str, TrackReport] = field(default_factory=dict)
    notices: list[Notice] = field(default_factory=list)  # about the session
    left_out: dict[str, int] = field(default_factory=dict)  # damaged messages by topic
    unused: tuple[Notice, ...] = ()  # those about parts of the session that were not used

    @property
    def words(self) -> list[str]:
        """The notices in English."""
        return [str(found) for found in self.notices]

    def to_json(self) -> dict[str, object]:
        out = dict(vars(self))
        if not self.error_mm:
            del out["error_mm"]
        if self.error_deg is None:
            del out["error_deg"]
        del out["notices"]
        if self.notices:
            out["words"], out["notices"] = self.words, [to_json(n) for n in self.notices]
        if not self.left_out:
            del out["left_out"]
        del out["hands"], out["unused"]
        if self.hands:
            out["hands"] = {side: report.to_json() for side, report in self.hands.items()}
        return out

    @staticmethod
    def of_hands(hands: dict[str, TrackReport]) -> TrackReport:
        """A session's report of its hands' by side: of one hand its own; of both the counts are
        sums, times and errors the worse of the two."""
        reports = list(hands.values())
        if len(reports) == 1:
            return reports[0]
        losses = {
            name: sum(r.losses.get(name, 0) for r in reports) for r in reports for name in r.losses
        }
        errors = [r.error_mm for r in reports if r.error_mm]
        worse = max(errors, key=lambda error: error["mean"], default={})
        angles = [r.error_deg for r in reports if r.error_deg is not None]
        return TrackReport(
            duration_s=max(r.duration_s for r in reports),
            estimates=sum(r.estimates for r in reports),
            frames=sum(r.frames for r in reports),
            losses=losses,
            lost_s=max(r.lost_s for r in reports),
            error_mm=worse,
            error_deg=max(angles, default=None),
            hands=hands,
            notices=[found for report in reports for found in report.notices],
        )


class Counter:
    """Counts packets and their results into a `TrackReport`."""

    def __init__(self) -> None:
        self.report = TrackReport()
        self._first = np.nan
        self._last: ImuSample | None = None

    def count(self, sample: ImuSample, tracking: Tracking) -> None:
        """Adds one packet and the state of tracking at its instant."""
        r, last = self.report, self._last
        r.estimates += 1
        if last is None:
            self._first = sample.t
        else:
            if tracking in (Tracking.SEARCHING, Tracking.LOST):
                r.lost_s += sample.t - last.t
            if sample.seq >= 0 and last.seq >= 0 and sample.seq > last.seq + 1:
                self._lost("imu_packets", sample.seq - last.seq - 1)
        self._lost("imu_readings", int(np.sum(~np.asarray(sample.valid))))
        self._last = sample
        r.duration_s = float(sample.t - self._first)

    def _lost(self, what: str, n: int) -> None:
        if n:
            self.report.losses[what] = self.report.losses.get(what, 0) + n


class StatusClock:
    """A Status once a second of the session: rates, delays and losses of its messages.

    It does not depend on the computer that tracks again, so that files are identical on any.
    """

    def __init__(self) -> None:
        self._next = -np.inf
        self._packets: deque[tuple[float, float]] = deque()  # t and delay, s
        self._frames: deque[tuple[float, float]] = deque()

    def frame(self, frame: BlobFrame) -> None:
        self._frames.append((frame.t, frame.t_arrival - frame.t))

    def packet(self, sample: ImuSample, tracking: Tracking, report: TrackReport) -> Status | None:
        """Take a packet; the status where one is due, at the first packet too."""
        self._packets.append((sample.t, sample.t_arrival - sample.t))
        if sample.t < self._next:
            return None
        self._next = sample.t + STATUS_PERIOD
        values = {
            "imu_lost": float(report.losses.get("imu_packets", 0)),
            "imu_readings_lost": float(report.losses.get("imu_readings", 0)),
            "lost_s": report.lost_s,
        }
        for name, stamps in (("imu", self._packets), ("frame", self._frames)):
            while stamps and stamps[0][0] < sample.t - STATUS_WINDOW:
                stamps.popleft()
            reach = max(sample.t - stamps[0][0], 0.1) if stamps else STATUS_WINDOW
            span = min(reach, STATUS_WINDOW)
            values[f"{name}_rate_hz"] = len(stamps) / span
            if stamps:
                values[f"latency_{name}_ms"] = 1e3 * float(np.median([d for _, d in stamps]))
        values["estimate_rate_hz"] = values["imu_rate_hz"]
        return Status(sample.t, tracking, values)


class TruthErrors(NamedTuple):
    """``mm``: mean errors of keypoints, the share of instants with all within 20 mm, and of those
    with all tracked; empty where nothing can be compared. ``deg``: of the joint angles."""

    mm: dict[str, float]
    deg: float | None


class TruthCheck:
    """Errors of four keypoints and the joint angles against the truth; stores little more."""

    def __init__(self, names: Iterable[str]) -> None:
        names = list(names)
        self._names = [k for k in MARKED_KEYPOINTS if k in names]
        self._rows = [names.index(k) for k in self._names]
        self._shown: dict[int, tuple[Array, Array]] = {}  # (4, 3) m and (J,) rad by instant, µs

    def add(self, estimate: Estimate) -> None:
        self._shown[_instant(estimate)] = estimate.keypoints[self._rows], estimate.angles

    def against(self, truth: Iterable[Estimate]) -> TruthErrors:
        points, angles = [], []
        for e in truth:
            shown = self._shown.get(_instant(e))
            if shown is None:
                continue
            points.append(np.linalg.norm(shown[0] - e.keypoints[self._rows], axis=1))
            if shown[1].shape == e.angles.shape:  # not another hand's joints
                angles.append(np.abs(shown[1] - e.angles))
        return TruthErrors(self._of_points(points), _mean_deg(angles))

    def _of_points(self, distances: list[Array]) -> dict[str, float]:
        distance_mm = 1e3 * np.array(distances).reshape(-1, len(self._names))
        seen = distance_mm[np.isfinite(distance_mm).all(axis=1)]
        if len(seen) == 0:
            return {}
        out = {k: float(v) for k, v in zip(self._names, seen.mean(axis=0), strict=True)}
        out["mean"] = float(seen.mean())
        out["pck20"] = float((seen.max(axis=1) < 20).mean())
        out["tracked_share"] = len(seen) / len(distance_mm)
        return out


def _mean_deg(errors: list[Array]) -> float | None:
    """Mean of the known ones, degrees."""
    known = np.array(errors)[np.isfinite(errors)]
    return float(np.degrees(known.mean())) if len(known) else None


def _instant(estimate: Estimate) -> int:
    return round(estimate.t * 1e6)
