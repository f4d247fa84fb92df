"""The process of the robot; loads MuJoCo."""

from __future__ import annotations

from contextlib import suppress
from multiprocessing.connection import Connection

import mujoco
import numpy as np

from extensions.robot.command import RobotCommand
from extensions.robot.driver import RobotDriver
from extensions.robot.look import NO_FINGER, Placed, RobotShape
from extensions.robot.process import Answer, Item, RobotFailed, RobotMoved, RobotReady, RobotShown
from extensions.robot.scene import COLOURS
from extensions.robot.settings import RobotSettings
from extensions.robot.teleop import Teleop
from extensions.robot.wearer_hand import FINGERS
from extensions.robot.world import RobotWorld
from tracker.base.errors import GlovetrackError
from tracker.base.notices import failure
from tracker.base.urgency import run_soon
from tracker.hand.model import HandModel
from tracker.messages import Array, Estimate, IntArray, RobotState


def serve(
    pipe: Connection, settings: RobotSettings, hand: HandModel, keypoint_names: tuple[str, ...]
) -> None:
    """Main function of the process: runs until it is asked to end or the pipe is closed."""
    run_soon()
    try:
        server = _Server(settings, hand, keypoint_names)
    except GlovetrackError as error:
        pipe.send(RobotFailed(error.notice))
        return
    with suppress(EOFError, OSError, KeyboardInterrupt):
        pipe.send(server.ready)
        while True:
            item: Item = pipe.recv()
            if item is None:
                return
            answer = server.do(item)
            if answer is not None:
                pipe.send(answer)


class _Server:
    """The robot itself."""

    def __init__(
        self, settings: RobotSettings, hand: HandModel, keypoint_names: tuple[str, ...]
    ) -> None:
        self._driver = RobotDriver(Teleop(settings), hand, keypoint_names)
        self._world = self._driver.teleop.world
        self.ready = RobotReady(self._driver.model, shape_of(self._world))

    def do(self, item: Estimate | RobotCommand | RobotState) -> Answer | None:
        if isinstance(item, RobotCommand):
            try:
                self._driver.ask(item)
            except GlovetrackError as error:
                return RobotFailed(error.notice)
            return None
        if isinstance(item, RobotState):
            try:
                self._world.show(item.joints, item.palm, item.objects)
            except ValueError:
                return RobotFailed(failure("robot.recorded_model"))
            return RobotShown(item, poses(self._world))
        outputs = self._driver.feed(item)
        errors = self._driver.teleop.fingers.error
        farthest = float(np.nanmax(errors)) if np.isfinite(errors).any() else float("nan")
        return RobotMoved(outputs, poses(self._world), farthest)


# ---- triangle meshes of a robot and its scene, for views without MuJoCo

SHOWN_GROUPS = 3  # MuJoCo's viewer shows the groups below
FINE, CELLS = 0.0025, 24  # m, and fractions of a mesh's size: smaller details are merged
ROUND = 16  # sides of round shapes
NO_AREA = 1e-14  # m²: the normals of opposite triangles cancel
HAND = "#AEB6C2"
Mesh = tuple[Array, IntArray]
"""Points (V, 3) m and triangles (F, 3), counter-clockwise from outside."""


def poses(world: RobotWorld) -> Placed:
    """Current poses of all geoms."""
    n = world.model.ngeom
    data = world.data
    return Placed(data.geom_xmat.reshape(n, 3, 3).copy(), data.geom_xpos.copy())


def shape_of(world: RobotWorld) -> RobotShape:
    """Mesh of the hand and the objects of a scene."""
    model = world.model
    shown = [g for g in range(model.ngeom) if _shown(model, g)]
    parts = [(g, _mesh(model, g)) for g in shown]
    points, normals, body, faces, part, colour, finger = [], [], [], [], [], [], []
    start = 0
    for g, (vertices, triangles) in parts:
        points.append(vertices)
        normals.append(_normals(vertices, triangles))
        body.append(np.full(len(vertices), g))
        faces.append(triangles + start)
        part.append(np.full(len(triangles), g))
        colour.append(np.tile(_colour(model, g), (len(vertices), 1)))
        finger.append(np.full(len(vertices), _finger(world, g)))
        start += len(vertices)
    return RobotShape(
        np.concatenate(points), np.concatenate(normals), np.concatenate(body).astype(np.int64),
        np.concatenate(faces).astype(np.int64), np.concatenate(part).astype(np.int64),
        np.concatenate(colour), np.concatenate(finger).astype(np.int64),
    )  # fmt: skip


def _shown(model: mujoco.MjModel, geom: int) -> bool:
    """Whether a geom is drawn. The table is not: views draw lines for it."""
    return model.geom_group[geom] < SHOWN_GROUPS and model.geom_bodyid[geom] != 0


def _finger(world: RobotWorld, geom: int) -> int:
    body = int(world.model.body_weldid[world.model.geom_bodyid[geom]])
    for row in range(len(FINGERS)):
        if world.scene.tip_bodies[row] == body:
            return row
    return NO_FINGER


