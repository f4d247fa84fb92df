"""Quaternions in arrays agree with SciPy's."""

from __future__ import annotations

import numpy as np
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

from extensions.openxr.publisher import inverse, product, rotate, rotation_vector


def test_they_turn_as_scipys_rotations() -> None:
    rng = np.random.default_rng(3)
    a, b = Rotation.random(26, rng=rng), Rotation.random(26, rng=rng)
    v = rng.normal(size=(26, 3))
    both = Rotation.from_quat(product(a.as_quat(), b.as_quat()))
    assert ((a * b) * both.inv()).magnitude().max() < 1e-12
    assert_allclose(rotate(a.as_quat(), v), a.apply(v), atol=1e-12)
    assert_allclose(rotate(inverse(a.as_quat()), v), a.inv().apply(v), atol=1e-12)
    assert_allclose(rotation_vector(a.as_quat()), a.as_rotvec(), atol=1e-12)
    assert_allclose(rotation_vector(-a.as_quat()), a.as_rotvec(), atol=1e-12)
    assert_allclose(rotation_vector(np.array([[0.0, 0, 0, 1]])), 0)
