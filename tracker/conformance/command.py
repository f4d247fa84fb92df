"""The command ``conformance``."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import TYPE_CHECKING

from tracker.terminal import add_json

if TYPE_CHECKING:
    from tracker.conformance.run import Verdict


def add_commands(subparsers: argparse._SubParsersAction[argparse.ArgumentParser]) -> None:
    """Add ``conformance``, whose exit status is 1 where a rule is not kept."""
    parser = subparsers.add_parser(
        "conformance", help="whether a take is what robot labs accept, as one HTML page"
    )
    parser.add_argument(
        "file", type=Path, nargs="?", metavar="FILE", help="session or Isaac record"
    )
    parser.add_argument("--simulate", action="store_true", help="a simulated wearer's script")
    parser.add_argument("--hands", choices=("left", "right", "both"), default="")
    parser.add_argument(
        "--glove", default="", help="of the simulated wearer; --hands says the side"
    )
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("-o", "--output", type=Path, metavar="PAGE.html", help="the page")
    add_json(parser)
    parser.set_defaults(func=_run)


def _run(args: argparse.Namespace) -> int:
    from tracker.conformance.page import as_json, page
    from tracker.conformance.run import judge, read_take
    from tracker.errors import ConfigError
    from tracker.files import check_target, write_whole
    from tracker.terminal import check_json, finish

    if args.simulate == (args.file is not None):
        raise ConfigError("Name a session or a record, or --simulate.")
    sides = {"": (), "both": ("left", "right")}.get(args.hands, (args.hands,))
    inputs = [args.file] if args.file else []
    check_json(args, inputs)
    if args.output:
        check_target(args.output, args.force, inputs)
    if args.simulate:
        verdict = _simulated(args, sides or ("left", "right"))
    else:
        verdict = judge(args.file.name, *read_take(args.file, sides))
    if args.output:
        write_whole(args.output, page(verdict), args.force, inputs)
    finish(args, as_json(verdict), _lines(verdict), inputs)
    return 0 if verdict.ok else 1


def _simulated(args: argparse.Namespace, sides: tuple[str, ...]) -> Verdict:
    """The verdict; the record and its labels stand beside the page, where one is asked for."""
    from tracker.conformance.run import judge, simulated_takes
    from tracker.conformance.take import labels_beside, take_of, write_labels
    from tracker.files import whole_files
    from tracker.isaac.writer import write_records
    from tracker.terminal import progress_line

    records, steps = simulated_takes(sides, args.seed, args.glove, progress_line("tracking"))
    takes = [take_of(side, found) for side, found in records.items()]
    name = f"a simulated wearer, seed {args.seed}"
    if args.output:
        take = args.output.with_suffix(".mcap")
        with whole_files(labels_beside(take), take, force=args.force) as (labels, record):
            write_records(record, records)
            first = min(int(t.sample[0]) for t in takes)
            write_labels(labels, take.name, steps, first)
        name = take.name
    return judge(name, takes, steps)


def _lines(verdict: Verdict) -> list[str]:
    lines = []
    for f in verdict.findings:
        if f.status != "pass":
            lines.append(f"{f.status}: {f.layer}, {f.side}: {f.rule}: {f.figure} ({f.limit})")
    kept = sum(f.status == "pass" for f in verdict.findings)
    return [*lines, f"{kept} of {len(verdict.findings)} rules are kept."]
