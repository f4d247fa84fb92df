"""A robot's state as JSON for other programs: angles in rad, positions in m, forces in N."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from extensions.robot.wearer_hand import FINGERS
from tracker.messages import Array, RobotState

SCHEMA = 1


def state_payload(
    state: RobotState, joint_names: Sequence[str], objects: Sequence[str]
) -> dict[str, Any]:
    """JSON-compatible values. Poses are in the robot's world: z up, the table at 0."""
    return {
        "schema": SCHEMA,
        "robot": state.name,
        "t": state.t,
        "engaged": state.engaged,
        "holding": state.holding,
        "commands": dict(zip(joint_names, state.command.tolist(), strict=True)),
        "joints": dict(zip(joint_names, state.joints.tolist(), strict=True)),
        "palm": _pose(state.palm),
        "objects": {n: _pose(p) for n, p in zip(objects, state.objects, strict=True)},
        "force": dict(zip(FINGERS, state.force.tolist(), strict=True)),
    }


def _pose(pose: Array) -> dict[str, list[float]]:
    return {"position": pose[:3].tolist(), "orientation_xyzw": pose[3:].tolist()}
