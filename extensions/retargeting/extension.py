"""Descriptor of the command that writes configurations of dex-retargeting; quick to import."""

from __future__ import annotations

from extensions.retargeting.command import add_config, write_config
from tracker.base.command import Command

CONFIG = Command(
    "retargeting-config",
    "write a dex-retargeting configuration for a robot hand",
    write_config,
    add=add_config,
    description="Writes the configuration file of dex-retargeting (vector, position or DexPilot) "
    "for the robot hand in an MJCF or URDF file: links, landmarks, scaling factor, and the "
    "rotation to the hand's base. For an MJCF file, a URDF is written next to it.",
    extra="robot",
)
