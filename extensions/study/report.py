"""The report of a study: its progress, the verdicts on its trials, times and errors."""

from __future__ import annotations

import argparse
import contextlib
import io
import json
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from html import escape
from pathlib import Path

import numpy as np

from extensions.study.folder import Study
from extensions.study.overview import counts
from extensions.study.progress import ACCEPTED
from extensions.study.schedule import ScheduleStep, condition_order
from extensions.study.verdict import TrialVerdict, stored
from tracker import __version__
from tracker.base.command import COMMANDS
from tracker.base.errors import GlovetrackError
from tracker.base.report_page import html_page, html_table
from tracker.messages import Array


@dataclass(frozen=True)
class JudgedTrial:
    """A trial with the verdict on its last recording, and how it was decided."""

    step: ScheduleStep
    verdict: TrialVerdict
    state: str
    tries: int
    path: Path


def judged_trials(study: Study) -> list[JudgedTrial]:
    """All trials that have a verdict."""
    found = []
    for progress in study.all_progress():
        for step in progress.trials:
            entry = progress.entry(step)
            if entry.tries and entry.tries[-1].verdict is not None:
                verdict = stored(entry.tries[-1].verdict)
                path = progress.path(step)
                found.append(JudgedTrial(step, verdict, entry.state, len(entry.tries), path))
    return found


def report_page(study: Study, touch: Sequence[tuple[str, str]], errors: str = "") -> str:
    """The page. ``touch``: name and quotable line of each touch test; ``errors``: tables of errors
    against references, as HTML."""
    protocol, trials = study.protocol, judged_trials(study)
    done = sum(counts(p)["accepted"] for p in study.all_progress())
    planned = sum(counts(p)["trials"] for p in study.all_progress())
    parts = [
        f"<h1>{escape(protocol.title)}</h1>",
        f'<p class="quote">{done} of {planned} trials accepted, '
        f"{len({j.step.participant for j in trials})} of {len(protocol.participants)} participants"
        "</p>",
        "<h2>Participants</h2>",
        _participants(study),
        "<h2>Conditions</h2>",
        _conditions(study, trials),
    ]
    timed = _times(study, trials)
    if timed:
        parts += ["<h2>Time to finish</h2>", timed]
    if touch:
        parts += ["<h2>Touch tests</h2>", html_table(("trial", "result"), touch)]
    if errors:
        parts += ["<h2>Errors against the reference</h2>", errors]
    parts += ["<h2>Trials</h2>", _trials(trials), _definitions(study)]
    return html_page(protocol.title, parts)


def _participants(study: Study) -> str:
    head = ("", "order of conditions", "accepted", "failed", "open", "repeated", "interrupted")
    rows = []
    for progress in study.all_progress():
        of = counts(progress)
        order = ", ".join(condition_order(study.protocol, progress.participant))
        figures = [str(of[k]) for k in ("accepted", "failed", "open", "repeated", "interrupted")]
        rows.append((progress.participant, order, *figures))
    return html_table(head, rows)


def _conditions(study: Study, trials: Sequence[JudgedTrial]) -> str:
    head = ("condition", "", "task", "trials", "minutes", "tracked %", "measured %", "inferred %",
            "lost %", "packets lost %", "images not searched %")  # fmt: skip
    rows = []
    for condition in study.protocol.conditions.values():
        for task in condition.tasks:
            found = [
                j.verdict.measured
                for j in trials
                if j.state == ACCEPTED and (j.step.condition, j.step.task) == (condition.name, task)
            ]
            if not found:
                continue
            shares = [
                _percent([getattr(m, name) for m in found])
                for name in ("tracked", "measured", "inferred", "lost")
            ]
            lost = [m.packets_lost / max(m.packets + m.packets_lost, 1) for m in found]
            minutes = sum(m.duration for m in found) / 60
            rows.append((condition.name, condition.title, study.protocol.tasks[task].title,
                         str(len(found)), f"{minutes:.1f}", *shares, _percent(lost, 2),
                         _percent([m.images_missed for m in found])))  # fmt: skip
    return html_table(head, rows)


