"""Nearest points and distances of meshes, against trimesh and known shapes."""

from __future__ import annotations

import numpy as np
import pytest
import trimesh

from tracker.geometry.triangles import GROUP, nearest, triangles_of


@pytest.mark.parametrize("make", [trimesh.creation.box, trimesh.creation.annulus])
def test_the_nearest_point_is_that_of_trimesh(make) -> None:
    """At edges and corners, inside and outside, also of a non-convex mesh."""
    args = {} if make is trimesh.creation.box else {"r_min": 0.3, "r_max": 0.6, "height": 0.4}
    solid = make(**args)
    mesh = triangles_of(np.array(solid.vertices), np.array(solid.faces))
    points = np.random.default_rng(2).uniform(-1, 1, (200, 3))
    found = nearest(mesh, points)
    _, distance, _ = trimesh.proximity.closest_point_naive(solid, points)
    assert np.abs(found.distance) == pytest.approx(distance, abs=1e-9)
    there = np.linalg.norm(found.point - points, axis=1)
    assert there == pytest.approx(distance, abs=1e-9)
    if make is trimesh.creation.box:
        inside = (np.abs(points) < 0.5).all(axis=1)
    else:
        r = np.linalg.norm(points[:, :2], axis=1)
        inside = (r > 0.3) & (r < 0.6) & (np.abs(points[:, 2]) < 0.2)
    sure = np.abs(found.distance) > 0.02  # the annulus has flat sides
    assert ((found.distance < 0) == inside)[sure].all()


def test_each_triangle_is_in_one_group_and_its_box() -> None:
    ball = trimesh.creation.icosphere(subdivisions=2)
    mesh = triangles_of(np.array(ball.vertices), np.array(ball.faces))
    assert mesh.first[0] == 0
    assert mesh.first[-1] == len(ball.faces)
    assert np.diff(mesh.first).max() <= GROUP
    for g, (a, b) in enumerate(zip(mesh.first[:-1], mesh.first[1:], strict=True)):
        assert (mesh.corners[a:b] >= mesh.low[g]).all()
        assert (mesh.corners[a:b] <= mesh.high[g]).all()


def test_degenerate_triangles_are_omitted() -> None:
    points = np.array([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [2, 0, 0]])
    faces = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3], [0, 1, 4]])
    assert len(triangles_of(points, faces).corners) == 4


def test_distance_and_sign_for_a_sphere() -> None:
    ball = trimesh.creation.icosphere(subdivisions=3, radius=0.05)
    mesh = triangles_of(np.array(ball.vertices), np.array(ball.faces))
    points = np.random.default_rng(1).normal(0, 0.05, (300, 3))
    found = nearest(mesh, points)
    radius = np.linalg.norm(points, axis=1)
    assert np.abs(found.distance - (radius - 0.05)).max() < 5e-4  # m: maximum depth of chords
    outwards = np.einsum("nk,nk->n", found.normal, points / radius[:, None])
    assert outwards[np.abs(found.distance) > 0.005].min() > 0.9
