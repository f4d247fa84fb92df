"""The estimates of a session as arrays."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from tracker.base.clock import NS
from tracker.base.errors import ConfigError, FileError
from tracker.base.notices import notice
from tracker.messages import Array, Estimate, IntArray, Validity
from tracker.session.description import SessionInfo
from tracker.session.edits import WORD, Mask, masks
from tracker.session.export.options import BONE_AXES, OPENXR_AXES
from tracker.session.mcap.input import RawMessage
from tracker.session.number_rows import (
    DeviationRows,
    NumberRows,
    StateRows,
    TransformRows,
    at_stamps,
)
from tracker.session.reader import SessionReader
from tracker.session.ros import topics


@dataclass(frozen=True, eq=False)
class EstimateSeries:
    """N estimates: stamp_ns (N,), keypoints (N, K, 3) m, q (N, K, 4), state (N, K), sd (N, K) m,
    angles (N, J) rad, angle_state (N, J); NaN where lost. segment_p (N, S, 3) m and segment_q (N,
    S, 4) of all the hand's segments, whatever `only` keeps. ``zero_ns`` was subtracted from the
    stamps. ``radius`` (K,) m of the fingers at the keypoints, if these are OpenXR's joints.
    ``point_filled`` (N, K) and ``angle_filled`` (N, J): in gaps that an edit filled.
    """

    info: SessionInfo
    keypoint_names: tuple[str, ...]
    joint_names: tuple[str, ...]
    stamp_ns: IntArray
    keypoints: Array
    q: Array
    state: IntArray
    sd: Array
    angles: Array
    angle_state: IntArray
    segment_p: Array
    segment_q: Array
    zero_ns: int = 0
    notes: dict[str, object] = field(default_factory=dict)
    radius: Array | None = None
    point_filled: Mask | None = None
    angle_filled: Mask | None = None

    @property
    def interpolated(self) -> Mask:
        """(N, K) keypoints that an edit filled."""
        return self._filled(self.point_filled, self.state)

    @property
    def angles_interpolated(self) -> Mask:
        """(N, J) likewise."""
        return self._filled(self.angle_filled, self.angle_state)

    @staticmethod
    def _filled(mask: Mask | None, state: IntArray) -> Mask:
        if mask is None:
            return np.zeros(state.shape, bool)
        return np.asarray(mask & (state == Validity.INFERRED))

    @property
    def bone_axes(self) -> str:
        """Describes the axes that `q` rotates."""
        return BONE_AXES if self.radius is None else OPENXR_AXES

    def __len__(self) -> int:
        return len(self.stamp_ns)

    def rows(self, rows: IntArray) -> EstimateSeries:
        """A selection of the estimates."""
        return replace(
            self,
            stamp_ns=self.stamp_ns[rows],
            keypoints=self.keypoints[rows],
            q=self.q[rows],
            state=self.state[rows],
            sd=self.sd[rows],
            angles=self.angles[rows],
            angle_state=self.angle_state[rows],
            segment_p=self.segment_p[rows],
            segment_q=self.segment_q[rows],
            point_filled=None if self.point_filled is None else self.point_filled[rows],
            angle_filled=None if self.angle_filled is None else self.angle_filled[rows],
        )

    def between(self, start: float | None, stop: float | None) -> EstimateSeries:
        """Returns those from ``start`` to ``stop``, s from the first. Raises FileError if empty."""
        low = -np.inf if start is None else start
        high = np.inf if stop is None else stop
        rows = np.flatnonzero((self.elapsed >= low) & (self.elapsed <= high))
        if len(rows) == 0:
            raise FileError(notice("session.none_between", start_s=low, end_s=high))
        return self.rows(rows)

    def only(self, names: tuple[str, ...]) -> EstimateSeries:
        """Returns only keypoints and angles of those names. Raises ConfigError for an unknown
        one."""
        for name in names:
            if name not in self.keypoint_names and name not in self.joint_names:
                raise ConfigError(notice("session.no_joint", name=name))
        points = [i for i, n in enumerate(self.keypoint_names) if n in names]
        joints = [i for i, n in enumerate(self.joint_names) if n in names]
        return replace(
            self,
            keypoint_names=tuple(self.keypoint_names[i] for i in points),
            joint_names=tuple(self.joint_names[i] for i in joints),
            keypoints=self.keypoints[:, points],
            q=self.q[:, points],
            state=self.state[:, points],
            sd=self.sd[:, points],
            angles=self.angles[:, joints],
            angle_state=self.angle_state[:, joints],
            point_filled=None if self.point_filled is None else self.point_filled[:, points],
            angle_filled=None if self.angle_filled is None else self.angle_filled[:, joints],
        )

    @property
    def elapsed(self) -> Array:
        """(N,) s from the first estimate."""
        return (self.stamp_ns - self.stamp_ns[0]) / NS

    @property
    def rate(self) -> float:
        """Estimates per second: the inverse of the median step."""
        return 100.0 if len(self) < 2 else NS / float(np.median(np.diff(self.stamp_ns)))

    @property
    def even(self) -> bool:
        """Whether all steps are the same within a thousandth."""
        steps = np.diff(self.stamp_ns)
        return len(steps) == 0 or bool(np.ptp(steps) < 1e-3 * np.median(steps))


def recorded_series(reader: SessionReader, segments: bool = True) -> EstimateSeries:
    """As `read_series`; raises FileError if the session contains no estimates."""
    series = read_series(reader, segments)
    if not len(series):
        raise FileError(notice("session.not_tracked", path=reader.path))
    return series


def read_series(reader: SessionReader, segments: bool = True) -> EstimateSeries:
    """Reads all estimates of the reader's hand, unchanged, in the order of their stamps.

    Without ``segments``, which take most of the time, these are (N, 0, 3) and (N, 0, 4).
    """
    side, info = reader.info.side, reader.info
    rows = {f"{side}_{s}": i for i, s in enumerate(info.hand.segment_names)} if segments else {}
    poses, joints, deviations = NumberRows(8 * 7), NumberRows(8), DeviationRows()
    states = StateRows(info.keypoint_names, info.hand.joint_names)
    transforms = TransformRows(rows, reader.source.left_out)
    feed: dict[str, Callable[[RawMessage], None]] = {
        topics.hand(side, "keypoints"): lambda raw: poses.feed_poses(raw.data),
        topics.hand(side, "joint_states"): lambda raw: joints.feed_joints(raw.data),
        topics.hand(side, "keypoint_sd"): lambda raw: deviations.feed(raw.data, len(poses.stamps)),
        topics.hand(side, "states"): lambda raw: states.feed(raw.data, len(poses.stamps)),
    }
    if segments:
        feed[topics.TF] = transforms.feed
    for raw in reader.raw_messages(frozenset(feed)):
        with reader.source.left_out.reading(raw.topic, raw.log_time):
            feed[raw.topic](raw)
    n, k = len(poses.stamps), len(info.keypoint_names)
    stamp, table = np.array(poses.stamps, np.int64), poses.table(k)
    angles = at_stamps(stamp, *joints.by_name(info.hand.joint_names))
    state, angle_state = states.of("keypoints", n), states.of("joints", n)
    state[~np.isfinite(table[:, :, :3]).all(axis=2)] = Validity.LOST
    angle_state[~np.isfinite(angles)] = Validity.LOST
    p, R = transforms.at(stamp)
    series = EstimateSeries(
        info, info.keypoint_names, info.hand.joint_names, stamp, table[:, :, :3], table[:, :, 3:],
        state.astype(np.int64), deviations.table((n, k)), angles, angle_state.astype(np.int64),
        p, _quaternions(R),
    )  # fmt: skip
    return _with_edits(reader, _in_order(series))


def _in_order(series: EstimateSeries) -> EstimateSeries:
    """By their stamps; those of one stamp as they were written."""
    order = np.argsort(series.stamp_ns, kind="stable")
    return series if (order == np.arange(len(series))).all() else series.rows(order)


def _with_edits(reader: SessionReader, series: EstimateSeries) -> EstimateSeries:
    if not reader.edits:
        return series
    points, angles = masks(
        reader.edits, reader.info.side, series.stamp_ns, series.keypoint_names, series.joint_names
    )
    return replace(series, point_filled=points, angle_filled=angles)


def series_of(info: SessionInfo, found: Sequence[Estimate]) -> EstimateSeries:
    """Returns estimates in the order of their times; without estimates it has no rows."""
    k, j, s = len(info.keypoint_names), len(info.hand.joint_names), len(info.hand.segments)
    return EstimateSeries(
        info,
        info.keypoint_names,
        info.hand.joint_names,
        np.array([info.anchor.wall(m.t) for m in found], np.int64),
        np.array([m.keypoints for m in found]).reshape(-1, k, 3),
        np.array([m.keypoint_q for m in found]).reshape(-1, k, 4),
        np.array([m.keypoint_state for m in found], np.int64).reshape(-1, k),
        np.array([m.keypoint_sd for m in found]).reshape(-1, k),
        np.array([m.angles for m in found]).reshape(-1, j),
        np.array([m.angle_state for m in found], np.int64).reshape(-1, j),
        np.array([m.segment_p for m in found]).reshape(-1, s, 3),
        _quaternions(np.array([m.segment_R for m in found]).reshape(-1, s, 3, 3)),
    )


def _quaternions(R: Array) -> Array:
    """(..., 4) xyzw of (..., 3, 3); NaN where lost."""
    from scipy.spatial.transform import Rotation  # deferred: slow to load

    q = np.full((*R.shape[:-2], 4), np.nan)
    known = np.isfinite(R).all(axis=(-1, -2))
    if known.any():
        q[known] = Rotation.from_matrix(R[known]).as_quat()
    return q


def state_names(state: IntArray, filled: Mask) -> list[str]:
    """measured, inferred, interpolated or lost for each number."""
    names = [Validity(int(s)).name.lower() for s in state]
    return [WORD if f else name for name, f in zip(names, filled, strict=True)]


def seconds_text(ns: int) -> str:
    """Seconds to the microsecond; a float does not have enough digits for times since 1970."""
    whole, micro = divmod(round(ns / 1000), 1_000_000)
    return f"{whole}.{micro:06d}"
