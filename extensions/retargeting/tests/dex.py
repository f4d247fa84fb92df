"""dex-retargeting's three objectives, implemented with NumPy and SciPy from their publication
(github.com/dexsuite/dex-retargeting, optimizer.py): Huber losses of positions or of the lengths of
vector differences, and a cost for leaving the last joint angles. Links are those that yourdfpy
finds in the URDF."""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

import numpy as np
import yaml
import yourdfpy
from scipy.optimize import minimize

NORM_DELTA = 4e-3
HUBER = {"vector": 0.02, "position": 0.02, "dexpilot": 0.03}
PROJECT, ESCAPE, ETA1, ETA2 = 0.03, 0.05, 1e-4, 3e-2  # m


class Loss(NamedTuple):
    """For errors (n,) with a gradient (n,)."""

    value: np.ndarray
    slope: np.ndarray


def smooth_l1(x: np.ndarray, beta: float) -> Loss:
    size = np.abs(x)
    value = np.where(size < beta, 0.5 * x**2 / beta, size - 0.5 * beta)
    return Loss(value, np.where(size < beta, x / beta, np.sign(x)))


class Kinematics:
    """Link positions of a URDF and their derivatives; joints that mimic others follow them.

    With ``free``, three translations and three small rotations of the base come first.
    """

    def __init__(self, path: Path, free: bool) -> None:
        robot = yourdfpy.URDF.load(
            str(path), load_meshes=False, load_collision_meshes=False, build_scene_graph=False
        )
        self.joint_to = {j.child: j for j in robot.joint_map.values()}
        driven = [j for j in robot.joint_map.values() if j.type == "revolute" and j.mimic is None]
        self.row = {j.name: i for i, j in enumerate(driven)}
        self.limits = np.array([[j.limit.lower, j.limit.upper] for j in driven])
        self.free = 6 if free else 0
        self._place = {
            name: np.eye(4) if j.origin is None else np.array(j.origin)
            for name, j in self.joint_to.items()
        }

    def links(self, q: np.ndarray, names: list[str]) -> tuple[np.ndarray, np.ndarray]:
        """(n, 3) m and (n, 3, len(q)) m/rad."""
        made: dict[str, tuple[np.ndarray, list[tuple[int, float, np.ndarray, np.ndarray]]]] = {}
        p, J = np.zeros((len(names), 3)), np.zeros((len(names), 3, len(q)))
        for i, name in enumerate(names):
            T, turns = self._pose(name, q[self.free :], made)
            p[i] = T[:3, 3]
            for column, ratio, axis, at in turns:
                J[i, :, self.free + column] += ratio * np.cross(axis, p[i] - at)
        if self.free:
            R, dR = turned(q[3:6])
            J[:, :, 6:] = np.einsum("ab,ibq->iaq", R, J[:, :, 6:])
            J[:, :, 3:6] = np.einsum("kab,ib->iak", dR, p)
            J[:, :, :3] = np.eye(3)
            p = p @ R.T + q[:3]
        return p, J

    def _pose(self, link: str, q: np.ndarray, made: dict) -> tuple[np.ndarray, list]:
        joint = self.joint_to.get(link)
        if joint is None:
            return np.eye(4), []
        if link not in made:
            T, turns = self._pose(joint.parent, q, made)
            T = T @ self._place[link]
            if joint.type == "revolute":
                source, ratio, offset = joint.name, 1.0, 0.0
                if joint.mimic is not None:
                    source = joint.mimic.joint
                    ratio, offset = joint.mimic.multiplier, joint.mimic.offset
                axis = np.array(joint.axis, float)
                column = self.row[source]
                turns = [*turns, (column, ratio, T[:3, :3] @ axis, T[:3, 3])]
                T = T @ rotated(axis, ratio * q[column] + offset)
            made[link] = T, turns
        return made[link]


def rotated(axis: np.ndarray, angle: float) -> np.ndarray:
    """(4, 4) by Rodrigues' formula."""
    x, y, z = axis
    K = np.array([[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]])
    T = np.eye(4)
    T[:3, :3] += np.sin(angle) * K + (1.0 - np.cos(angle)) * (K @ K)
    return T


