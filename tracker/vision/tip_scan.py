"""Locates a fingertip in an image by the glove's cloth (docs/chain.md, "Fingertips in the cloth").

A fingertip is a sphere: in any orientation its outline is a disc, filled with the glove's colours,
and without them around it except towards the finger. Each candidate position of the disc is
evaluated by both; the measurement is the result with the prior's contribution removed.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.kernels import kernel
from tracker.kernels.arrays import Matrix, Vector
from tracker.vision.cloth import STEP, TILE, ClothMap

GRID_PX = 3.0  # between two positions
FARTHEST = 2.5  # standard deviations from the predicted position, limit of the grid
FARTHEST_PX = 40.0
GLOVE_INSIDE, GLOVE_OUTSIDE = 0.95, 0.35  # probability of the glove's colours; outside there may
GLOVE_ANYWHERE = 0.6  # be other fingers
PIXELS_ALIKE = 24.0  # px² that count as one sample: cloth, shade and noise are correlated
BACK = -0.1  # cosine, to the finger's direction, from which the surroundings of a tip count
LEAST_LIKELY = 1.1  # ln of the likelihood ratio of the best position to no tip
LEAST_KNOWN = 0.7  # of the disc's pixels
LEAST_FREE = 0.75  # of the pixels around it
SHARPER = 0.5  # area of the posterior relative to the prior's, maximum
VAGUEST_PX = 20.0  # of a position not determined in some direction
OUT_OF_GRID = 0.1  # px², discretisation of the grid

RINGS = ((0.0, 1), (0.4, 8), (0.8, 16))  # radius relative to the disc's, and number of samples
AROUND, MANY_AROUND, WIDTH = (1.3, 1.6), 16, 0.3
NOTHING, OUTSIDE, INSIDE = 0, 1, 2  # classes of a pixel


class ExpectedTip(NamedTuple):
    """In one image, px: centre (2,) of the disc and its radius, joint (2,) at the other end of the
    segment, S (2, 2) covariance of the centre."""

    middle: Vector
    joint: Vector
    radius: float
    S: Matrix


@kernel
def cloth_at(cloth: ClothMap, u: float, v: float) -> int:
    """`INSIDE` where the pixel has the glove's colours, `OUTSIDE` where not, `NOTHING` if
    unknown."""
    x, y = int(np.floor(u + 0.5)), int(np.floor(v + 0.5))
    j, i = y // TILE, x // TILE
    if j < 0 or i < 0 or j >= cloth.known.shape[0] or i >= cloth.known.shape[1]:
        return NOTHING
    if cloth.known[j, i] == 0:
        return NOTHING
    bit = (y % TILE) // STEP * (TILE // STEP) + (x % TILE) // STEP
    return INSIDE if (cloth.bits[j, i] >> np.int64(bit)) & 1 else OUTSIDE


@kernel
def _likelihood(
    cloth: ClothMap, tip: ExpectedTip, u: float, v: float
) -> tuple[float, float, float]:
    """ln of the likelihood ratio of the disc at (u, v) to no disc; the share of the disc's pixels
    that are known, and of its surroundings that do not have the glove's colours."""
    r, total, known, count = tip.radius, 0.0, 0, 0
    inside = np.log(GLOVE_INSIDE / GLOVE_ANYWHERE)
    not_inside = np.log((1.0 - GLOVE_INSIDE) / (1.0 - GLOVE_ANYWHERE))
    for q, most in RINGS:
        for k in range(most):
            a = 2.0 * np.pi * k / most
            what = cloth_at(cloth, u + q * r * np.cos(a), v + q * r * np.sin(a))
            count += 1
            if what != NOTHING:
                known += 1
                total += inside if what == INSIDE else not_inside
    total *= np.pi * r * r / count
    outside = np.log((1.0 - GLOVE_OUTSIDE) / (1.0 - GLOVE_ANYWHERE))
    not_outside = np.log(GLOVE_OUTSIDE / GLOVE_ANYWHERE)
    free, many = 0, 0
    du, dv = u - tip.joint[0], v - tip.joint[1]
    length = max(np.hypot(du, dv), 1e-9)
    for q in AROUND:
        for k in range(MANY_AROUND):
            a = 2.0 * np.pi * k / MANY_AROUND
            x, y = np.cos(a), np.sin(a)
            if (x * du + y * dv) / length > BACK:
                what = cloth_at(cloth, u + q * r * x, v + q * r * y)
                many += 1
                free += what == OUTSIDE
                if what != NOTHING:
                    area = 2.0 * np.pi * q * WIDTH * r * r / MANY_AROUND
                    total += area * (not_outside if what == INSIDE else outside)
    return total / PIXELS_ALIKE, known / count, free / max(many, 1)


