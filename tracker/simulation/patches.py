"""What of each marker one camera sees: sample points on the curved patch, facing and occlusion."""

from __future__ import annotations

import numba
import numpy as np

from tracker.messages import Array, IntArray

CIRCLE, SQUARE = 0, 1
_SAMPLES = 16


def sample_pattern() -> Array:
    """(2, 16, 2): points of equal area over a circle and a square of unit diameter or side."""
    k = np.arange(_SAMPLES) + 0.5
    radius, turn = 0.5 * np.sqrt(k / _SAMPLES), np.pi * (3 - np.sqrt(5)) * k
    circle = np.column_stack([radius * np.cos(turn), radius * np.sin(turn)])
    circle -= circle.mean(axis=0)  # a spiral of few points is off its middle
    edge = (np.arange(4) + 0.5) / 4 - 0.5
    square = np.stack(np.meshgrid(edge, edge), axis=-1).reshape(-1, 2)
    return np.stack([circle, square])


@numba.njit(cache=True)
def view_patches(
    eye: Array,
    K: Array,
    position: Array,
    normal: Array,
    size: Array,
    shape: IntArray,
    segment: IntArray,
    flat: IntArray,
    R_CB: Array,
    p_CB: Array,
    pattern: Array,
    a: Array,
    b: Array,
    radius: Array,
    owner: IntArray,
    box_R: Array,
    centre: Array,
    half: Array,
    box_owner: IntArray,
) -> tuple[Array, Array, Array, Array]:
    """Seen patches of M markers from ``eye`` (3,) in C with K = (fx, fy, cx, cy).

    position, normal (M, 3) in their segment's B; flat (M,) 1 where the patch lies on a plane, else
    it is wrapped about the bone. R_CB (S, 3, 3), p_CB (S, 3). Solids in C.
    Returns uv (M, 2) px of the seen area's centroid, extent (M, 2) px, facing (M,) mean cosine of
    what is seen of the whole, whole (M,) share of what faces the camera that is not hidden.
    """
    count, samples = len(position), pattern.shape[1]
    uv, extent = np.full((count, 2), np.nan), np.zeros((count, 2))
    facing, whole = np.zeros(count), np.zeros(count)
    point, n_B = np.empty(3), np.empty(3)
    for m in range(count):
        R, p = R_CB[segment[m]], p_CB[segment[m]]
        seen, turned, su, sv = 0.0, 0.0, 0.0, 0.0
        low_u, high_u, low_v, high_v = 1e9, -1e9, 1e9, -1e9
        for k in range(samples):
            s = pattern[shape[m], k] * size[m]
            _on_surface(position[m], normal[m], s, flat[m] == 1, point, n_B)
            x = R @ point + p
            ray = x - eye
            distance = np.sqrt(ray[0] ** 2 + ray[1] ** 2 + ray[2] ** 2)
            n_C = R @ n_B
            cosine = -(n_C[0] * ray[0] + n_C[1] * ray[1] + n_C[2] * ray[2]) / distance
            if ray[2] < 0.02 or cosine <= 0.0:
                continue
            turned += cosine
            if hidden(eye, x, segment[m], a, b, radius, owner, box_R, centre, half, box_owner):
                continue
            u = K[0] * ray[0] / ray[2] + K[2]
            v = K[1] * ray[1] / ray[2] + K[3]
            seen += cosine
            su += cosine * u
            sv += cosine * v
            low_u, high_u = min(low_u, u), max(high_u, u)
            low_v, high_v = min(low_v, v), max(high_v, v)
        if seen > 0.0:
            uv[m, 0], uv[m, 1] = su / seen, sv / seen
            extent[m, 0], extent[m, 1] = high_u - low_u, high_v - low_v
            facing[m] = seen / samples
            whole[m] = seen / turned
    return uv, extent, facing, whole


