"""A study's protocol file: participants, conditions, tasks with their cues, and what a trial needs.

Labels of participants, conditions and tasks consist of letters and digits, as BIDS requires.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path

from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.base.toml_reader import TomlTable, read_text, read_toml, texts
from tracker.hand.names import SIDES

ORDERS = ("latin", "random", "fixed")
KINDS = ("cues", "touch")
PICTURES = (".png", ".jpg", ".jpeg", ".svg")
MOST_PARTICIPANTS = 500
_LABEL = re.compile(r"[A-Za-z0-9]{1,32}")
_HOUR = 3600.0


@dataclass(frozen=True)
class Task:
    """What a participant does in a trial. Times in s.

    ``kind``: ``cues`` are shown one after another, or the ``touch`` test of the window. A
    ``duration`` of 0 means that the trial lasts until the experimenter ends it, at most
    ``longest``. ``things``: objects of which ``things_drawn`` are taken in turn, with ``take``
    seconds to take each. A cue is a text, or a picture's path relative to the protocol file.
    """

    name: str
    title: str
    instruction: str
    kind: str = "cues"
    duration: float = 60.0
    longest: float = 300.0
    practice_duration: float = 15.0
    cues: tuple[str, ...] = ()
    cue_every: float = 3.0
    cue_order: str = "random"
    things: tuple[str, ...] = ()
    things_drawn: int = 0
    take: float = 10.0

    @property
    def is_timed(self) -> bool:
        """Whether the time until the experimenter ends the trial is a result."""
        return self.kind == "cues" and self.duration == 0


@dataclass(frozen=True)
class Condition:
    """A part of the study, in the order of the participant: its tasks, each for ``trials`` trials
    after ``practice`` trials that are not recorded."""

    name: str
    title: str
    instruction: str
    tasks: tuple[str, ...]
    task_order: str = "random"
    trials: int = 1
    practice: int = 0


@dataclass(frozen=True)
class TrialLimits:
    """What a trial needs to be accepted: shares 0..1 and rates in Hz; 0 (or 1 of what is allowed)
    for no requirement."""

    duration: float = 0.95  # share of the planned one
    tracked: float = 0.8  # share of the time
    measured: float = 0.0  # share of keypoints and instants
    packets_lost: float = 0.02
    packet_rate: float = 50.0
    images_missed: float = 0.2
    image_rate: float = 0.0


@dataclass(frozen=True)
class Protocol:
    """A study. ``order`` is that of the conditions; ``tries``: how often a trial can be recorded
    before it counts as failed without a decision of the experimenter. Times in s."""

    name: str
    title: str
    seed: int
    participants: tuple[str, ...]
    conditions: Mapping[str, Condition]
    tasks: Mapping[str, Task]
    order: str = "latin"
    hand: str = "right"
    countdown: float = 3.0
    rest: float = 20.0
    rest_between_conditions: float = 120.0
    tries: int = 3
    limits: TrialLimits = field(default_factory=TrialLimits)

    @property
    def pictures(self) -> tuple[str, ...]:
        """Relative paths of all pictures that are cues."""
        shown = (cue for task in self.tasks.values() for cue in task.cues if is_picture(cue))
        return tuple(dict.fromkeys(shown))


def is_picture(cue: str) -> bool:
    """Whether a cue is a picture's path rather than a text."""
    return cue.lower().endswith(PICTURES)


def load_protocol(path: Path) -> tuple[Protocol, str]:
    """The protocol and the text of its file. Raises FileError, which names file, line and key."""
    text = read_text(path)
    protocol = parse_protocol(text, str(path))
    root = read_toml(text, str(path))
    for cue in protocol.pictures:
        if Path(cue).is_absolute() or ".." in Path(cue).parts:
            raise root.fail("tasks", notice("study.picture_outside", picture=cue))
        if not (path.parent / cue).is_file():
            raise root.fail("tasks", notice("study.picture_missing", picture=cue))
    return protocol, text


def parse_protocol(text: str, name: str = "protocol.toml") -> Protocol:
    """The protocol of a TOML text; ``name`` is that of the file in messages. Raises FileError."""
    root = read_toml(text, name)
    study = root.table("study")
    tasks = {label: _task(label, table) for label, table in _labelled(root, "tasks").items()}
    conditions = {
        label: _condition(label, table, tasks)
        for label, table in _labelled(root, "conditions").items()
    }
    if not conditions:
        raise root.fail("conditions", notice("study.no_condition"))
    used = {task for condition in conditions.values() for task in condition.tasks}
    for unused in tasks.keys() - used:
        raise root.table("tasks").fail(unused, notice("study.task_unused"))
    protocol = Protocol(
        name=_label(study, "name"),
        title=study.text("title"),
        seed=study.integer("seed", 0),
        participants=_participants(study),
        conditions=conditions,
        tasks=tasks,
        order=study.text("order", "latin", ORDERS),
        hand=study.text("hand", "right", (*SIDES, "both")),
        countdown=study.number("countdown", 3.0, 0.0, 60.0),
        rest=study.number("rest", 20.0, 0.0, _HOUR),
        rest_between_conditions=study.number("rest_between_conditions", 120.0, 0.0, _HOUR),
        tries=_count(study, "tries", 3, 1, 20),
        limits=_limits(root.table("verdict", {})),
    )
    study.finish()
    root.finish()
    return protocol


