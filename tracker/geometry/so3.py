"""Rotations in three dimensions: matrices (…, 3, 3), vectors (…, 3), quaternions (…, 4) xyzw."""

import numpy as np

from tracker.base.arrays import Array

_SMALL = 1e-8
_EYE = np.eye(3)
_FEW = 8
"""Rotations up to which one at a time is faster."""


def skew(v: Array) -> Array:
    """The cross-product matrix: ``skew(a) @ b == cross(a, b)``. (…, 3) to (…, 3, 3)."""
    v = np.asarray(v, float)
    out = np.zeros((*v.shape, 3))
    out[..., 0, 1] = -v[..., 2]
    out[..., 0, 2] = v[..., 1]
    out[..., 1, 0] = v[..., 2]
    out[..., 1, 2] = -v[..., 0]
    out[..., 2, 0] = -v[..., 1]
    out[..., 2, 1] = v[..., 0]
    return out


def exp(phi: Array) -> Array:
    """Rotation matrix of a rotation vector (Rodrigues). (…, 3) to (…, 3, 3)."""
    phi = np.asarray(phi, float)
    angle2 = np.add.reduce(phi * phi, axis=-1)[..., None, None]
    angle = np.sqrt(angle2)
    small = angle < _SMALL
    is_small = small.any()
    safe = np.where(small, 1.0, angle) if is_small else angle
    a = np.sin(safe) / safe
    half = np.sin(safe / 2) / safe
    b = 2 * half * half
    if is_small:
        a, b = np.where(small, 1.0 - angle2 / 6, a), np.where(small, 0.5 - angle2 / 24, b)
    K = skew(phi)
    return _EYE + a * K + b * (K @ K)


def log(R: Array) -> Array:
    """Rotation vector of a rotation matrix, angle in [0, π]. (…, 3, 3) to (…, 3)."""
    q = quat_from_matrix(R)
    v, w = q[..., :3], q[..., 3:]
    sign = np.where(w < 0, -1.0, 1.0)
    v, w = v * sign, w * sign
    n = np.linalg.norm(v, axis=-1, keepdims=True)
    small = n < _SMALL
    safe = np.where(small, 1.0, n)
    return v * np.where(small, 2.0 / np.where(w == 0, 1.0, w), 2 * np.arctan2(n, w) / safe)


def quat_from_matrix(R: Array) -> Array:
    """Unit quaternion xyzw with w ≥ 0 of a rotation matrix; picks the best-conditioned formula."""
    R = np.asarray(R, float)
    m = R.reshape(-1, 3, 3)
    q = _quats(m) if len(m) > _FEW else np.array([_quat_one(M) for M in m]).reshape(-1, 4)
    q *= np.where(q[:, 3:] < 0, -1.0, 1.0)
    return q.reshape(*R.shape[:-2], 4)


def _quats(m: Array) -> Array:
    """`_quat_one` of each of (N, 3, 3), to the bit: (N, 4)."""
    trace = m[:, 0, 0] + m[:, 1, 1] + m[:, 2, 2]
    d = np.stack([m[:, 0, 0], m[:, 1, 1], m[:, 2, 2], trace], axis=1)
    largest = d.argmax(axis=1)
    q = np.empty((len(m), 4))
    for i in range(3):
        j, n = (i + 1) % 3, (i + 2) % 3
        rows = np.flatnonzero(largest == i)
        M = m[rows]
        q[rows, i] = 1 - d[rows, 3] + 2 * M[:, i, i]
        q[rows, j] = M[:, j, i] + M[:, i, j]
        q[rows, n] = M[:, n, i] + M[:, i, n]
        q[rows, 3] = M[:, n, j] - M[:, j, n]
    rows = np.flatnonzero(largest == 3)
    M = m[rows]
    q[rows, 0] = M[:, 2, 1] - M[:, 1, 2]
    q[rows, 1] = M[:, 0, 2] - M[:, 2, 0]
    q[rows, 2] = M[:, 1, 0] - M[:, 0, 1]
    q[rows, 3] = 1 + d[rows, 3]
    return q / np.sqrt(q[:, None, :] @ q[:, :, None])[:, 0]  # norm() of one has the same sums


