"""What is shown of a robot hand: its triangles where they are now, and how well it follows."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from app.viewmodels.states import BAD, GOOD, IDLE, ORANGE, WARN, StateLook
from app.widgets.view3d.scene import rgb
from app.words import local, mark, tr
from extensions.robot.library import MODELS as MODELS
from extensions.robot.look import NO_FINGER, Placed, RobotShape
from extensions.robot.settings import CLUTCHES as CLUTCHES
from tracker.messages import Array, RobotModel, RobotState

_MODELS = {"shadow": mark("Shadow hand")}
_CLUTCHES = {
    "none": mark("none (button only)"),
    "thumb_up": mark("thumb up"),
    "point": mark("pointing"),
    "fist": mark("fist"),
}
_FINGERS = {
    "thumb": mark("Thumb"),
    "index": mark("Index finger"),
    "middle": mark("Middle finger"),
    "ring": mark("Ring finger"),
    "little": mark("Little finger"),
    "palm": mark("Palm"),
}
_FOUND_BY = {"user": mark("your choice"), "name": mark("name"), "position": mark("position")}
MOST_FORCE = 5.0  # N at which a fingertip has the full contact colour
LATE_MS, FAR_MM = 15.0, 5.0
AMBIENT = 0.12
TABLE_HALF, TABLE_CELL, TABLE_STRENGTH = 0.4, 0.05, 0.35  # m, m, opacity


def model_title(name: str) -> str:
    """Displayed name of a robot hand."""
    return tr(_MODELS.get(name, name))


def clutch_title(name: str) -> str:
    """Displayed name of a clutch gesture."""
    return tr(_CLUTCHES.get(name, name))


def finger_title(name: str) -> str:
    """Displayed name of a finger, or of the palm."""
    return tr(_FINGERS[name])


def found_by(how: str) -> str:
    """How a fingertip's link was found."""
    return tr(_FOUND_BY[how]) if how in _FOUND_BY else ""


def table_lines() -> tuple[Array, Array]:
    """Grid lines (M, 6) m on the table in the robot's world, and their opacity (M,)."""
    at = np.arange(-TABLE_HALF, TABLE_HALF + 1e-6, TABLE_CELL)
    across, along = np.zeros((len(at), 6)), np.zeros((len(at), 6))
    across[:, 0] = across[:, 3] = at
    across[:, 1], across[:, 4] = -TABLE_HALF, TABLE_HALF
    along[:, [1, 0, 2, 4, 3, 5]] = across
    return np.concatenate([across, along]), np.full(2 * len(at), TABLE_STRENGTH)


class DrapedRobot(NamedTuple):
    """points, normals (V, 3) in the robot's world; looks (V, 7) as defined by the 3D view."""

    points: Array
    normals: Array
    looks: Array


class RobotView:
    """Written by the robot's thread and read by the window's, one immutable tuple at a time."""

    def __init__(self, shape: RobotShape, model: RobotModel) -> None:
        self.shape, self.model = shape, model
        self._now: tuple[RobotState, Placed, float] | None = None
        self._touch = np.array(rgb(ORANGE))

    def show(self, state: RobotState, placed: Placed, error: float) -> None:
        """Set what to show; ``error`` is the largest distance of a tip from its target in m."""
        self._now = (state, placed, error)

    @property
    def state(self) -> RobotState | None:
        """The latest state; None before the first hand."""
        now = self._now
        return now[0] if now is not None else None

    @property
    def palm(self) -> Array | None:
        """(3,) m in the robot's world; None before the first hand."""
        state = self.state
        return state.palm[:3] if state is not None else None

    @property
    def error_mm(self) -> float:
        """Largest tip error in mm; NaN while the robot does not follow."""
        now = self._now
        return 1e3 * now[2] if now is not None else float("nan")

    def draped(self) -> DrapedRobot | None:
        """The mesh in its current pose; None before the first hand."""
        now = self._now
        if now is None:
            return None
        state, placed, _ = now
        shape = self.shape
        R = placed.R[shape.body]
        points = np.einsum("vij,vj->vi", R, shape.points) + placed.p[shape.body]
        normals = np.einsum("vij,vj->vi", R, shape.normals)
        return DrapedRobot(points, normals, self._looks(state))

    def _looks(self, state: RobotState) -> Array:
        """Colours; fingertips fade to the contact colour with increasing force."""
        shape = self.shape
        looks = np.zeros((len(shape.points), 7))
        looks[:, :3], looks[:, 3], looks[:, 4] = shape.colour, 1.0, AMBIENT
        tip = shape.finger != NO_FINGER
        share = np.clip(state.force / MOST_FORCE, 0.0, 1.0) ** 0.5
        mixed = share[shape.finger[tip]][:, None]
        looks[tip, :3] += mixed * (self._touch - looks[tip, :3])
        return looks


class RobotFigures(NamedTuple):
    """The robot's status: a line of text, its rating, and a tool tip with details."""

    look: StateLook
    text: str
    tip: str

    @staticmethod
    def of(
        on: bool, view: RobotView | None, took: list[float], missed: int, recorded: bool = False
    ) -> RobotFigures:
        """``took``: recent times in s from a packet's arrival to the robot's command;
        ``recorded``: the robot of a replayed session is shown."""
        if not on:
            return RobotFigures(IDLE, tr("Not connected"), "")
        if view is None:
            return RobotFigures(IDLE, tr("Starting the robot…"), "")
        state = view.state
        if state is None:
            return RobotFigures(IDLE, tr("Waiting for the tracked hand"), "")
        if recorded:
            return RobotFigures(GOOD, tr("Recorded robot"), "")
        if not state.engaged:
            return RobotFigures(WARN, tr("Clutch released: the robot holds its pose"), "")
        if state.holding:
            return RobotFigures(BAD, tr("Hand lost: the robot holds its pose"), "")
        return _following(view, took, missed)


def _following(view: RobotView, took: list[float], missed: int) -> RobotFigures:
    error = view.error_mm
    late = 1e3 * float(np.percentile(took, 99)) if len(took) > 20 else float("nan")
    parts = [tr("Following")]
    if np.isfinite(error):
        parts.append(tr("fingertip error {} mm").format(f"{local(error):.1f}"))
    if late > 0:
        parts.append(tr("latency {} ms (99 %)").format(f"{late:.0f}"))
    good = not error > FAR_MM and not late > LATE_MS
    tip = tr("Estimates skipped in favour of newer ones: {}").format(missed)
    return RobotFigures(GOOD if good else WARN, " · ".join(parts), tip)