def _colour(model: mujoco.MjModel, geom: int) -> Array:
    name = model.body(int(model.geom_bodyid[geom])).name
    text = COLOURS.get(name, HAND)
    return np.array([int(text[i : i + 2], 16) / 255 for i in (1, 3, 5)])


def _mesh(model: mujoco.MjModel, geom: int) -> Mesh:
    """Mesh of a geom in its own frame."""
    kind, size = model.geom_type[geom], model.geom_size[geom]
    if kind == mujoco.mjtGeom.mjGEOM_MESH:
        return _clustered(*_stored(model, int(model.geom_dataid[geom])))
    if kind == mujoco.mjtGeom.mjGEOM_BOX:
        return _box(size)
    if kind == mujoco.mjtGeom.mjGEOM_SPHERE:
        return _turned(*_arc(float(size[0]), 0.0))
    if kind == mujoco.mjtGeom.mjGEOM_CAPSULE:
        return _turned(*_arc(float(size[0]), float(size[1])))
    if kind == mujoco.mjtGeom.mjGEOM_CYLINDER:
        r, h = float(size[0]), float(size[1])
        return _turned(np.array([0, r, r, r, r, 0]), np.array([-h, -h, -h, h, h, h]))
    return np.zeros((0, 3)), np.zeros((0, 3), np.int64)


def _stored(model: mujoco.MjModel, mesh: int) -> Mesh:
    v, f = int(model.mesh_vertadr[mesh]), int(model.mesh_faceadr[mesh])
    points = model.mesh_vert[v : v + int(model.mesh_vertnum[mesh])]
    faces = model.mesh_face[f : f + int(model.mesh_facenum[mesh])]
    return np.array(points, float), np.array(faces, np.int64)


def _clustered(points: Array, faces: IntArray) -> Mesh:
    """Merge the points in each cell of a grid into their mean; drop degenerate triangles."""
    cell = max(FINE, float(np.ptp(points, axis=0).max()) / CELLS)
    keys = np.floor(points / cell).astype(np.int64)
    _, row, count = np.unique(keys, axis=0, return_inverse=True, return_counts=True)
    row = row.ravel()
    means = np.zeros((len(count), 3))
    np.add.at(means, row, points)
    out = row[faces]
    whole = (out[:, 0] != out[:, 1]) & (out[:, 1] != out[:, 2]) & (out[:, 2] != out[:, 0])
    return means / count[:, None], out[whole]


def _normals(points: Array, faces: IntArray) -> Array:
    """(V, 3) unit normals: the area-weighted mean over each point's triangles."""
    a, b, c = points[faces[:, 0]], points[faces[:, 1]], points[faces[:, 2]]
    across = np.cross(b - a, c - a)
    out = np.zeros_like(points)
    for k in range(3):
        np.add.at(out, faces[:, k], across)
    length = np.linalg.norm(out, axis=1, keepdims=True)
    known = length > NO_AREA
    return np.where(known, out / np.where(known, length, 1.0), [0.0, 0.0, 1.0])


def _box(half: Array) -> Mesh:
    """A box. Sides do not share corners, so that edges are sharp."""
    points: list[Array] = []
    faces: list[list[int]] = []
    for axis in range(3):
        for sign in (-1.0, 1.0):
            u, v = np.eye(3)[(axis + 1) % 3], np.eye(3)[(axis + 2) % 3]
            middle = sign * np.eye(3)[axis]
            start = 4 * len(faces)
            points += [middle - u - v, middle + u - v, middle + u + v, middle - u + v]
            order = [0, 1, 2, 3] if sign > 0 else [0, 3, 2, 1]
            faces.append([start + k for k in order])
    quads = np.array(faces)
    triangles = np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]])
    return np.array(points) * half, triangles.astype(np.int64)


def _arc(radius: float, half: float) -> tuple[Array, Array]:
    """Distances from the axis and heights of a capsule's outline; ``half`` of its cylinder's."""
    angle = np.linspace(-np.pi / 2, np.pi / 2, ROUND // 2 + 2)
    return radius * np.cos(angle), radius * np.sin(angle) + np.where(angle < 0, -half, half)


def _turned(distance: Array, height: Array) -> Mesh:
    """Surface of revolution of an outline about z, from bottom to top."""
    angle = 2 * np.pi * np.arange(ROUND) / ROUND
    ring = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    points = np.concatenate(
        [
            np.column_stack([d * ring, np.full(ROUND, h)])
            for d, h in zip(distance, height, strict=True)
        ]
    )
    here = np.arange(ROUND)
    after = (here + 1) % ROUND
    faces = []
    for k in range(len(distance) - 1):
        low, high = k * ROUND, (k + 1) * ROUND
        faces.append(np.stack([low + here, low + after, high + after], axis=1))
        faces.append(np.stack([low + here, high + after, high + here], axis=1))
    return points, np.concatenate(faces).astype(np.int64)
