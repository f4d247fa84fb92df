"""The command ``opensim-body``."""

from __future__ import annotations

from dataclasses import field
from pathlib import Path

from tracker.base.arguments import argument, options
from tracker.base.command import Command
from tracker.base.registry import deferred
from tracker.base.terminal import force_option, json_option


@options
class OpensimBodyArguments:
    """Arguments of ``glovetrack opensim-body``."""

    session: Path = field(metadata=argument("a tracked session", metavar="SESSION"))
    body: Path = field(
        metadata=argument("model of the body, OpenSim 4", "--body", metavar="BODY.osim")
    )
    output: Path = field(
        metadata=argument(
            "the body with the hands; OUT.mot is written next to it",
            "-o",
            "--output",
            metavar="OUT.osim",
        )
    )
    motion: Path | None = field(
        default=None, metadata=argument("coordinates of the body over time", metavar="BODY.mot")
    )
    offset: float = field(
        default=0.0,
        metadata=argument(
            "time in BODY.mot of the session's first estimate, s (default: 0)", metavar="S"
        ),
    )
    right: str = field(
        default="hand_r",
        metadata=argument("body segment of the right hand (default: hand_r)", metavar="SEGMENT"),
    )
    place_right: tuple[float, ...] | None = field(
        default=None,
        metadata=argument(
            "pose of the right dorsum in its segment, m and degrees (body-fixed x, y, z)",
            nargs=6,
            metavar=("X", "Y", "Z", "RX", "RY", "RZ"),
        ),
    )
    left: str = field(
        default="hand_l",
        metadata=argument("body segment of the left hand (default: hand_l)", metavar="SEGMENT"),
    )
    place_left: tuple[float, ...] | None = field(
        default=None,
        metadata=argument(
            "pose of the left dorsum in its segment, m and degrees (body-fixed x, y, z)",
            nargs=6,
            metavar=("X", "Y", "Z", "RX", "RY", "RZ"),
        ),
    )
    json: str | None = json_option()
    force: bool = force_option()


OPENSIM_BODY = Command(
    "opensim-body",
    "attach tracked hands to a whole-body OpenSim model",
    deferred("extensions.movement.whole_body:opensim_body"),
    options=OpensimBodyArguments,
)


@options
class ReportArguments:
    """Arguments of ``glovetrack report``."""

    sessions: tuple[Path, ...] = field(
        metadata=argument("sessions or folders of sessions", metavar="SESSION")
    )
    output: Path = field(
        metadata=argument(
            "the HTML page; the table is written next to it",
            "-o",
            "--output",
            metavar="REPORT.html",
        )
    )
    anonymous: bool = field(
        default=False, metadata=argument("omit names of recordings and participants")
    )
    json: str | None = json_option()
    force: bool = force_option()


REPORT = Command(
    "report",
    "summarise recordings in one HTML page and one table",
    deferred("extensions.movement.report.command:report"),
    options=ReportArguments,
)