def _quat_one(M: Array) -> Array:
    d = np.array([M[0, 0], M[1, 1], M[2, 2], M[0, 0] + M[1, 1] + M[2, 2]])
    k = int(np.argmax(d))
    if k == 3:
        q = np.array([M[2, 1] - M[1, 2], M[0, 2] - M[2, 0], M[1, 0] - M[0, 1], 1 + d[3]])
    else:
        i, j, n = k, (k + 1) % 3, (k + 2) % 3
        q = np.empty(4)
        q[i] = 1 - d[3] + 2 * M[i, i]
        q[j] = M[j, i] + M[i, j]
        q[n] = M[n, i] + M[i, n]
        q[3] = M[n, j] - M[j, n]
    return q / np.linalg.norm(q)


def matrix_from_quat(q: Array) -> Array:
    """Rotation matrix of a quaternion xyzw, normalised here. (…, 4) to (…, 3, 3)."""
    q = np.asarray(q, float)
    q = q / np.linalg.norm(q, axis=-1, keepdims=True)
    v, w = q[..., :3], q[..., 3, None, None]
    K = skew(v)
    return np.eye(3) + 2 * w * K + 2 * (K @ K)


def rx(a: float) -> Array:
    """Rotation about x by ``a``."""
    c, s = np.cos(a), np.sin(a)
    return np.array([[1.0, 0, 0], [0, c, -s], [0, s, c]])


def ry(a: float) -> Array:
    """Rotation about y by ``a``."""
    c, s = np.cos(a), np.sin(a)
    return np.array([[c, 0, s], [0, 1.0, 0], [-s, 0, c]])


def rz(a: float) -> Array:
    """Rotation about z by ``a``."""
    c, s = np.cos(a), np.sin(a)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])


def _zyx(R: Array) -> Array:
    """(..., 3) abduction, flexion, twist of R = Rz(abduction) Ry(flexion) Rx(twist).

    Flexion is in [-π/2, π/2] by this formula alone, and a finger flexes further; so when the
    cosine's sign is ambiguous the branch with the smaller |abduction| + |twist| is used.
    """
    first = np.stack(
        [
            np.arctan2(R[..., 1, 0], R[..., 0, 0]),
            np.arctan2(-R[..., 2, 0], np.hypot(R[..., 0, 0], R[..., 1, 0])),
            np.arctan2(R[..., 2, 1], R[..., 2, 2]),
        ],
        axis=-1,
    )
    second = first * [1.0, -1.0, 1.0] + np.pi
    second = (second + np.pi) % (2 * np.pi) - np.pi
    far = np.abs(second[..., ::2]).sum(-1) < np.abs(first[..., ::2]).sum(-1)
    return np.where(far[..., None], second, first)


NEAREST_ROUNDS = 12


def joint_angles(R: Array, abducts: bool = True, twists: bool = True) -> Array:
    """(..., 3) abduction, flexion, twist of joint rotations R (..., 3, 3), for the axes it has.

    For a joint without twist, the Rz Ry nearest to R: this is continuous near 90° of flexion, where
    abduction and twist have the same axis and Euler angles jump. Zero where there is no axis.
    """
    if twists:
        return _zyx(R)
    a = np.zeros(R.shape[:-2])
    b = np.arctan2(R[..., 0, 2] - R[..., 2, 0], R[..., 0, 0] + R[..., 2, 2])
    for _ in range(NEAREST_ROUNDS if abducts else 0):  # alternate between the angles
        c, s = np.cos(b), np.sin(b)
        a = np.arctan2(
            R[..., 1, 0] * c + R[..., 1, 2] * s - R[..., 0, 1],
            R[..., 0, 0] * c + R[..., 0, 2] * s + R[..., 1, 1],
        )
        c, s = np.cos(a), np.sin(a)
        b = np.arctan2(
            R[..., 0, 2] * c + R[..., 1, 2] * s - R[..., 2, 0],
            R[..., 0, 0] * c + R[..., 1, 0] * s + R[..., 2, 2],
        )
    return np.stack([a, b, np.zeros_like(a)], axis=-1)
