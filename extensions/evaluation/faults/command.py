"""The command ``evaluate faults``: a thousand random device faults."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from tracker.base.command import Command
from tracker.base.terminal import add_json, check_json, finish, progress_line

if TYPE_CHECKING:
    from extensions.evaluation.faults.drill import DrillReport


def add_faults(parser: argparse.ArgumentParser) -> None:
    """Its arguments."""
    parser.add_argument("--count", type=int, default=1000, help="number of faults (default: 1000)")
    parser.add_argument("--seed", type=int, default=1, help="random seed")
    add_json(parser)


def evaluate_faults(args: argparse.Namespace) -> int:
    """Run the drill; returns exit status 1 if an error was not reported."""
    from extensions.evaluation.faults.drill import drill

    check_json(args)
    report = drill(max(args.count, 1), args.seed, progress=progress_line("failing"))
    finish(args, report.to_json(), _table(report).splitlines())
    return 0 if not report.silent_wrong else 1


def _table(report: DrillReport) -> str:
    lines = [
        f"{'fault':<16}{'count':>6}{'recovery max s':>16}{'unreported':>12}{'silent error':>14}"
    ]
    for kind, count in sorted(report.faults.items()):
        worst = max(report.recovery[kind])
        unsaid, wrong = report.unsaid[kind], report.silent_wrong[kind]
        lines.append(f"{kind:<16}{count:>6}{worst:>16.2f}{unsaid:>12}{wrong:>14}")
    return "\n".join(lines)


FAULTS = Command(
    "evaluate faults",
    "inject random faults into a simulated glove and camera and check the tracking",
    evaluate_faults,
    add=add_faults,
)
