"""The estimate of the whole hand from a filter's segments, with its validity states."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import product
from typing import NamedTuple

import numpy as np

from tracker.fusion.output.completion import ActiveSegments, Completion, HandTables, complete
from tracker.fusion.segments import EstimatedSegments
from tracker.geometry.kernels import quats, rotate_back
from tracker.kernels import kernel
from tracker.kernels.arrays import BoolVector, IntMatrix, IntVector, Matrix, Stack, Vector
from tracker.messages import Array, Estimate, IntArray, Tracking, Validity

INFERRED_DEG = {
    "thumb_metacarpal": 20.0,
    "ring_distal": 17.0,
    "little_distal": 17.0,
    "little_proximal": 23.0,
    "little_intermediate": 19.0,
    "proximal": 19.0,
    "intermediate": 16.0,
    "distal": 24.0,
}
"""Standard deviation of an unsensed joint about its synergy, flexion and abduction together: of a
segment, else of a finger's segments of that kind. Ring and little finger follow the middle finger.
An end joint beside a sensed one moves its tip along one line, for which 17° count as 24°."""
BASE_SD = 0.0022  # m per axis, of an unsensed knuckle
STRAIGHT_DEG, BENT_DEG = 40.0, 75.0
"""A finger next to one that is bent less than the first (MCP and PIP joint together) may be closed:
people point with two fingers. One next to a finger that is bent more than the second is bent."""
FREE, TOGETHER = 1.25, 0.95
FREE_DEG, TOGETHER_DEG = 115.0, 145.0
"""People bend the first two joints of half bent fingers independently, and close fingers together:
factors on `INFERRED_DEG` where MCP and PIP joint together are bent less, or more, than that."""
CLOSED_SHARE = 0.25
"""Standard deviation of a point on a finger that may be closed, relative to its distance from the
farthest position that its joints allow."""
WITHIN_LIMITS = tuple(product(np.linspace(0.0, 1.0, 5), repeat=2))
"""Possible postures of a digit without sensors, independent of its neighbours: relative to their
ranges, the flexion of its first joint, and of its other joints together."""
FLEXION = 1  # index among a joint's axes
LOST, INFERRED, MEASURED = int(Validity.LOST), int(Validity.INFERRED), int(Validity.MEASURED)


class Keypoints(NamedTuple):
    """K keypoints of a hand with S segments: segment (K,) the row each moves with, offset (K, 3) m
    in its nominal B, end_of (K,) the segment whose far end it is, -1 for none; sd_row (S,) the row
    of a segment whose end's standard deviation is given, -1 for the others, which have bend_sd (S,)
    rad relative to their parents; own_row (K,) the row of a keypoint whose own standard deviation
    is given, else -1, and knuckle (K,) whether it is the first joint of a digit without sensors;
    base (K,) the first segment of the keypoint's digit if that has
    no sensors, else -1, bends (K, 2) the flexions of that digit's first two joints among the
    angles, -1 for none, and reached (K, C, 3) m its position for each of `WITHIN_LIMITS`, from that
    digit's joint in the nominal B of the digit's parent."""

    segment: IntVector
    offset: Matrix
    end_of: IntVector
    sd_row: IntVector
    bend_sd: Vector
    own_row: IntVector
    knuckle: BoolVector
    base: IntVector
    bends: IntMatrix
    reached: Stack


class Angles(NamedTuple):
    """(k,) joint axes: child and parent segment of the joint, column among the hand's angles, and
    the standard deviation (rad) of the angle where the child is unsensed."""

    child: IntVector
    parent: IntVector
    column: IntVector
    inferred_sd: Vector


@dataclass(frozen=True, eq=False)
class Sensed:
    """The sensing state: per active segment, whether an IMU or a marker measured it recently."""

    segments: IntArray  # (A,) bool
    tracking: Tracking


class EstimateFields(NamedTuple):
    """Fields of an `Estimate` from ``keypoints`` on, in their order."""

    points: Array
    q: Array
    state: IntArray
    sd: Array
    angles: Array
    angle_state: IntArray
    segment_R: Array
    segment_p: Array


def fields_of(estimate: Estimate) -> EstimateFields:
    """The arrays of an estimate."""
    e = estimate
    return EstimateFields(
        e.keypoints, e.keypoint_q, e.keypoint_state, e.keypoint_sd, e.angles, e.angle_state,
        e.segment_R, e.segment_p,
    )  # fmt: skip


class HandOutput:
    """Builds estimates for one hand with one glove; `moving` adds the motion of the hand, from the
    same tables ``complete``, ``keypoints`` and ``angles``."""

    def __init__(
        self,
        segments: EstimatedSegments,
        driven: Sequence[int] = (),
        own: Sequence[int] | IntArray = (),
    ) -> None:
        """``driven`` are segments of the hand that are not estimated, but have standard deviations
        of their ends; ``own`` are keypoints that have standard deviations of their own."""
        self._segments = segments
        rows = {s: len(segments.active) + k for k, s in enumerate(driven)}
        self._sd_row = segments.row_of | rows
        hand = segments.hand
        self.complete = Completion(segments)
        self._keypoint_count = len(segments.glove.keypoint_names(hand))
        moves_with, end_of = segments.glove.keypoint_segments(hand), self._far_ends()
        offset = [hand.keypoint_offset, *(k.position[None] for k in segments.glove.keypoints)]
        offsets = np.concatenate(offset)
        own_row = np.full(self._keypoint_count, -1, np.int64)
        own_row[list(own)] = len(segments.active) + len(rows) + np.arange(len(own))
        sd_row = np.array([self._sd_row.get(s, -1) for s in range(len(hand.segments))], np.int64)
        self.keypoints = Keypoints(
            moves_with,
            offsets,
            end_of,
            sd_row,
            np.deg2rad([0.0, *(_inferred_deg(s.name) for s in hand.segments[1:])]),
            own_row,
            (end_of == hand.root) & (sd_row[moves_with] < 0),
            *self._unsensed_digits(moves_with, offsets),
        )
        columns, parent = np.array(hand.axis_columns), np.array(hand.parent, np.int64)
        child, axis = np.nonzero(columns >= 0)
        column = np.ascontiguousarray(columns[child, axis], np.int64)
        inferred = np.deg2rad([_inferred_deg(hand.segments[i].name) for i in child])
        self.angles = Angles(
            np.ascontiguousarray(child), np.maximum(parent[child], 0), column, inferred
        )

    def estimate(
        self, t: float, R: Array, p: Array, scale3: Array, sensed: Sensed, active_sd: Array
    ) -> Estimate:
        """The whole hand from active segments R_GB (A, 3, 3), p_GB (A, 3), scale3 (A, 3).

        active_sd (A + d + k,) m is the standard deviation of each active segment's end, then of
        each driven one's, then of the keypoints that have their own.
        """
        found = self.fields(R, p, scale3, sensed, active_sd)
        return self.nothing(t) if found is None else Estimate(t, sensed.tracking, *found)

    def fields(
        self, R: Array, p: Array, scale3: Array, sensed: Sensed, active_sd: Array
    ) -> EstimateFields | None:
        """The arrays of `estimate`; None while the hand is searched for."""
        if sensed.tracking == Tracking.SEARCHING:
            return None
        coasting = sensed.tracking == Tracking.COASTING
        lost = sensed.tracking == Tracking.LOST
        return EstimateFields(
            *whole_hand(
                self.complete.tables, self.keypoints, self.angles, ActiveSegments(R, p, scale3),
                sensed.segments, active_sd, coasting, lost,
            )
        )  # fmt: skip

    def _far_ends(self) -> IntArray:
        """(K,) parent of the segment whose base is the keypoint: measured if either is. -1:
        none."""
        hand = self._segments.hand
        out = np.full(self._keypoint_count, -1, np.int64)
        for k, s in enumerate(hand.keypoint_segment):
            if not np.any(hand.keypoint_offset[k]):
                out[k] = hand.parent[s]
        return out

    def _unsensed_digits(
        self, moves_with: IntArray, offset: Array
    ) -> tuple[IntArray, IntArray, Array]:
        """Per keypoint: the first segment of its digit if that has no sensors, else -1, the
        flexions of that digit, and the keypoint's position for each of `WITHIN_LIMITS`."""
        hand, row_of = self._segments.hand, self._segments.row_of
        base = np.full(len(moves_with), -1, np.int64)
        for k, s in enumerate(moves_with):
            first = int(s)
            while first not in row_of and hand.parent[first] not in row_of:
                first = hand.parent[first]
            if first not in row_of and hand.parent[first] == hand.root:
                base[k] = first
        bends = np.full((len(moves_with), 2), -1, np.int64)
        flexion = np.array(hand.axis_columns)[:, FLEXION]
        for row in np.flatnonzero(base >= 0):
            second = np.flatnonzero(np.array(hand.parent) == base[row])
            bends[row] = flexion[base[row]], flexion[second[0]] if len(second) else -1
        reached = np.zeros((len(moves_with), len(WITHIN_LIMITS), 3))
        low, high = hand.angle_limits.T
        moves, first = flexion >= 0, np.array(hand.parent) == hand.root
        for c, (near, far) in enumerate(WITHIN_LIMITS):
            angles, share = np.zeros(len(low)), np.where(first, near, far)[moves]
            column = flexion[moves]
            angles[column] = low[column] + share * (high - low)[column]
            R, p = hand.forward(angles, np.eye(3), np.zeros(3))
            points = p[moves_with] + np.einsum("kij,kj->ki", R[moves_with], offset)
            reached[:, c] = np.where(base[:, None] >= 0, points - p[base], 0.0)
        return base, bends, reached

    def nothing(self, t: float) -> Estimate:
        """The estimate while the hand is searched for."""
        hand, k = self._segments.hand, self._keypoint_count
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


