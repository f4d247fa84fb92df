"""The command ``conformance``."""

from __future__ import annotations

from dataclasses import field
from pathlib import Path

from tracker.base.arguments import argument, options
from tracker.base.command import Command
from tracker.base.registry import deferred
from tracker.base.terminal import force_option, json_option


@options
class ConformanceArguments:
    """Arguments of ``glovetrack conformance``."""

    file: Path | None = field(default=None, metadata=argument("session or Isaac record", "FILE"))
    simulate: bool = field(
        default=False,
        metadata=argument(
            "check a simulated wearer who follows the script", "--simulate", "--simulated"
        ),
    )
    hands: str = field(
        default="",
        metadata=argument("hands to check (default: all)", choices=("left", "right", "both")),
    )
    glove: str = field(
        default="", metadata=argument("glove of the simulated wearer; --hands selects the side")
    )
    seed: int = field(default=1, metadata=argument("random seed of the simulated wearer"))
    output: Path | None = field(
        default=None,
        metadata=argument(
            "HTML page, or a folder for it (created if missing)",
            "-o",
            "--output",
            metavar="PAGE.html|DIR",
        ),
    )
    json: str | None = json_option()
    force: bool = force_option()


CONFORMANCE = Command(
    "conformance",
    "check hand data against the requirements of robot labs and write an HTML page",
    deferred("extensions.conformance.command_runs:check_conformance"),
    options=ConformanceArguments,
)
