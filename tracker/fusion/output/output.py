"""From a filter's segments to the estimate of the whole hand, with its validity."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.output import output_kernel as kernel
from tracker.fusion.output.completion import Completion
from tracker.messages import Array, Estimate, IntArray, Tracking, Validity

INFERRED_SD = 0.0037  # m that each segment beyond the last estimated one adds


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
        self._keypoint_offset = np.concatenate(
            [hand.keypoint_offset, *(k.position[None] for k in layout.glove.keypoints)]
        )
        self._end_of = self._far_ends()
        self._sensed_ancestor, self._steps = self._ancestors()

    def estimate(
        self, t: float, R: Array, p: Array, scale3: Array, sensed: Sensed, active_sd: Array
    ) -> Estimate:
        """The whole hand from active segments R_GB (A, 3, 3), p_GB (A, 3), scale3 (A, 3).

        active_sd (A,) m is the standard deviation of each active segment's tip.
        """
        if sensed.tracking == Tracking.SEARCHING:
            return self._nothing(t)
        coasting = sensed.tracking == Tracking.COASTING
        lost = sensed.tracking == Tracking.LOST
        points, q, state, sd, angles, angle_state, R_all, p_all = kernel.whole_hand(
            *self.complete.tables, self._keypoint_segments, self._keypoint_offset, self._end_of,
            self._sensed_ancestor, self._steps, self._angle_segment, self._angle_parent,
            self._angle_column, R, p, scale3, sensed.segments, active_sd, INFERRED_SD, coasting,
            lost,
        )  # fmt: skip
        return Estimate(t, sensed.tracking, points, q, state, sd, angles, angle_state, R_all, p_all)

    def _far_ends(self) -> IntArray:
        """(K,) parent of the segment whose base a keypoint is: measured if either is. -1: none."""
        hand = self._layout.hand
        out = np.full(self._keypoint_count, -1, np.int64)
        for k, s in enumerate(hand.keypoint_segment):
            if not np.any(hand.keypoint_offset[k]):
                out[k] = hand.parent[s]
        return out

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
