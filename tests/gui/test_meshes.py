"""Bodies of the 3D view: their shape, their normals, and the pixels that come of them."""

from __future__ import annotations

import numpy as np
import pytest
from gui_fakes import ScriptedEngine, scripted_setup

from app.panels.hand_actors import HandActors
from app.widgets.meshes import Mesh, ball, capsule, disc, lines, rounded_block
from app.widgets.orbit import Orbit

OBLIQUE = np.array([0.6, 0.0, -0.8])
BODIES = {
    "ball": ball(0.02),
    "capsule": capsule(0.04, 0.01),
    "disc": disc(0.005, 0.002, OBLIQUE),
    "block": rounded_block(np.array([0.05, 0.04, 0.01])),
}


def face_vectors(mesh: Mesh) -> np.ndarray:
    """(M, 3) area vectors of the quads, by their diagonals."""
    a, b, c, d = (mesh.points[mesh.cells[:, i]] for i in range(4))
    return np.cross(c - a, d - b) / 2


@pytest.mark.parametrize("mesh", BODIES.values(), ids=BODIES.keys())
def test_a_body_is_closed(mesh: Mesh) -> None:
    """The area vectors of a closed surface cancel."""
    vectors = face_vectors(mesh)
    assert np.abs(vectors.sum(axis=0)).max() < 1e-9 * len(vectors)
    assert np.linalg.norm(vectors, axis=1).sum() > 1e-5


@pytest.mark.parametrize("mesh", BODIES.values(), ids=BODIES.keys())
def test_normals_point_out_of_the_surface(mesh: Mesh) -> None:
    assert np.linalg.norm(mesh.normals, axis=1) == pytest.approx(1.0)
    vectors = face_vectors(mesh)
    area = np.linalg.norm(vectors, axis=1)
    flat = vectors[area > 1e-9] / area[area > 1e-9, None]
    corners = mesh.normals[mesh.cells[area > 1e-9]].mean(axis=1)
    assert np.abs((flat * corners).sum(axis=1)).min() > 0.6
    outwards = mesh.points - mesh.points.mean(axis=0)
    assert (mesh.normals * outwards).sum(axis=1).min() > -1e-9


def test_a_capsule_keeps_its_radius_all_along() -> None:
    mesh = capsule(0.04, 0.01)
    nearest = np.clip(mesh.points[:, 0], 0.0, 0.04)
    away = mesh.points - np.stack([nearest, 0 * nearest, 0 * nearest], axis=1)
    assert np.linalg.norm(away, axis=1) == pytest.approx(0.01)


def test_a_disc_lies_across_its_direction() -> None:
    along = disc(0.005, 0.002, OBLIQUE).points @ OBLIQUE
    assert (along.min(), along.max()) == pytest.approx((-0.001, 0.001))


def test_a_scene_shows_bodies_where_they_are() -> None:
    vtk_scene = pytest.importorskip("app.widgets.vtk_scene")
    try:
        scene = vtk_scene.VtkScene()
    except RuntimeError:
        pytest.skip("no OpenGL here")
    scene.set_background("#000000")
    body = scene.add(ball(0.03), "#00FF00", ambient=1.0)
    frame = scene.add(lines(np.array([[0, 0, 0], [0, 0, 0.1]]), [(0, 1)]), "#0000FF", ambient=1.0)
    orbit = Orbit()
    frame.show(False)

    def green() -> np.ndarray:
        return scene.render(orbit, 160, 120)[..., 1] > 100

    body.move(np.eye(3), orbit.target)
    rows, columns = np.nonzero(green())
    assert (rows.mean(), columns.mean()) == pytest.approx((59.5, 79.5), abs=1.0)
    body.move(2 * np.eye(3), orbit.target)
    assert green().sum() == pytest.approx(4 * len(rows), rel=0.15)
    body.move(np.eye(3), orbit.target + 0.02 * orbit.up)
    assert np.nonzero(green())[0].mean() < rows.mean() - 2  # rows count from the top
    body.show(False)
    assert not green().any()
    scene.close()


def test_nothing_is_drawn_before_there_is_a_hand() -> None:
    """A fingertip's ball has unit size until it is placed, and would fill the view."""
    vtk_scene = pytest.importorskip("app.widgets.vtk_scene")
    try:
        scene = vtk_scene.VtkScene()
    except RuntimeError:
        pytest.skip("no OpenGL here")
    scene.set_background("#102030")
    HandActors(scene, scripted_setup(ScriptedEngine()), {})
    pixels = scene.render(Orbit(), 80, 60).reshape(-1, 3)
    assert (pixels == pixels[0]).all()
    scene.close()
