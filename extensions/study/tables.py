"""The tables of the VIST paper for a study: errors per condition, variant and keypoint.

A participant's trials of a condition are pooled; means and SDs are over all instants of all
participants, between-participant SDs and confidence intervals over participants' means.
"""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass, replace
from functools import partial
from pathlib import Path

import numpy as np

from extensions.evaluation.vist.metrics import Trial, confidence_interval, pck
from extensions.evaluation.vist.paper import PAPER
from extensions.study.errors import read_truth, trial_of
from extensions.study.folder import Study
from extensions.study.retrack import Variant, chosen
from tracker.base.errors import ConfigError, GlovetrackError
from tracker.base.notices import failure
from tracker.base.urgency import usable_cores
from tracker.base.workers import WorkItem, run_all, some_workers
from tracker.hand.names import MARKED_KEYPOINTS
from tracker.session.reader import SessionReader

ALL = "all"
"""The four keypoints together; their PCK is that of the worst one, as in the paper."""


@dataclass(frozen=True)
class TableRow:
    """One line; errors in mm, shares in percent. ``within``: mean of the participants' SDs;
    ``between``: SD of their means. NaN where there are too few."""

    condition: str
    variant: str
    keypoint: str
    participants: int
    trials: int
    seconds: float
    mean_mm: float
    sd_mm: float
    within_sd_mm: float
    between_sd_mm: float
    ci95_low_mm: float
    ci95_high_mm: float
    pck20: float
    pck35: float
    lost: float


@dataclass(frozen=True)
class Evaluated:
    """The errors of one trial with one variant."""

    condition: str
    participant: str
    variant: str
    trial: Trial


Progress = Callable[[float], None]


def evaluate(
    study: Study,
    variants: Sequence[Variant],
    processes: int | None = None,
    progress: Progress = lambda share: None,
) -> list[Evaluated]:
    """The errors of all accepted trials that have a truth or a reference, with each variant.

    Raises ConfigError if none has, and GlovetrackError if a trial cannot be tracked.
    """
    accepted = [a for a in study.accepted() if study.protocol.tasks[a.step.task].kind == "cues"]
    pairs = [(a, v) for a in accepted if _has_truth(a.path) for v in variants]
    if not pairs:
        raise ConfigError(failure("study.no_truth"))
    number = {p: i for i, p in enumerate(study.protocol.participants)}
    items = [WorkItem(errors_of, (a.path, v.name, number[a.step.participant])) for a, v in pairs]
    trials = _run(items, processes, progress)
    return [
        Evaluated(a.step.condition, a.step.participant, v.name, trial)
        for (a, v), trial in zip(pairs, trials, strict=True)
    ]


def _run(items: list[WorkItem], processes: int | None, progress: Progress) -> list[Trial]:
    count = min(processes or usable_cores(), len(items))
    if count == 1:
        out = []
        for i, item in enumerate(items):
            progress(i / len(items))
            out.append(item.function(*item.arguments))
        return out
    with some_workers(count, "") as workers:
        outcomes = run_all(items, workers, progress)
    for outcome in outcomes:
        if outcome.error:
            raise GlovetrackError(outcome.error)
    return [outcome.value for outcome in outcomes]


def errors_of(
    path: Path, variant: str, number: int, progress: Progress = lambda share: None
) -> Trial:
    """The errors of one trial; for a process of its own."""
    truth = read_truth(path)
    assert truth is not None, "only trials with a truth are evaluated"
    (found,) = chosen((variant,))
    return trial_of(path, found, truth, number)


def _has_truth(path: Path) -> bool:
    with SessionReader(path) as reader:
        return any(name.startswith(("/truth/", "/reference/")) for name in reader.topic_names)


def rows_of(evaluated: Sequence[Evaluated]) -> list[TableRow]:
    """All rows, by condition, variant and keypoint in the order of their appearance. A variant
    without evaluated instants (an outage longer than the trials) has no row."""
    groups = dict.fromkeys((e.condition, e.variant) for e in evaluated)
    rows: list[TableRow] = []
    for condition, variant in groups:
        members = [e for e in evaluated if (e.condition, e.variant) == (condition, variant)]
        trials = pooled(members)
        if not any(len(t.t) for t in trials):
            continue
        make = partial(_row, condition, variant, trials, len(members))
        rows.append(make(ALL, list(range(len(MARKED_KEYPOINTS)))))
        rows += [make(name, [k]) for k, name in enumerate(MARKED_KEYPOINTS)]
    return rows


def pooled(members: Sequence[Evaluated]) -> list[Trial]:
    """One trial per participant, with the instants of all of that participant's."""
    out = []
    for participant in dict.fromkeys(e.participant for e in members):
        trials = [e.trial for e in members if e.participant == participant]
        out.append(
            replace(
                trials[0],
                t=np.concatenate([t.t for t in trials]),
                error=np.concatenate([t.error for t in trials]),
                sd=np.concatenate([t.sd for t in trials]),
                joints=np.concatenate([t.joints for t in trials]),
                seen=np.concatenate([t.seen for t in trials]),
                duration=sum(t.duration for t in trials),
            )
        )
    return out