def _inferred_deg(segment: str) -> float:
    kind = segment if segment in INFERRED_DEG else segment.rsplit("_", 1)[-1]
    return INFERRED_DEG[kind]


@kernel(nogil=False)
def whole_hand(
    hand: HandTables,
    keypoints: Keypoints,
    angles_of: Angles,
    active: ActiveSegments,
    sensed: IntVector,
    active_sd: Vector,
    coasting: bool,
    lost: bool,
) -> tuple[Matrix, Matrix, IntVector, Vector, Vector, IntVector, Stack, Matrix]:
    """The fields of an `Estimate` except its time and tracking, in their order.

    sensed (A,) as in `sensed_lately`, active_sd (A + d + k,) m. While the hand is ``lost`` no
    keypoint has a position.
    """
    R, p, scale, angles, known = complete(hand, active)
    points, q = keypoint_positions(keypoints, R, p, scale)
    of_segment = segment_states(hand.row, sensed)
    state = keypoint_states(of_segment, keypoints, coasting)
    away = farthest(keypoints, hand.parent, points, R, p, scale)
    open_sd = CLOSED_SHARE * away * may_be_closed(keypoints, angles)
    apart = independence(keypoints, angles)
    sd = keypoint_sds(keypoints, hand.parent, active_sd, points, p, (open_sd, apart))
    if lost:
        state[:], points[:], q[:] = LOST, np.nan, np.nan
    return points, q, state, sd, angles, angle_states(of_segment, angles_of, known), R, p


