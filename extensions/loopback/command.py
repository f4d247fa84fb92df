"""``glovetrack loop-back``: from a command to its light in an image."""

from __future__ import annotations

import argparse

from tracker.base.command import Command
from tracker.base.registry import deferred
from tracker.base.terminal import add_json


def _add(command: argparse.ArgumentParser) -> None:
    command.add_argument("--port", default="", help="serial port of the glove (default: search)")
    command.add_argument(
        "--camera", required=True, help="number of the camera, or address or path of a stream"
    )
    command.add_argument(
        "--calibration", required=True, metavar="FILE", help="calibration of the camera"
    )
    command.add_argument(
        "--channel", type=int, default=0, help="motor output of the light (default: 0)"
    )
    command.add_argument(
        "--seconds", type=float, default=30.0, metavar="S", help="duration (default: 30)"
    )
    add_json(command)
    command.epilog = (
        "Connect an LED, with its resistor, to a motor output of the glove, and put it into the "
        "picture of the left camera. It blinks at irregular times."
    )


LOOP_BACK = Command(
    "loop-back",
    "measure the delay from a command to the glove to its light in an image",
    deferred("extensions.loopback.command_runs:run_loop_back"),
    add=_add,
)
