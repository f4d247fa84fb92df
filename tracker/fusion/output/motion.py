"""The motion of the whole hand from the motion of a filter's segments."""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from tracker.fusion.output.completion import ActiveSegments, HandTables, complete
from tracker.fusion.output.output import (
    Angles,
    EstimateFields,
    HandOutput,
    Keypoints,
    fields_of,
    keypoint_positions,
)
from tracker.geometry.kernels import cross3, log3, mul3, rotate, rotate_all
from tracker.kernels import kernel
from tracker.kernels.arrays import IntVector, Matrix, Stack, Vector
from tracker.messages import Estimate, Motion, Tracking

STEP = 1e-5  # s, step of the difference quotient of the completed hand
JOINT_RATE_SD = 0.8
"""rad/s: standard deviation of the rate of an unsensed joint about that given by its synergy or its
parent: corresponds to the 22° of `INFERRED_DEG` within a movement of half a second."""


class Rates(NamedTuple):
    """Motion of A active segments: v (A, 3) m/s of p_GB in G, w (A, 3) rad/s in B, and their
    standard deviations per axis, v_sd (A,) m/s and w_sd (A,) rad/s; turn_sd (A,) rad, of the
    rotation relative to the parent."""

    v: Matrix
    w: Matrix
    v_sd: Vector
    w_sd: Vector
    turn_sd: Vector


class WholeHand(NamedTuple):
    """The input of `hand_motion`: R_GB (S, 3, 3), p_GB (S, 3) m, points (K, 3) m in G and angles
    (J,) rad, as in an `Estimate`."""

    R: Stack
    p: Matrix
    points: Matrix
    angles: Vector


def moving(
    output: HandOutput, estimate: Estimate, active: ActiveSegments, rates: Rates
) -> Estimate:
    """The estimate by ``output`` for ``active``, with its motion."""
    if estimate.tracking == Tracking.SEARCHING:
        return estimate
    return replace(estimate, motion=motion_of(output, fields_of(estimate), active, rates))


def motion_of(
    output: HandOutput, found: EstimateFields, active: ActiveSegments, rates: Rates
) -> Motion:
    """The motion of the hand ``found`` by ``output`` for ``active``."""
    now = WholeHand(found.segment_R, found.segment_p, found.points, found.angles)
    tables = output.complete.tables, output.keypoints, output.angles
    return Motion(*hand_motion(*tables, active, rates, now))


@kernel(nogil=False)
def linked_rates(
    parent: IntVector,
    active: ActiveSegments,
    v: Vector,
    w: Matrix,
    v_sd: float,
    w_sd: Vector,
    turn_sd: Vector,
) -> tuple[Matrix, Matrix, Vector, Vector, Vector]:
    """The fields of `Rates`, in their order, of connected segments, parent (A,): the root's origin
    moves with v (3,) m/s, with standard deviation ``v_sd``; the other arguments are fields of the
    result."""
    n = len(parent)
    v_all, sd = np.empty((n, 3)), np.empty(n)
    v_all[0], sd[0] = v, v_sd
    for i in range(1, n):
        a = parent[i]
        lever = active.p[i] - active.p[a]
        v_all[i] = v_all[a] + cross3(rotate(active.R[a], w[a]), lever)
        sd[i] = np.sqrt(sd[a] ** 2 + _lever_variance(lever, w_sd[a] ** 2))
    return v_all, w, sd, w_sd, turn_sd


@kernel(nogil=False)
def hand_motion(
    hand: HandTables,
    keypoints: Keypoints,
    angles_of: Angles,
    active: ActiveSegments,
    rates: Rates,
    now: WholeHand,
) -> tuple[Matrix, Matrix, Vector, Vector, Vector, Vector, Vector]:
    """The fields of a `Motion`, in their order: the derivative of the completed hand."""
    # 1. the same hand a moment later
    R_next = rotate_all(active.R, rates.w * STEP)
    p_next = active.p + rates.v * STEP
    R, p, scale, angles, _ = complete(hand, ActiveSegments(R_next, p_next, active.scale))
    points, _ = keypoint_positions(keypoints, R, p, scale)
    linear, angle_rate = (points - now.points) / STEP, (angles - now.angles) / STEP
    # 2. variances per axis
    v_var, w_var = _variances(hand, rates, now.p)
    angular, linear_sd = np.empty_like(linear), np.empty(len(linear))
    angular_sd, rate_sd, angle_sd = (
        np.empty(len(linear)),
        np.empty(len(angles)),
        np.empty(len(angles)),
    )
    for k in range(len(linear)):
        s = keypoints.segment[k]
        angular[k] = log3(mul3(R[s], now.R[s].T)) / STEP
        linear_sd[k] = np.sqrt(v_var[s] + _lever_variance(now.points[k] - now.p[s], w_var[s]))
        angular_sd[k] = np.sqrt(w_var[s])
    for j in range(len(angles_of.column)):
        child, parent, column = angles_of.child[j], angles_of.parent[j], angles_of.column[j]
        rate_sd[column] = np.sqrt(w_var[child] + w_var[parent])
        row = hand.row[child]
        angle_sd[column] = rates.turn_sd[row] if row >= 0 else angles_of.inferred_sd[j]
    return linear, angular, linear_sd, angular_sd, angle_rate, rate_sd, angle_sd


@kernel
def _variances(hand: HandTables, rates: Rates, p: Matrix) -> tuple[Vector, Vector]:
    """(S,) m²/s² of each segment's origin and (S,) rad²/s² of its rotation, per axis."""
    parent, row = hand.parent, hand.row
    v, w = np.empty(len(parent)), np.empty(len(parent))
    for i in range(len(parent)):
        a = parent[i]
        if row[i] >= 0:
            v[i], w[i] = rates.v_sd[row[i]] ** 2, rates.w_sd[row[i]] ** 2
        else:
            v[i] = v[a] + _lever_variance(p[i] - p[a], w[a])
            w[i] = w[a] + JOINT_RATE_SD**2
    return v, w


@kernel
def _lever_variance(lever: Vector, w_var: float) -> float:
    """m²/s², mean of three axes, of w x lever for an angular velocity of variance ``w_var`` per
    axis."""
    return 2.0 / 3.0 * w_var * (lever[0] ** 2 + lever[1] ** 2 + lever[2] ** 2)
