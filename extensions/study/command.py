"""``glovetrack study``: check, run, status, report, tables and export."""

from __future__ import annotations

import argparse
from pathlib import Path

from tracker.base.command import Command
from tracker.base.registry import deferred
from tracker.base.terminal import (
    add_force,
    add_json,
)

DESCRIPTION = "A study is described in one TOML file: participants, conditions, tasks, verdicts."


def _add_protocol(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("protocol", metavar="PROTOCOL", help="protocol file, or name of an example")


def _add_folder(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("source", type=Path, metavar="DIR", help="folder of the study")


def _add_check(parser: argparse.ArgumentParser) -> None:
    _add_protocol(parser)
    add_json(parser)


def _add_run(parser: argparse.ArgumentParser) -> None:
    _add_protocol(parser)
    parser.add_argument(
        "--folder", type=Path, metavar="DIR", help="folder of the study (default: its name)"
    )
    parser.add_argument(
        "--participant", default="", metavar="P01", help="participant (default: the next one)"
    )
    parser.add_argument(
        "--simulated", action="store_true", help="simulate the glove, the camera and the wearer"
    )
    parser.add_argument(
        "--headless",
        action="store_true",
        help="run all remaining trials with simulated participants, without a window",
    )


def _add_status(parser: argparse.ArgumentParser) -> None:
    _add_folder(parser)
    add_json(parser)


def _add_tables(parser: argparse.ArgumentParser) -> None:
    _add_folder(parser)
    parser.add_argument(
        "-o", "--output", type=Path, metavar="CSV", help="table (default: DIR/tables.csv)"
    )
    parser.add_argument(
        "--ablations",
        action="store_true",
        help="track each trial again with the engines chain and vist and with variants of them",
    )
    parser.add_argument(
        "--variants",
        default="",
        metavar="A,B",
        help="only these variants, by their names in the table",
    )
    parser.add_argument("--processes", type=int, metavar="N", help="default: one per core")
    add_json(parser)


def _add_report(parser: argparse.ArgumentParser) -> None:
    _add_folder(parser)
    parser.add_argument(
        "-o",
        "--output",
        type=Path,
        metavar="OUT",
        help="folder of the report (default: DIR/report, whose files are replaced)",
    )
    add_force(parser)
    parser.add_argument(
        "--movement",
        action="store_true",
        help="also compare ranges of motion, speed and smoothness of all trials",
    )


def _add_export(parser: argparse.ArgumentParser) -> None:
    _add_folder(parser)
    parser.add_argument(
        "-o", "--output", type=Path, required=True, metavar="OUT", help="folder of the data set"
    )
    parser.add_argument(
        "--anonymous", action="store_true", help="omit dates and notes; labels remain"
    )
    add_json(parser)


STUDY = Command[argparse.Namespace](
    "study", "plan, run and evaluate studies with several participants"
)


CHECK = Command[argparse.Namespace](
    "study check",
    "check a protocol file and list its participants, trials and duration",
    deferred("extensions.study.command_runs:run_check"),
    add=_add_check,
    description=DESCRIPTION,
)


RUN = Command[argparse.Namespace](
    "study run",
    "guide a participant through the trials, and continue where the study stopped",
    deferred("extensions.study.command_runs:run_study"),
    add=_add_run,
    description=DESCRIPTION,
    opens_window=True,
)


STATUS = Command[argparse.Namespace](
    "study status",
    "show the progress of each participant",
    deferred("extensions.study.command_runs:run_status"),
    add=_add_status,
)


TABLES = Command[argparse.Namespace](
    "study tables",
    "write mean, SD and PCK per condition and keypoint, where trials have a reference",
    deferred("extensions.study.command_runs:run_tables"),
    add=_add_tables,
    description="The tables of Lee et al. 2021: errors of the four keypoints against the reference "
    "(glovetrack import-reference) or the truth of simulated trials.",
)


EXPORT = Command[argparse.Namespace](
    "study export",
    "write the accepted trials of all participants as one data set (Motion-BIDS)",
    deferred("extensions.study.command_runs:run_export"),
    add=_add_export,
)


REPORT = Command[argparse.Namespace](
    "study report",
    "write one HTML page about all trials: verdicts, times, touch tests, errors",
    deferred("extensions.study.command_runs:run_report"),
    add=_add_report,
)
