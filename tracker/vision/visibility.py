"""Which markers a camera can see: the prior p(m_j) of Lee et al. 2021, eqs. 4 to 6.

Three factors per camera: the marker faces it (eq. 4), it lies in the image (eq. 5), and no other
segment stands between (the paper's last condition). A product over both cameras (eq. 6) suits
stereo points; an assignment in one image takes that camera's own row.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from tracker.hand.model import HandModel
from tracker.kernels import kernel
from tracker.messages import Array, CameraPose, IntArray
from tracker.vision.rig import Camera, StereoRig

FAR_OUTSIDE = 0.5  # of the image's size; beyond it a lens polynomial means nothing


@dataclass(frozen=True)
class VisibilityParams:
    """Ranges of the three factors."""

    facing_full_deg: float = 58.0  # alpha_min of eq. 4
    facing_none_deg: float = 85.0  # alpha_max of eq. 4
    pixel_sd_px: float = 2.0  # of the projection, where no covariance is given
    radius_factor: float = 0.8  # thinner occluders: the predicted pose is wrong by some mm
    lift: float = 0.001  # m above the surface, so that a neighbour's skin does not hide a marker
    occluded: float = 0.03  # what remains behind a segment: a wrong pose must not veto evidence


@dataclass(frozen=True, eq=False)
class HandShape:
    """Segments as solids, S rows: capsules, or slabs where width > 0. All m."""

    length: Array
    radius: Array
    width: Array

    @staticmethod
    def of(hand: HandModel) -> HandShape:
        s = hand.segments
        return HandShape(
            np.array([x.length for x in s], float),
            np.array([x.radius for x in s], float),
            np.array([x.width for x in s], float),
        )

    def scaled(self, scale: Array) -> HandShape:
        """With factors (S, 3) along each segment's axes."""
        return HandShape(
            self.length * scale[:, 0], self.radius * scale[:, 2], self.width * scale[:, 1]
        )


def visibility(
    shape: HandShape,
    rig: StereoRig,
    pose: CameraPose,
    p_G: Array,
    normal_G: Array,
    segment: IntArray,
    R_GB: Array,
    p_GB: Array,
    cov_px: Array | None = None,
    params: VisibilityParams | None = None,
) -> Array:
    """Prior probability (2, M) that the left and the right camera see each marker.

    p_G, normal_G (M, 3) markers and outward unit normals; segment (M,) the row each sits on;
    R_GB (S, 3, 3), p_GB (S, 3) poses of all segments; cov_px (2, M, 2, 2) of the projections.
    """
    p_C = (p_G - pose.p_GC) @ pose.R_GC
    uv = np.stack([rig.project(p_C), rig.project(p_C, right=True)])
    solids = shape, R_GB, p_GB
    return visibility_at(uv, solids, rig, pose, p_G, normal_G, segment, cov_px, params)


def visibility_at(
    uv: Array,
    solids: tuple[HandShape, Array, Array],
    rig: StereoRig,
    pose: CameraPose,
    p_G: Array,
    normal_G: Array,
    segment: IntArray,
    cov_px: Array | None = None,
    params: VisibilityParams | None = None,
) -> Array:
    """`visibility` of markers whose rectified pixels uv (2, M, 2) are known.

    ``solids`` are the segments' shape, R_GB (S, 3, 3) and p_GB (S, 3).
    """
    params = params or VisibilityParams()
    shape, R_GB, p_GB = solids
    if cov_px is None:
        sd = np.full(uv.shape, params.pixel_sd_px)
    else:
        sd = np.sqrt(np.stack([cov_px[..., 0, 0], cov_px[..., 1, 1]], axis=-1))
    return _priors(
        p_G, normal_G, segment, pose.R_GC, pose.p_GC, rig.baseline,
        _recorded(rig.left, uv[0]), _recorded(rig.right, uv[1]), sd,
        (rig.left.width - 1.0, rig.left.height - 1.0),
        (rig.right.width - 1.0, rig.right.height - 1.0),
        R_GB, p_GB, shape.length, shape.radius, shape.width,
        params.facing_full_deg, params.facing_none_deg,
        params.radius_factor, params.lift, params.occluded,
    )  # fmt: skip


@kernel
def _priors(
    p_G: Array,
    normal_G: Array,
    segment: IntArray,
    R_GC: Array,
    p_GC: Array,
    baseline: float,
    uv_left: Array,
    uv_right: Array,
    sd: Array,
    left_corner: tuple[float, float],
    right_corner: tuple[float, float],
    R_GB: Array,
    p_GB: Array,
    length: Array,
    radius: Array,
    width: Array,
    full_deg: float,
    none_deg: float,
    thin: float,
    lift: float,
    occluded: float,
) -> Array:
    """(2, M) of both cameras: the product of the three factors. Corners are the last pixel's u, v;
    sd (2, M, 2) px."""
    out = np.empty((2, len(p_G)))
    start = p_G + lift * normal_G
    for c in range(2):
        centre = p_GC + (baseline if c else 0.0) * R_GC[:, 0]
        right, bottom = right_corner if c else left_corner
        out[c] = facing(p_G, normal_G, centre, full_deg, none_deg)
        out[c] *= _inside(uv_right if c else uv_left, sd[c], right, bottom)
        _weaken_hidden(
            out[c], occluded, centre, start, segment, R_GB, p_GB, length, radius * thin,
            width * thin,
        )  # fmt: skip
    return out


