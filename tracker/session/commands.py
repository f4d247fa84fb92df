"""The commands ``export``, ``info``, ``latency``, ``verify``, ``recover`` and ``compare``."""

from __future__ import annotations

from dataclasses import field
from pathlib import Path

from tracker.base.arguments import argument, options
from tracker.base.command import Command
from tracker.base.registry import deferred
from tracker.base.terminal import force_option, json_option
from tracker.session.export.formats import FORMATS
from tracker.session.export.options import (
    AXES_NAMES,
    ENCODED,
    HIDEABLE,
    IMAGES,
    PERSONAL,
    UNITS,
    VIEWS,
)


@options
class ExportArguments:
    """Arguments of ``glovetrack export``."""

    files: tuple[Path, ...] = field(
        metadata=argument("a session; for lerobot, several sessions or folders", metavar="IN")
    )
    format: str = field(metadata=argument("output format", "--format", choices=FORMATS.names))
    output: Path = field(
        metadata=argument("output file or folder", "-o", "--output", metavar="OUT")
    )
    rate: float | None = field(
        default=None, metadata=argument("resample to this rate", metavar="HZ")
    )
    axes: str | None = field(default=None, metadata=argument("coordinate axes", choices=AXES_NAMES))
    units: str | None = field(default=None, metadata=argument("unit of length", choices=UNITS))
    start: float | None = field(
        default=None, metadata=argument("start, in seconds after the first estimate", metavar="S")
    )
    stop: float | None = field(
        default=None, metadata=argument("end, in seconds after the first estimate", metavar="S")
    )
    every: int = field(
        default=1, metadata=argument("in videos and images, use every Nth frame", metavar="N")
    )
    views: str = field(
        default="left",
        metadata=argument(
            f"views in videos, side by side: {', '.join(VIEWS)} (default: left)", metavar="A,B"
        ),
    )
    joints: str | None = field(
        default=None,
        metadata=argument(
            "export only these keypoints and angles; openxr exports OpenXR's 26 joints",
            metavar="A,B",
        ),
    )
    anonymous: tuple[str, ...] | None = field(
        default=None,
        metadata=argument(
            f"omit {' and '.join(PERSONAL)}, or only the given fields out of {', '.join(HIDEABLE)}",
            choices=HIDEABLE,
            metavar="FIELD",
        ),
    )
    task: str = field(
        default="",
        metadata=argument(
            "description of the task", metavar="TEXT", group="data sets of many sessions (lerobot)"
        ),
    )
    split: bool = field(
        default=False,
        metadata=argument(
            "start a new episode at each note", group="data sets of many sessions (lerobot)"
        ),
    )
    images: str = field(
        default=ENCODED,
        metadata=argument(
            "keep images as recorded (encoded), convert them to video with ffmpeg, or omit them",
            choices=IMAGES,
            group="data sets of many sessions (lerobot)",
        ),
    )
    jobs: int | None = field(
        default=None,
        metadata=argument(
            "number of worker processes (default: one per core)",
            metavar="N",
            group="data sets of many sessions (lerobot)",
        ),
    )
    dask: str = field(
        default="",
        metadata=argument(
            "run on this Dask cluster",
            metavar="ADDRESS",
            group="data sets of many sessions (lerobot)",
        ),
    )
    json: str | None = json_option()
    force: bool = force_option()


EXPORT = Command(
    "export",
    "convert a session to another format",
    deferred("tracker.session.command_runs:run_export"),
    options=ExportArguments,
)


@options
class InfoArguments:
    """Arguments of ``glovetrack info``."""

    file: Path = field(metadata=argument("session file", metavar="FILE"))
    latency: bool = field(
        default=False, metadata=argument("also report the latencies, as `glovetrack latency` does")
    )
    json: str | None = json_option()
    force: bool = force_option()


INFO = Command(
    "info",
    "show the contents of a session",
    deferred("tracker.session.command_runs:run_info"),
    options=InfoArguments,
)


@options
class LatencyArguments:
    """Arguments of ``glovetrack latency``."""

    file: Path = field(metadata=argument("session file", metavar="FILE"))
    json: str | None = json_option()
    force: bool = force_option()


LATENCY = Command(
    "latency",
    "report the latencies of a recording, from sample or exposure to pose, motor and robot",
    deferred("tracker.session.command_runs:run_latency"),
    options=LatencyArguments,
)


@options
class VerifyArguments:
    """Arguments of ``glovetrack verify``."""

    files: tuple[Path, ...] = field(
        metadata=argument("sessions or folders of sessions", metavar="FILE")
    )
    json: str | None = json_option()
    force: bool = force_option()


VERIFY = Command(
    "verify",
    "check sessions for damage",
    deferred("tracker.session.command_runs:run_verify"),
    options=VerifyArguments,
)


@options
class RecoverArguments:
    """Arguments of ``glovetrack recover``."""

    file: Path = field(metadata=argument("session file", metavar="FILE"))
    output: Path | None = field(
        default=None,
        metadata=argument(
            "the recovered session (default: FILE_recovered.mcap)", "-o", "--output", metavar="OUT"
        ),
    )
    json: str | None = json_option()
    force: bool = force_option()


RECOVER = Command(
    "recover",
    "recover a damaged recording",
    deferred("tracker.session.command_runs:run_recover"),
    options=RecoverArguments,
)


@options
class CompareArguments:
    """Arguments of ``glovetrack compare``."""

    first: Path = field(metadata=argument("session A", metavar="A"))
    second: Path = field(metadata=argument("session B, compared with A", metavar="B"))
    figure: Path | None = field(
        default=None, metadata=argument("plot the differences", metavar="PNG")
    )
    align: Path | None = field(
        default=None,
        metadata=argument(
            "shift B to A's time by the result of `glovetrack align`", metavar="FILE"
        ),
    )
    json: str | None = json_option()
    force: bool = force_option()


COMPARE = Command(
    "compare",
    "list the differences between two trackings of a session",
    deferred("tracker.session.command_runs:run_compare"),
    options=CompareArguments,
)


@options
class AlignArguments:
    """Arguments of ``glovetrack align``."""

    first: Path = field(metadata=argument("reference session", metavar="A"))
    second: Path = field(metadata=argument("session to align with A", metavar="B"))
    by: str = field(
        default="movement",
        metadata=argument(
            "align by recorded timestamps or by hand movement", choices=("clock", "movement")
        ),
    )
    output: Path | None = field(
        default=None,
        metadata=argument(
            "save the result for `compare --align`", "-o", "--output", metavar="JSON"
        ),
    )
    figure: Path | None = field(
        default=None, metadata=argument("plot both recordings on one time axis", metavar="PNG")
    )
    json: str | None = json_option()
    force: bool = force_option()


ALIGN = Command(
    "align",
    "find the time offset between two recordings",
    deferred("tracker.session.align_command:run_align"),
    options=AlignArguments,
)
