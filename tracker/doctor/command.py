"""``glovetrack doctor``."""

from __future__ import annotations

from dataclasses import field
from pathlib import Path

from tracker.base.arguments import argument, options
from tracker.base.command import Command
from tracker.base.registry import deferred
from tracker.base.terminal import force_option, json_option


@options
class DoctorArguments:
    """Arguments of ``glovetrack doctor``."""

    out: Path | None = field(
        default=None,
        metadata=argument("also write the report to a text file", "-o", "--out", metavar="REPORT"),
    )
    folder: Path = field(
        default=Path(), metadata=argument("folder whose disk is tested (default: the current one)")
    )
    only: tuple[str, ...] | None = field(
        default=None,
        metadata=argument(
            "run these checks only, such as gloves cameras", metavar="CHECK", nargs="+"
        ),
    )
    fps: float = field(
        default=30.0, metadata=argument("images per second to request (default: 30)")
    )
    json: str | None = json_option()
    force: bool = force_option()


DOCTOR = Command(
    "doctor",
    "check the computer and the devices, with a remedy for each problem",
    deferred("tracker.doctor.command_runs:run_doctor"),
    options=DoctorArguments,
    description="Checks the system, permissions, ports, gloves, cameras, disk, processor and "
    "graphics card. Prints a line per finding: ok, warning or error, what was found, and what to "
    "do about it. The exit status is 1 if there is an error. Devices must not be in use.",
)
