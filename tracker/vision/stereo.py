"""Stereo points from the blobs of two images: matching by one parallax, or all possible pairs.

Pixels are rectified, so that matching blobs are on one row. `match_stereo` is the method of Lee et
al. 2021 during tracking; `all_pairs` is for a search without a prior, where wrong pairs find no
support.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from tracker.kernels import kernel
from tracker.kernels.arrays import IntVector
from tracker.messages import Array, IntArray
from tracker.vision.cpd import HuedPixels, ParallaxMixture, parallax_em
from tracker.vision.rig import StereoRig


@dataclass(frozen=True)
class StereoParams:
    """Limits of stereo matching."""

    row_px: float = 3.0  # |dv|, the first outlier condition
    parallax_px: float = 45.0  # |du - zeta|, the second
    unit_u_px: float = 8.0  # du of this size has the weight of one pixel of dv
    sd_u_min_px: float = 6.0
    sd_u_max_px: float = 30.0
    sd_v_px: float = 1.0
    outlier: float = 0.1
    iterations: int = 10
    nearest: float = 0.15  # m
    farthest: float = 0.9  # m

    @cached_property
    def mixture(self) -> ParallaxMixture:
        """The parameters of the EM."""
        return ParallaxMixture(
            self.sd_u_min_px, self.sd_u_max_px, self.sd_v_px, self.outlier, self.iterations
        )


@dataclass(frozen=True)
class PairParams:
    """Limits on possible pairs."""

    row_px: float = 3.0
    nearest: float = 0.18  # m
    farthest: float = 0.70  # m


@dataclass(frozen=True, eq=False)
class StereoMatches:
    """Pairs of blobs: rows left_index (n,), right_index (n,), and points p_C (n, 3) m."""

    left_index: IntArray
    right_index: IntArray
    p_C: Array

    def __len__(self) -> int:
        return len(self.left_index)


def match_stereo(
    left_uv: Array,
    left_hue: IntArray,
    right_uv: Array,
    right_hue: IntArray,
    rig: StereoRig,
    params: StereoParams | None = None,
    z_hint: float | None = None,
) -> StereoMatches:
    """At most one match for each blob. ``z_hint`` is the hand's distance (m) where known."""
    params = params or StereoParams()
    left, right = HuedPixels(_pixels(left_uv), left_hue), HuedPixels(_pixels(right_uv), right_hue)
    focal = rig.fx * rig.baseline
    limits = (focal / params.farthest, focal / params.nearest)
    start = focal / z_hint if z_hint else commonest_parallax(
        left, right, params.row_px, limits, params.sd_u_min_px
    )  # fmt: skip
    zeta, _ = parallax_em(left, right, start, params.mixture)
    i, j = _mutual_nearest(left, right, zeta, params.unit_u_px, params.row_px, params.parallax_px)
    return _matches(i, j, left.uv, right.uv, rig)


def all_pairs(
    left_uv: Array,
    left_hue: IntArray,
    right_uv: Array,
    right_hue: IntArray,
    rig: StereoRig,
    params: PairParams | None = None,
) -> StereoMatches:
    """Every same-hue pair on one row with a possible depth; a blob may be in several."""
    params = params or PairParams()
    left, right = _pixels(left_uv), _pixels(right_uv)
    focal = rig.fx * rig.baseline
    du = left[:, None, 0] - right[None, :, 0]
    dv = left[:, None, 1] - right[None, :, 1]
    possible = np.asarray(left_hue)[:, None] == np.asarray(right_hue)[None]
    possible &= np.abs(dv) < params.row_px
    possible &= (du > focal / params.farthest) & (du < focal / params.nearest)
    i, j = np.nonzero(possible)
    return _matches(i, j, left, right, rig)


def _pixels(uv: Array) -> Array:
    return np.ascontiguousarray(uv, float).reshape(-1, 2)


def _matches(i: IntArray, j: IntArray, left: Array, right: Array, rig: StereoRig) -> StereoMatches:
    p_C = rig.triangulate(left[i], right[j])
    ok = np.isfinite(p_C[:, 2])
    return StereoMatches(i[ok], j[ok], p_C[ok])


@kernel
def commonest_parallax(
    left: HuedPixels,
    right: HuedPixels,
    row_px: float,
    limits: tuple[float, float],
    width_px: float,
) -> float:
    """The disparity in ``limits`` (px) that most same-hue pairs support within ``width_px``.

    Initial value for the EM where the hand's distance is unknown. Each left blob votes once: many
    candidates of one blob are not support.
    """
    best, best_votes = 0.5 * (limits[0] + limits[1]), 0.0
    l_uv, r_uv = left.uv, right.uv
    for i in range(len(l_uv)):
        for j in range(len(r_uv)):
            zeta = l_uv[i, 0] - r_uv[j, 0]
            if left.hue[i] != right.hue[j] or abs(l_uv[i, 1] - r_uv[j, 1]) > row_px:
                continue
            if zeta < limits[0] or zeta > limits[1]:
                continue
            votes = _votes(left, right, zeta, row_px, width_px)
            if votes > best_votes:
                best, best_votes = zeta, votes
    return best


@kernel
def _votes(
    left: HuedPixels, right: HuedPixels, zeta: float, row_px: float, width_px: float
) -> float:
    """Number of left blobs with a candidate near the parallax, each 1 at it and 0 at 4 widths."""
    total, reach, l_uv, r_uv = 0.0, 4.0 * width_px, left.uv, right.uv
    for i in range(len(l_uv)):
        nearest = reach
        for j in range(len(r_uv)):
            if left.hue[i] == right.hue[j] and abs(l_uv[i, 1] - r_uv[j, 1]) < row_px:
                nearest = min(nearest, abs(l_uv[i, 0] - r_uv[j, 0] - zeta))
        total += 1.0 - (nearest / reach) ** 2
    return total


@kernel
def _mutual_nearest(
    left: HuedPixels,
    right: HuedPixels,
    zeta: float,
    unit_u: float,
    row_px: float,
    parallax_px: float,
) -> tuple[IntVector, IntVector]:
    """Pairs that are mutual nearest neighbours after the shift and meet both outlier conditions."""
    l_uv, l_hue, r_uv, r_hue = left.uv, left.hue, right.uv, right.hue
    n, m = len(l_uv), len(r_uv)
    partner, back = np.full(n, -1, np.int64), np.full(m, -1, np.int64)
    least, least_back = np.full(n, np.inf), np.full(m, np.inf)
    for i in range(n):
        for j in range(m):
            if l_hue[i] != r_hue[j]:
                continue
            du = l_uv[i, 0] - r_uv[j, 0] - zeta
            dv = l_uv[i, 1] - r_uv[j, 1]
            if abs(dv) >= row_px or abs(du) >= parallax_px:
                continue
            d2 = (du / unit_u) ** 2 + dv * dv
            if d2 < least[i]:
                least[i], partner[i] = d2, j
            if d2 < least_back[j]:
                least_back[j], back[j] = d2, i
    rows = np.array([i for i in range(n) if partner[i] >= 0 and back[partner[i]] == i], np.int64)
    return rows, partner[rows]
