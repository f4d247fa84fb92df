"""The commands ``export``, ``info``, ``latency``, ``verify``, ``recover`` and ``compare``."""

from __future__ import annotations

import argparse
from pathlib import Path

from tracker.base.command import Command
from tracker.base.registry import deferred
from tracker.base.terminal import add_json
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


def _add_file(command: argparse.ArgumentParser) -> None:
    command.add_argument("file", type=Path, metavar="FILE", help="session file")


def _add_info(command: argparse.ArgumentParser) -> None:
    _add_file(command)
    command.add_argument(
        "--latency",
        action="store_true",
        help="also report the latencies, as `glovetrack latency` does",
    )
    add_json(command)


def _add_latency(command: argparse.ArgumentParser) -> None:
    _add_file(command)
    add_json(command)


def _add_verify(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "files", type=Path, nargs="+", metavar="FILE", help="sessions or folders of sessions"
    )
    add_json(command)


def _add_recover(command: argparse.ArgumentParser) -> None:
    _add_file(command)
    command.add_argument(
        "-o",
        "--output",
        type=Path,
        metavar="OUT",
        help="the recovered session (default: FILE_recovered.mcap)",
    )
    add_json(command)


def _add_compare(command: argparse.ArgumentParser) -> None:
    command.add_argument("first", type=Path, metavar="A", help="session A")
    command.add_argument("second", type=Path, metavar="B", help="session B, compared with A")
    command.add_argument("--figure", type=Path, metavar="PNG", help="plot the differences")
    command.add_argument(
        "--align",
        type=Path,
        metavar="FILE",
        help="shift B to A's time by the result of `glovetrack align`",
    )
    add_json(command)


def _add_export(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "files",
        type=Path,
        nargs="+",
        metavar="IN",
        help="a session; for lerobot, several sessions or folders",
    )
    command.add_argument("--format", required=True, choices=FORMATS.names(), help="output format")
    command.add_argument(
        "-o", "--output", type=Path, required=True, metavar="OUT", help="output file or folder"
    )
    command.add_argument("--rate", type=float, metavar="HZ", help="resample to this rate")
    command.add_argument("--axes", choices=AXES_NAMES, help="coordinate axes")
    command.add_argument("--units", choices=UNITS, help="unit of length")
    _add_selection(command)
    _add_dataset(command)
    add_json(command)


def _add_selection(command: argparse.ArgumentParser) -> None:
    """Adds the options that select the part of a session to export."""
    command.add_argument(
        "--start", type=float, metavar="S", help="start, in seconds after the first estimate"
    )
    command.add_argument(
        "--stop", type=float, metavar="S", help="end, in seconds after the first estimate"
    )
    command.add_argument(
        "--every",
        type=int,
        default=1,
        metavar="N",
        help="in videos and images, use every Nth frame",
    )
    command.add_argument(
        "--views",
        default="left",
        metavar="A,B",
        help=f"views in videos, side by side: {', '.join(VIEWS)} (default: left)",
    )
    command.add_argument(
        "--joints",
        metavar="A,B",
        help="export only these keypoints and angles; openxr exports OpenXR's 26 joints",
    )
    command.add_argument(
        "--anonymous",
        nargs="*",
        choices=HIDEABLE,
        metavar="FIELD",
        help=f"omit {' and '.join(PERSONAL)}, or only the given fields out of "
        f"{', '.join(HIDEABLE)}",
    )


def _add_dataset(command: argparse.ArgumentParser) -> None:
    group = command.add_argument_group("data sets of many sessions (lerobot)")
    group.add_argument("--task", default="", metavar="TEXT", help="description of the task")
    group.add_argument("--split", action="store_true", help="start a new episode at each note")
    group.add_argument(
        "--images",
        choices=IMAGES,
        default=ENCODED,
        help="keep images as recorded (encoded), convert them to video with ffmpeg, or omit them",
    )
    group.add_argument(
        "--jobs", type=int, metavar="N", help="number of worker processes (default: one per core)"
    )
    group.add_argument("--dask", default="", metavar="ADDRESS", help="run on this Dask cluster")


EXPORT = Command(
    "export",
    "convert a session to another format",
    deferred("tracker.session.command_runs:run_export"),
    add=_add_export,
)


INFO = Command(
    "info",
    "show the contents of a session",
    deferred("tracker.session.command_runs:run_info"),
    add=_add_info,
)


LATENCY = Command(
    "latency",
    "report the latencies of a recording, from sample or exposure to pose, motor and robot",
    deferred("tracker.session.command_runs:run_latency"),
    add=_add_latency,
)


VERIFY = Command(
    "verify",
    "check sessions for damage",
    deferred("tracker.session.command_runs:run_verify"),
    add=_add_verify,
)


RECOVER = Command(
    "recover",
    "recover a damaged recording",
    deferred("tracker.session.command_runs:run_recover"),
    add=_add_recover,
)


COMPARE = Command(
    "compare",
    "list the differences between two trackings of a session",
    deferred("tracker.session.command_runs:run_compare"),
    add=_add_compare,
)


def _add_align(command: argparse.ArgumentParser) -> None:
    command.add_argument("first", type=Path, metavar="A", help="reference session")
    command.add_argument("second", type=Path, metavar="B", help="session to align with A")
    command.add_argument(
        "--by",
        choices=("clock", "movement"),
        default="movement",
        help="align by recorded timestamps or by hand movement",
    )
    command.add_argument(
        "-o", "--output", type=Path, metavar="JSON", help="save the result for `compare --align`"
    )
    command.add_argument(
        "--figure", type=Path, metavar="PNG", help="plot both recordings on one time axis"
    )
    add_json(command)


ALIGN = Command(
    "align",
    "find the time offset between two recordings",
    deferred("tracker.session.align_command:run_align"),
    add=_add_align,
)
