"""A protocol and the state of a study, as lines and as plain values."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import Any

from extensions.study.folder import Study
from extensions.study.progress import ACCEPTED, FAILED, FINISHED, OPEN, Progress
from extensions.study.protocol import Protocol
from extensions.study.schedule import PRACTICE, TRIAL, ScheduleStep, condition_order, steps_of


def duration_of(protocol: Protocol, steps: tuple[ScheduleStep, ...]) -> float:
    """s; a trial that is ended manually counts with its longest duration."""
    total = 0.0
    for step in steps:
        total += step.duration
        if step.kind in (TRIAL, PRACTICE):
            task = protocol.tasks[step.task]
            total += protocol.countdown + (task.longest if step.duration == 0 else 0.0)
    return total


def lines_of_protocol(protocol: Protocol) -> Iterator[str]:
    """Participants with the order of their conditions."""
    yield f"{protocol.name}: {protocol.title}"
    first = steps_of(protocol, protocol.participants[0])
    kinds = Counter(step.kind for step in first)
    minutes = duration_of(protocol, first) / 60
    yield (
        f"{len(protocol.participants)} participants, {kinds[TRIAL]} trials each, "
        f"{kinds[PRACTICE]} practice trials, at most {minutes:.0f} min each"
    )
    for participant in protocol.participants:
        yield f"  {participant}: {', '.join(condition_order(protocol, participant))}"


def protocol_as_json(protocol: Protocol) -> dict[str, Any]:
    """The steps of all participants."""
    return {
        "name": protocol.name,
        "title": protocol.title,
        "seed": protocol.seed,
        "participants": {
            participant: {
                "conditions": list(condition_order(protocol, participant)),
                "duration_s": duration_of(protocol, steps),
                "steps": [
                    {"kind": s.kind, "name": s.name, "duration_s": s.duration} for s in steps
                ],
            }
            for participant in protocol.participants
            for steps in [steps_of(protocol, participant)]
        },
    }


def lines_of_status(study: Study) -> Iterator[str]:
    """One line per participant."""
    yield f"{study.protocol.name}: {study.protocol.title}"
    for progress in study.all_progress():
        of = counts(progress)
        line = f"  {progress.participant}: {of['accepted']} of {of['trials']} trials accepted"
        for name, words in (("repeated", "repeated"), ("interrupted", "interrupted")):
            if of[name]:
                line += f", {of[name]} {words}"
        if of["failed"]:
            line += f", {of['failed']} failed"
        step = progress.step
        yield line + (f"; next: {step.name}" if step is not None else "; finished")


def counts(progress: Progress) -> dict[str, int]:
    """Trials of a participant by their state, and tries by their outcome."""
    entries = [progress.entry(step) for step in progress.trials]
    states = Counter(entry.state for entry in entries)
    outcomes = Counter(one.outcome for entry in entries for one in entry.tries)
    return {
        "trials": len(entries),
        "accepted": states[ACCEPTED],
        "failed": states[FAILED],
        "open": len(entries) - sum(states[state] for state in FINISHED),
        "repeated": outcomes["repeated"],
        "interrupted": outcomes["interrupted"],
    }


def status_as_json(study: Study) -> dict[str, Any]:
    """All participants; ``next`` is the name of the next step, null at the end."""
    out: dict[str, Any] = {}
    for progress in study.all_progress():
        step = progress.step
        steps = {
            s.name: progress.entry(s).state
            for s in progress.steps
            if progress.entry(s).state != OPEN
        }
        out[progress.participant] = {
            **counts(progress),
            "next": None if step is None else step.name,
            "steps": steps,
        }
    return {"name": study.protocol.name, "participants": out}