def _percent(shares: Sequence[float], digits: int = 1) -> str:
    known = np.array([s for s in shares if np.isfinite(s)])
    return f"{100 * known.mean():.{digits}f}" if len(known) else "–"


def times_of(
    study: Study, trials: Sequence[JudgedTrial], condition: str, task: str
) -> dict[str, Array]:
    """Durations in s of a timed task's accepted trials, by participant in order of runs."""
    found: dict[str, list[float]] = {}
    for j in trials:
        if j.state == ACCEPTED and (j.step.condition, j.step.task) == (condition, task):
            found.setdefault(j.step.participant, []).append(j.verdict.measured.duration)
    return {participant: np.array(times) for participant, times in found.items()}


def _times(study: Study, trials: Sequence[JudgedTrial]) -> str:
    rows = []
    for condition in study.protocol.conditions.values():
        for task in condition.tasks:
            if not study.protocol.tasks[task].is_timed:
                continue
            times = times_of(study, trials, condition.name, task)
            means = np.array([t.mean() for t in times.values()])
            for participant, t in times.items():
                each = ", ".join(f"{x:.1f}" for x in t)
                rows.append((condition.name, task, participant, each, f"{t.mean():.2f}", ""))
            if len(means):
                sd = f"{means.std(ddof=1):.2f}" if len(means) > 1 else "–"
                rows.append((condition.name, task, "all", "", f"{means.mean():.2f}", sd))
    head = ("condition", "task", "participant", "trials, s", "mean s", "SD between participants s")
    return html_table(head, rows) if rows else ""


def _trials(trials: Sequence[JudgedTrial]) -> str:
    head = ("trial", "", "tries", "s", "tracked %", "measured %", "packets/s", "lost", "images/s",
            "findings")  # fmt: skip
    rows = []
    for j in trials:
        m = j.verdict.measured
        rows.append((j.step.name, j.state, str(j.tries), f"{m.duration:.1f}",
                     _percent([m.tracked]), _percent([m.measured]), f"{m.packet_rate:.1f}",
                     str(m.packets_lost), f"{m.image_rate:.1f}",
                     " ".join(str(f) for f in j.verdict.findings)))  # fmt: skip
    return html_table(head, rows)


def _definitions(study: Study) -> str:
    p = study.protocol
    return (
        '<p class="note">Shares are means over accepted trials. <i>Tracked</i>: share of the time '
        "in which the hand was found; <i>measured</i>, <i>inferred</i>, <i>lost</i>: shares of all "
        "keypoints and instants. <i>Tries</i> include repeated and interrupted recordings. "
        f"Order of conditions: {p.order}, seed {p.seed}. Glovetrack {__version__}.</p>"
    )


# ---- parts that other extensions write


def touch_lines(study: Study, folder: Path) -> Iterator[tuple[str, str]]:
    """Writes the report of each accepted touch test into ``folder`` by the command ``touch-test``;
    yields its trial and its quotable line, or why there is none."""
    for one in study.accepted():
        if study.protocol.tasks[one.step.task].kind != "touch":
            continue
        page = folder / f"{one.step.name}_touch.html"
        numbers = page.with_suffix(".json")
        try:
            run_command("touch-test", str(one.path), "-o", str(page), "--json", str(numbers))
            yield one.step.name, str(json.loads(numbers.read_text("utf-8"))["line"])
        except GlovetrackError as error:
            yield one.step.name, str(error)


def write_movement(study: Study, page: Path) -> None:
    """Writes the report of movements of all accepted trials by the command ``report``. Raises
    ConfigError without that extension."""
    sessions = [str(one.path) for one in study.accepted()]
    run_command("report", *sessions, "-o", str(page))


def run_command(name: str, *arguments: str) -> None:
    """Runs a command of another extension, replacing existing files, without its output. Raises
    ConfigError if that extension is not installed, GlovetrackError if the command fails."""
    command = COMMANDS.get(name)
    parser = argparse.ArgumentParser()
    command.fill(parser)
    with contextlib.redirect_stdout(io.StringIO()):
        command.start(parser.parse_args([*arguments, "--force"]))
