"""The commands ``import-reference`` and ``accuracy``."""

from __future__ import annotations

from dataclasses import field
from pathlib import Path

from tracker.base.arguments import argument, options
from tracker.base.command import Command
from tracker.base.registry import deferred
from tracker.base.terminal import force_option, json_option
from tracker.hand.names import SIDES


@options
class ImportReferenceArguments:
    """Arguments of ``glovetrack import-reference``."""

    reference: Path = field(
        metadata=argument("C3D, TRC, TSV, CSV or BVH file", metavar="REFERENCE")
    )
    session: Path = field(metadata=argument("the tracked session", metavar="SESSION"))
    output: Path = field(metadata=argument("the new session", "-o", "--output", metavar="OUT.mcap"))
    mapping: Path | None = field(
        default=None, metadata=argument("names of points, columns of a CSV, unit", metavar="TOML")
    )
    by: str = field(
        default="movement",
        metadata=argument("how to align the times", choices=("movement", "clock", "pulse")),
    )
    pulse: str = field(
        default="", metadata=argument("name of the reference's events or channel", metavar="NAME")
    )
    start: str = field(
        default="",
        metadata=argument("clock time of the reference's start (ISO 8601)", metavar="TIME"),
    )
    no_drift: bool = field(
        default=False, metadata=argument("assume that both clocks have the same rate")
    )
    register: str = field(
        default="offsets",
        metadata=argument(
            "estimate the laboratory's frame and marker offsets, the frame alone, or nothing",
            choices=("offsets", "rigid", "none"),
        ),
    )
    hand: str = field(default="", metadata=argument("hand in a session of both", choices=SIDES))
    json: str | None = json_option()
    force: bool = force_option()


IMPORT = Command(
    "import-reference",
    "add a motion-capture recording to a session as a reference",
    deferred("extensions.reference.command_runs:import_reference_command"),
    options=ImportReferenceArguments,
)


@options
class AccuracyArguments:
    """Arguments of ``glovetrack accuracy``."""

    sessions: tuple[Path, ...] = field(
        metadata=argument("sessions with a reference, or folders of them", metavar="SESSION")
    )
    output: Path = field(
        metadata=argument("the HTML page", "-o", "--output", metavar="REPORT.html")
    )
    without_offsets: bool = field(
        default=False, metadata=argument("do not correct the markers' positions")
    )
    anonymous: bool = field(
        default=False, metadata=argument("omit the names of recordings and participants")
    )
    json: str | None = json_option()
    force: bool = force_option()


ACCURACY = Command(
    "accuracy",
    "report the accuracy of sessions against their references",
    deferred("extensions.reference.command_runs:accuracy_command"),
    options=AccuracyArguments,
)
