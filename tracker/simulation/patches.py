"""What of each marker one camera sees: sample points on the curved patch, facing and occlusion."""

from __future__ import annotations

import numpy as np

from tracker.kernels import kernel
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


@kernel
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
    local, n_B = np.empty(3), np.empty(3)
    x, n_C, ray = np.empty(3), np.empty(3), np.empty(3)
    rows = np.empty(len(radius), np.int64)
    for m in range(count):
        own = segment[m]
        _carry(R_CB, p_CB, own, position[m], x)
        near = near_ray(eye, x, 0.8 * size[m], own, a, b, radius, owner, rows)
        seen, turned, su, sv = 0.0, 0.0, 0.0, 0.0
        low_u, high_u, low_v, high_v = 1e9, -1e9, 1e9, -1e9
        for k in range(samples):
            s = pattern[shape[m], k] * size[m]
            _on_surface(position[m], normal[m], s, flat[m] == 1, local, n_B)
            _carry(R_CB, p_CB, own, local, x)
            _turn(R_CB, own, n_B, n_C)
            distance, along = 0.0, 0.0
            for c in range(3):
                ray[c] = x[c] - eye[c]
                distance += ray[c] * ray[c]
                along += n_C[c] * ray[c]
            cosine = -along / np.sqrt(distance)
            if ray[2] < 0.02 or cosine <= 0.0:
                continue
            turned += cosine
            if hidden(eye, x, own, rows, near, a, b, radius, box_R, centre, half, box_owner):
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


@kernel
def _turn(R: Array, i: int, v: Array, out: Array) -> None:
    """R[i] v, without a BLAS call for three numbers."""
    for c in range(3):
        out[c] = R[i, c, 0] * v[0] + R[i, c, 1] * v[1] + R[i, c, 2] * v[2]


@kernel
def _carry(R: Array, p: Array, i: int, v: Array, out: Array) -> None:
    """R[i] v + p[i]."""
    _turn(R, i, v, out)
    for c in range(3):
        out[c] += p[i, c]


@kernel
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


@kernel
def _on_plane(position: Array, n: Array, s: Array, point: Array) -> None:
    along = np.array([1.0, 0.0, 0.0]) if abs(n[0]) <= 0.9 else np.array([0.0, 0.0, 1.0])
    along -= (along[0] * n[0] + along[1] * n[1] + along[2] * n[2]) * n
    along /= np.sqrt(along[0] ** 2 + along[1] ** 2 + along[2] ** 2)
    across = np.cross(n, along)
    point[:] = position + s[0] * along + s[1] * across


@kernel
def near_ray(
    eye: Array,
    x: Array,
    reach: float,
    own: int,
    a: Array,
    b: Array,
    radius: Array,
    owner: IntArray,
    found: IntArray,
) -> int:
    """How many capsules come within ``reach`` of the ray from ``eye`` to x; rows into ``found``."""
    count = 0
    for i in range(len(radius)):
        if owner[i] != own and _segments_closer(eye, x, a, b, i, radius[i] + reach):
            found[count] = i
            count += 1
    return count


@kernel
def hidden(
    eye: Array,
    x: Array,
    own: int,
    rows: IntArray,
    count: int,
    a: Array,
    b: Array,
    radius: Array,
    box_R: Array,
    centre: Array,
    half: Array,
    box_owner: IntArray,
) -> bool:
    """Whether a capsule of rows[:count], or a box, stands between ``eye`` and the point x.

    What belongs to the segment ``own`` is not asked: `near_ray` leaves its capsules out.
    """
    for k in range(count):
        if _segments_closer(eye, x, a, b, rows[k], radius[rows[k]]):
            return True
    for i in range(len(half)):
        if box_owner[i] != own and _crosses_box(eye, x, box_R, centre, half, i):
            return True
    return False


@kernel
def _segments_closer(p: Array, q: Array, a: Array, b: Array, i: int, r: float) -> bool:
    """Whether pq and capsule i's axis come nearer than r (Ericson 2005, section 5.1.9)."""
    d0, d1, d2 = q[0] - p[0], q[1] - p[1], q[2] - p[2]
    e0, e1, e2 = b[i, 0] - a[i, 0], b[i, 1] - a[i, 1], b[i, 2] - a[i, 2]
    w0, w1, w2 = p[0] - a[i, 0], p[1] - a[i, 1], p[2] - a[i, 2]
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


@kernel
def _crosses_box(p: Array, q: Array, R: Array, centre: Array, half: Array, i: int) -> bool:
    """Whether the segment pq meets box i (slab method)."""
    low, high = 0.0, 1.0
    for k in range(3):
        start, step = 0.0, 0.0
        for c in range(3):
            start += R[i, c, k] * (p[c] - centre[i, c])
            step += R[i, c, k] * (q[c] - p[c])
        if abs(step) < 1e-12:
            if abs(start) > half[i, k]:
                return False
            continue
        t0, t1 = (-half[i, k] - start) / step, (half[i, k] - start) / step
        low, high = max(low, min(t0, t1)), min(high, max(t0, t1))
        if low > high:
            return False
    return True
