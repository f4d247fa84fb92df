"""``glovetrack firmware``."""

from __future__ import annotations

import argparse
from pathlib import Path

from tracker.base.command import Command
from tracker.base.registry import deferred
from tracker.base.terminal import add_json


def _add_show(show: argparse.ArgumentParser) -> None:
    show.add_argument(
        "port",
        nargs="?",
        help="serial port of the glove, such as /dev/ttyUSB0 or COM5 (default: all ports)",
    )
    add_json(show)


def _add_write(write: argparse.ArgumentParser) -> None:
    write.add_argument("port", help="serial port of the glove, such as /dev/ttyUSB0 or COM5")
    write.add_argument(
        "--glove-id",
        type=int,
        help="number that identifies the glove (default: its current number, or 1)",
    )
    write.add_argument(
        "--baud",
        type=int,
        default=250_000,
        help="baud rate of the new firmware: 250000 (default) or 115200",
    )
    write.add_argument(
        "--image", type=Path, help="Intel HEX file to write instead of the bundled firmware"
    )
    write.add_argument(
        "--old-bootloader",
        action="store_true",
        help="use the 57600 baud bootloader of early Arduino Nanos",
    )


FIRMWARE = Command[argparse.Namespace]("firmware", "show or write the glove's firmware")


SHOW = Command(
    "firmware show",
    "show the versions of the bundled firmware and of the connected gloves",
    deferred("tracker.firmware.command_runs:run_show"),
    add=_add_show,
)


WRITE = Command(
    "firmware write",
    "write firmware to a glove and verify it",
    deferred("tracker.firmware.command_runs:run_write"),
    add=_add_write,
)
