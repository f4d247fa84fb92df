"""The texts of the study's dialog, computed from its conductor; no Qt."""

from __future__ import annotations

import math
from dataclasses import dataclass

from app.words import local, notice_text, tr
from extensions.study.conductor import Conductor, TrialPhase
from extensions.study.progress import FINISHED
from extensions.study.schedule import PRACTICE, TRIAL, ScheduleStep
from extensions.study.verdict import TrialVerdict


@dataclass(frozen=True)
class ShownStep:
    """What the dialog shows. ``share`` (0..1) of the time until the next cue or the end of a
    countdown or rest; ``next_text``: of the main button, which is hidden if it is empty;
    ``can_repeat`` and ``can_exclude``: whether these buttons are shown."""

    where: str
    title: str
    cue: str
    detail: str
    share: float = 0.0
    next_text: str = ""
    can_pause: bool = False
    can_repeat: bool = False
    can_exclude: bool = False
    is_good: bool | None = None


def shown(conductor: Conductor) -> ShownStep:
    """The texts of the present phase."""
    step = conductor.step
    if step is None:
        participant = conductor.progress.participant
        return ShownStep(participant, tr("Finished"), tr("Thank you!"), tr("All trials are done."))
    where, title = where_text(conductor, step), title_of(conductor, step)
    match conductor.phase:
        case TrialPhase.READY:
            return _ready(conductor, where, title)
        case TrialPhase.COUNTDOWN:
            left = conductor.countdown_left
            whole = conductor.progress.protocol.countdown
            share = 1 - left / whole if whole else 1.0
            return ShownStep(
                where, title, f"{math.ceil(left)}", tr("Get ready"), share, can_pause=True
            )
        case TrialPhase.RUNNING:
            return _running(conductor, step, where, title)
        case TrialPhase.CHECKING:
            return ShownStep(where, title, "", tr("Checking the recording…"))
        case TrialPhase.VERDICT:
            return _verdict(conductor, where, title)
        case _:
            left = conductor.rest_left
            text = f"{int(left) // 60}:{int(left) % 60:02}"
            share = 1 - left / step.duration if step.duration else 1.0
            return ShownStep(where, tr("Rest"), text, tr("Relax the hand."), share,
                         tr("&Skip the rest"), can_pause=True)  # fmt: skip


def _ready(conductor: Conductor, where: str, title: str) -> ShownStep:
    if conductor.paused:
        return ShownStep(where, title, tr("Paused"), "", can_pause=True)
    task, step = conductor.progress.task, conductor.step
    assert task is not None and step is not None
    condition = conductor.progress.protocol.conditions[step.condition]
    detail = " ".join(text for text in (condition.instruction, task.instruction) if text)
    return ShownStep(where, title, task.title, detail, 0.0, tr("&Start"), can_pause=True)


def _running(conductor: Conductor, step: ScheduleStep, where: str, title: str) -> ShownStep:
    cue, task = conductor.cue, conductor.progress.task
    assert task is not None
    text = cue.what if cue is not None else task.title
    left = conductor.next_cue_in
    share = 0.0 if math.isinf(left) else 1 - min(left / task.cue_every, 1.0)
    by_hand = step.duration == 0
    detail = ""
    if by_hand:
        detail = tr("{:.1f} s").format(local(conductor.elapsed))
    return ShownStep(where, title, text, detail, share, tr("&Finished") if by_hand else "", True)


def _verdict(conductor: Conductor, where: str, title: str) -> ShownStep:
    verdict = conductor.verdict
    assert verdict is not None
    if verdict.is_good:
        figures = figures_text(verdict)
        return ShownStep(where, title, tr("Good"), figures, 1.0, tr("&Accept and continue"),
                     can_repeat=True, is_good=True)  # fmt: skip
    why = " ".join(notice_text(finding) for finding in verdict.findings)
    return ShownStep(where, title, tr("Not good"), why, 1.0, tr("&Accept anyway"), can_repeat=True,
                 can_exclude=True, is_good=False)  # fmt: skip


def figures_text(verdict: TrialVerdict) -> str:
    """Figures of a recording."""
    m = verdict.measured
    text = tr("{:.1f} s, tracked {:.0f} % of the time, measured {:.0f} %, inferred {:.0f} %, "
              "{} packets lost, {:.0f} images per second")  # fmt: skip
    shares = (100 * m.tracked, 100 * m.measured, 100 * m.inferred)
    return text.format(local(m.duration), *shares, m.packets_lost, m.image_rate)


def title_of(conductor: Conductor, step: ScheduleStep) -> str:
    """Condition, and whether it is practice."""
    if not step.condition:
        return ""
    title = conductor.progress.protocol.conditions[step.condition].title
    return tr("Practice: {}").format(title) if step.kind == PRACTICE else title


def where_text(conductor: Conductor, step: ScheduleStep) -> str:
    """Participant, number of the trial, and try."""
    trials = conductor.progress.trials
    number = sum(conductor.progress.entry(t).state in FINISHED for t in trials)
    text = tr("{}: {} of {} trials done").format(step.participant, number, len(trials))
    if step.kind == TRIAL and conductor.progress.tries > 1:
        text = tr("{}, try {}").format(text, conductor.progress.tries)
    return text
