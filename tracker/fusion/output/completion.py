"""The whole hand from the segments that a filter estimates: the rest by synergy or rest pose.

`HandModel` says the same in plain Python; this is the form that runs a hundred times a second.
"""

from __future__ import annotations

import numpy as np

from tracker.fusion.chain.layout import ChainLayout
from tracker.geometry.kernels import joint_angles3, mul3, rotate, tmul3
from tracker.kernels import kernel
from tracker.messages import Array


class Completion:
    """Index arrays of one layout and the kernel over them."""

    def __init__(self, layout: ChainLayout) -> None:
        hand = layout.hand
        row = np.full(len(hand.segments), -1, np.int64)
        row[layout.active] = np.arange(len(layout.active))
        links = [[hand.angle_index[s.angle], hand.angle_index[s.of]] for s in hand.synergies]
        self.tables = (
            np.array(hand.parent, np.int64),
            np.array([s.origin for s in hand.segments]),
            np.array([s.R_rest for s in hand.segments]),
            np.array(hand.axis_columns, np.int64),
            hand.angle_limits,
            np.array(links, np.int64).reshape(-1, 2),
            np.array([[s.ratio, s.offset] for s in hand.synergies]).reshape(-1, 2),
            row,
        )
        """Of `complete`: its first arguments."""

    def __call__(
        self, R: Array, p: Array, scale3: Array
    ) -> tuple[Array, Array, Array, Array, Array]:
        """From active R_GB (A, 3, 3), p_GB (A, 3), scale3 (A, 3).

        Returns R_GB (S, 3, 3), p_GB (S, 3), scale (S, 3), angles (J,) rad, known (J,) bool: the
        angle comes from estimated segments or by synergy from them.
        """
        return complete(*self.tables, np.ascontiguousarray(R), p, scale3)


@kernel
def _rotation(a, b, c):  # type: ignore[no-untyped-def]
    """Rz(a) Ry(b) Rx(c)."""
    ca, sa, cb, sb, cc, sc = np.cos(a), np.sin(a), np.cos(b), np.sin(b), np.cos(c), np.sin(c)
    return np.array(
        [
            [ca * cb, ca * sb * sc - sa * cc, ca * sb * cc + sa * sc],
            [sa * cb, sa * sb * sc + ca * cc, sa * sb * cc - ca * sc],
            [-sb, cb * sc, cb * cc],
        ]
    )


@kernel
def complete(  # type: ignore[no-untyped-def]
    parent, origin, R_rest, columns, limits, links, gains, row, R, p, scale3
):  # fmt: skip
    """`Completion` of active segments; ``row`` (S,) is each segment's among them, -1 for none."""
    n, n_angles = len(parent), len(limits)
    R_all, p_all, scale = np.empty((n, 3, 3)), np.empty((n, 3)), np.empty((n, 3))
    angles, known = np.zeros(n_angles), np.zeros(n_angles, np.bool_)
    for i in range(n):  # 1. what the filter estimates, and the angles between
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
    for _ in range(len(links)):  # 2. synergies, which may chain
        for k in range(len(links)):
            i, j = links[k, 0], links[k, 1]
            if not known[i] and known[j]:
                value = gains[k, 0] * angles[j] + gains[k, 1]
                angles[i] = min(max(value, limits[i, 0]), limits[i, 1])
                known[i] = True
    mean = np.zeros(3)
    for k in range(len(scale3)):
        mean += scale3[k] / len(scale3)
    for i in range(n):  # 3. unseen segments, parents first
        if row[i] >= 0:
            continue
        a = parent[i]
        joint = np.zeros(3)
        for k in range(3):
            if columns[i, k] >= 0:
                joint[k] = angles[columns[i, k]]
        R_all[i] = mul3(mul3(R_all[a], R_rest[i]), _rotation(joint[0], joint[1], joint[2]))
        p_all[i] = p_all[a] + rotate(R_all[a], scale[a] * origin[i])
        total, count = np.zeros(3), 0
        while a > 0:  # a finger's own scale where it has one, else the hand's
            total += scale[a]
            count += 1
            a = parent[a]
        scale[i] = total / count if count > 0 else mean
    return R_all, p_all, scale, angles, known
