"""Inverse kinematics: joint angles and the dorsum's pose from points, by damped Gauss-Newton."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.kernels import kernel
from tracker.kernels.arrays import IntMatrix, IntVector, Matrix, Stack, Vector, Written
from tracker.simulation.kinematics import forward_many


class FittedSkeleton(NamedTuple):
    """parent (S,), -1 for the root; origin (S, 3) m in the parent's B; R_rest (S, 3, 3); column
    (S, 3) of abduction, flexion and twist among the angles, -1 where fixed; limits (J, 2) rad;
    coupling (C, 4): angle, other, ratio, offset of a soft synergy."""

    parent: IntVector
    origin: Matrix
    R_rest: Stack
    column: IntMatrix
    limits: Matrix
    coupling: Matrix


class PointTargets(NamedTuple):
    """Positions of the points: segment (T,), and position (T, 3) m in its B."""

    segment: IntVector
    local: Matrix


class Posture(NamedTuple):
    """angles (J,) rad, R_GB (3, 3) and p_GB (3,) m of the root."""

    angles: Vector
    R: Matrix
    p: Vector


@kernel
def solve_frames(
    hand: FittedSkeleton,
    targets: PointTargets,
    points: Stack,
    start: Posture,
    weights: Vector,
    iterations: int,
) -> tuple[Matrix, Stack, Matrix, Matrix]:
    """Solves the frames in order, each starting from the previous one.

    points (n, T, 3) m in G of the targets, NaN where missing. weights: 1 / standard deviation of (a
    point, 1/m; rest, 1/rad; change of angle, 1/rad; synergy, 1/rad). Returns angles (n, J), R_GB
    (n, 3, 3), p_GB (n, 3) of the root, residual (n, T) m.
    """
    parent, origin, R_rest, column = hand.parent, hand.origin, hand.R_rest, hand.column
    limits, segment, local = hand.limits, targets.segment, targets.local
    n, count = len(points), len(start.angles)
    twist, step = np.zeros(len(parent)), np.empty(6 + count)
    out_a, out_R = np.empty((n, count)), np.empty((n, 3, 3))
    out_p, residual = np.empty((n, 3)), np.full((n, len(local)), np.nan)
    a, R0, p0 = start.angles.copy(), start.R.copy(), start.p.copy()
    for k in range(n):
        before = a.copy()
        for _ in range(iterations):
            Rs, ps = forward_many(parent, origin, R_rest, column, twist, a.reshape(1, -1),
                                  R0.reshape(1, 3, 3), p0.reshape(1, 3))  # fmt: skip
            H, g = _normal_equations(hand, targets, points[k], a, Rs[0], ps[0], weights[0])
            _priors(H, g, a, before, hand.coupling, weights)
            step[:] = np.linalg.solve(H, g)
            p0 = p0 + step[:3]
            R0 = _rotated(step[3:6], R0)
            a = np.minimum(np.maximum(a + step[6:], limits[:, 0]), limits[:, 1])
        Rs, ps = forward_many(parent, origin, R_rest, column, twist, a.reshape(1, -1),
                              R0.reshape(1, 3, 3), p0.reshape(1, 3))  # fmt: skip
        for i in range(len(local)):
            gap = points[k, i] - (ps[0, segment[i]] + Rs[0, segment[i]] @ local[i])
            residual[k, i] = np.sqrt(gap[0] ** 2 + gap[1] ** 2 + gap[2] ** 2)
        out_a[k], out_R[k], out_p[k] = a, R0, p0
    return out_a, out_R, out_p, residual


@kernel
def _normal_equations(
    hand: FittedSkeleton,
    targets: PointTargets,
    points: Matrix,
    angles: Vector,
    R: Stack,
    p: Matrix,
    weight: float,
) -> tuple[Matrix, Vector]:
    """JᵀJ and Jᵀr over (p (3), rotation of the root in G (3), angles (J)), with the poses R
    (S, 3, 3), p (S, 3) of all segments."""
    parent, R_rest, column = hand.parent, hand.R_rest, hand.column
    segment, local = targets.segment, targets.local
    size = 6 + len(angles)
    H, g = np.zeros((size, size)), np.zeros(size)
    J = np.zeros((3, size))
    for i in range(len(local)):
        if np.isnan(points[i, 0]):
            continue
        x = p[segment[i]] + R[segment[i]] @ local[i]
        J[:] = 0.0
        for c in range(3):
            J[c, c] = 1.0
            unit = np.zeros(3)
            unit[c] = 1.0
            J[:, 3 + c] = np.cross(unit, x - p[0])
        s = segment[i]
        while parent[s] >= 0:
            _joint_columns(J, R[parent[s]] @ R_rest[s], R[s], column[s], angles, x - p[s])
            s = parent[s]
        r = points[i] - x
        H += weight * weight * (J.T @ J)
        g += weight * weight * (J.T @ r)
    return H, g


@kernel
def _joint_columns(
    J: Written[Matrix], base: Matrix, R: Matrix, column: IntVector, angles: Vector, arm: Vector
) -> None:
    """Axes in G of a joint Rz Ry Rx: base z; base Rz y; the segment's own x."""
    a = angles[column[0]] if column[0] >= 0 else 0.0
    if column[0] >= 0:
        J[:, 6 + column[0]] = np.cross(base[:, 2], arm)
    if column[1] >= 0:
        axis = np.cos(a) * base[:, 1] - np.sin(a) * base[:, 0]
        J[:, 6 + column[1]] = np.cross(axis, arm)
    if column[2] >= 0:
        J[:, 6 + column[2]] = np.cross(R[:, 0], arm)


@kernel
def _priors(
    H: Written[Matrix],
    g: Written[Vector],
    a: Vector,
    before: Vector,
    coupling: Matrix,
    weights: Vector,
) -> None:
    """Priors for rest, smoothness and synergies, which determine unobserved joints."""
    for j in range(len(a)):
        H[6 + j, 6 + j] += weights[1] ** 2 + weights[2] ** 2
        g[6 + j] += weights[1] ** 2 * (0.0 - a[j]) + weights[2] ** 2 * (before[j] - a[j])
    for c in range(len(coupling)):
        i, j, k = 6 + int(coupling[c, 0]), 6 + int(coupling[c, 1]), coupling[c, 2]
        w = weights[3] ** 2
        r = coupling[c, 3] + k * a[j - 6] - a[i - 6]
        H[i, i] += w
        H[j, j] += w * k * k
        H[i, j] -= w * k
        H[j, i] -= w * k
        g[i] += w * r
        g[j] -= w * k * r
    for j in range(6):
        H[j, j] += 1e-6


@kernel
def _rotated(step: Vector, R: Matrix) -> Matrix:
    """Exp(step) R, orthonormalised."""
    angle = np.sqrt(step[0] ** 2 + step[1] ** 2 + step[2] ** 2)
    K = np.array([[0.0, -step[2], step[1]], [step[2], 0.0, -step[0]], [-step[1], step[0], 0.0]])
    a = 1.0 if angle < 1e-8 else np.sin(angle) / angle
    b = 0.5 if angle < 1e-8 else (1 - np.cos(angle)) / angle**2
    out = (np.eye(3) + a * K + b * (K @ K)) @ R
    x = out[:, 0] / np.sqrt((out[:, 0] ** 2).sum())
    y = out[:, 1] - x * (x * out[:, 1]).sum()
    y = y / np.sqrt((y**2).sum())
    turned = np.empty((3, 3))
    turned[:, 0], turned[:, 1], turned[:, 2] = x, y, np.cross(x, y)
    return turned
