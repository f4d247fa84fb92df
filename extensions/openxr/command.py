"""``glovetrack openxr``: the layer registered for this user, and which applications read hands."""

from __future__ import annotations

import argparse

from tracker.base.command import Command
from tracker.base.registry import deferred

OPENXR = Command[argparse.Namespace](
    "openxr", "register the OpenXR layer, and show which applications read the hand"
)


REGISTER = Command[argparse.Namespace](
    "openxr register",
    "register the layer for this user",
    deferred("extensions.openxr.command_runs:run_register"),
    description="Copies the layer into the user's data folder and adds it to the layers of the "
    "OpenXR loader. OpenXR applications that this user starts then have hand tracking.",
)


UNREGISTER = Command[argparse.Namespace](
    "openxr unregister",
    "remove the layer of this user",
    deferred("extensions.openxr.command_runs:run_unregister"),
)


STATUS = Command[argparse.Namespace](
    "openxr status",
    "show whether the layer is registered and which applications read the hand",
    deferred("extensions.openxr.command_runs:run_status"),
    description="The exit status is 0 if the layer is registered.",
)
