"""Estimates of the hand with fingers that were measured in images."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from tracker.fusion.output.output import INFERRED, MEASURED, EstimateFields, Keypoints
from tracker.hand.model import HandModel
from tracker.messages import Array

JOINTS = 4  # of a finger with its tip
SURE_ANGLE = np.deg2rad(12.0)  # rad, sd up to which an angle is measured
DRIFT = 0.012  # m per axis after `DRIFT_TIME` without an image, growing with the square root
DRIFT_TIME = 0.1  # s


class FingerRows(NamedTuple):
    """A finger's segments, from the palm, and columns of its joint axes among the hand's angles:
    flexion and abduction of the first, flexion of the second and third joint."""

    segments: tuple[int, int, int]
    columns: tuple[int, int, int, int]

    @classmethod
    def of(cls, hand: HandModel, segments: tuple[int, int, int]) -> FingerRows:
        """Raises ValueError if an axis is missing."""
        first, second, third = (hand.axis_columns[s] for s in segments)
        columns = (first[1], first[0], second[1], third[1])
        if min(columns) < 0:
            raise ValueError("a finger needs flexion of all joints and abduction of the first")
        return cls(segments, columns)


class MeasuredFingers(NamedTuple):
    """For d fingers, measured at the times t (d,) s: angles (d, 4) rad of the columns of ``rows``,
    origin (d, 3) m of their first segments in the nominal B of the palm, variance (d, 4) m² per
    axis of the joints and the tip relative to the palm, angle_sd (d, 3) rad without the last joint,
    whether the fit is displayed (d,), else the neighbour's posture as far as the images allow, and
    whether the finger was seen (d,)."""

    t: Array
    rows: tuple[FingerRows, ...]
    angles: Array
    origin: Array
    variance: Array
    angle_sd: Array
    is_fitted: NDArray[np.bool_]
    is_seen: NDArray[np.bool_]

    def placed(self) -> tuple[dict[int, float], dict[int, Array]]:
        """Angles by their columns and origins by their segments."""
        angles: dict[int, float] = {}
        origin: dict[int, Array] = {}
        for k, row in enumerate(self.rows):
            angles.update(zip(row.columns, self.angles[k].tolist(), strict=True))
            origin[row.segments[0]] = self.origin[k]
        return angles, origin

    def judged(
        self, found: EstimateFields, keypoints: Keypoints, t: float, palm_variance: float
    ) -> EstimateFields:
        """The fields with the standard deviations and states of these fingers; the palm has the
        variance ``palm_variance`` m² per axis."""
        sd, state, angle_state = found.sd.copy(), found.state.copy(), found.angle_state.copy()
        drift = DRIFT**2 * np.maximum(t - self.t, 0.0) / DRIFT_TIME
        palm_measured = bool((state == MEASURED).any())
        for k, row in enumerate(self.rows):
            for i, segment in enumerate(row.segments):
                for j in np.flatnonzero(keypoints.segment == segment):
                    joint = i + int(np.any(keypoints.offset[j]))
                    moving = drift[k] * joint / (JOINTS - 1)
                    fitted = np.sqrt(palm_variance + self.variance[k, joint] + moving)
                    sd[j] = fitted if self.is_fitted[k] else max(sd[j], fitted)
                    if state[j] == INFERRED and self.is_seen[k] and palm_measured:
                        state[j] = MEASURED
            if self.is_seen[k] and palm_measured:
                for column, spread in zip(row.columns, self.angle_sd[k], strict=False):
                    if spread <= SURE_ANGLE:
                        angle_state[column] = MEASURED
        return found._replace(sd=sd, state=state, angle_state=angle_state)