@kernel
def _inverse(a: float, b: float, c: float) -> tuple[float, float, float]:
    """Inverse of the symmetric matrix ((a, b), (b, c))."""
    det = a * c - b * b
    return c / det, -b / det, a / det


@kernel
def _at_least(a: float, b: float, c: float, least: float) -> tuple[float, float, float]:
    """((a, b), (b, c)) with its eigenvalues raised to at least ``least``."""
    middle, half = (a + c) / 2, (a - c) / 2
    radius = np.hypot(half, b)
    high, low = max(middle + radius, least), max(middle - radius, least)
    if radius <= 1e-12:
        return high, 0.0, high
    cosine, sine = half / radius, b / radius  # of twice the angle of the first eigenvector
    mean, apart = (high + low) / 2, (high - low) / 2
    return mean + apart * cosine, apart * sine, mean - apart * cosine


@kernel(nogil=False)
def scan_tip(cloth: ClothMap, tip: ExpectedTip) -> Vector:
    """(6,): 1 where the image shows the end of the finger, else 0; its offset from the prediction
    in u and v, px; and its variance uu, uv, vv, px², all without the prior's contribution."""
    p_uu, p_uv, p_vv = _inverse(tip.S[0, 0], tip.S[0, 1], tip.S[1, 1])
    reach = int(FARTHEST_PX / GRID_PX)
    wide = 2 * reach + 1
    weight, best = np.full((wide, wide), -np.inf), -np.inf
    best_known, best_free, peak = 0.0, 0.0, 0.0
    # 1. each position, by the image and by the prior (eq. 59)
    for j in range(wide):
        for i in range(wide):
            u, v = GRID_PX * (i - reach), GRID_PX * (j - reach)
            d2 = p_uu * u * u + 2 * p_uv * u * v + p_vv * v * v
            if d2 > FARTHEST**2:
                continue
            likely, known, free = _likelihood(cloth, tip, tip.middle[0] + u, tip.middle[1] + v)
            weight[j, i] = likely - d2 / 2
            if weight[j, i] > best:
                best, best_known, best_free, peak = weight[j, i], known, free, likely
    out = np.zeros(6)
    if peak < LEAST_LIKELY or best_known < LEAST_KNOWN or best_free < LEAST_FREE:
        return out
    # 2. mean and variance
    total, m_u, m_v, c_uu, c_uv, c_vv = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    for j in range(wide):
        for i in range(wide):
            w = np.exp(weight[j, i] - best)
            u, v = GRID_PX * (i - reach), GRID_PX * (j - reach)
            total, m_u, m_v = total + w, m_u + w * u, m_v + w * v
            c_uu, c_uv, c_vv = c_uu + w * u * u, c_uv + w * u * v, c_vv + w * v * v
    m_u, m_v = m_u / total, m_v / total
    c_uu, c_uv, c_vv = c_uu / total - m_u**2, c_uv / total - m_u * m_v, c_vv / total - m_v**2
    if c_uu * c_vv - c_uv**2 > SHARPER**2 * (tip.S[0, 0] * tip.S[1, 1] - tip.S[0, 1] ** 2):
        return out
    # 3. the contribution of the image alone
    i_uu, i_uv, i_vv = _inverse(c_uu + OUT_OF_GRID, c_uv, c_vv + OUT_OF_GRID)
    o_uu, o_uv, o_vv = _at_least(i_uu - p_uu, i_uv - p_uv, i_vv - p_vv, VAGUEST_PX**-2)
    r_uu, r_uv, r_vv = _inverse(o_uu, o_uv, o_vv)
    y_u, y_v = i_uu * m_u + i_uv * m_v, i_uv * m_u + i_vv * m_v
    out[:] = 1.0, r_uu * y_u + r_uv * y_v, r_uv * y_u + r_vv * y_v, r_uu, r_uv, r_vv
    return out
