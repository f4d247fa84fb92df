"""Registration of a reference's frame and markers with a session.

R_GL, p_GL: the pose of the laboratory's frame L in the session's world G, by Kabsch's method on the
points that remain after trimming. With offsets: each marker is at a constant position relative to
its keypoint, in the axes of the keypoint's segment, p_GL + R_GL x_L = x_G + R_GB d; pose and
offsets d are estimated together, by Gauss-Newton steps with Huber's weights.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from extensions.reference.statistics import effective_size
from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.geometry import so3
from tracker.messages import Array
from tracker.session.edits import Mask

_TRIMMED = 3.0  # robust standard deviations beyond which a point is not used
_HUBER = 1.345
_OFFSET_SD = 0.015  # m, of markers from their keypoints; decides what the motion does not
_MOST = 1500  # instants that are used
_FEWEST = 10  # instants
_MIRRORED = 0.5  # share of the residual that a reflection must leave to be reported


@dataclass(frozen=True, eq=False)
class Registration:
    """R_GL (3, 3), p_GL (3,) m; ``residual`` (rms, m) of all points and ``share`` of them used;
    ``offsets`` (K, 3) m in the segments' axes, zero without, and ``offset_sd`` (K, 3) m."""

    R_GL: Array
    p_GL: Array
    residual: float
    share: float
    offsets: Array
    offset_sd: Array

    def world(self, x_L: Array) -> Array:
        """(..., 3) of the laboratory's frame in G, without offsets."""
        return np.asarray(x_L @ self.R_GL.T + self.p_GL)

    def keypoints(self, x_L: Array, R_GB: Array) -> Array:
        """(N, K, 3) keypoints in G from markers (N, K, 3) in L and the segments' axes (N, K, 3, 3);
        a keypoint with an offset and without axes is NaN."""
        shift = np.einsum("nkij,kj->nki", R_GB, self.offsets)
        none = (self.offsets == 0).all(axis=1)[None, :, None]
        return self.world(x_L) - np.where(none, 0.0, shift)


def register(x_L: Array, x_G: Array, file: str) -> Registration:
    """Rigid registration of points (N, K, 3) m, NaN where either is unknown.

    Raises FileError for too few instants, and for a mirrored reference.
    """
    x_L, x_G = _common(x_L, x_G, file)
    R, p, used, residual = _trimmed_kabsch(x_L, x_G)
    mirror = np.array([1.0, 1.0, -1.0])
    *_, mirrored = _trimmed_kabsch(x_L * mirror, x_G)
    if mirrored < _MIRRORED * residual and residual > 0.005:
        raise FileError(
            notice(
                "reference.mirrored",
                file=file,
                mirrored_mm=1e3 * mirrored,
                residual_mm=1e3 * residual,
            )
        )
    none = np.zeros((x_L.shape[1], 3))
    return Registration(R, p, residual, used, none, none)


