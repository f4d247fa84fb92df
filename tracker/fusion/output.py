"""From a filter's segments to the estimate of the whole hand, with its validity."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker.fusion.completion import Completion
from tracker.fusion.layout import ChainLayout
from tracker.geometry.kernels import quats
from tracker.messages import Array, Estimate, IntArray, Tracking, Validity

INFERRED_SD = 0.004  # m that each segment beyond the last estimated one adds


@dataclass(frozen=True, eq=False)
class Sensed:
    """What is known to be seen: per active segment, whether an IMU or a marker saw it lately."""

    segments: IntArray  # (A,) bool
    tracking: Tracking


class HandOutput:
    """Builds estimates for one hand with one glove."""

    def __init__(self, layout: ChainLayout) -> None:
        self._layout = layout
        hand = layout.hand
        self.complete = Completion(layout)
        self._keypoint_segments = layout.glove.keypoint_segments(hand)
        self._keypoint_count = len(layout.glove.keypoint_names(hand))
        columns, parent = np.array(hand.axis_columns), np.array(hand.parent)
        self._angle_segment, axis = np.nonzero(columns >= 0)
        self._angle_column = columns[self._angle_segment, axis]
        self._angle_parent = np.maximum(parent[self._angle_segment], 0)
        self._base, self._base_parent = self._bases()
        self._sensed_ancestor, self._steps = self._ancestors()

    def estimate(
        self, t: float, R: Array, p: Array, scale3: Array, sensed: Sensed, active_sd: Array
    ) -> Estimate:
        """The whole hand from active segments R_GB (A, 3, 3), p_GB (A, 3), scale3 (A, 3).

        active_sd (A,) m is the standard deviation of each active segment's tip.
        """
        lay, hand = self._layout, self._layout.hand
        if sensed.tracking == Tracking.SEARCHING:
            return self._nothing(t)
        R_all, p_all, scale_all, angles, known = self.complete(R, p, scale3)
        points = lay.glove.keypoint_positions(hand, R_all, p_all, scale_all)
        segment_state = self._segment_state(sensed)
        angle_state = self._angle_state(segment_state, known)
        keypoint_state = self._keypoint_state(segment_state, sensed.tracking)
        lost = keypoint_state == Validity.LOST
        points[lost] = np.nan
        q = quats(R_all)[self._keypoint_segments]
        q[lost] = np.nan
        angles = np.where(angle_state == Validity.LOST, np.nan, angles)
        return Estimate(
            t=t,
            tracking=sensed.tracking,
            keypoints=points,
            keypoint_q=q,
            keypoint_state=keypoint_state,
            keypoint_sd=self._keypoint_sd(active_sd),
            angles=angles,
            angle_state=angle_state,
            segment_R=R_all,
            segment_p=p_all,
        )

    def _segment_state(self, sensed: Sensed) -> IntArray:
        """(S,) measured where an IMU or marker saw it; inferred otherwise."""
        out = np.full(len(self._layout.hand.segments), int(Validity.INFERRED), np.int64)
        out[self._layout.active[sensed.segments != 0]] = Validity.MEASURED
        return out

    def _angle_state(self, segment: IntArray, known: Array) -> IntArray:
        """(J,) measured where the segment and its parent are."""
        measured = segment == Validity.MEASURED
        both = measured[self._angle_segment] & measured[self._angle_parent]
        out = np.full(len(self._layout.hand.joint_names), int(Validity.INFERRED), np.int64)
        out[self._angle_column[both & known[self._angle_column].astype(bool)]] = Validity.MEASURED
        return out

    def _bases(self) -> tuple[IntArray, IntArray]:
        """Keypoints at the base of a segment, and that segment's parent."""
        hand = self._layout.hand
        parent = np.array(hand.parent)[list(hand.keypoint_segment)]
        base = np.flatnonzero(~np.any(hand.keypoint_offset, axis=1) & (parent >= 0))
        return base, parent[base]

    def _ancestors(self) -> tuple[IntArray, IntArray]:
        """Per segment: active row of itself or its nearest active ancestor, and steps to it."""
        hand, row_of = self._layout.hand, self._layout.row_of
        row, steps = np.zeros((2, len(hand.segments)), np.int64)
        for i in range(len(row)):
            if i in row_of:
                row[i] = row_of[i]
            else:
                row[i], steps[i] = row[hand.parent[i]], steps[hand.parent[i]] + 1
        return row, steps

    def _keypoint_state(self, segment: IntArray, tracking: Tracking) -> IntArray:
        """A keypoint's place needs the hand's place: lost with it, inferred while coasting."""
        out = segment[self._keypoint_segments].copy()
        # the base of a segment is the end of its parent: measured if the parent is
        out[self._base] = np.maximum(out[self._base], segment[self._base_parent])
        if tracking == Tracking.LOST:
            out[:] = Validity.LOST
        elif tracking == Tracking.COASTING:
            out[out == Validity.MEASURED] = Validity.INFERRED
        return out

    def _keypoint_sd(self, active_sd: Array) -> Array:
        own = active_sd[self._sensed_ancestor] ** 2
        return np.sqrt(own + self._steps * INFERRED_SD**2)[self._keypoint_segments]

    def _nothing(self, t: float) -> Estimate:
        hand, k = self._layout.hand, self._keypoint_count
        n, j = len(hand.segments), len(hand.joint_names)
        return Estimate(
            t=t,
            tracking=Tracking.SEARCHING,
            keypoints=np.full((k, 3), np.nan),
            keypoint_q=np.full((k, 4), np.nan),
            keypoint_state=np.full(k, int(Validity.LOST), np.int64),
            keypoint_sd=np.full(k, np.nan),
            angles=np.full(j, np.nan),
            angle_state=np.full(j, int(Validity.LOST), np.int64),
            segment_R=np.full((n, 3, 3), np.nan),
            segment_p=np.full((n, 3), np.nan),
        )
