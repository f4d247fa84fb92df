"""Completes the hand from the segments that a filter estimates: the rest by synergy or rest pose.

`HandModel` implements the same in plain Python, except for `anatomical_synergies`; this form is for
a hundred calls per second.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

import numpy as np

from tracker.fusion.output.anatomy import anatomical_synergies
from tracker.fusion.segments import EstimatedSegments
from tracker.geometry.kernels import joint_angles3, mul3, rotate, tmul3
from tracker.kernels import kernel
from tracker.kernels.arrays import BoolVector, IntMatrix, IntVector, Matrix, Stack, Vector
from tracker.messages import Array


class HandTables(NamedTuple):
    """For the S segments of a hand: parent (S,), origin (S, 3) m, R_rest (S, 3, 3), columns (S, 3)
    of a joint's abduction, flexion and twist among the angles, -1 for none; limits (J, 2) rad of
    the angles; of the synergies links (k, 2), an angle and the one that drives it, and gains (k, 2)
    ratio and offset (rad); row (S,) among the active segments, -1 for none; lateral (S,) rad, fixed
    abduction of a segment that has no such joint axis; measured (J,) rad, angles that were measured
    apart from the filter, NaN for the others."""

    parent: IntVector
    origin: Matrix
    R_rest: Stack
    columns: IntMatrix
    limits: Matrix
    links: IntMatrix
    gains: Matrix
    row: IntVector
    lateral: Vector
    measured: Vector


class ActiveSegments(NamedTuple):
    """The segments a filter estimates: R_GB (A, 3, 3), p_GB (A, 3) m, scale (A, 3) along B."""

    R: Stack
    p: Matrix
    scale: Matrix


class Completion:
    """Index arrays of one hand with one glove and the kernel that uses them."""

    def __init__(self, segments: EstimatedSegments) -> None:
        hand = segments.hand
        row = np.full(len(hand.segments), -1, np.int64)
        row[segments.active] = np.arange(len(segments.active))
        own = anatomical_synergies(hand)
        self._anatomical = np.array([[s.ratio, s.offset] for s in own]).reshape(-1, 2)
        synergies = (*hand.synergies, *own)
        links = [[hand.angle_index[s.angle], hand.angle_index[s.of]] for s in synergies]
        self.tables = HandTables(
            np.array(hand.parent, np.int64),
            np.array([s.origin for s in hand.segments]),
            np.array([s.R_rest for s in hand.segments]),
            np.array(hand.axis_columns, np.int64),
            np.array(hand.angle_limits),
            np.array(links, np.int64).reshape(-1, 2),
            np.array([[s.ratio, s.offset] for s in synergies]).reshape(-1, 2),
            row,
            np.zeros(len(hand.segments)),
            np.full(len(hand.angle_limits), np.nan),
        )
        self._nominal = self.tables

    def wear(self, gains: Array, lateral: Array) -> None:
        """Sets a wearer's own synergies (k, 2) and ``lateral`` (S,)."""
        gains = np.concatenate([gains, self._anatomical])
        self.tables = self.tables._replace(gains=gains, lateral=lateral)

    def measure(self, angles: Mapping[int, float], origin: Mapping[int, Array]) -> None:
        """Sets angles (rad) by their columns, and origins (3,) m of segments by their rows, that
        were measured apart from the filter; what is not given follows the hand file again."""
        measured, origins = self._nominal.measured.copy(), self._nominal.origin.copy()
        for column, angle in angles.items():
            measured[column] = angle
        for row, at in origin.items():
            origins[row] = at
        self.tables = self.tables._replace(measured=measured, origin=origins)

    def angles_with(self, R: Array, p: Array, scale3: Array, angles: Mapping[int, float]) -> Array:
        """(J,) rad, the angles of the completed hand, as `__call__`, if only these ``angles`` (rad,
        by their columns) were measured apart from the filter."""
        measured = self._nominal.measured.copy()
        for column, angle in angles.items():
            measured[column] = angle
        active = ActiveSegments(np.ascontiguousarray(R), p, scale3)
        return complete(self.tables._replace(measured=measured), active)[3]

    def __call__(
        self, R: Array, p: Array, scale3: Array
    ) -> tuple[Array, Array, Array, Array, BoolVector]:
        """Completes active R_GB (A, 3, 3), p_GB (A, 3), scale3 (A, 3).

        Returns R_GB (S, 3, 3), p_GB (S, 3), scale (S, 3), angles (J,) rad, known (J,) bool: the
        angle comes from estimated segments or by synergy from them.
        """
        return complete(self.tables, ActiveSegments(np.ascontiguousarray(R), p, scale3))