def _common(x_L: Array, x_G: Array, file: str) -> tuple[Array, Array]:
    known = np.isfinite(x_L + x_G).all(axis=2)
    rows = np.flatnonzero(known.sum(axis=1))
    if len(rows) < _FEWEST:
        raise FileError(
            notice("reference.few_instants", file=file, found=len(rows), needed=_FEWEST)
        )
    rows = rows[:: max(1, len(rows) // _MOST)]
    return x_L[rows], x_G[rows]


def _trimmed_kabsch(a: Array, b: Array) -> tuple[Array, Array, float, float]:
    """R, p with b ≈ R a + p, the share of points used, and the rms residual of all."""
    known = np.isfinite(a).all(axis=2) & np.isfinite(b).all(axis=2)
    x, y = a[known], b[known]
    used = np.ones(len(x), bool)
    for _ in range(30):
        R, p = kabsch(x[used], y[used])
        error = np.linalg.norm(x @ R.T + p - y, axis=1)
        limit = _TRIMMED * 1.4826 * float(np.median(error[used])) + 1e-6
        keep = error <= limit
        if np.array_equal(keep, used) or keep.sum() < 3:
            break
        used = keep
    return R, p, float(used.mean()), float(np.sqrt(np.mean(error**2)))


def kabsch(x: Array, y: Array) -> tuple[Array, Array]:
    """Rotation (3, 3) and translation (3,) with the least squares of y - (R x + p); x, y (n, 3).

    Kabsch 1976, Acta Cryst. A32:922, with the sign of Umeyama 1991 against reflections."""
    u, v = x.mean(axis=0), y.mean(axis=0)
    U, _, Vt = np.linalg.svd((y - v).T @ (x - u))
    R = U @ np.diag([1.0, 1.0, np.sign(np.linalg.det(U @ Vt))]) @ Vt
    return R, v - R @ u


def register_offsets(x_L: Array, x_G: Array, R_GB: Array, start: Registration) -> Registration:
    """Pose and marker offsets together, from the rigid registration on.

    x_L, x_G (N, K, 3) m, R_GB (N, K, 3, 3) of the keypoints' segments. If the hand does not turn, a
    a common offset and a translation are the same; the offsets are then kept small. The data count
    as many times as their residuals are independent.
    """
    every = np.concatenate([x_L, x_G, R_GB.reshape(*x_L.shape[:2], 9)], axis=2)
    known = np.asarray(np.isfinite(every).all(axis=2))
    rows = np.flatnonzero(known.any(axis=1))
    rows = rows[:: max(1, len(rows) // _MOST)]
    x, y, B, known = x_L[rows], x_G[rows], R_GB[rows], known[rows]
    x, y, B = (
        np.where(known.reshape(known.shape + (1,) * (v.ndim - 2)), v, 0.0) for v in (x, y, B)
    )
    R, p, d = start.R_GL, start.p_GL, np.zeros((x.shape[1], 3))
    redundancy = _redundancy(np.where(known[:, :, None], x @ R.T + p - y, np.nan))
    for _ in range(30):
        e = x @ R.T + p - y - np.einsum("nkij,kj->nki", B, d)
        norm = np.linalg.norm(e, axis=2)
        scale = 1.4826 * float(np.median(norm[known])) / 1.54 + 1e-9  # χ's median, 3 coordinates
        w = np.where(known, np.minimum(1.0, 3 * _HUBER * scale / np.maximum(norm, 1e-12)), 0.0)
        H, g = _normal_equations(x @ R.T, B, e, w)
        prior = redundancy * (scale / _OFFSET_SD) ** 2
        H[6:, 6:] += np.eye(3 * len(d)) * prior
        g[6:] += prior * d.ravel()
        step = np.linalg.solve(H, -g)
        R, p, d = so3.exp(np.asarray(step[:3])) @ R, p + step[3:6], d + step[6:].reshape(-1, 3)
        if np.abs(step).max() < 1e-9:
            break
    e = np.where(known[:, :, None], x @ R.T + p - y - np.einsum("nkij,kj->nki", B, d), np.nan)
    residual = float(np.sqrt(np.nanmean((e**2).sum(axis=2))))
    sd = scale * np.sqrt(np.diag(np.linalg.inv(H))[6:].reshape(-1, 3) * redundancy)
    seen = np.asarray(known.any(axis=0))[:, None]
    return Registration(R, p, residual, float((w[known] >= 1).mean()),
                        np.where(seen, d, 0.0), np.where(seen, sd, np.nan))  # fmt: skip


def with_inferred(
    found: Registration, x_L: Array, x_G: Array, R_GB: Array, inferred: Mask
) -> Registration:
    """The offsets of the keypoints ``inferred`` (K,), which are hardly ever measured and take no
    part in the registration, too: medians over time, without a standard deviation."""
    e = found.world(x_L) - x_G
    offsets, sd = found.offsets.copy(), found.offset_sd.copy()
    for k in np.flatnonzero(inferred):
        d = np.einsum("nji,nj->ni", R_GB[:, k], e[:, k])
        d = d[np.isfinite(d).all(axis=1)]
        if len(d) >= _FEWEST:
            offsets[k], sd[k] = np.median(d, axis=0), np.nan
    return replace(found, offsets=offsets, offset_sd=sd)


def _normal_equations(Rx: Array, B: Array, e: Array, w: Array) -> tuple[Array, Array]:
    """H (6 + 3K, 6 + 3K) and gradient of Σ w e², for a small turn, a shift and the offsets.

    ∂e/∂turn = -[R x]×, ∂e/∂shift = 1, ∂e/∂d_k = -R_GB."""
    n, k = w.shape
    turn = -so3.skew(Rx)
    pose = np.concatenate([turn, np.broadcast_to(np.eye(3), (n, k, 3, 3))], axis=3)  # (n, k, 3, 6)
    H, g = np.zeros((6 + 3 * k, 6 + 3 * k)), np.zeros(6 + 3 * k)
    H[:6, :6] = np.einsum("nk,nkia,nkib->ab", w, pose, pose)
    g[:6] = np.einsum("nk,nkia,nki->a", w, pose, e)
    across = -np.einsum("nk,nkia,nkib->kab", w, pose, B)
    weight = w.sum(axis=0)
    for j in range(k):
        at = slice(6 + 3 * j, 9 + 3 * j)
        H[:6, at], H[at, :6] = across[j], across[j].T
        H[at, at] = np.eye(3) * weight[j]
    g[6:] = -np.einsum("nk,nkia,nki->ka", w, B, e).ravel()
    return H, g


def _redundancy(e: Array) -> float:
    """By how much residuals (N, K, 3) are more than they are independent; NaN ones do not count."""
    known = [x for x in e.reshape(len(e), -1).T if np.isfinite(x).sum() >= _FEWEST]
    each = [effective_size(x) / np.isfinite(x).sum() for x in known]
    return 1.0 / float(np.median(each)) if each else 1.0
