"""A robot arm that follows the hand while the clutch is closed, and grips when the hand pinches.

A closed hand, grasping or pinching, is the clutch: while it is closed, the gripper moves like the
palm, ``scale`` times as far; while it is open, the arm does not move. A sustained pinch closes the
gripper, the next one opens it. An open palm stops the arm until a thumb up releases it; otherwise a
thumb up marks the gripper's position. An open palm of which ring and little finger are only
inferred stops the arm as well, since an unnecessary stop is harmless.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from extensions.applications.arm.robot import AXES, SixAxisArm, ToolPose
from extensions.applications.drawing import Drawing, Line, Mesh, Points, Primitive, Text
from extensions.applications.hand import HandSample
from extensions.applications.interface import Command, Happening, JointCommand, PoseCommand, Step
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

    def tells(self, shown: bool, t: float) -> bool:
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
        if self._palm.tells(palm, hand.t) and not self._stopped:
            self._stopped, self._clutched = True, None
            events.append(Happening("stop"))
        if self._thumb.tells(hand.shows("thumb_up"), hand.t):
            self._confirm(events)
        if self._pinch.tells(hand.shows("pinch_index"), hand.t) and not self._stopped:
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