def both_cameras(prior: Array) -> Array:
    """Eq. 6: probability (M,) that both cameras see a marker, from the rows of `visibility`."""
    return prior[0] * prior[1]


@kernel
def facing(p: Array, normal: Array, centre: Array, full_deg: float, none_deg: float) -> Array:
    """Eq. 4, (M,): 1 up to alpha_min between normal and way to the camera, 0 from alpha_max."""
    out = np.empty(len(p))
    for j in range(len(p)):
        along, length2 = 0.0, 0.0
        for k in range(3):
            d = centre[k] - p[j, k]
            along += normal[j, k] * d
            length2 += d * d
        cosine = min(max(along / math.sqrt(length2), -1.0), 1.0)
        alpha_deg = math.degrees(math.acos(cosine))
        out[j] = min(max((none_deg - alpha_deg) / (none_deg - full_deg), 0.0), 1.0)
    return out


def _recorded(camera: Camera, uv: Array) -> Array:
    """Raw pixels of rectified ones; those far outside stay as they are, for they stay outside."""
    if camera.is_rectified:
        return uv
    size = np.array([camera.width, camera.height], float)
    near = np.all((uv > -FAR_OUTSIDE * size) & (uv < (1 + FAR_OUTSIDE) * size), axis=1)
    out = uv.copy()
    out[near] = camera.unrectify(uv[near])
    return out


@kernel
def _inside(uv: Array, sd: Array, right: float, bottom: float) -> Array:
    """Eq. 5, (M,): probability that a pixel of uv (M, 2) lies inside the image as recorded.

    Phi(d / sigma) with d the signed distance to the nearest edge, sigma along it.
    """
    out = np.zeros(len(uv))
    for j in range(len(uv)):
        u, v = uv[j, 0], uv[j, 1]
        if math.isnan(u):
            continue
        du, dv = min(u, right - u), min(v, bottom - v)
        d, sigma = (du, sd[j, 0]) if du < dv else (dv, sd[j, 1])
        out[j] = 0.5 * math.erfc(-d / (max(sigma, 1e-6) * math.sqrt(2.0)))
    return out


@kernel
def _weaken_hidden(
    prior: Array,
    factor: float,
    centre: Array,
    p: Array,
    segment: IntArray,
    R: Array,
    origin: Array,
    length: Array,
    radius: Array,
    width: Array,
) -> None:
    """prior (M,) *= factor where another segment than its own cuts the line camera to marker."""
    hidden = np.zeros(len(p), np.bool_)
    a, b = np.empty(3), np.empty(3)
    for s in range(len(length)):
        _into(R[s], origin[s], centre, a)
        for j in range(len(p)):
            if prior[j] <= 0.0 or segment[j] == s or hidden[j]:
                continue
            _into(R[s], origin[s], p[j], b)
            if width[s] > 0:
                hidden[j] = _cuts_slab(a, b, length[s], width[s] / 2, radius[s])
            else:
                hidden[j] = _cuts_capsule(a, b, length[s], radius[s])
    for j in range(len(p)):
        if hidden[j]:
            prior[j] *= factor


@kernel
def _into(R: Array, origin: Array, p_G: Array, out: Array) -> None:
    """p_B = R_GB^T (p_G - p_GB)."""
    for i in range(3):
        out[i] = 0.0
        for k in range(3):
            out[i] += R[k, i] * (p_G[k] - origin[k])


@kernel
def _cuts_slab(a: Array, b: Array, length: float, half_width: float, half_height: float) -> bool:
    """Whether the line a-b meets the box 0..length, ±half_width, ±half_height (slab method)."""
    low, high = 0.0, 1.0
    for i in range(3):
        lo = 0.0 if i == 0 else (-half_width if i == 1 else -half_height)
        hi = length if i == 0 else -lo
        d = b[i] - a[i]
        if abs(d) < 1e-12:
            if a[i] < lo or a[i] > hi:
                return False
            continue
        t0, t1 = (lo - a[i]) / d, (hi - a[i]) / d
        low, high = max(low, min(t0, t1)), min(high, max(t0, t1))
    return low < high


@kernel
def _cuts_capsule(a: Array, b: Array, length: float, radius: float) -> bool:
    """Whether the line a-b comes within ``radius`` of the axis (0, 0, 0)-(length, 0, 0).

    The nearest points of two line segments, Ericson, Real-Time Collision Detection, 5.1.9.
    """
    d0, d1, d2 = b[0] - a[0], b[1] - a[1], b[2] - a[2]
    dd = d0 * d0 + d1 * d1 + d2 * d2
    da = d0 * a[0] + d1 * a[1] + d2 * a[2]
    cross = dd - d0 * d0  # of the two directions, squared, over length squared
    t = 0.0
    if cross > 1e-15:
        t = min(max((d0 * a[0] - da) / cross, 0.0), 1.0)
    x = min(max(a[0] + t * d0, 0.0), length)  # nearest on the axis to that point of the line
    t = min(max((x * d0 - da) / dd, 0.0), 1.0)
    x = min(max(a[0] + t * d0, 0.0), length)
    u, v, w = a[0] + t * d0 - x, a[1] + t * d1, a[2] + t * d2
    return u * u + v * v + w * w < radius * radius
