"""Compiled kernels against their plain twins."""

import numpy as np
from scipy.spatial.transform import Rotation

from tracker.geometry import kernels, so3

VECTORS = np.concatenate([np.random.default_rng(0).normal(size=(30, 3)), np.zeros((1, 3))])


def test_rotations() -> None:
    R = Rotation.random(31, rng=1).as_matrix()
    assert np.allclose(kernels.turn_all(R, VECTORS), R @ so3.exp(VECTORS), atol=1e-14)
    assert np.allclose(kernels.quats(R), so3.quat_from_matrix(R), atol=1e-12)
    for M, v in zip(R, VECTORS, strict=True):
        assert np.allclose(kernels.zyx3(M), so3.zyx_from_matrix(M), atol=1e-12)
        for axes in ((True, True), (True, False), (False, False)):
            assert np.allclose(kernels.joint_angles3(M, *axes), so3.joint_angles(M, *axes))
        assert np.array_equal(kernels.skew3(v), so3.skew(v))
        assert np.allclose(kernels.cross3(v, M[0]), np.cross(v, M[0]), atol=1e-15)


def test_small_products() -> None:
    rng = np.random.default_rng(1)
    A, B, v = rng.normal(size=(3, 3)), rng.normal(size=(3, 3)), rng.normal(size=3)
    assert np.allclose(kernels.mul3(A, B), A @ B, atol=1e-14)
    assert np.allclose(kernels.tmul3(A, B), A.T @ B, atol=1e-14)
    assert np.allclose(kernels.act3(A, v), A @ v, atol=1e-14)
    assert np.allclose(kernels.tact3(A, v), A.T @ v, atol=1e-14)


def test_rotation_vectors() -> None:
    R = Rotation.random(31, rng=2).as_matrix()
    R[3], R[4] = np.eye(3), so3.rx(np.pi)
    for M in R:
        assert np.allclose(kernels.log3(M), so3.log(M), atol=1e-12)
    parent = np.maximum((np.arange(len(R)) - 1) // 2, -1)
    plain = so3.log(R[parent[1:]].swapaxes(1, 2) @ R[1:])
    assert np.allclose(kernels.relative_turns(R, parent), plain, atol=1e-12)


def test_inverse() -> None:
    root = np.random.default_rng(3).normal(size=(20, 3, 3))
    for M in root @ root.swapaxes(1, 2):
        assert np.allclose(kernels.inverse3(M) @ M, np.eye(3), atol=1e-8)
