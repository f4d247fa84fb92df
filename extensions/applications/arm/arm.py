"""A robot arm that follows the hand while the clutch is closed, and grips when the hand pinches.

A closed hand, grasping or pinching, is the clutch: while it is closed, the gripper moves like the
palm, ``scale`` times as far; while it is open, the arm does not move. A sustained pinch closes the
gripper, the next one opens it. An open palm stops the arm until a thumb up releases it; otherwise a
thumb up marks the gripper's position. An open palm of which ring and little finger are only
inferred stops the arm as well, since an unnecessary stop is harmless.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar, NamedTuple

import mujoco
import numpy as np

from extensions.applications.drawing import Drawing, Line, Mesh, Points, Primitive, Text
from extensions.applications.hand import HandSample
from extensions.applications.interface import Command, Happening, JointCommand, PoseCommand, Step
from extensions.applications.solids import Solid, box, capsule, cylinder
from resources import folder
from tracker.geometry import so3
from tracker.gestures.values import BEGINS_AT
from tracker.messages import Array

CLUTCH = ("grasp", "pinch_index")
AHEAD = np.array([0.12, 0.12, -0.10])  # m of the arm's base from the first known palm
LOW, HIGH = np.array([0.10, -0.40, 0.016]), np.array([0.50, 0.40, 0.50])  # m, workspace
PINCH_LASTS, SIGN_LASTS, STOP_LASTS = 0.2, 0.3, 0.05  # s until each gesture counts
LONGEST_STEP = 0.05  # s
TRAIL = 100  # points
TABLE = np.array(
    [[0.1, -0.3, 0.0], [0.5, -0.3, 0.0], [0.5, 0.3, 0.0], [0.1, 0.3, 0.0], [0.1, -0.3, 0.0]]
)  # m, its edge
COLOURS = {"block": "#E69F00", "left": "#56B4E9", "right": "#56B4E9"}
METAL, STOPPED = "#B8BEC6", "#D55E00"


@dataclass(frozen=True)
class ArmSettings:
    """``place``: position of the base, m in G; empty: in front of the hand when first known.
    ``commands``: joints or pose. ``robot``: host:port that receives these by UDP; empty: none."""

    scale: float = 1.5
    place: tuple[float, ...] = ()
    turning: bool = True  # whether the gripper turns with the hand
    commands: str = "joints"
    robot: str = ""


@dataclass(frozen=True, eq=False)
class _Clutched:
    """Palm and gripper when the clutch closed: R (3, 3), p (3,) of each."""

    R_palm: Array
    p_palm: Array
    tool: ToolPose


class _Lasting:
    """Detects that a gesture has lasted; true once per gesture."""

    def __init__(self, seconds: float) -> None:
        self._seconds, self._since, self._reported = seconds, np.nan, False

    def has_started(self, shown: bool, t: float) -> bool:
        if not shown:
            self._since, self._reported = np.nan, False
            return False
        if np.isnan(self._since):
            self._since = t
        if self._reported or t - self._since < self._seconds - 1e-9:
            return False
        self._reported = True
        return True


class RobotArm:
    name: ClassVar[str] = "arm"
    title: ClassVar[str] = "Robot arm"
    between: ClassVar[int] = 0

    def __init__(self, settings: ArmSettings) -> None:
        self.settings = settings
        self._arm = SixAxisArm()
        self._place: Array | None = None
        self._t = np.nan
        self._clutched: _Clutched | None = None
        self._target, self._angles = self._arm.tool, self._arm.angles
        self._closed = self._stopped = self._holding = False
        self._marks: list[Array] = []
        self._trail: list[Array] = []
        self._pinch, self._thumb = _Lasting(PINCH_LASTS), _Lasting(SIGN_LASTS)
        self._palm = _Lasting(STOP_LASTS)

    def step(self, hand: HandSample) -> Step:
        events: list[Happening] = []
        if self._place is None and not self._stand(hand, events):
            return Step()
        self._signs(hand, events)
        self._follow(hand, events)
        command = self._command()
        self._arm.take(command)
        passed = hand.t - self._t if np.isfinite(self._t) else 0.0
        self._t = hand.t
        self._arm.advance(min(max(passed, 0.0), LONGEST_STEP))
        self._report_block(events)
        commands: list[Command] = [command] if self.settings.robot else []
        return Step(self._drawing(), events, commands)

    def _stand(self, hand: HandSample, events: list[Happening]) -> bool:
        if len(self.settings.place) == 3:
            self._place = np.array(self.settings.place)
        elif hand.palm is not None:
            self._place = hand.palm[1] + AHEAD - [self._arm.tool.p[0], 0.0, 0.0]
        else:
            return False
        events.append(Happening("placed", {"at": self._place.tolist()}))
        return True

    # --- gestures

    def _signs(self, hand: HandSample, events: list[Happening]) -> None:
        palm = hand.shows("open_palm") or hand.value("open_palm") > BEGINS_AT
        if self._palm.has_started(palm, hand.t) and not self._stopped:
            self._stopped, self._clutched = True, None
            events.append(Happening("stop"))
        if self._thumb.has_started(hand.shows("thumb_up"), hand.t):
            self._confirm(events)
        if self._pinch.has_started(hand.shows("pinch_index"), hand.t) and not self._stopped:
            self._closed = not self._closed
            events.append(Happening("grab" if self._closed else "release"))

    def _confirm(self, events: list[Happening]) -> None:
        if self._stopped:
            self._stopped = False
            self._target, self._angles = self._arm.tool, self._arm.angles
            events.append(Happening("go_on"))
            return
        self._marks.append(self._arm.tool.p)
        events.append(Happening("confirm", {"at": self._arm.tool.p.tolist()}))

    def _follow(self, hand: HandSample, events: list[Happening]) -> None:
        """Compute the gripper's target."""
        closed = any(map(hand.shows, CLUTCH)) and not self._stopped
        if not closed or hand.palm is None:
            if self._clutched is not None:
                events.append(Happening("unclutch"))
            self._clutched = None
            return
        R, p = hand.palm
        if self._clutched is None:
            self._clutched = _Clutched(R, p, self._target)
            events.append(Happening("clutch"))
        start = self._clutched
        moved = start.tool.p + self.settings.scale * (p - start.p_palm)
        turn = R @ start.R_palm.T if self.settings.turning else np.eye(3)
        self._target = ToolPose(turn @ start.tool.R, np.clip(moved, LOW, HIGH))

    def _command(self) -> JointCommand | PoseCommand:
        grip, to = float(self._closed), self.settings.robot
        if self.settings.commands == "pose":
            x, y, z = self._target.p.tolist()
            a, b, c, d = so3.quat_from_matrix(self._target.R).tolist()
            return PoseCommand("six-axis", (x, y, z), (a, b, c, d), grip, self._stopped, to)
        if not self._stopped:
            self._angles = self._arm.solve(self._target, self._angles)
        angles = tuple(self._angles.tolist())
        return JointCommand("six-axis", AXES, angles, grip, self._stopped, to)

    def _report_block(self, events: list[Happening]) -> None:
        """Report whether the gripper holds the block in the air."""
        block = self._arm.block
        near = float(np.linalg.norm(block - self._arm.tool.p)) < 0.03
        holds = near and block[2] > 0.03
        if holds != self._holding:
            self._holding = holds
            events.append(Happening("lifted" if holds else "put_down", {"at": block.tolist()}))

    # --- drawing

    def _drawing(self) -> Drawing:
        assert self._place is not None
        place, tool = self._place, self._arm.tool.p
        usual = STOPPED if self._stopped else METAL
        out: list[Primitive] = [
            Mesh(
                part.name,
                part.solid.points,
                part.solid.faces,
                COLOURS.get(part.name, usual),
                part.R,
                part.p + place,
            )
            for part in self._arm.parts()
        ]
        self._trail = [*self._trail[1 - TRAIL :], tool + place]
        if len(self._trail) > 1:
            out.append(Line("trail", np.array(self._trail)))
        out.append(Line("table", TABLE + place, "#808890", 1.0))
        if self._marks:
            out.append(Points("marks", np.array(self._marks) + place, 0.006, "#009E73"))
        state = "stopped: thumb up to continue" if self._stopped else ""
        state = state or ("following" if self._clutched else "waiting: grasp to move the arm")
        out.append(Text("state", state, place + tool + [0.0, 0.0, 0.12]))
        return tuple(out)


