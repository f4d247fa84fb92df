"""The command ``evaluate faults``: a thousand random device faults."""

from __future__ import annotations

from extensions.evaluation.commands import EvaluateFaultsArguments
from extensions.evaluation.faults.drill import DrillReport, drill
from tracker.base.terminal import check_json, finish, progress_line


def evaluate_faults(args: EvaluateFaultsArguments) -> int:
    """Run the drill; returns exit status 1 if an error was not reported."""
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