@numba.njit(cache=True)
def _on_surface(
    position: Array, normal: Array, s: Array, flat: bool, point: Array, n_out: Array
) -> None:
    """The patch's point at ``s`` (along the bone, around it) from its centre, and its normal."""
    if flat or abs(normal[0]) > 0.5:
        _on_plane(position, normal, s, point)
        n_out[:] = normal
        return
    rho = np.sqrt(position[1] ** 2 + position[2] ** 2)
    angle = np.arctan2(position[2], position[1]) + s[1] / rho
    c, d = np.cos(angle), np.sin(angle)
    point[0], point[1], point[2] = position[0] + s[0], rho * c, rho * d
    n_out[0], n_out[1], n_out[2] = 0.0, c, d


@numba.njit(cache=True)
def _on_plane(position: Array, n: Array, s: Array, point: Array) -> None:
    along = np.array([1.0, 0.0, 0.0]) if abs(n[0]) <= 0.9 else np.array([0.0, 0.0, 1.0])
    along -= (along[0] * n[0] + along[1] * n[1] + along[2] * n[2]) * n
    along /= np.sqrt(along[0] ** 2 + along[1] ** 2 + along[2] ** 2)
    across = np.cross(n, along)
    point[:] = position + s[0] * along + s[1] * across


@numba.njit(cache=True)
def hidden(
    eye: Array,
    x: Array,
    own: int,
    a: Array,
    b: Array,
    radius: Array,
    owner: IntArray,
    box_R: Array,
    centre: Array,
    half: Array,
    box_owner: IntArray,
) -> bool:
    """Whether a solid that is not the segment ``own`` stands between ``eye`` and the point x."""
    for i in range(len(radius)):
        if owner[i] == own:
            continue
        if _segments_closer(eye, x, a[i], b[i], radius[i]):
            return True
    for i in range(len(half)):
        if box_owner[i] != own and _crosses_box(eye, x, box_R[i], centre[i], half[i]):
            return True
    return False


@numba.njit(cache=True)
def _segments_closer(p: Array, q: Array, a: Array, b: Array, r: float) -> bool:
    """Whether the segments pq and ab come nearer than r (Ericson 2005, section 5.1.9)."""
    d0, d1, d2 = q[0] - p[0], q[1] - p[1], q[2] - p[2]
    e0, e1, e2 = b[0] - a[0], b[1] - a[1], b[2] - a[2]
    w0, w1, w2 = p[0] - a[0], p[1] - a[1], p[2] - a[2]
    dd = d0 * d0 + d1 * d1 + d2 * d2
    ee = e0 * e0 + e1 * e1 + e2 * e2
    f = e0 * w0 + e1 * w1 + e2 * w2
    c = d0 * w0 + d1 * w1 + d2 * w2
    if ee < 1e-12:
        s, t = min(max(-c / dd, 0.0), 1.0), 0.0
    else:
        de = d0 * e0 + d1 * e1 + d2 * e2
        denominator = dd * ee - de * de
        s = 0.0
        if denominator > 1e-15:
            s = min(max((de * f - c * ee) / denominator, 0.0), 1.0)
        t = (de * s + f) / ee
        if t < 0.0:
            t, s = 0.0, min(max(-c / dd, 0.0), 1.0)
        elif t > 1.0:
            t, s = 1.0, min(max((de - c) / dd, 0.0), 1.0)
    g0, g1, g2 = w0 + s * d0 - t * e0, w1 + s * d1 - t * e1, w2 + s * d2 - t * e2
    return g0 * g0 + g1 * g1 + g2 * g2 < r * r


@numba.njit(cache=True)
def _crosses_box(p: Array, q: Array, R: Array, centre: Array, half: Array) -> bool:
    """Whether the segment pq meets the box (slab method)."""
    low, high = 0.0, 1.0
    for k in range(3):
        start = (
            R[0, k] * (p[0] - centre[0])
            + R[1, k] * (p[1] - centre[1])
            + R[2, k] * (p[2] - centre[2])
        )
        step = R[0, k] * (q[0] - p[0]) + R[1, k] * (q[1] - p[1]) + R[2, k] * (q[2] - p[2])
        if abs(step) < 1e-12:
            if abs(start) > half[k]:
                return False
            continue
        t0, t1 = (-half[k] - start) / step, (half[k] - start) / step
        low, high = max(low, min(t0, t1)), min(high, max(t0, t1))
        if low > high:
            return False
    return True
