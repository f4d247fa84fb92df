"""Robot hands for tests, made once; without their packages the tests are skipped."""

from __future__ import annotations

from functools import cache
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
import pytest

from extensions.robot.library import SHADOW, model_path
from extensions.robot.settings import RobotSettings
from extensions.robot.wearer_hand import WearerHand, hand_from_keypoints
from tracker.geometry import so3
from tracker.hand.files import load_hand as load_wearer
from tracker.hand.model import HandModel

if TYPE_CHECKING:
    from extensions.robot.hand import RobotHand

for package in ("mujoco", "gymnasium_robotics"):
    if find_spec(package) is None:
        pytest.skip(f"the extra robot is not installed: no {package}", allow_module_level=True)

RESOURCES = Path(__file__).parents[3] / "resources"


@cache
def shadow(side: str = "right") -> RobotHand:
    """The Shadow hand."""
    from extensions.robot.hand import load_hand

    return load_hand(RobotSettings(side=side))


@cache
def adroit() -> RobotHand:
    """Another model, by its path: a hand on joints of its own, with tools beside it."""
    from extensions.robot.hand import load_hand

    path = model_path(SHADOW).parents[1] / "adroit_hand" / "adroit_relocate.xml"
    return load_hand(RobotSettings(model=str(path)))


@cache
def wearer_model(side: str = "right") -> HandModel:
    return load_wearer(RESOURCES / "hands" / f"reference-{side}.toml")


def wearer(
    angles: np.ndarray | None = None,
    p_GB: tuple[float, float, float] = (0.0, 0.0, 0.3),
    R_GB: np.ndarray | None = None,
    t: float = 0.0,
    side: str = "right",
) -> WearerHand:
    """The reference hand with joints at ``angles`` (J,), straight by default."""
    hand = wearer_model(side)
    R_GB = np.eye(3) if R_GB is None else R_GB
    angles = np.zeros(len(hand.joint_names)) if angles is None else angles
    R, p = hand.forward(angles, R_GB, np.array(p_GB))
    q = so3.quat_from_matrix(R_GB)
    return hand_from_keypoints(t, True, hand.keypoints(R, p), np.full(21, 2), q)
