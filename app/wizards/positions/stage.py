"""Draws a hand that moves from one rest position to the next."""

from __future__ import annotations

import numpy as np
from PySide6.QtWidgets import QWidget

from app.engines.engine import EngineSetup
from app.viewmodels.guided_hand import DRAWN, MOVE, Shown
from app.wizards.leading.page import PoseStage
from tracker.base.clock import monotonic
from tracker.calibration.imu_positions import orientation
from tracker.geometry import so3
from tracker.messages import Array
from tracker.simulation.postures import posture
from tracker.simulation.smooth import minimum_jerk

EYE = (-0.75, -0.55, 0.45)
"""Direction to the viewer of a right hand, in G: behind the wearer and to the right."""
FLAT = "flat"
FARTHER = 1.5
"""Than for guided poses: the hand is seen from its side, too."""


class PositionStage(PoseStage):
    """``pose`` is a name of `tracker.calibration.imu_positions`; up is up in the view.

    The wearer's hand is drawn as an outline with its own inclination.
    """

    def __init__(self, setup: EngineSetup, background: str, parent: QWidget | None = None) -> None:
        super().__init__(setup, background, parent)
        self._side = setup.side
        self._angles = posture(setup.hand, DRAWN[FLAT])
        self.pose = "palm_down"
        self.distance *= FARTHER
        self.view.setAccessibleName(self.tr("The position of the hand"))

    def shown(self, again: bool) -> Shown:
        there = orientation(self.pose, self._side)
        start = orientation(self.before or self.pose, self._side)
        share = float(minimum_jerk(np.array([(monotonic() - self._since) / MOVE]))[0])
        R_GB = start @ so3.exp(so3.log(start.T @ there) * share)
        middle = np.array([0.48 * self._hand.length, 0.0, -0.01])
        R, p = self._hand.forward(self._angles, R_GB, -R_GB @ middle)
        mirror = [1.0, -1.0 if self._side == "left" else 1.0, 1.0]
        return Shown(R, p, np.zeros(3), np.array(EYE) * mirror)

    def alignment(self, R_shown: Array, R_own: Array) -> Array:
        """(3, 3) the rotation about the vertical that turns ``R_own`` closest to ``R_shown``."""
        M = R_own @ R_shown.T
        return so3.rz(float(np.arctan2(M[0, 1] - M[1, 0], M[0, 0] + M[1, 1])))
