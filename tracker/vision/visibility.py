"""Which markers a camera can see: the prior p(m_j) of Lee et al. 2021, eqs. 4 to 6.

Three factors per camera: the marker faces it (eq. 4), it lies in the image (eq. 5), and no other
segment is in between (the paper's last condition). A product over both cameras (eq. 6) suits stereo
points; an assignment in one image uses that camera's own row.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np

from tracker.geometry.solids import Vector3, sight_cuts_box, sight_cuts_capsule
from tracker.hand.model import HandModel
from tracker.kernels import kernel
from tracker.kernels.arrays import IntVector, Matrix, Stack, Vector, Written
from tracker.messages import Array, CameraPose
from tracker.vision.rig import Camera, StereoRig

FAR_OUTSIDE = 0.5  # of the image's size; beyond it a lens polynomial is invalid


class Factors(NamedTuple):
    """`VisibilityParams` for kernels."""

    full_deg: float
    none_deg: float
    thin: float
    lift: float
    occluded: float


@dataclass(frozen=True)
class VisibilityParams:
    """Ranges of the three factors."""

    facing_full_deg: float = 58.0  # alpha_min of eq. 4
    facing_none_deg: float = 85.0  # alpha_max of eq. 4
    pixel_sd_px: float = 2.0  # of the projection, where no covariance is given
    radius_factor: float = 0.8  # thinner occluders, to allow for mm of error in the predicted pose
    lift: float = 0.001  # m above the surface, so that a neighbour's skin does not occlude a marker
    occluded: float = 0.03  # prior behind a segment: a wrong pose must not veto evidence

    @cached_property
    def factors(self) -> Factors:
        """The parameters for kernels."""
        return Factors(
            self.facing_full_deg, self.facing_none_deg, self.radius_factor, self.lift, self.occluded
        )


class HandShape(NamedTuple):
    """Segments as solids, S rows: capsules, or slabs where width > 0. All m."""

    length: Vector
    radius: Vector
    width: Vector

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


class PosedHand(NamedTuple):
    """Segments as solids with poses: R_GB (S, 3, 3), p_GB (S, 3) m."""

    shape: HandShape
    R_GB: Stack
    p_GB: Matrix


class MarkerRows(NamedTuple):
    """Markers: p_G (M, 3) m, outward unit normals normal_G (M, 3), and the row (M,) of their
    segments."""

    p_G: Matrix
    normal_G: Matrix
    segment: IntVector


class _View(NamedTuple):
    """A stereo camera in G, m, and u, v of each image's last pixel."""

    R_GC: Matrix
    p_GC: Vector
    baseline: float
    left_corner: tuple[float, float]
    right_corner: tuple[float, float]


class _Pixels(NamedTuple):
    """Markers in both images as recorded, (M, 2) px each, and their sd (2, M, 2) px."""

    left: Matrix
    right: Matrix
    sd: Stack


def visibility(
    hand: PosedHand,
    markers: MarkerRows,
    rig: StereoRig,
    pose: CameraPose,
    cov_px: Array | None = None,
    params: VisibilityParams | None = None,
) -> Array:
    """Prior probability (2, M) that the left and the right camera see each marker.

    cov_px (2, M, 2, 2) px² of the projections.
    """
    uv = seen_from(markers.p_G, rig, pose)
    return visibility_at(uv, hand, markers, rig, pose, cov_px, params)


def seen_from(p_G: Array, rig: StereoRig, pose: CameraPose) -> Array:
    """Rectified pixels (2, M, 2) of points (M, 3) of G in the left and the right image; NaN where
    not in front."""
    p_C = (p_G - pose.p_GC) @ pose.R_GC
    return np.stack([rig.project(p_C), rig.project(p_C, right=True)])


def visibility_at(
    uv: Array,
    hand: PosedHand,
    markers: MarkerRows,
    rig: StereoRig,
    pose: CameraPose,
    cov_px: Array | None = None,
    params: VisibilityParams | None = None,
) -> Array:
    """`visibility` of markers whose rectified pixels uv (2, M, 2) are known."""
    params = params or VisibilityParams()
    if cov_px is None:
        sd = np.full(uv.shape, params.pixel_sd_px)
    else:
        sd = np.sqrt(np.stack([cov_px[..., 0, 0], cov_px[..., 1, 1]], axis=-1))
    view = _View(
        pose.R_GC, pose.p_GC, rig.baseline,
        (rig.left.width - 1.0, rig.left.height - 1.0),
        (rig.right.width - 1.0, rig.right.height - 1.0),
    )  # fmt: skip
    seen = _Pixels(_recorded(rig.left, uv[0]), _recorded(rig.right, uv[1]), sd)
    p_G, normal_G = np.ascontiguousarray(markers.p_G), np.ascontiguousarray(markers.normal_G)
    markers = markers._replace(p_G=p_G, normal_G=normal_G)  # einsum returns other memory orders
    return _priors(markers, hand, seen, view, params.factors)


