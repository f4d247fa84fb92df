"""Errors of a trial's estimates against the truth of a simulation or a laboratory's reference.

Errors are distances in G. During an outage of images the hand's position is unknown, so the errors
are those of the articulation, in the dorsum's frame.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from extensions.evaluation.vist.cases import SETTLING, judged_in_outage
from extensions.evaluation.vist.metrics import Trial
from extensions.study.retrack import RetrackedTrial, Variant, retracked
from tracker.geometry import so3
from tracker.hand.names import MARKED_KEYPOINTS
from tracker.messages import Array, Estimate, Tracking
from tracker.session.description import SessionInfo
from tracker.session.reader import SessionReader

LONGEST_GAP = 0.1  # s over which the reference is interpolated
WRIST = "wrist"


@dataclass(frozen=True, eq=False)
class TrueKeypoints:
    """Keypoints (M, K, 3) m in G and the dorsum's R_GB (M, 3, 3) at t (M,) s since the beginning of
    the session; NaN where unknown. ``source``: truth or reference."""

    t: Array
    keypoints: Array
    R_GB: Array
    source: str

    def at(self, t: Array) -> tuple[Array, Array]:
        """Keypoints (n, K, 3), interpolated linearly, and R_GB (n, 3, 3) of the nearest instant;
        NaN in gaps of more than `LONGEST_GAP` and outside."""
        after = np.clip(np.searchsorted(self.t, t), 1, len(self.t) - 1)
        before = after - 1
        step = self.t[after] - self.t[before]
        share = ((t - self.t[before]) / step)[:, None, None]
        keypoints = self.keypoints[before] * (1 - share) + self.keypoints[after] * share
        known = (
            (step <= LONGEST_GAP + 1e-9) & (share[:, 0, 0] >= -1e-6) & (share[:, 0, 0] <= 1 + 1e-6)
        )
        keypoints[~known] = np.nan
        nearest = np.where(share[:, 0, 0] < 0.5, before, after)
        return keypoints, self.R_GB[nearest]


def read_truth(path: Path, side: str = "") -> TrueKeypoints | None:
    """The truth of a session, or its reference; None without either. Raises FileError."""
    with SessionReader(path, side=side) as reader:
        start = reader.anchor.monotonic(reader.span_ns[0])
        for source, found in (("reference", reader.reference()), ("truth", reader.truth())):
            truths = sorted(found, key=lambda e: e.t)
            if len(truths) > 1:
                return _truth(truths, reader.info, start, source)
    return None


def _truth(truths: list[Estimate], info: SessionInfo, start: float, source: str) -> TrueKeypoints:
    rows = np.flatnonzero(info.glove.keypoint_segments(info.hand) == info.hand.index["dorsum"])
    q = np.array([e.keypoint_q[rows[0]] for e in truths])
    known = np.isfinite(q).all(axis=1)
    R_GB = so3.matrix_from_quat(np.where(known[:, None], q, [0.0, 0.0, 0.0, 1.0]))
    return TrueKeypoints(
        np.array([e.t - start for e in truths]),
        np.array([e.keypoints for e in truths]),
        np.where(known[:, None, None], R_GB, np.nan),
        source,
    )


def trial_of(
    path: Path, variant: Variant, truth: TrueKeypoints, number: int, side: str = ""
) -> Trial:
    """The errors of a variant; ``number`` of the participant. The first `SETTLING` s of a recording
    are not evaluated, as in the evaluation of simulated people."""
    tracked = retracked(path, variant, side)
    with SessionReader(path, side=side) as reader:
        info, duration = reader.info, reader.duration
    t = np.array(tracked.t)
    rows = np.flatnonzero(_evaluated(t, duration, variant.outage))
    columns = [info.keypoint_names.index(k) for k in MARKED_KEYPOINTS]
    estimates = [tracked.estimates[i] for i in rows]
    keypoints, R_GB = truth.at(t[rows])
    if variant.outage:
        error = _articulation(estimates, tracked, info, keypoints, R_GB, columns)
    else:
        given = np.array([e.keypoints[columns] for e in estimates]).reshape(-1, len(columns), 3)
        error = np.linalg.norm(given - keypoints[:, columns], axis=2)
    known = np.isfinite(keypoints[:, columns]).all(axis=(1, 2))
    rows, error = rows[known], error[known]  # instants without a reference are not errors
    sd = np.array([tracked.estimates[i].keypoint_sd[columns] for i in rows])
    return Trial(
        participant=number,
        hand_length=float("nan"),
        t=t[rows],
        error=error,
        sd=sd.reshape(error.shape),
        joints=np.zeros((len(rows), 0)),
        seen=tracked.seen[rows],
        matches=0,
        wrong_matches=0,
        core_s=0.0,
        duration=duration,
    )


def _evaluated(t: Array, duration: float, outage: float) -> NDArray[np.bool_]:
    """(n,) whether each instant is evaluated."""
    ok = t > min(SETTLING, duration / 3)
    if outage:
        ok &= np.array([judged_in_outage(float(x), outage) for x in t], bool)
    return ok


def _articulation(
    estimates: list[Estimate],
    tracked: RetrackedTrial,
    info: SessionInfo,
    keypoints: Array,
    R_GB: Array,
    columns: list[int],
) -> Array:
    """Errors (n, k) m in the dorsum's frame, from segment poses, since keypoints are lost."""
    scale = _scale(tracked, info)
    wrist = info.keypoint_names.index(WRIST)
    out = np.full((len(estimates), len(columns)), np.nan)
    for i, e in enumerate(estimates):
        if e.tracking == Tracking.SEARCHING:
            continue
        given = info.glove.keypoint_positions(info.hand, e.segment_R, e.segment_p, scale)[columns]
        given = (given - e.segment_p[0]) @ e.segment_R[0]
        true = (keypoints[i, columns] - keypoints[i, wrist]) @ R_GB[i]
        out[i] = np.linalg.norm(given - true, axis=1)
    return out


def _scale(tracked: RetrackedTrial, info: SessionInfo) -> Array:
    """Learned scales (S, 3); segments without a scale in the engine have the mean."""
    calibration = tracked.calibration
    if calibration is None:
        return np.ones((len(info.hand.segments), 3))
    scale = np.full((len(info.hand.segments), 3), float(np.nanmean(calibration.scale[:, 0])))
    for name, row in zip(calibration.segments, calibration.scale, strict=True):
        scale[info.hand.index[name]] = row
    return scale
