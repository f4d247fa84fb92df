"""A segment's pose from its own stereo points alone, for loosely coupled filters.

Points y_i in G of a segment with markers at x_i in B, with mean x̄, determine the position c of x̄
and the orientation R:  y_i = c + R Exp(δ) (x_i - x̄) + noise of covariance C_i. The weighted
least-squares solution starts at the unweighted optimum (Kabsch) and yields the covariance of
(c, δ).
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from tracker.geometry import so3
from tracker.messages import Array, IntArray
from tracker.vision.rig import StereoRig

LEAST_POINTS = 3
STEPS = 3  # Gauss-Newton iterations
MOST_ROTATION_SD = 0.6  # rad: nearly collinear points do not determine the orientation
MOST_MISFIT = 9.0  # squared residuals per degree of freedom: one point is of another segment


@dataclass(frozen=True, eq=False)
class SegmentPose:
    """centre_G (3,) m of the markers' mean, R_GB (3, 3), covariance (6, 6) of both: m in G, and
    rad as a local rotation in B."""

    centre_G: Array
    R_GB: Array
    cov: Array


def fit_pose(shape_B: Array, points_G: Array, cov: Array) -> SegmentPose | None:
    """Pose of points (k, 3) m with covariances (k, 3, 3) m² whose shape (k, 3) is known.

    None where there are fewer than three points, or the points are collinear or do not fit the
    shape.
    """
    if len(shape_B) < LEAST_POINTS:
        return None
    x = shape_B - shape_B.mean(axis=0)
    centre, R = points_G.mean(axis=0), _kabsch(x, points_G)
    weight = np.linalg.inv(cov)
    for _ in range(STEPS):
        residual = points_G - centre - x @ R.T
        J = np.concatenate([np.tile(np.eye(3), (len(x), 1, 1)), -R @ so3.skew(x)], axis=2)
        JW = J.swapaxes(1, 2) @ weight
        information = np.sum(JW @ J, axis=0)
        if np.linalg.eigvalsh(information)[0] * MOST_ROTATION_SD**2 < 1.0:
            return None
        step = np.linalg.solve(information, np.einsum("kij,kj->i", JW, residual))
        centre, R = centre + step[:3], R @ so3.exp(step[3:])
    residual = points_G - centre - x @ R.T
    misfit = float(np.einsum("ki,kij,kj->", residual, weight, residual))
    if misfit > MOST_MISFIT * (3 * len(x) - 6):
        return None
    return SegmentPose(centre, R, np.linalg.inv(information))


def _kabsch(x: Array, points: Array) -> Array:
    """Rotation (3, 3) that aligns the centred x (k, 3) best with the points (k, 3)."""
    U, _, Vt = np.linalg.svd((points - points.mean(axis=0)).T @ x)
    proper = np.diag([1.0, 1.0, np.sign(np.linalg.det(U @ Vt))])
    R: Array = U @ proper @ Vt
    return R


def by_segment(segment: IntArray) -> Iterator[tuple[int, IntArray]]:
    """Each segment with at least three of the markers (k,), whose segments are ``segment`` (k,)."""
    for s in np.unique(segment):
        rows = np.flatnonzero(segment == s)
        if len(rows) >= LEAST_POINTS:
            yield int(s), rows


def stereo_covariance(
    rig: StereoRig, p_C: Array, R_GC: Array, pixel_px: float, marker: float
) -> Array:
    """Sigma_c (k, 3, 3) m² in G of triangulated points p_C (k, 3), including marker placement.

    J diag(s², s²/2, 2 s²) J^T for (u_L, v, disparity), so depth is the least accurate.
    """
    s2, focal = pixel_px**2, rig.fx * rig.baseline
    x, y, z = p_C.T
    J = np.zeros((len(p_C), 3, 3))
    J[:, 0, 0] = z / rig.fx
    J[:, 1, 1] = z / rig.fy
    J[:, :, 2] = -np.column_stack([x, y, z]) * (z / focal)[:, None]
    cov_C = (J * np.array([s2, s2 / 2, 2 * s2])) @ J.swapaxes(1, 2)
    cov_C += np.eye(3) * marker**2
    return R_GC @ cov_C @ R_GC.T


def softened(cov: Array, r: Array, HPH: Array, huber: float) -> Array:
    """Noise (m, m), inflated where the innovation (m,) exceeds ``huber`` standard deviations."""
    distance = float(np.sqrt(r @ np.linalg.solve(HPH + cov, r) / len(r)))
    return cov * max(1.0, distance / huber) ** 2
