"""The order of a participant's steps: counterbalanced or random by the protocol's seed.

Shuffling sorts by digests (SHA-256) of seed and item: the same on every computer and with every
version of Python and NumPy.
"""

from __future__ import annotations

import hashlib
import itertools
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TypeVar

from extensions.study.protocol import Condition, Protocol, Task

T = TypeVar("T")
PRACTICE, TRIAL, REST = "practice", "trial", "rest"


@dataclass(frozen=True)
class Cue:
    """What is shown from ``t`` s of the trial on: a text, or a picture's path."""

    t: float
    what: str


@dataclass(frozen=True)
class ScheduleStep:
    """A step of a participant: a trial, a practice trial, which is not recorded, or a rest.

    ``name`` is unique for the participant and, of a trial, the name of its file, made of BIDS
    entities. ``duration`` s; 0: until the experimenter ends it. ``run`` counts the trials of a task
    in a condition from 1.
    """

    kind: str
    name: str
    participant: str
    condition: str = ""
    task: str = ""
    run: int = 0
    duration: float = 0.0
    cues: tuple[Cue, ...] = ()


def steps_of(protocol: Protocol, participant: str) -> tuple[ScheduleStep, ...]:
    """All steps of one of the protocol's participants, in order; the same each time."""
    steps: list[ScheduleStep] = []
    for number, label in enumerate(condition_order(protocol, participant)):
        condition = protocol.conditions[label]
        if number and protocol.rest_between_conditions:
            steps.append(_rest(participant, len(steps), protocol.rest_between_conditions))
        trials = [*_practice(protocol, participant, condition)]
        for k, trial in enumerate(_trials(protocol, participant, condition)):
            if k and protocol.rest:
                trials.append(_rest(participant, len(steps) + len(trials), protocol.rest))
            trials.append(trial)
        steps += trials
    return tuple(steps)


def condition_order(protocol: Protocol, participant: str) -> tuple[str, ...]:
    """Labels of the conditions in the participant's order.

    ``latin``: rows of a Williams square, in which each condition has each position and follows
    each other condition equally often; participants get the rows in random order, block by block.
    ``random``: independent permutations. ``fixed``: as in the file.
    """
    labels = list(protocol.conditions)
    if protocol.order == "fixed":
        return tuple(labels)
    if protocol.order == "random":
        return tuple(shuffled(labels, protocol.seed, "conditions", participant))
    mixed = shuffled(labels, protocol.seed, "labels")
    rows = williams(len(mixed))
    number = protocol.participants.index(participant)
    block, place = divmod(number, len(rows))
    row = shuffled(rows, protocol.seed, "rows", str(block))[place]
    return tuple(mixed[i] for i in row)


def williams(n: int) -> list[tuple[int, ...]]:
    """Rows of a Williams square of n treatments: n rows if n is even, 2 n if it is odd."""
    first = [0]
    for k in range(1, n):
        first.append((k + 1) // 2 if k % 2 else n - k // 2)
    rows = [tuple((i + shift) % n for i in first) for shift in range(n)]
    return rows if n % 2 == 0 or n == 1 else [*rows, *(row[::-1] for row in rows)]


def shuffled(items: Sequence[T], seed: int, *about: str) -> list[T]:
    """The items in an order that depends only on the seed and the texts."""
    return [items[i] for i in sorted(range(len(items)), key=lambda i: digest(seed, *about, str(i)))]


def digest(seed: int, *about: str) -> int:
    """A number of 64 bits that depends only on the seed and the texts."""
    text = "\x1f".join([str(seed), *about])
    return int.from_bytes(hashlib.sha256(text.encode()).digest()[:8], "big")


def cues_of(task: Task, duration: float, seed: int, *about: str) -> tuple[Cue, ...]:
    """The cues of a trial of that duration (s; 0: as long as it may last)."""
    end = duration or task.longest
    if not task.things:
        return tuple(_cues(task, 0.0, end, seed, *about))
    each = end / task.things_drawn
    out: list[Cue] = []
    for k, thing in enumerate(shuffled(task.things, seed, "things", *about)[: task.things_drawn]):
        begin = k * each
        out.append(Cue(begin, thing))
        out += _cues(task, begin + task.take, begin + each, seed, *about, thing)
    return tuple(out)


def _cues(task: Task, begin: float, end: float, seed: int, *about: str) -> Iterator[Cue]:
    """Cues in rounds, each of which has every cue once; none is shown twice in succession."""
    if not task.cues:
        return
    last = ""
    count = 0
    for turn in itertools.count():
        order = list(task.cues)
        if task.cue_order == "random":
            order = shuffled(order, seed, "cues", *about, str(turn))
        if order[0] == last and len(order) > 1:
            order.append(order.pop(0))
        for what in order:
            t = begin + count * task.cue_every
            if t >= end - 1e-9:
                return
            yield Cue(t, what)
            last, count = what, count + 1


def _trials(protocol: Protocol, participant: str, condition: Condition) -> Iterator[ScheduleStep]:
    """Trials in blocks, each of which has every task once."""
    for run in range(1, condition.trials + 1):
        tasks = list(condition.tasks)
        if condition.task_order == "random":
            tasks = shuffled(tasks, protocol.seed, "tasks", participant, condition.name, str(run))
        for label in tasks:
            task = protocol.tasks[label]
            name = f"sub-{participant}_ses-{condition.name}_task-{label}_run-{run:02}"
            cues = cues_of(task, task.duration, protocol.seed, name)
            yield ScheduleStep(
                TRIAL, name, participant, condition.name, label, run, task.duration, cues
            )


def _practice(protocol: Protocol, participant: str, condition: Condition) -> Iterator[ScheduleStep]:
    for run in range(1, condition.practice + 1):
        for label in condition.tasks:
            task = protocol.tasks[label]
            if task.kind != "cues":
                continue
            name = f"practice-{condition.name}-{label}-{run:02}"
            most = task.practice_duration
            duration = 0.0 if task.is_timed else min(most, task.duration or most)
            cues = _cues(task, 0.0, duration or task.longest, protocol.seed, participant, name)
            yield ScheduleStep(
                PRACTICE, name, participant, condition.name, label, run, duration, tuple(cues)
            )


def _rest(participant: str, number: int, duration: float) -> ScheduleStep:
    return ScheduleStep(REST, f"rest-{number:03}", participant, duration=duration)
