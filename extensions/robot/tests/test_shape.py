"""A robot is drawn as in MuJoCo: closed shapes, with outward normals, at its bodies' poses."""

from __future__ import annotations

import numpy as np
import pytest

from extensions.robot.scene import BALL, CUBE, CYLINDER
from extensions.robot.server import NO_FINGER, RobotShape, poses, shape_of
from extensions.robot.settings import RobotSettings
from extensions.robot.tests.hands import shadow
from extensions.robot.world import RobotWorld


@pytest.fixture(scope="module")
def world() -> RobotWorld:
    world = RobotWorld(shadow(), RobotSettings())
    world.reset(np.eye(3), np.array([0.0, 0.0, 0.2]))
    return world


@pytest.fixture(scope="module")
def shape(world: RobotWorld) -> RobotShape:
    return shape_of(world)


def volume(shape: RobotShape, geom: int) -> float:
    """m³ that its triangles enclose, negative where they are turned inwards."""
    a, b, c = (shape.points[shape.faces[shape.part == geom][:, k]] for k in range(3))
    return float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)


def test_objects_have_the_volume_of_their_shapes(world: RobotWorld, shape: RobotShape) -> None:
    expected = {
        "cube": (2 * CUBE) ** 3,
        "ball": 4 / 3 * np.pi * BALL**3,
        "cylinder": np.pi * CYLINDER[0] ** 2 * 2 * CYLINDER[1],
    }
    for name, true in expected.items():
        # a form of 16 sides lies inside the round one
        assert 0.9 * true < volume(shape, world.model.geom(name).id) < 1.001 * true


def test_simplified_meshes_keep_their_size_and_orientation(
    world: RobotWorld, shape: RobotShape
) -> None:
    assert len(shape.faces) < 20_000  # of 38 000
    for geom in np.unique(shape.part):
        if world.model.geom_type[geom] == 7:  # a mesh
            mesh = int(world.model.geom_dataid[geom])
            start, count = world.model.mesh_vertadr[mesh], world.model.mesh_vertnum[mesh]
            whole = world.model.mesh_vert[start : start + count]
            mine = shape.points[shape.body == geom]
            assert np.ptp(mine, axis=0) == pytest.approx(np.ptp(whole, axis=0), rel=0.2, abs=4e-3)
            assert volume(shape, int(geom)) > 0


def test_normals_have_length_one_and_fingertips_are_marked(shape: RobotShape) -> None:
    assert np.abs(np.linalg.norm(shape.normals, axis=1) - 1.0).max() < 1e-9
    assert set(np.unique(shape.finger)) == {NO_FINGER, 0, 1, 2, 3, 4}


def test_objects_are_on_the_table_at_z_zero(world: RobotWorld, shape: RobotShape) -> None:
    placed = poses(world)
    for name in ("cube", "cylinder", "ball"):
        geom = world.model.geom(name).id
        points = shape.points[shape.body == geom] @ placed.R[geom].T + placed.p[geom]
        assert points[:, 2].min() == pytest.approx(0.0, abs=1e-3)
    assert world.model.geom("table").id not in shape.part
