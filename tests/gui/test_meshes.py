"""Meshes for a graphics card: their shape and their normals."""

from __future__ import annotations

import numpy as np
import pytest

from app.widgets.view3d.raster.solids import Rounded, block_surface
from app.widgets.view3d.shapes import Block, CapsuleShape, Disc, ball
from app.widgets.view3d.vtk_scene import BodyMesh, mesh_of

OBLIQUE = np.array([0.6, 0.0, -0.8])
BODIES = {
    "ball": mesh_of(ball(0.02)),
    "capsule": mesh_of(CapsuleShape(0.04, 0.01)),
    "disc": mesh_of(Disc(0.005, 0.002, OBLIQUE)),
    "block": mesh_of(Block(np.array([0.05, 0.04, 0.01]))),
}


def face_vectors(mesh: BodyMesh) -> np.ndarray:
    """(M, 3) area vectors of the quads, by their diagonals."""
    a, b, c, d = (mesh.points[mesh.cells[:, i]] for i in range(4))
    return np.cross(c - a, d - b) / 2


@pytest.mark.parametrize("mesh", BODIES.values(), ids=BODIES.keys())
def test_a_body_is_closed(mesh: BodyMesh) -> None:
    """The area vectors of a closed surface cancel."""
    vectors = face_vectors(mesh)
    assert np.abs(vectors.sum(axis=0)).max() < 1e-9 * len(vectors)
    assert np.linalg.norm(vectors, axis=1).sum() > 1e-5


@pytest.mark.parametrize("mesh", BODIES.values(), ids=BODIES.keys())
def test_normals_point_outward(mesh: BodyMesh) -> None:
    assert np.linalg.norm(mesh.normals, axis=1) == pytest.approx(1.0)
    vectors = face_vectors(mesh)
    area = np.linalg.norm(vectors, axis=1)
    flat = vectors[area > 1e-9] / area[area > 1e-9, None]
    corners = mesh.normals[mesh.cells[area > 1e-9]].mean(axis=1)
    assert np.abs((flat * corners).sum(axis=1)).min() > 0.6
    outwards = mesh.points - mesh.points.mean(axis=0)
    assert (mesh.normals * outwards).sum(axis=1).min() > -1e-9


def test_a_capsule_has_a_constant_radius() -> None:
    mesh = mesh_of(CapsuleShape(0.04, 0.01))
    nearest = np.clip(mesh.points[:, 0], 0.0, 0.04)
    away = mesh.points - np.stack([nearest, 0 * nearest, 0 * nearest], axis=1)
    assert np.linalg.norm(away, axis=1) == pytest.approx(0.01)


def test_a_disc_is_perpendicular_to_its_direction() -> None:
    along = mesh_of(Disc(0.005, 0.002, OBLIQUE)).points @ OBLIQUE
    assert (along.min(), along.max()) == pytest.approx((-0.001, 0.001))


def test_a_block_has_the_given_size() -> None:
    half, centre = np.array([0.05, 0.04, 0.01]), np.array([0.02, 0.0, 0.001])
    bounds = np.array(mesh_of(Block(half, centre)).bounds).reshape(3, 2)
    np.testing.assert_allclose(bounds, np.stack([centre - half, centre + half], axis=1))


def test_a_blocks_mesh_equals_the_surface_of_the_software_renderer() -> None:
    """One shape, two renderers."""
    shape = Block(np.array([0.05, 0.04, 0.01]))
    block = Rounded(*map(float, shape.half), shape.corner, shape.edge)
    mesh = BODIES["block"]
    for point, normal in zip(mesh.points, mesh.normals, strict=True):
        away = block_surface(tuple(point), block)[0]
        assert away == pytest.approx(0.0, abs=1e-9)
        outside = block_surface(tuple(point + 0.01 * normal), block)
        np.testing.assert_allclose(outside, [0.01, *normal], atol=1e-6)