@kernel(nogil=False)
def sensed_lately(
    felt: Vector,
    imu_segment: IntVector,
    seen: Vector,
    marker_segment: IntVector,
    segments: int,
    t: float,
    lately: float,
) -> IntVector:
    """(A,) 1 for each of the active ``segments`` with a valid IMU, or a matched marker, less than
    ``lately`` s before ``t``; felt (n,) and seen (M,) s are the last times of each."""
    out = np.zeros(segments, np.int64)
    for j in range(len(felt)):
        if t - felt[j] < lately:
            out[imu_segment[j]] = 1
    for j in range(len(seen)):
        if t - seen[j] < lately:
            out[marker_segment[j]] = 1
    return out


@kernel
def keypoint_positions(
    keypoints: Keypoints, R: Stack, p: Matrix, scale: Matrix
) -> tuple[Matrix, Matrix]:
    """Keypoints (K, 3) m in G and their quaternions (K, 4), from R (S, 3, 3), p (S, 3) and scale
    (S, 3) of all segments."""
    segment, offset = keypoints.segment, keypoints.offset
    q_all = quats(R)
    points, q = np.empty((len(segment), 3)), np.empty((len(segment), 4))
    for k in range(len(segment)):
        s = segment[k]
        q[k] = q_all[s]
        for i in range(3):
            points[k, i] = p[s, i]
            for j in range(3):
                points[k, i] += R[s, i, j] * scale[s, j] * offset[k, j]
    return points, q


@kernel
def segment_states(row: IntVector, sensed: IntVector) -> IntVector:
    """(S,) measured where the active segment of ``row`` (S,), -1 for none, is sensed (A,)."""
    out = np.full(len(row), INFERRED)
    for s in range(len(row)):
        if row[s] >= 0 and sensed[row[s]] != 0:
            out[s] = MEASURED
    return out


@kernel
def angle_states(segment_state: IntVector, angles: Angles, known: BoolVector) -> IntVector:
    """(J,) measured where an angle is known and both its segments are."""
    out = np.full(len(known), INFERRED)
    child, parent, column, _ = angles
    for k in range(len(column)):
        both = segment_state[child[k]] == MEASURED and segment_state[parent[k]] == MEASURED
        if both and known[column[k]]:
            out[column[k]] = MEASURED
    return out