def _labelled(root: TomlTable, key: str) -> dict[str, TomlTable]:
    found = root.tables(key)
    for label in found:
        if not _LABEL.fullmatch(label):
            raise root.table(key).fail(label, notice("study.label", label=label))
    return found


def _label(table: TomlTable, key: str) -> str:
    value = table.text(key)
    if not _LABEL.fullmatch(value):
        raise table.fail(key, notice("study.label", label=value))
    return value


def _participants(study: TomlTable) -> tuple[str, ...]:
    """``P01``… for a number, or the labels of a list."""
    if not study.has("participants"):
        raise study.fail("participants", notice("study.participants"))
    try:
        study.integer("participants")
    except FileError:
        return _listed(study)
    count = _count(study, "participants", ..., 1, MOST_PARTICIPANTS)
    digits = max(2, len(str(count)))
    return tuple(f"P{k:0{digits}}" for k in range(1, count + 1))


def _listed(study: TomlTable) -> tuple[str, ...]:
    labels = texts(study, "participants")
    for label in labels:
        if not _LABEL.fullmatch(label):
            raise study.fail("participants", notice("study.label", label=label))
    if len(set(labels)) != len(labels):
        raise study.fail("participants", notice("toml.twice"))
    return labels


def _count(table: TomlTable, key: str, default: object, low: int, high: int) -> int:
    value = table.integer(key, default)
    if not low <= value <= high:
        raise table.fail(key, notice("toml.range", value=value, low=low, high=high))
    return value


def _condition(label: str, table: TomlTable, tasks: Mapping[str, Task]) -> Condition:
    names = texts(table, "tasks")
    for task in names:
        if task not in tasks:
            known = ", ".join(tasks) or "none"
            raise table.fail("tasks", notice("study.unknown_task", task=task, known=known))
    if len(set(names)) != len(names):
        raise table.fail("tasks", notice("study.task_twice"))
    condition = Condition(
        name=label,
        title=table.text("title"),
        instruction=table.text("instruction") if table.has("instruction") else "",
        tasks=names,
        task_order=table.text("task_order", "random", ("random", "fixed")),
        trials=_count(table, "trials", 1, 1, 100),
        practice=_count(table, "practice", 0, 0, 20),
    )
    table.finish()
    return condition


def _task(label: str, table: TomlTable) -> Task:
    task = Task(
        name=label,
        title=table.text("title"),
        instruction=table.text("instruction"),
        kind=table.text("kind", "cues", KINDS),
        duration=table.number("duration", 60.0, 0.0, _HOUR),
        longest=table.number("longest", 300.0, 1.0, _HOUR),
        practice_duration=table.number("practice_duration", 15.0, 1.0, _HOUR),
        cues=texts(table, "cues") if table.has("cues") else (),
        cue_every=table.number("cue_every", 3.0, 0.5, _HOUR),
        cue_order=table.text("cue_order", "random", ("random", "fixed")),
        things=texts(table, "things") if table.has("things") else (),
        things_drawn=_count(table, "things_drawn", 0, 0, 100),
        take=table.number("take", 10.0, 0.0, 600.0),
    )
    if task.things_drawn > len(task.things):
        count = len(task.things)
        raise table.fail(
            "things_drawn", notice("study.things_drawn", drawn=task.things_drawn, count=count)
        )
    if task.things and not task.things_drawn:
        raise table.fail("things", notice("study.things_undrawn"))
    if task.things and task.is_timed:
        raise table.fail("things", notice("study.no_duration"))
    if task.things and task.duration <= task.things_drawn * task.take:
        raise table.fail("take", notice("study.no_time"))
    table.finish()
    return task


def _limits(table: TomlTable) -> TrialLimits:
    usual = TrialLimits()
    shares = ("duration", "tracked", "measured", "packets_lost", "images_missed")
    found = {key: table.number(key, getattr(usual, key), 0.0, 1.0) for key in shares}
    for key in ("packet_rate", "image_rate"):
        found[key] = table.number(key, getattr(usual, key), 0.0, 10_000.0)
    table.finish()
    return TrialLimits(**found)
