"""``glovetrack study``: check, run, status, report, tables and export.

Functions import what they need, so that ``glovetrack --help`` is fast.
"""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from tracker.base.command import Command, UsageError
from tracker.base.terminal import add_json, check_json, finish, printable

if TYPE_CHECKING:
    from extensions.study.folder import Study
    from extensions.study.protocol import Protocol

DESCRIPTION = "A study is described in one TOML file: participants, conditions, tasks, verdicts."


def _add_protocol(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("protocol", metavar="PROTOCOL", help="protocol file, or name of an example")


def _add_folder(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("folder", type=Path, metavar="DIR", help="folder of the study")


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
        raise UsageError("--headless requires --simulated: cues need a screen and a participant.")
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
    from tracker.base.numeric_threads import one_blas_thread
    from tracker.base.terminal import stopped_by_signals

    chosen = (participant,) if participant else protocol.participants
    with one_blas_thread(), stopped_by_signals():
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
    study = open_study(args.folder)
    finish(args, status_as_json(study), lines_of_status(study))


STUDY = Command[argparse.Namespace]("study", "studies with several participants, from one file")
CHECK = Command[argparse.Namespace](
    "study check",
    "check a protocol file and list its participants, trials and duration",
    _check,
    add=_add_check,
    description=DESCRIPTION,
)
RUN = Command[argparse.Namespace](
    "study run",
    "lead a participant through the trials, and continue where the study stopped",
    _run,
    add=_add_run,
    description=DESCRIPTION,
    opens_window=True,
)
STATUS = Command[argparse.Namespace](
    "study status", "list how far each participant is", _status, add=_add_status
)