@kernel
def _rotation(a: float, b: float, c: float) -> Matrix:
    """Rz(a) Ry(b) Rx(c)."""
    ca, sa, cb, sb, cc, sc = np.cos(a), np.sin(a), np.cos(b), np.sin(b), np.cos(c), np.sin(c)
    return np.array(
        [
            [ca * cb, ca * sb * sc - sa * cc, ca * sb * cc + sa * sc],
            [sa * cb, sa * sb * sc + ca * cc, sa * sb * cc - ca * sc],
            [-sb, cb * sc, cb * cc],
        ]
    )


@kernel(nogil=False)
def complete(
    hand: HandTables, active: ActiveSegments
) -> tuple[Stack, Matrix, Matrix, Vector, BoolVector]:
    """`Completion` of active segments."""
    parent, origin, R_rest, columns, limits, links, gains, row, lateral, measured = hand
    R, p, scale3 = active
    n, n_angles = len(parent), len(limits)
    R_all, p_all, scale = np.empty((n, 3, 3)), np.empty((n, 3)), np.empty((n, 3))
    angles, known = np.zeros(n_angles), np.zeros(n_angles, np.bool_)
    for i in range(n):  # 1. estimated segments, and the angles between them
        if row[i] < 0:
            continue
        R_all[i], p_all[i], scale[i] = R[row[i]], p[row[i]], scale3[row[i]]
        if parent[i] >= 0:
            relative = tmul3(R_rest[i], tmul3(R_all[parent[i]], R_all[i]))
            values = joint_angles3(relative, columns[i, 0] >= 0, columns[i, 2] >= 0)
            for k in range(3):
                if columns[i, k] >= 0:
                    angles[columns[i, k]] = values[k]
                    known[columns[i, k]] = True
    for j in range(n_angles):
        if not known[j] and not np.isnan(measured[j]):
            angles[j] = min(max(measured[j], limits[j, 0]), limits[j, 1])
            known[j] = True
    for _ in range(len(links)):  # 2. synergies, which may be chained
        for k in range(len(links)):
            i, j = links[k, 0], links[k, 1]
            if not known[i] and known[j]:
                value = gains[k, 0] * angles[j] + gains[k, 1]
                angles[i] = min(max(value, limits[i, 0]), limits[i, 1])
                known[i] = True
    mean = np.zeros(3)
    for k in range(len(scale3)):
        mean += scale3[k] / len(scale3)
    for i in range(n):  # 3. unsensed segments, parents first
        if row[i] >= 0:
            continue
        a = parent[i]
        joint = np.zeros(3)
        for k in range(3):
            if columns[i, k] >= 0:
                joint[k] = angles[columns[i, k]]
        R_all[i] = mul3(
            mul3(R_all[a], R_rest[i]), _rotation(joint[0] + lateral[i], joint[1], joint[2])
        )
        p_all[i] = p_all[a] + rotate(R_all[a], scale[a] * origin[i])
        total, count = np.zeros(3), 0
        while a > 0:  # a finger's own scale if it has one, else the hand's
            total += scale[a]
            count += 1
            a = parent[a]
        scale[i] = total / count if count > 0 else mean
    return R_all, p_all, scale, angles, known
