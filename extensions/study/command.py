"""``glovetrack study``: check, run, status, report, tables and export.

Functions import what they need, so that ``glovetrack --help`` is fast.
"""

from __future__ import annotations

import argparse
import contextlib
from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

from tracker.base.command import Command, UsageError
from tracker.base.errors import ConfigError
from tracker.base.files import check_folder_target, check_target, write_whole
from tracker.base.notices import failure, notice
from tracker.base.numeric_threads import one_numeric_thread
from tracker.base.terminal import (
    add_force,
    add_json,
    check_json,
    finish,
    printable,
    progress_line,
    stopped_by_signals,
)
from tracker.session.export.options import ExportOptions

if TYPE_CHECKING:
    from extensions.study.folder import Study
    from extensions.study.protocol import Protocol

DESCRIPTION = "A study is described in one TOML file: participants, conditions, tasks, verdicts."


def _add_protocol(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("protocol", metavar="PROTOCOL", help="protocol file, or name of an example")


def _add_folder(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("source", type=Path, metavar="DIR", help="folder of the study")


# ---- check


def _add_check(parser: argparse.ArgumentParser) -> None:
    _add_protocol(parser)
    add_json(parser)


def _check(args: argparse.Namespace) -> None:
    from extensions.study.examples import protocol_path
    from extensions.study.overview import lines_of_protocol, protocol_as_json
    from extensions.study.protocol import load_protocol

    path = protocol_path(args.protocol)
    check_json(args, [path])
    protocol, _ = load_protocol(path)
    finish(args, protocol_as_json(protocol), lines_of_protocol(protocol), [path])


# ---- run


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


def _run(args: argparse.Namespace) -> int:
    from extensions.study.examples import protocol_path
    from extensions.study.folder import start_study
    from extensions.study.protocol import load_protocol

    if args.headless and not args.simulated:
        raise UsageError(notice("option.requires", option="--headless", needed="--simulated"))
    path = protocol_path(args.protocol)
    protocol, _ = load_protocol(path)
    study = start_study(path, args.folder or Path(protocol.name))
    if args.participant:
        study.progress(args.participant)  # raises for an unknown one
    if not args.headless:
        from extensions.study.window.start import open_study_window

        return open_study_window(study, args.participant, args.simulated)
    return _run_headless(study, protocol, args.participant)


def _run_headless(study: Study, protocol: Protocol, participant: str) -> int:
    from extensions.study.headless import run_headless

    chosen = (participant,) if participant else protocol.participants
    with one_numeric_thread(), stopped_by_signals():
        for label in chosen:
            run_headless(study.progress(label), lambda line: print(printable(line), flush=True))
    return 0


# ---- status


def _add_status(parser: argparse.ArgumentParser) -> None:
    _add_folder(parser)
    add_json(parser)


def _status(args: argparse.Namespace) -> None:
    from extensions.study.folder import open_study
    from extensions.study.overview import lines_of_status, status_as_json

    check_json(args)
    study = open_study(args.source)
    finish(args, status_as_json(study), lines_of_status(study))


# ---- tables


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


def _tables(args: argparse.Namespace) -> None:
    from extensions.study.folder import open_study

    with _other_extension("evaluation"):
        from extensions.study import retrack, tables

    study = open_study(args.source)
    out = args.output or args.source / "tables.csv"
    check_json(args)
    check_target(out, args.force or args.output is None)
    names = tuple(n.strip() for n in args.variants.split(",") if n.strip())
    names = names or (tuple(retrack.variants()) if args.ablations else (retrack.RECORDED,))
    evaluated = tables.evaluate(
        study, retrack.chosen(names), args.processes, progress_line("tracking")
    )
    rows = tables.rows_of(evaluated)
    write_whole(out, tables.as_csv(rows), force=args.force or args.output is None)
    lines = [*tables.lines_of(rows), f"{out}: {len(rows)} rows"]
    finish(args, {"rows": [asdict(row) for row in rows]}, lines, [out])


# ---- report


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


def _report(args: argparse.Namespace) -> None:
    from extensions.study.folder import open_study
    from extensions.study.report import write_movement
    from extensions.study.results import write_report

    study = open_study(args.source)
    folder = args.output or args.source / "report"
    if args.output is not None:
        check_folder_target(folder, args.force)
    print(write_report(study, folder))
    if args.movement:
        write_movement(study, folder / "movement.html")
        print(folder / "movement.html")


# ---- export


def _add_export(parser: argparse.ArgumentParser) -> None:
    _add_folder(parser)
    parser.add_argument(
        "-o", "--output", type=Path, required=True, metavar="OUT", help="folder of the data set"
    )
    parser.add_argument(
        "--anonymous", action="store_true", help="omit dates and notes; labels remain"
    )
    add_json(parser)


def _export(args: argparse.Namespace) -> None:
    from extensions.study.folder import open_study

    with _other_extension("movement"):
        from extensions.study.export import export_study

    check_json(args)
    study = open_study(args.source)
    options = ExportOptions(anonymous=("time", "notes") if args.anonymous else ())
    count = export_study(study, args.output, options, args.force, progress_line("exporting"))
    result = {"recordings": count, "folder": str(args.output)}
    finish(args, result, [f"{args.output}: {count} recordings"], [args.output])


@contextlib.contextmanager
def _other_extension(name: str) -> Iterator[None]:
    """Imports of another extension, whose folder may have been removed."""
    try:
        yield
    except ModuleNotFoundError as error:
        raise ConfigError(failure("study.needs_extension", name=name)) from error


STUDY = Command[argparse.Namespace](
    "study", "plan, run and evaluate studies with several participants"
)
CHECK = Command[argparse.Namespace](
    "study check",
    "check a protocol file and list its participants, trials and duration",
    _check,
    add=_add_check,
    description=DESCRIPTION,
)
RUN = Command[argparse.Namespace](
    "study run",
    "guide a participant through the trials, and continue where the study stopped",
    _run,
    add=_add_run,
    description=DESCRIPTION,
    opens_window=True,
)
STATUS = Command[argparse.Namespace](
    "study status", "show the progress of each participant", _status, add=_add_status
)
TABLES = Command[argparse.Namespace](
    "study tables",
    "write mean, SD and PCK per condition and keypoint, where trials have a reference",
    _tables,
    add=_add_tables,
    description="The tables of Lee et al. 2021: errors of the four keypoints against the reference "
    "(glovetrack import-reference) or the truth of simulated trials.",
)
EXPORT = Command[argparse.Namespace](
    "study export",
    "write the accepted trials of all participants as one data set (Motion-BIDS)",
    _export,
    add=_add_export,
)
REPORT = Command[argparse.Namespace](
    "study report",
    "write one HTML page about all trials: verdicts, times, touch tests, errors",
    _report,
    add=_add_report,
)
