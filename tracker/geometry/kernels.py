"""Compiled twins of `so3` for single rotations, used inside the filters' loops."""

import numpy as np

from tracker.geometry.so3 import NEAREST_ROUNDS
from tracker.kernels import kernel
from tracker.kernels.arrays import IntVector, Matrix, Stack, Vector, Written


@kernel
def exp3(v: Vector) -> Matrix:
    """Rotation matrix (3, 3) of a rotation vector (3,)."""
    x, y, z = v[0], v[1], v[2]
    angle2 = x * x + y * y + z * z
    if angle2 < 1e-16:
        a, b = 1.0 - angle2 / 6, 0.5 - angle2 / 24
    else:
        angle = np.sqrt(angle2)
        a = np.sin(angle) / angle
        half = np.sin(angle / 2) / angle
        b = 2 * half * half
    R = np.empty((3, 3))
    R[0, 0] = 1 - b * (y * y + z * z)
    R[1, 1] = 1 - b * (x * x + z * z)
    R[2, 2] = 1 - b * (x * x + y * y)
    R[0, 1], R[1, 0] = b * x * y - a * z, b * x * y + a * z
    R[0, 2], R[2, 0] = b * x * z + a * y, b * x * z - a * y
    R[1, 2], R[2, 1] = b * y * z - a * x, b * y * z + a * x
    return R


@kernel
def mul3(A: Matrix, B: Matrix) -> Matrix:
    """A B of two (3, 3): BLAS takes four times as long at this size."""
    out = np.empty((3, 3))
    for i in range(3):
        for j in range(3):
            out[i, j] = A[i, 0] * B[0, j] + A[i, 1] * B[1, j] + A[i, 2] * B[2, j]
    return out


@kernel
def tmul3(A: Matrix, B: Matrix) -> Matrix:
    """A^T B of two (3, 3)."""
    return mul3(A.T, B)


@kernel(nogil=False)
def rotate(A: Matrix, v: Vector) -> Vector:
    """A v of (3, 3) and (3,)."""
    out = np.empty(3)
    for i in range(3):
        out[i] = A[i, 0] * v[0] + A[i, 1] * v[1] + A[i, 2] * v[2]
    return out


@kernel
def rotate_back(A: Matrix, v: Vector) -> Vector:
    """A^T v of (3, 3) and (3,)."""
    return rotate(A.T, v)


@kernel
def inverse3(M: Matrix) -> Matrix:
    """The inverse of a symmetric (3, 3), by cofactors."""
    a, b, c, d, e, f = M[0, 0], M[0, 1], M[0, 2], M[1, 1], M[1, 2], M[2, 2]
    A, B, C = d * f - e * e, c * e - b * f, b * e - c * d
    det = a * A + b * B + c * C
    D, E, F = (a * f - c * c) / det, (b * c - a * e) / det, (a * d - b * b) / det
    A, B, C = A / det, B / det, C / det
    return np.array([[A, B, C], [B, D, E], [C, E, F]])


@kernel
def nearest_rotation(M: Matrix) -> Matrix:
    """The rotation R (3, 3) with the largest trace of R^T M, for any M (3, 3): Kabsch's.

    From the eigenvectors V of M^T M, by Jacobi's rotations, longest first: M V is orthogonal, and
    From the eigenvectors V of M^T M, by Jacobi rotations, in descending order: M V is orthogonal,
    and the third axes follow from the first two, so that R is never a reflection.
    """
    A, V = tmul3(M, M), np.eye(3)
    for _ in range(12):  # sweeps; a few suffice
        off = A[0, 1] ** 2 + A[0, 2] ** 2 + A[1, 2] ** 2
        if off <= 1e-32 * (A[0, 0] ** 2 + A[1, 1] ** 2 + A[2, 2] ** 2):
            break
        for i in range(2):
            for j in range(i + 1, 3):
                _rotate_away(A, V, i, j)
    order = np.argsort(np.array([-A[0, 0], -A[1, 1], -A[2, 2]]))
    v_1, v_2 = V[:, order[0]], V[:, order[1]]
    u_1 = _normalised(rotate(M, v_1), v_1)
    u_2 = rotate(M, v_2)
    u_2 = _normalised(u_2 - np.sum(u_1 * u_2) * u_1, across3(u_1))
    return outer3(u_1, v_1) + outer3(u_2, v_2) + outer3(cross3(u_1, u_2), cross3(v_1, v_2))


@kernel
def _rotate_away(A: Written[Matrix], V: Written[Matrix], i: int, j: int) -> None:
    """Jacobi rotation that makes A[i, j] of a symmetric A (3, 3) zero; also applied to V (3, 3)."""
    if A[i, j] == 0.0:
        return
    tau = (A[j, j] - A[i, i]) / (2.0 * A[i, j])
    t = (1.0 if tau >= 0 else -1.0) / (abs(tau) + np.sqrt(1.0 + tau * tau))
    c = 1.0 / np.sqrt(1.0 + t * t)
    s = t * c
    for k in range(3):
        A[k, i], A[k, j] = c * A[k, i] - s * A[k, j], s * A[k, i] + c * A[k, j]
    for k in range(3):
        A[i, k], A[j, k] = c * A[i, k] - s * A[j, k], s * A[i, k] + c * A[j, k]
        V[k, i], V[k, j] = c * V[k, i] - s * V[k, j], s * V[k, i] + c * V[k, j]


@kernel
def _normalised(v: Vector, instead: Vector) -> Vector:
    """v (3,) at unit length; ``instead`` where it is zero."""
    length = np.sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])
    return v / length if length > 0.0 else instead.copy()


