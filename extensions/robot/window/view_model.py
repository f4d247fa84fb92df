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
    "none": mark("its button alone"),
    "thumb_up": mark("thumb up"),
    "point": mark("pointing"),
    "fist": mark("fist"),
}
MOST_FORCE = 5.0  # N: a tip that presses so is all in the colour of touch
LATE_MS, FAR_MM = 15.0, 5.0
AMBIENT = 0.12
TABLE_HALF, TABLE_CELL, TABLE_STRENGTH = 0.4, 0.05, 0.35  # m, m, share of the ink


def model_title(name: str) -> str:
    """What a robot hand is called on screen."""
    return tr(_MODELS.get(name, name))


def clutch_title(name: str) -> str:
    """What couples and uncouples, on screen."""
    return tr(_CLUTCHES.get(name, name))


def table_lines() -> tuple[Array, Array]:
    """Lines (M, 6) m in the robot's world, on its table, and their strength (M,)."""
    at = np.arange(-TABLE_HALF, TABLE_HALF + 1e-6, TABLE_CELL)
    across, along = np.zeros((len(at), 6)), np.zeros((len(at), 6))
    across[:, 0] = across[:, 3] = at
    across[:, 1], across[:, 4] = -TABLE_HALF, TABLE_HALF
    along[:, [1, 0, 2, 4, 3, 5]] = across
    return np.concatenate([across, along]), np.full(2 * len(at), TABLE_STRENGTH)


class DrapedRobot(NamedTuple):
    """points, normals (V, 3) in the robot's world, looks (V, 7) as the 3D view has them."""

    points: Array
    normals: Array
    looks: Array


class RobotView:
    """Written by the robot's thread, read by the window's: each takes one whole tuple."""

    def __init__(self, shape: RobotShape, model: RobotModel) -> None:
        self.shape, self.model = shape, model
        self._now: tuple[RobotState, Placed, float] | None = None
        self._touch = np.array(rgb(ORANGE))

    def show(self, state: RobotState, placed: Placed, error: float) -> None:
        """From now on; ``error`` m of the farthest tip from its target."""
        self._now = (state, placed, error)

    @property
    def state(self) -> RobotState | None:
        """The latest; None before the first hand."""
        now = self._now
        return now[0] if now is not None else None

    @property
    def palm(self) -> Array | None:
        """(3,) m in the robot's world; None before the first hand."""
        state = self.state
        return state.palm[:3] if state is not None else None

    @property
    def error_mm(self) -> float:
        """Of the farthest tip; NaN where nothing is followed."""
        now = self._now
        return 1e3 * now[2] if now is not None else float("nan")

    def draped(self) -> DrapedRobot | None:
        """None before there is anything to be seen."""
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
        """Fingertips take the colour of touch the more they press."""
        shape = self.shape
        looks = np.zeros((len(shape.points), 7))
        looks[:, :3], looks[:, 3], looks[:, 4] = shape.colour, 1.0, AMBIENT
        tip = shape.finger != NO_FINGER
        share = np.clip(state.force / MOST_FORCE, 0.0, 1.0) ** 0.5
        mixed = share[shape.finger[tip]][:, None]
        looks[tip, :3] += mixed * (self._touch - looks[tip, :3])
        return looks


class RobotFigures(NamedTuple):
    """A line about the robot, how good that is, and what lies behind it."""

    look: StateLook
    text: str
    tip: str

    @staticmethod
    def of(
        on: bool, view: RobotView | None, took: list[float], missed: int, recorded: bool = False
    ) -> RobotFigures:
        """``took``: s from a packet's arrival to the robot's command, lately; ``recorded``: it is
        that of the session which is replayed."""
        if not on:
            return RobotFigures(IDLE, tr("No robot follows"), "")
        if view is None:
            return RobotFigures(IDLE, tr("The robot is being made ready"), "")
        state = view.state
        if state is None:
            return RobotFigures(IDLE, tr("The robot waits for a hand"), "")
        if recorded:
            return RobotFigures(GOOD, tr("The robot as it was recorded"), "")
        if not state.engaged:
            return RobotFigures(WARN, tr("Released: the robot holds"), "")
        if state.holding:
            return RobotFigures(BAD, tr("The hand is lost: the robot holds"), "")
        return _following(view, took, missed)


def _following(view: RobotView, took: list[float], missed: int) -> RobotFigures:
    error = view.error_mm
    late = 1e3 * float(np.percentile(took, 99)) if len(took) > 20 else float("nan")
    parts = [tr("Follows")]
    if np.isfinite(error):
        parts.append(tr("fingertips {} mm off").format(f"{local(error):.1f}"))
    if late > 0:
        parts.append(tr("{} ms behind (99 %)").format(f"{late:.0f}"))
    good = not error > FAR_MM and not late > LATE_MS
    tip = tr("Hands that were overtaken by a newer one: {}").format(missed)
    return RobotFigures(GOOD if good else WARN, " · ".join(parts), tip)
