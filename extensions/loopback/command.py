"""``glovetrack loop-back``: from a command, or a tap, to its light in an image."""

from __future__ import annotations

from dataclasses import field

from tracker.base.arguments import argument, options
from tracker.base.command import Command
from tracker.base.registry import deferred
from tracker.base.terminal import force_option, json_option


@options
class LoopBackArguments:
    """Arguments of ``glovetrack loop-back``."""

    port: str = field(default="", metadata=argument("serial port of the glove (default: search)"))
    camera: str = field(
        metadata=argument("number of the camera, or address or path of a stream", "--camera")
    )
    calibration: str = field(
        metadata=argument("calibration of the camera", "--calibration", metavar="FILE")
    )
    channel: int = field(default=0, metadata=argument("motor output of the light (default: 0)"))
    screen: bool = field(
        default=False,
        metadata=argument("flash the screen at each tap of the glove instead of blinking a light"),
    )
    seconds: float = field(default=30.0, metadata=argument("duration (default: 30)", metavar="S"))
    json: str | None = json_option()
    force: bool = force_option()


LOOP_BACK = Command(
    "loop-back",
    "measure the delay from a command to the glove, or from a tap, to its light in an image",
    deferred("extensions.loopback.command_runs:run_loop_back"),
    options=LoopBackArguments,
    epilog="Connect an LED, with its resistor, to a motor output of the glove, and put it into the "
    "picture of the left camera. It blinks at irregular times. With --screen, point the left "
    "camera at the screen and tap on the table with the glove.",
)