@kernel
def across3(v: Vector) -> Vector:
    """A unit vector perpendicular to v (3,)."""
    x = np.array([0.0, -v[2], v[1]]) if abs(v[0]) < 0.6 else np.array([-v[1], v[0], 0.0])
    return x / np.sqrt(np.sum(x * x))


@kernel
def outer3(a: Vector, b: Vector) -> Matrix:
    """a b^T of two (3,) vectors."""
    out = np.empty((3, 3))
    for i in range(3):
        for j in range(3):
            out[i, j] = a[i] * b[j]
    return out


@kernel(nogil=False)
def rotate_all(R: Stack, v: Matrix) -> Stack:
    """R (n, 3, 3) times Exp of v (n, 3)."""
    out = np.empty_like(R)
    for i in range(len(R)):
        out[i] = mul3(R[i], exp3(v[i]))
    return out


@kernel
def skew3(v: Vector) -> Matrix:
    """The cross-product matrix of v (3,)."""
    return np.array([[0.0, -v[2], v[1]], [v[2], 0.0, -v[0]], [-v[1], v[0], 0.0]])


@kernel(nogil=False)
def cross3(a: Vector, b: Vector) -> Vector:
    """a x b of two (3,) vectors."""
    return np.array(
        [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    )


@kernel
def zyx3(R: Matrix) -> tuple[float, float, float]:
    """(abduction, flexion, twist) of R = Rz Ry Rx, as `so3.joint_angles` with all axes."""
    a = np.arctan2(R[1, 0], R[0, 0])
    b = np.arctan2(-R[2, 0], np.hypot(R[0, 0], R[1, 0]))
    c = np.arctan2(R[2, 1], R[2, 2])
    a2, b2, c2 = _wrap(a + np.pi), _wrap(np.pi - b), _wrap(c + np.pi)
    if abs(a2) + abs(c2) < abs(a) + abs(c):
        return a2, b2, c2
    return a, b, c


@kernel(nogil=False)
def joint_angles3(R: Matrix, abducts: bool, twists: bool) -> tuple[float, float, float]:
    """(abduction, flexion, twist) of one joint rotation, as `so3.joint_angles`."""
    if twists:
        return zyx3(R)
    ca, sa = 1.0, 0.0
    cb, sb = _unit(R[0, 0] + R[2, 2], R[0, 2] - R[2, 0])
    for _ in range(NEAREST_ROUNDS if abducts else 0):  # on cosines and sines: no angle is needed
        ca, sa = _unit(R[0, 0] * cb + R[0, 2] * sb + R[1, 1], R[1, 0] * cb + R[1, 2] * sb - R[0, 1])
        cb, sb = _unit(R[0, 0] * ca + R[1, 0] * sa + R[2, 2], R[0, 2] * ca + R[1, 2] * sa - R[2, 0])
    return np.arctan2(sa, ca), np.arctan2(sb, cb), 0.0


@kernel
def _unit(x: float, y: float) -> tuple[float, float]:
    """Cosine and sine of the angle of (x, y); of angle zero where both are zero."""
    length = np.sqrt(x * x + y * y)
    if length == 0.0:
        return 1.0, 0.0
    return x / length, y / length


@kernel
def _wrap(a: float) -> float:
    return (a + np.pi) % (2 * np.pi) - np.pi


@kernel
def quats(R: Stack) -> Matrix:
    """Unit quaternions (n, 4) xyzw, w >= 0, of matrices (n, 3, 3)."""
    out = np.empty((len(R), 4))
    for i in range(len(R)):
        out[i] = quat3(R[i])
    return out


@kernel
def quat3(M: Matrix) -> Vector:
    """Unit quaternion (4,) xyzw, w >= 0, of a matrix (3, 3), as `so3.quat_from_matrix`."""
    trace = M[0, 0] + M[1, 1] + M[2, 2]
    k, best, q = 3, trace, np.empty(4)
    for r in range(3):
        if M[r, r] > best:
            best, k = M[r, r], r
    if k == 3:
        q[0], q[1] = M[2, 1] - M[1, 2], M[0, 2] - M[2, 0]
        q[2], q[3] = M[1, 0] - M[0, 1], 1 + trace
    else:
        j, n = (k + 1) % 3, (k + 2) % 3
        q[k] = 1 - trace + 2 * M[k, k]
        q[j], q[n] = M[j, k] + M[k, j], M[n, k] + M[k, n]
        q[3] = M[n, j] - M[j, n]
    norm = np.sqrt(q[0] ** 2 + q[1] ** 2 + q[2] ** 2 + q[3] ** 2)
    if q[3] < 0:
        norm = -norm
    for r in range(4):
        q[r] /= norm
    return q


@kernel
def log3(R: Matrix) -> Vector:
    """Rotation vector (3,), angle in [0, pi], of a matrix (3, 3), as `so3.log`."""
    q = quat3(R)
    n = np.sqrt(q[0] ** 2 + q[1] ** 2 + q[2] ** 2)
    gain = 2.0 if n < 1e-8 else 2 * np.arctan2(n, q[3]) / n
    return gain * q[:3]


@kernel(nogil=False)
def relative_rotations(R: Stack, parent: IntVector) -> Matrix:
    """(n - 1, 3) rotation vectors of matrices (n, 3, 3), except the first, relative to their
    parents.

    ``parent`` (n,) is the row of each.
    """
    out = np.empty((len(R) - 1, 3))
    for i in range(1, len(R)):
        out[i - 1] = log3(tmul3(R[parent[i]], R[i]))
    return out
