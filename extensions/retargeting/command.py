"""``glovetrack retargeting-config``: a configuration of dex-retargeting for a robot hand."""

from __future__ import annotations

import argparse
from pathlib import Path

from extensions.robot.commands import add_fingers
from extensions.robot.library import SHADOW
from tracker.base.command import Command
from tracker.base.registry import deferred
from tracker.base.terminal import add_force


def add_config(parser: argparse.ArgumentParser) -> None:
    """Its arguments."""
    parser.add_argument(
        "model",
        metavar="MODEL",
        nargs="?",
        default=SHADOW,
        help="a robot hand: the path of an MJCF or URDF file (default: shadow)",
    )
    parser.add_argument(
        "--type",
        dest="kind",
        choices=("vector", "position", "dexpilot"),
        default="vector",
        help="algorithm (default: vector)",
    )
    add_fingers(parser)
    parser.add_argument(
        "--hand",
        default="",
        help="hand file of the wearer, for the scaling factor (default: the reference hand)",
    )
    parser.add_argument(
        "-o", "--out", type=Path, required=True, metavar="FILE.yml", help="configuration to write"
    )
    add_force(parser)


CONFIG = Command(
    "retargeting-config",
    "write a dex-retargeting configuration for a robot hand",
    deferred("extensions.retargeting.command_runs:write_config"),
    add=add_config,
    description="Writes the configuration file of dex-retargeting (vector, position or DexPilot) "
    "for the robot hand in an MJCF or URDF file: links, landmarks, scaling factor, and the "
    "rotation to the hand's base. For an MJCF file, a URDF is written next to it.",
    extra="robot",
)
