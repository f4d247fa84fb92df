"""``glovetrack retargeting-config``: a configuration of dex-retargeting for a robot hand."""

from __future__ import annotations

from dataclasses import field
from pathlib import Path

from extensions.robot.commands import fingers_option
from extensions.robot.library import SHADOW
from tracker.base.arguments import argument, options
from tracker.base.command import Command
from tracker.base.registry import deferred
from tracker.base.terminal import force_option


@options
class RetargetingConfigArguments:
    """Arguments of ``glovetrack retargeting-config``."""

    model: str = field(
        default=SHADOW,
        metadata=argument(
            "a robot hand: the path of an MJCF or URDF file (default: shadow)", "MODEL"
        ),
    )
    kind: str = field(
        default="vector",
        metadata=argument(
            "algorithm (default: vector)", "--type", choices=("vector", "position", "dexpilot")
        ),
    )
    fingers: str = fingers_option()
    hand: str = field(
        default="",
        metadata=argument(
            "hand file of the wearer, for the scaling factor (default: the reference hand)"
        ),
    )
    out: Path = field(
        metadata=argument("configuration to write", "-o", "--out", metavar="FILE.yml")
    )
    force: bool = force_option()


CONFIG = Command(
    "retargeting-config",
    "write a dex-retargeting configuration for a robot hand",
    deferred("extensions.retargeting.config:write_config"),
    options=RetargetingConfigArguments,
    description="Writes the configuration file of dex-retargeting (vector, position or DexPilot) "
    "for the robot hand in an MJCF or URDF file: links, landmarks, scaling factor, and the "
    "rotation to the hand's base. For an MJCF file, a URDF is written next to it.",
    extra="robot",
)
