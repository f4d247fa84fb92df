"""The command ``evaluate gaps``: hands that leave the view for a while and return."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from extensions.evaluation.commands import DEVICES, EvaluateGapsArguments
from extensions.evaluation.gaps.trial import GapsCase, GapsFigures, run_trial
from extensions.evaluation.trials import run_trials
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.base.terminal import check_json, finish
from tracker.engine.kinds import ENGINES

LONGEST_RETURN = 0.15
"""Goal: s from the first image with five markers until the hand is tracked."""


MOST_LOST = 0.003
"""Goal: share of later instants with five markers in view at which the hand has no position."""


LEAST_TRUE = 0.97
"""Goal: share of errors within three standard deviations while the hand is out of view."""


class GapsRow(NamedTuple):
    """For several people out of view for ``gap`` s, with errors of real devices or without:
    number of gaps; share of errors within three standard deviations, out of view, and of the
    instants there that have a position; median and longest time (s) until the hand is found;
    share of instants in view without a position; instants that are wrong."""

    gap: float
    errors: bool
    gaps: int
    true: float
    position: float
    back_s: float
    longest_s: float
    lost: float
    wrong: int

    @property
    def is_good(self) -> bool:
        """Whether the goals are met."""
        back = self.longest_s <= LONGEST_RETURN and self.lost <= MOST_LOST
        return back and self.true >= LEAST_TRUE and not self.wrong


def evaluate_gaps(args: EvaluateGapsArguments) -> int:
    """Track the people with gaps of each duration and print the figures."""
    check_json(args.trials)
    ENGINES.get(args.trials.engine)  # raises ConfigError if the name is unknown
    if args.participants < 1 or not 0.1 <= min(args.gaps) <= max(args.gaps) <= 60:
        raise ConfigError(notice("evaluation.gaps_options"))
    cases = [
        GapsCase(gap, errors, args.trials.engine, args.trials.fps)
        for errors in DEVICES[args.devices]
        for gap in args.gaps
    ]
    figures = run_trials(run_trial, cases, args.participants, args.trials)
    people = args.participants
    rows = [
        row_of(case.gap, case.errors, figures[k * people : (k + 1) * people])
        for k, case in enumerate(cases)
    ]
    found = summary(rows)
    finish(args.trials, found, table(rows))
    return 0 if found["ok"] else 1


def row_of(gap: float, errors: bool, figures: Sequence[GapsFigures]) -> GapsRow:
    """The figures of several people in one case as a row."""
    back = sorted(s for f in figures for s in f.back_s)
    out, nowhere = sum(f.out for f in figures), sum(f.no_position for f in figures)
    return GapsRow(
        gap=gap,
        errors=errors,
        gaps=len(back),
        true=sum(f.true for f in figures) / max(out, 1),
        position=out / max(out + nowhere, 1),
        back_s=back[len(back) // 2] if back else float("nan"),
        longest_s=back[-1] if back else float("nan"),
        lost=sum(f.lost for f in figures) / max(sum(f.enough for f in figures), 1),
        wrong=sum(f.wrong for f in figures),
    )


def summary(rows: Sequence[GapsRow]) -> dict[str, Any]:
    """JSON values: the rows, and whether all of them meet the goals."""
    return {"rows": [row._asdict() for row in rows], "ok": all(row.is_good for row in rows)}


def table(rows: Sequence[GapsRow]) -> list[str]:
    """The table as lines of text."""
    lines = [
        f"{'gap s':>6}{'devices':>9}{'gaps':>6}{'within 3 sd %':>15}{'with position %':>17}"
        f"{'back s':>8}{'longest s':>11}{'lost %':>8}{'wrong':>7}"
    ]
    lines += [
        f"{r.gap:>6.1f}{'real' if r.errors else 'ideal':>9}{r.gaps:>6d}{100 * r.true:>15.1f}"
        f"{100 * r.position:>17.1f}{r.back_s:>8.3f}{r.longest_s:>11.3f}{100 * r.lost:>8.2f}"
        f"{r.wrong:>7d}"
        for r in rows
    ]
    return lines
