"""``glovetrack firmware``."""

from __future__ import annotations

import argparse
from dataclasses import field
from pathlib import Path

from tracker.base.arguments import argument, options
from tracker.base.command import Command
from tracker.base.registry import deferred
from tracker.base.terminal import force_option, json_option

FIRMWARE = Command[argparse.Namespace]("firmware", "show or write the glove's firmware")


@options
class FirmwareShowArguments:
    """Arguments of ``glovetrack firmware show``."""

    port: str | None = field(
        default=None,
        metadata=argument(
            "serial port of the glove, such as /dev/ttyUSB0 or COM5 (default: all ports)", "port"
        ),
    )
    json: str | None = json_option()
    force: bool = force_option()


SHOW = Command(
    "firmware show",
    "show the versions of the bundled firmware and of the connected gloves",
    deferred("tracker.firmware.command_runs:run_show"),
    options=FirmwareShowArguments,
)


@options
class FirmwareWriteArguments:
    """Arguments of ``glovetrack firmware write``."""

    port: str = field(metadata=argument("serial port of the glove, such as /dev/ttyUSB0 or COM5"))
    glove_id: int | None = field(
        default=None,
        metadata=argument("number that identifies the glove (default: its current number, or 1)"),
    )
    baud: int = field(
        default=250_000,
        metadata=argument("baud rate of the new firmware: 250000 (default) or 115200"),
    )
    image: Path | None = field(
        default=None, metadata=argument("Intel HEX file to write instead of the bundled firmware")
    )
    old_bootloader: bool = field(
        default=False, metadata=argument("use the 57600 baud bootloader of early Arduino Nanos")
    )


WRITE = Command(
    "firmware write",
    "write firmware to a glove and verify it",
    deferred("tracker.firmware.command_runs:run_write"),
    options=FirmwareWriteArguments,
)