@kernel(nogil=False)
def _priors(
    markers: MarkerRows, hand: PosedHand, seen: _Pixels, view: _View, factors: Factors
) -> Matrix:
    """(2, M) of both cameras: the product of the three factors."""
    p_G, normal_G = markers.p_G, markers.normal_G
    out = np.empty((2, len(p_G)))
    start = p_G + factors.lift * normal_G
    shape = hand.shape
    thin = HandShape(shape.length, shape.radius * factors.thin, shape.width * factors.thin)
    occluders = PosedHand(thin, hand.R_GB, hand.p_GB)
    for c in range(2):
        centre = view.p_GC + (view.baseline if c else 0.0) * view.R_GC[:, 0]
        right, bottom = view.right_corner if c else view.left_corner
        # 1. eq. 4: does the marker face the camera?
        out[c] = facing(p_G, normal_G, centre, factors.full_deg, factors.none_deg)
        # 2. eq. 5: is it in the image?
        out[c] *= _inside(seen.right if c else seen.left, seen.sd[c], right, bottom)
        # 3. is another segment in between?
        _weaken_hidden(out[c], factors.occluded, centre, start, markers.segment, occluders)
    return out


def both_cameras(prior: Array) -> Array:
    """Eq. 6: probability (M,) that both cameras see a marker, from the rows of `visibility`."""
    return prior[0] * prior[1]


@kernel(nogil=False)
def turned(R_GB: Stack, segment: IntVector, normal: Matrix) -> Matrix:
    """(M, 3) in G of normals (M, 3) in the B of their segments (M,)."""
    out = np.empty_like(normal)
    for m in range(len(normal)):
        R, x, y, z = R_GB[segment[m]], normal[m, 0], normal[m, 1], normal[m, 2]
        for i in range(3):
            out[m, i] = (R[i, 0] * x + R[i, 2] * z) + R[i, 1] * y  # as numpy.einsum adds them
    return out


@kernel
def facing(p: Matrix, normal: Matrix, centre: Vector, full_deg: float, none_deg: float) -> Vector:
    """Eq. 4, (M,): 1 up to alpha_min between normal and direction to the camera, 0 from
    alpha_max."""
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
    """Raw pixels of rectified ones; those far outside are returned unchanged, since they remain
    outside."""
    if camera.is_rectified:
        return uv
    size = np.array([camera.width, camera.height], float)
    near = np.all((uv > -FAR_OUTSIDE * size) & (uv < (1 + FAR_OUTSIDE) * size), axis=1)
    out = uv.copy()
    out[near] = camera.unrectify(uv[near])
    return out


@kernel
def _inside(uv: Matrix, sd: Matrix, right: float, bottom: float) -> Vector:
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
    prior: Written[Vector],
    factor: float,
    centre: Vector,
    p: Matrix,
    segment: IntVector,
    hand: PosedHand,
) -> None:
    """prior (M,) *= factor where a segment other than its own intersects the line camera to
    marker."""
    R, origin = hand.R_GB, hand.p_GB
    length, radius, width = hand.shape.length, hand.shape.radius, hand.shape.width
    hidden = np.zeros(len(p), np.bool_)
    for s in range(len(length)):
        a = _into(R, origin, s, centre)
        for j in range(len(p)):
            if prior[j] <= 0.0 or segment[j] == s or hidden[j]:
                continue
            b = _into(R, origin, s, p[j])
            if width[s] > 0:
                lower = 0.0, -width[s] / 2, -radius[s]
                upper = length[s], width[s] / 2, radius[s]
                hidden[j] = sight_cuts_box(a, b, lower, upper)
            else:
                hidden[j] = sight_cuts_capsule(a, b, length[s], radius[s])
    for j in range(len(p)):
        if hidden[j]:
            prior[j] *= factor


@kernel(inline="always")
def _into(R: Stack, origin: Matrix, s: int, p_G: Vector) -> Vector3:
    """p_B = R_GB^T (p_G - p_GB) of segment s."""
    x, y, z = p_G[0] - origin[s, 0], p_G[1] - origin[s, 1], p_G[2] - origin[s, 2]
    return (
        R[s, 0, 0] * x + R[s, 1, 0] * y + R[s, 2, 0] * z,
        R[s, 0, 1] * x + R[s, 1, 1] * y + R[s, 2, 1] * z,
        R[s, 0, 2] * x + R[s, 1, 2] * y + R[s, 2, 2] * z,
    )
