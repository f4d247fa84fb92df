"""Compiled kernels against their plain twins."""

import numpy as np
from scipy.spatial.transform import Rotation

from tracker.geometry import kernels, so3

VECTORS = np.concatenate([np.random.default_rng(0).normal(size=(30, 3)), np.zeros((1, 3))])


def test_rotations() -> None:
    R = Rotation.random(31, rng=1).as_matrix()
    assert np.allclose(kernels.rotate_all(R, VECTORS), R @ so3.exp(VECTORS), atol=1e-14)
    assert np.allclose(kernels.quats(R), so3.quat_from_matrix(R), atol=1e-12)
    for M, v in zip(R, VECTORS, strict=True):
        assert np.allclose(kernels.zyx3(M), so3.joint_angles(M), atol=1e-12)
        for axes in ((True, True), (True, False), (False, False)):
            assert np.allclose(kernels.joint_angles3(M, *axes), so3.joint_angles(M, *axes))
        assert np.array_equal(kernels.skew3(v), so3.skew(v))
        assert np.allclose(kernels.cross3(v, M[0]), np.cross(v, M[0]), atol=1e-15)


def test_small_products() -> None:
    rng = np.random.default_rng(1)
    A, B, v = rng.normal(size=(3, 3)), rng.normal(size=(3, 3)), rng.normal(size=3)
    assert np.allclose(kernels.mul3(A, B), A @ B, atol=1e-14)
    assert np.allclose(kernels.tmul3(A, B), A.T @ B, atol=1e-14)
    assert np.allclose(kernels.rotate(A, v), A @ v, atol=1e-14)
    assert np.allclose(kernels.rotate_back(A, v), A.T @ v, atol=1e-14)


def test_rotation_vectors() -> None:
    R = Rotation.random(31, rng=2).as_matrix()
    R[3], R[4] = np.eye(3), so3.rx(np.pi)
    for M in R:
        assert np.allclose(kernels.log3(M), so3.log(M), atol=1e-12)
    parent = np.maximum((np.arange(len(R)) - 1) // 2, -1)
    plain = so3.log(R[parent[1:]].swapaxes(1, 2) @ R[1:])
    assert np.allclose(kernels.relative_rotations(R, parent), plain, atol=1e-12)


def test_inverse() -> None:
    root = np.random.default_rng(3).normal(size=(20, 3, 3))
    for M in root @ root.swapaxes(1, 2):
        assert np.allclose(kernels.inverse3(M) @ M, np.eye(3), atol=1e-8)


def test_nearest_rotation_is_kabschs() -> None:
    """Full rank, with a reflection, of points in a plane, and nearly zero."""
    rng = np.random.default_rng(4)
    cases = [*rng.normal(size=(20, 3, 3)), np.diag([1.0, 1.0, -0.5]), np.eye(3)]
    cases += [np.outer(*rng.normal(size=(2, 3))) + np.outer(*rng.normal(size=(2, 3)))]
    for M in cases:
        U, _, Vt = np.linalg.svd(M)
        expected = U @ np.diag([1.0, 1.0, np.sign(np.linalg.det(U @ Vt))]) @ Vt
        assert np.allclose(kernels.nearest_rotation(M), expected, atol=1e-9)
    for M in (np.zeros((3, 3)), np.outer(VECTORS[0], VECTORS[1])):
        R = kernels.nearest_rotation(M)
        assert np.allclose(R @ R.T, np.eye(3), atol=1e-12) and np.linalg.det(R) > 0
        assert np.trace(R.T @ M) >= np.linalg.norm(M) - 1e-9
