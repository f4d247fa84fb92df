"""``glovetrack study``: check, run, status, report, tables and export."""

from __future__ import annotations

import argparse
from dataclasses import field
from pathlib import Path

from tracker.base.arguments import argument, options
from tracker.base.command import Command
from tracker.base.registry import deferred
from tracker.base.terminal import force_option, json_option

DESCRIPTION = "A study is described in one TOML file: participants, conditions, tasks, verdicts."


STUDY = Command[argparse.Namespace](
    "study", "plan, run and evaluate studies with several participants"
)


@options
class StudyCheckArguments:
    """Arguments of ``glovetrack study check``."""

    protocol: str = field(
        metadata=argument("protocol file, or name of an example", metavar="PROTOCOL")
    )
    json: str | None = json_option()
    force: bool = force_option()


CHECK = Command(
    "study check",
    "check a protocol file and list its participants, trials and duration",
    deferred("extensions.study.command_runs:run_check"),
    options=StudyCheckArguments,
    description=DESCRIPTION,
)


@options
class StudyRunArguments:
    """Arguments of ``glovetrack study run``."""

    protocol: str = field(
        metadata=argument("protocol file, or name of an example", metavar="PROTOCOL")
    )
    folder: Path | None = field(
        default=None, metadata=argument("folder of the study (default: its name)", metavar="DIR")
    )
    participant: str = field(
        default="", metadata=argument("participant (default: the next one)", metavar="P01")
    )
    simulated: bool = field(
        default=False, metadata=argument("simulate the glove, the camera and the wearer")
    )
    headless: bool = field(
        default=False,
        metadata=argument("run all remaining trials with simulated participants, without a window"),
    )


RUN = Command(
    "study run",
    "guide a participant through the trials, and continue where the study stopped",
    deferred("extensions.study.command_runs:run_study"),
    options=StudyRunArguments,
    description=DESCRIPTION,
    opens_window=True,
)


@options
class StudyStatusArguments:
    """Arguments of ``glovetrack study status``."""

    source: Path = field(metadata=argument("folder of the study", metavar="DIR"))
    json: str | None = json_option()
    force: bool = force_option()


STATUS = Command(
    "study status",
    "show the progress of each participant",
    deferred("extensions.study.command_runs:run_status"),
    options=StudyStatusArguments,
)


@options
class StudyTablesArguments:
    """Arguments of ``glovetrack study tables``."""

    source: Path = field(metadata=argument("folder of the study", metavar="DIR"))
    output: Path | None = field(
        default=None,
        metadata=argument("table (default: DIR/tables.csv)", "-o", "--output", metavar="CSV"),
    )
    ablations: bool = field(
        default=False,
        metadata=argument(
            "track each trial again with the engines chain and vist and with variants of them"
        ),
    )
    variants: str = field(
        default="",
        metadata=argument("only these variants, by their names in the table", metavar="A,B"),
    )
    processes: int | None = field(
        default=None, metadata=argument("default: one per core", metavar="N")
    )
    json: str | None = json_option()
    force: bool = force_option()


TABLES = Command(
    "study tables",
    "write mean, SD and PCK per condition and keypoint, where trials have a reference",
    deferred("extensions.study.command_runs:run_tables"),
    options=StudyTablesArguments,
    description="The tables of Lee et al. 2021: errors of the four keypoints against the reference "
    "(glovetrack import-reference) or the truth of simulated trials.",
)


@options
class StudyExportArguments:
    """Arguments of ``glovetrack study export``."""

    source: Path = field(metadata=argument("folder of the study", metavar="DIR"))
    output: Path = field(
        metadata=argument("folder of the data set", "-o", "--output", metavar="OUT")
    )
    anonymous: bool = field(default=False, metadata=argument("omit dates and notes; labels remain"))
    json: str | None = json_option()
    force: bool = force_option()


EXPORT = Command(
    "study export",
    "write the accepted trials of all participants as one data set (Motion-BIDS)",
    deferred("extensions.study.command_runs:run_export"),
    options=StudyExportArguments,
)


@options
class StudyReportArguments:
    """Arguments of ``glovetrack study report``."""

    source: Path = field(metadata=argument("folder of the study", metavar="DIR"))
    output: Path | None = field(
        default=None,
        metadata=argument(
            "folder of the report (default: DIR/report, whose files are replaced)",
            "-o",
            "--output",
            metavar="OUT",
        ),
    )
    force: bool = force_option()
    movement: bool = field(
        default=False,
        metadata=argument("also compare ranges of motion, speed and smoothness of all trials"),
    )


REPORT = Command(
    "study report",
    "write one HTML page about all trials: verdicts, times, touch tests, errors",
    deferred("extensions.study.command_runs:run_report"),
    options=StudyReportArguments,
)