# ---- simulated six-axis arm in MuJoCo with a gripper and a block
#
# Like a real arm, it only receives `JointCommand` and `PoseCommand`; poses are converted to
# angles by damped least squares (Buss 2004, Introduction to inverse kinematics, section 6).

AXES = ("yaw", "shoulder", "elbow", "forearm_roll", "wrist_pitch", "wrist_roll")
FINGERS = ("left", "right")
REST = np.array([0.0, 0.05, 1.75, 0.0, 1.34, 0.0])  # rad: the gripper looks down before the base
OPEN = 0.03  # m of each finger from the centre when open
DAMPING = 0.03  # of the least squares
ROUNDS = 4  # iterations of the inverse kinematics per step
FASTEST = 2.5  # rad/s of any joint
RAD_PER_M = 4.0  # weight of rotation relative to translation


class ToolPose(NamedTuple):
    """Pose of the gripper: R (3, 3), p (3,) m, in the base's frame."""

    R: Array
    p: Array


class Part(NamedTuple):
    """One solid of the arm or the scene, and its pose in the base's frame."""

    name: str
    solid: Solid
    R: Array
    p: Array


class SixAxisArm:
    """The arm at the origin of its frame, x away from the wearer, z up."""

    def __init__(self) -> None:
        text = (folder("arms") / "six-axis.xml").read_text("utf-8")
        self._model = mujoco.MjModel.from_xml_string(text)
        self._data = mujoco.MjData(self._model)
        self._ik_data = mujoco.MjData(self._model)  # for the inverse kinematics
        self._columns = [int(self._model.joint(name).dofadr[0]) for name in AXES]
        self._rows = [int(self._model.joint(name).qposadr[0]) for name in AXES]
        self._limits = np.array([self._model.joint(name).range for name in AXES])
        self._motors = [self._model.actuator(name).id for name in (*AXES, *FINGERS)]
        self._tool = self._model.site("tool").id
        self._wanted, self._goal, self._grip = REST.copy(), REST.copy(), 0.0
        self._data.qpos[self._rows] = REST
        for finger in FINGERS:
            self._data.qpos[self._model.joint(finger).qposadr[0]] = OPEN
        self._left = 0.0
        self._solids = self._make_solids()
        self._drive()
        mujoco.mj_forward(self._model, self._data)

    # --- commands

    def take(self, command: JointCommand | PoseCommand) -> None:
        """Set the target; ``stop``: hold the current pose."""
        if command.stop:
            self._goal = self.angles
            self._wanted = self.angles
            return
        self._grip = float(np.clip(command.grip, 0.0, 1.0))
        if isinstance(command, PoseCommand):
            R = so3.matrix_from_quat(np.array(command.q))
            self._goal = self.solve(ToolPose(R, np.array(command.p)), self._goal)
        else:
            angles = dict(zip(command.names, command.angles, strict=True))
            wanted = [angles.get(n, a) for n, a in zip(AXES, self._goal.tolist(), strict=True)]
            self._goal = np.clip(wanted, *self._limits.T)

    def advance(self, dt: float) -> None:
        """Simulate ``dt`` s in whole steps; the remainder is added to the next call."""
        self._left += dt
        step = self._model.opt.timestep
        most = FASTEST * step
        while self._left >= step - 1e-9:
            self._left -= step
            self._wanted = self._wanted + np.clip(self._goal - self._wanted, -most, most)
            self._drive()
            mujoco.mj_step(self._model, self._data)

    def _drive(self) -> None:
        finger = OPEN * (1.0 - self._grip)
        self._data.ctrl[self._motors] = [*self._wanted, finger, finger]

    def solve(self, pose: ToolPose, start: Array) -> Array:
        """Angles (6,) rad that bring the tool to a pose, or as near as possible from ``start``."""
        q = np.array(start)
        J_p, J_r = np.empty((3, self._model.nv)), np.empty((3, self._model.nv))
        for _ in range(ROUNDS):
            here = self.pose_of(q)
            turn = so3.log(pose.R @ here.R.T) / RAD_PER_M
            error = np.concatenate([pose.p - here.p, turn])
            mujoco.mj_jacSite(self._model, self._ik_data, J_p, J_r, self._tool)
            J = np.concatenate([J_p, J_r / RAD_PER_M])[:, self._columns]
            damped = J @ J.T + DAMPING**2 * np.eye(6)
            q = np.clip(q + J.T @ np.linalg.solve(damped, error), *self._limits.T)
        return q

    # --- state

    @property
    def angles(self) -> Array:
        """Current angles (6,) rad."""
        return np.array(self._data.qpos[self._rows])

    @property
    def tool(self) -> ToolPose:
        """Current pose of the gripper."""
        R = np.array(self._data.site_xmat[self._tool]).reshape(3, 3)
        return ToolPose(R, np.array(self._data.site_xpos[self._tool]))

    @property
    def block(self) -> Array:
        """Centre of the block (3,) m."""
        return np.array(self._data.body("block").xpos)

    def pose_of(self, angles: Array) -> ToolPose:
        """Pose of the gripper for other angles (6,) rad."""
        self._ik_data.qpos[:] = self._data.qpos
        self._ik_data.qpos[self._rows] = angles
        mujoco.mj_kinematics(self._model, self._ik_data)
        mujoco.mj_comPos(self._model, self._ik_data)
        R = np.array(self._ik_data.site_xmat[self._tool]).reshape(3, 3)
        return ToolPose(R, np.array(self._ik_data.site_xpos[self._tool]))

    def parts(self) -> list[Part]:
        """All solids except the floor."""
        out = []
        for i, solid in self._solids.items():
            R = np.array(self._data.geom_xmat[i]).reshape(3, 3)
            out.append(Part(self._model.geom(i).name, solid, R, np.array(self._data.geom_xpos[i])))
        return out

    def _make_solids(self) -> dict[int, Solid]:
        kinds = mujoco.mjtGeom
        out: dict[int, Solid] = {}
        for i in range(self._model.ngeom):
            kind, size = self._model.geom_type[i], np.array(self._model.geom_size[i])
            if kind == kinds.mjGEOM_BOX:
                out[i] = box(size)
            elif kind == kinds.mjGEOM_CAPSULE:
                out[i] = capsule(float(size[0]), float(size[1]))
            elif kind == kinds.mjGEOM_CYLINDER:
                out[i] = cylinder(float(size[0]), float(size[1]))
        return out