def _row(
    condition: str, variant: str, trials: Sequence[Trial], count: int, name: str, columns: list[int]
) -> TableRow:
    """``count`` of recordings; ``columns`` of the keypoints."""
    part = [replace(t, error=t.error[:, columns], sd=t.sd[:, columns]) for t in trials]
    mm = [1e3 * t.error[np.isfinite(t.error).all(axis=1)] for t in part]
    every = np.concatenate(mm)
    each = [e for e in mm if len(e)]
    means = np.array([e.mean() for e in each])
    low, high = confidence_interval(means)
    low = max(low, 0.0)  # an error is not negative; NaN remains
    instants = sum(len(t.t) for t in trials)
    nan = float("nan")
    return TableRow(
        condition=condition,
        variant=variant,
        keypoint=name,
        participants=len(trials),
        trials=count,
        seconds=sum(t.duration for t in trials),
        mean_mm=float(every.mean()) if every.size else nan,
        sd_mm=float(every.std()) if every.size else nan,
        within_sd_mm=float(np.mean([e.std() for e in each])) if each else nan,
        between_sd_mm=float(means.std(ddof=1)) if len(means) > 1 else nan,
        ci95_low_mm=low,
        ci95_high_mm=high,
        pck20=pck(part, 20.0),
        pck35=pck(part, 35.0),
        lost=100 * (1 - len(every) / instants),
    )


HEAD = (
    "condition   variant                         keypoint    people trials   mean ±   sd mm  within"
    " between   95 % interval   pck20  pck35  lost%"
)


def lines_of(rows: Sequence[TableRow], every_keypoint: bool = True) -> Iterator[str]:
    """The table as text, with the paper's figures for conditions of its names."""
    yield HEAD
    last = ""
    for row in rows:
        if row.condition != last and row.condition in PAPER:
            yield _paper_line(row.condition)
        last = row.condition
        if every_keypoint or row.keypoint == ALL:
            yield _line(row)


def _line(r: TableRow) -> str:
    between, interval = f"{'–':>7}", f"{'–':>15}"
    if np.isfinite(r.between_sd_mm):
        between = f"{r.between_sd_mm:7.2f}"
        interval = f"{f'{r.ci95_low_mm:.2f}–{r.ci95_high_mm:.2f}':>15}"
    return (
        f"{r.condition:<11} {r.variant:<31} {r.keypoint:<11} {r.participants:>6} {r.trials:>6} "
        f"{r.mean_mm:6.2f} ± {r.sd_mm:6.2f}  {r.within_sd_mm:6.2f} {between} {interval} "
        f"{r.pck20:7.1f} {r.pck35:6.1f} {r.lost:6.1f}"
    )


def _paper_line(condition: str) -> str:
    p = PAPER[condition]
    interval = p["ci95_mm"]
    assert isinstance(interval, list)
    low, high = interval
    sd = f"{p['sd_mm']:6.2f}" if "sd_mm" in p else f"{'–':>6}"
    return (
        f"{condition:<11} {'Lee et al. 2021':<31} {ALL:<11} {15:>6} {'':>6} {p['mean_mm']:6.2f} ± "
        f"{sd}  {'–':>6} {p['between_sd_mm']:7.2f} {f'{low:.2f}–{high:.2f}':>15} "
        f"{p['pck20']:7.1f} {p['pck35']:6.1f} {'':>6}"
    )


def as_table(rows: Sequence[TableRow]) -> tuple[Sequence[str], Sequence[Sequence[str]]]:
    """Head and rows of texts; conditions of the paper's names are followed by its figures."""
    head = ("condition", "variant", "keypoint", "participants", "trials", "mean mm", "SD mm",
            "SD within", "SD between", "95 % interval mm", "PCK 20 mm %", "PCK 35 mm %",
            "lost %")  # fmt: skip
    out = []
    for r in rows:
        interval = f"{r.ci95_low_mm:.2f} to {r.ci95_high_mm:.2f}"
        out.append((r.condition, r.variant, r.keypoint, str(r.participants), str(r.trials),
                    f"{r.mean_mm:.2f}", f"{r.sd_mm:.2f}", f"{r.within_sd_mm:.2f}",
                    f"{r.between_sd_mm:.2f}", interval, f"{r.pck20:.1f}", f"{r.pck35:.1f}",
                    f"{r.lost:.1f}"))  # fmt: skip
        if r.keypoint == ALL and r.condition in PAPER:
            p = PAPER[r.condition]
            out.append((r.condition, "Lee et al. 2021", ALL, "15", "", f"{p['mean_mm']}",
                        f"{p.get('sd_mm', '–')}", "", f"{p['between_sd_mm']}", "",
                        f"{p['pck20']}", f"{p['pck35']}", ""))  # fmt: skip
    return head, [tuple(c.replace("nan", "–") for c in row) for row in out]


def as_csv(rows: Sequence[TableRow]) -> str:
    """One line per row; unknown values are empty."""
    out = io.StringIO()
    names = list(TableRow.__dataclass_fields__)
    writer = csv.DictWriter(out, names, lineterminator="\n")
    writer.writeheader()
    for row in rows:
        writer.writerow({k: _cell(v) for k, v in asdict(row).items()})
    return out.getvalue()


def _cell(value: object) -> object:
    if isinstance(value, float):
        return f"{value:.4f}" if np.isfinite(value) else ""
    return value
