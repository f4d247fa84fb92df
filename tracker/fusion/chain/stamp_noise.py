"""Noise of an image whose time stamp is uncertain (docs/chain.md, eqs. 67 and 68).

A hand that moves is elsewhere when the stamp is wrong: all markers together, each along its own
velocity against the camera.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.fusion.chain.prediction import Prediction, seen_covariance
from tracker.kernels import kernel
from tracker.kernels.arrays import IntMatrix, IntVector, Matrix, Stack, Stack4, Vector, Written


class StampNoise(NamedTuple):
    """The standard deviation ``sd`` s of an image's stamp, and v_G (M, 3) m/s of the markers
    against the camera."""

    sd: float
    v_G: Matrix


def widened(prediction: Prediction, stamp: StampNoise, pixel_px: float) -> None:
    """Add the noise to each marker's own covariances, in place (eq. 67)."""
    p = prediction
    add_stamp_noise(p.cov, p.S, p.A, p.rows, stamp.v_G, stamp.sd, pixel_px)


def common_noise(prediction: Prediction, match: IntMatrix, stamp: StampNoise, m: int) -> Matrix:
    """The noise (m, m) that the m rows of `pixel_rows.point_rows` have in common (eq. 68)."""
    w = row_velocities(prediction.A, prediction.rows, match, stamp.v_G, m)
    out: Matrix = stamp.sd**2 * np.outer(w, w)
    return out


@kernel(nogil=False)
def add_stamp_noise(
    cov: Written[Stack],
    S: Written[Stack4],
    A: Stack4,
    rows: IntVector,
    v_G: Matrix,
    sd: float,
    pixel_px: float,
) -> None:
    """`widened` of the prediction's parts."""
    for i in range(len(rows)):
        v = v_G[rows[i]]
        for r in range(3):
            for s in range(3):
                cov[i, r, s] += sd * sd * v[r] * v[s]
        for c in range(2):
            S[c, i] = seen_covariance(A[c, rows[i]], cov[i], pixel_px)


@kernel(nogil=False)
def row_velocities(A: Stack4, rows: IntVector, match: IntMatrix, v_G: Matrix, m: int) -> Vector:
    """(m,) by which each row's measurement changes per second: m/s for the three rows of a marker
    that both cameras see, px/s for the two of one that one camera sees."""
    out = np.zeros(m)
    at = 0
    for k in range(len(rows)):
        marker = rows[k]
        left, right = match[0, marker] >= 0, match[1, marker] >= 0
        v = v_G[marker]
        if left and right:
            out[at : at + 3] = v
            at += 3
        elif left or right:
            J = A[0 if left else 1, marker]
            for a in range(2):
                out[at + a] = J[a, 0] * v[0] + J[a, 1] * v[1] + J[a, 2] * v[2]
            at += 2
    return out