def turned(angles: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """R (3, 3) = X Y Z of the base, and its derivatives (3, 3, 3)."""
    axes = np.eye(3)
    parts = [rotated(a, q)[:3, :3] for a, q in zip(axes, angles, strict=True)]
    quarter = np.pi / 2
    slopes = [
        rotated(a, q + quarter)[:3, :3] - np.outer(a, a) for a, q in zip(axes, angles, strict=True)
    ]
    made = []
    for k in range(3):
        x, y, z = (slopes[i] if i == k else parts[i] for i in range(3))
        made.append(x @ y @ z)
    return parts[0] @ parts[1] @ parts[2], np.array(made)


class Dex:
    """Follows landmarks (21, 3) m from the wrist, in the operator frame, with a configuration."""

    def __init__(self, path: Path) -> None:
        data = yaml.safe_load(path.read_text())
        self.config, extra = data["retargeting"], data["glovetrack"]
        self.kind: str = self.config["type"]
        free = bool(self.config.get("add_dummy_free_joint"))
        self.robot = Kinematics(path.parent / self.config["urdf_path"], free)
        self.R = np.array(extra["R_base_operator"])
        self.last = np.concatenate([np.zeros(self.robot.free), self.robot.limits.mean(axis=1)])
        self.projected = np.zeros(0, bool)
        self._make_pairs()

    def _make_pairs(self) -> None:
        """Links and landmarks as origins and tasks; positions have no origins."""
        c = self.config
        if self.kind == "dexpilot":
            names = [c["wrist_link_name"], *c["finger_tip_link_names"]]
            n = len(names) - 1
            pairs = [(j, i) for i in range(1, n) for j in range(i + 1, n + 1)]
            self.projected = np.zeros(len(pairs), bool)
            ends = np.array([*pairs, *((0, i) for i in range(1, n + 1))]).T
            self.human = 4 * ends
            self.links = [names[k] for k in ends.ravel()]
        elif self.kind == "vector":
            self.human = np.array(c["target_link_human_indices"])
            self.links = [*c["target_origin_link_names"], *c["target_task_link_names"]]
        else:
            self.human = np.array(c["target_link_human_indices"])
            self.links = c["target_link_names"]

    def retarget(self, landmarks: np.ndarray) -> np.ndarray:
        """Joint angles, those of the free base first."""
        wanted, weight = self._reference(landmarks)
        last = self.last

        def objective(q: np.ndarray) -> tuple[float, np.ndarray]:
            now, J = self.vectors(q)
            off = now - wanted
            if self.kind == "position":
                loss = smooth_l1(off, HUBER[self.kind])
                value, slope = loss.value.mean(), loss.slope / off.size
            else:
                length = np.linalg.norm(off, axis=1)
                loss = smooth_l1(length, HUBER[self.kind])
                value = (weight * loss.value).mean()
                along = off / np.maximum(length, 1e-9)[:, None]
                slope = (weight * loss.slope / len(off))[:, None] * along
            left = q - last
            gradient = np.einsum("ia,iaq->q", slope, J) + 2 * NORM_DELTA * left
            return float(value + NORM_DELTA * left @ left), gradient

        wide = np.tile([-10.0, 10.0], (self.robot.free, 1))
        bounds = np.concatenate([wide, self.robot.limits])
        found = minimize(
            objective, last, jac=True, method="SLSQP", bounds=bounds, options={"ftol": 1e-8}
        )
        self.last = np.asarray(found.x)
        return self.last

    def vectors(self, q: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """(n, 3) m of what is compared, and derivatives (n, 3, len(q))."""
        p, J = self.robot.links(q, self.links)
        if self.kind == "position":
            return p, J
        n = len(p) // 2
        return p[n:] - p[:n], J[n:] - J[:n]

    def wanted(self, landmarks: np.ndarray) -> np.ndarray:
        """(n, 3) m: scaled vectors, or positions, of the wearer in the base's axes."""
        points = landmarks @ self.R.T
        if self.kind == "position":
            return points[self.human]
        return self.config["scaling_factor"] * (points[self.human[1]] - points[self.human[0]])

    def _reference(self, landmarks: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """What the algorithm aims at, and weights; DexPilot projects near fingertips together."""
        wanted, n = self.wanted(landmarks), len(self.projected)
        if self.kind != "dexpilot":
            return wanted, np.ones(len(wanted))
        fingers = len(wanted) - n
        gap = np.linalg.norm(wanted[:n], axis=1) / self.config["scaling_factor"]
        first = np.arange(n) < fingers - 1
        self.projected[first & (gap < PROJECT)] = True
        self.projected[first & (gap > ESCAPE)] = False
        pairs = [(j, i) for i in range(fingers - 2) for j in range(i + 1, fingers - 1)]
        for row, (j, i) in zip(np.flatnonzero(~first), pairs, strict=True):
            self.projected[row] = self.projected[j] and self.projected[i] and gap[row] <= 0.03
        near = np.where(self.projected, np.where(first, 200.0, 400.0), 1.0)
        unit = wanted[:n] / (np.linalg.norm(wanted[:n], axis=1, keepdims=True) + 1e-6)
        close = unit * np.where(first, ETA1, ETA2)[:, None]
        wanted[:n] = np.where(self.projected[:, None], close, wanted[:n])
        return wanted, np.concatenate([near, np.full(fingers, n + fingers)])