@kernel
def keypoint_states(segment_state: IntVector, keypoints: Keypoints, coasting: bool) -> IntVector:
    """(K,) the state of the segment each moves with, or whose far end it is; the first joint of a
    digit without sensors is inferred.

    While coasting no position of a hand is measured.
    """
    segment, end_of = keypoints.segment, keypoints.end_of
    out = np.empty(len(segment), np.int64)
    for k in range(len(segment)):
        state = segment_state[segment[k]]
        if end_of[k] >= 0 and not keypoints.knuckle[k]:
            state = max(state, segment_state[end_of[k]])
        out[k] = min(state, INFERRED) if coasting else state
    return out


@kernel
def farthest(
    keypoints: Keypoints, parent: IntVector, points: Matrix, R: Stack, p: Matrix, scale: Matrix
) -> Vector:
    """(K,) m from each of the ``points`` (K, 3) on a digit without sensors to the farthest position
    that digit's joints allow; 0 on other digits."""
    out = np.zeros(len(points))
    for k in range(len(points)):
        base = keypoints.base[k]
        if base < 0:
            continue
        here = rotate_back(R[parent[base]], points[k] - p[base])
        for c in range(keypoints.reached.shape[1]):
            total = 0.0
            for i in range(3):
                total += (here[i] - scale[base, i] * keypoints.reached[k, c, i]) ** 2
            out[k] = max(out[k], np.sqrt(total))
    return out


@kernel
def may_be_closed(keypoints: Keypoints, angles: Vector) -> Vector:
    """(K,) 1 for points on a digit without sensors that is straight like its neighbours, 0 on a
    bent one and on other digits, from the ``angles`` (J,) rad."""
    out = np.zeros(len(keypoints.base))
    straight, bent = np.deg2rad(STRAIGHT_DEG), np.deg2rad(BENT_DEG)
    for k in range(len(out)):
        if keypoints.base[k] >= 0:
            share = (bent - _bent(keypoints, angles, k)) / (bent - straight)
            out[k] = min(max(share, 0.0), 1.0)
    return out


@kernel
def independence(keypoints: Keypoints, angles: Vector) -> Vector:
    """(K,) factor on the standard deviation of the first two joints of a digit without sensors, 1
    on other digits, from the ``angles`` (J,) rad."""
    out = np.ones(len(keypoints.base))
    free, together = np.deg2rad(FREE_DEG), np.deg2rad(TOGETHER_DEG)
    for k in range(len(out)):
        if keypoints.base[k] >= 0:
            share = (_bent(keypoints, angles, k) - free) / (together - free)
            out[k] = FREE + (TOGETHER - FREE) * min(max(share, 0.0), 1.0)
    return out


@kernel
def _bent(keypoints: Keypoints, angles: Vector, k: int) -> float:
    """rad, of the first two joints of the keypoint's digit together."""
    total = 0.0
    for column in keypoints.bends[k]:
        if column >= 0:
            total += angles[column]
    return total


@kernel
def keypoint_sds(
    keypoints: Keypoints,
    parent: IntVector,
    active_sd: Vector,
    points: Matrix,
    p: Matrix,
    posture: tuple[Vector, Vector],
) -> Vector:
    """(K,) m: a keypoint's own, else from that of the nearest ancestor, the joints between them,
    with the ``points`` (K, 3) and the segments' origins p (S, 3) m (docs/chain.md, eq. 55), and
    by ``posture`` open_sd (K,) m of straight digits without sensors (eq. 62) and `independence`."""
    open_sd, apart = posture
    out = np.empty(len(points))
    for k in range(len(points)):
        a = keypoints.end_of[k] if keypoints.end_of[k] >= 0 else keypoints.segment[k]
        variance = open_sd[k] ** 2
        if keypoints.knuckle[k]:
            variance += BASE_SD**2
        if keypoints.own_row[k] >= 0:
            out[k] = np.sqrt(active_sd[keypoints.own_row[k]] ** 2 + variance)
            continue
        while keypoints.sd_row[a] < 0:
            if parent[a] == 0:
                variance += BASE_SD**2
            lever2 = 0.0
            for i in range(3):
                lever2 += (points[k, i] - p[a, i]) ** 2
            bend_sd, base = keypoints.bend_sd[a], keypoints.base[k]
            if base >= 0 and (a == base or parent[a] == base):
                bend_sd *= apart[k]
            variance += lever2 * bend_sd**2 / 3.0
            a = parent[a]
        out[k] = np.sqrt(active_sd[keypoints.sd_row[a]] ** 2 + variance)
    return out
