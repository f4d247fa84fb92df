"""From a filter's segments to the estimate of the whole hand, with its validity."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker.fusion.completion import Completion
from tracker.fusion.layout import ChainLayout
from tracker.geometry.kernels import quats
from tracker.messages import Array, Estimate, IntArray, Tracking, Validity


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
        angle_state = self._angle_state(sensed, known)
        segment_state = self._segment_state(sensed)
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
        for i, row in self._layout.row_of.items():
            if sensed.segments[row]:
                out[i] = Validity.MEASURED
        return out

    def _angle_state(self, sensed: Sensed, known: Array) -> IntArray:
        segment = self._segment_state(sensed)
        hand = self._layout.hand
        out = np.full(len(hand.joint_names), int(Validity.INFERRED), np.int64)
        for i, columns in enumerate(hand.axis_columns):
            both = segment[i] == segment[max(hand.parent[i], 0)] == Validity.MEASURED
            for c in columns:
                if c >= 0 and both and known[c]:
                    out[c] = Validity.MEASURED
        return out

    def _keypoint_state(self, segment: IntArray, tracking: Tracking) -> IntArray:
        """A keypoint's place needs the hand's place: lost with it, inferred while coasting."""
        out = segment[self._keypoint_segments].copy()
        hand = self._layout.hand
        # the base of a segment is the end of its parent: measured if the parent is
        for k, (i, offset) in enumerate(
            zip(hand.keypoint_segment, hand.keypoint_offset, strict=True)
        ):
            parent = hand.parent[i]
            if not np.any(offset) and parent >= 0:
                out[k] = max(out[k], segment[parent])
        if tracking == Tracking.LOST:
            out[:] = Validity.LOST
        elif tracking == Tracking.COASTING:
            out[out == Validity.MEASURED] = Validity.INFERRED
        return out

    def _keypoint_sd(self, active_sd: Array) -> Array:
        hand, lay = self._layout.hand, self._layout
        sd = np.empty(len(hand.segments))
        for i in range(len(sd)):
            row = lay.row_of.get(i)
            sd[i] = active_sd[row] if row is not None else np.hypot(sd[hand.parent[i]], 0.004)
        return sd[self._keypoint_segments]

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
