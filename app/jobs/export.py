"""Exports: the request, the job, and a queue that runs one export at a time."""

from __future__ import annotations

from collections.abc import Callable, Collection
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from app.platform.subprocess_job import run_in_subprocess
from app.platform.tasks import Job, JobProgress, RunningJob, TaskOwner
from app.viewmodels.states import BAD, GOOD, IDLE, SKY, StateLook
from app.words import mark
from tracker.base.files import free_path
from tracker.messages import Estimate
from tracker.session.export.options import ExportOptions
from tracker.session.reader import SessionReader

WAITING = StateLook(IDLE.colour, "◌", mark("waiting"))
RUNNING = StateLook(SKY, "▶", mark("running"))
DONE = StateLook(GOOD.colour, GOOD.sign, mark("done"))
FAILED = StateLook(BAD.colour, BAD.sign, mark("failed"))
CANCELLED = StateLook(IDLE.colour, IDLE.sign, mark("cancelled"))


@dataclass(frozen=True)
class ExportRequest:
    """Source, format, target and options. ``part``: from and to in s of the replay; None for the
    whole session."""

    source: Path
    form: str
    target: Path
    part: tuple[float, float] | None = None
    options: ExportOptions = field(default_factory=ExportOptions)
    also: tuple[Path, ...] = ()  # further sessions of a data set


def free_target(folder: Path, source: Path, form: str, taken: Collection[Path] = ()) -> Path:
    """A file named after the session, with a number if that exists: files are never overwritten.

    ``taken``: targets of other exports in the queue.
    """
    wanted = target = folder / f"{source.stem}.{form}"
    n = 1
    while free_path(target) != target or target in taken:
        n += 1
        target = wanted.with_name(f"{wanted.stem}_{n}{wanted.suffix}")
    return target


def export_job(request: ExportRequest) -> Job:
    """A job that writes the file; leaves no file if cancelled."""

    def run(progress: JobProgress) -> Path:
        progress(0.0, request.form)
        run_in_subprocess("export", partial(_export, request), progress)
        return request.target

    return run


def _export(request: ExportRequest, progress: Callable[..., None]) -> None:
    from tracker.session.export.run import export, export_dataset  # deferred: loads every format

    options = _options(request)
    if request.also:
        sources = [request.source, *request.also]
        export_dataset(sources, request.form, request.target, options, progress)
    else:
        export(request.source, request.form, request.target, options, progress)


def _options(request: ExportRequest) -> ExportOptions:
    """Converts the part: export times start at the first estimate, replay times at the start."""
    if request.part is None:
        return request.options
    first = _first_estimate(request.source)
    start, stop = request.part
    return replace(request.options, start=max(0.0, start - first), stop=max(0.0, stop - first))


def _first_estimate(path: Path) -> float:
    """Replay time of the first estimate, s; 0 without one."""

    with SessionReader(path) as reader:
        start = reader.anchor.monotonic(reader.span_ns[0])
        return next((m.t - start for m in reader.messages((Estimate,))), 0.0)


@dataclass(eq=False)
class QueueItem:
    """An export in the queue."""

    request: ExportRequest
    look: StateLook = WAITING
    share: float = 0.0
    problem: str = ""
    task: RunningJob | None = field(default=None, repr=False)

    @property
    def open(self) -> bool:
        """Waiting or running."""
        return self.look in (WAITING, RUNNING)


class ExportQueue(QObject):
    """Runs one export at a time: two would only wait for the same disk."""

    changed = Signal()

    def __init__(self, tasks: TaskOwner, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._tasks = tasks
        self.items: list[QueueItem] = []

    def add(self, request: ExportRequest) -> QueueItem:
        item = QueueItem(request)
        self.items.append(item)
        self._go_on()
        return item

    def cancel(self, item: QueueItem) -> None:
        """Remove a waiting export from the queue, or stop a running one."""
        if item.task is not None:
            item.task.cancel()
        elif item.look == WAITING:
            item.look = CANCELLED
            self.changed.emit()

    def forget_ended(self) -> None:
        self.items = [i for i in self.items if i.open]
        self.changed.emit()

    def _go_on(self) -> None:
        self.changed.emit()
        if any(i.look == RUNNING for i in self.items):
            return
        item = next((i for i in self.items if i.look == WAITING), None)
        if item is None:
            return
        item.look = RUNNING
        item.task = self._tasks.run(
            self.tr("Exporting {}").format(item.request.target.name),
            export_job(item.request),
            done=lambda _path: self._settle(item, DONE),
            ended=lambda: self._ended(item),
            progressed=lambda share, _text: self._progressed(item, share),
            failed=lambda text: self._settle(item, FAILED, text),
        )
        self.changed.emit()

    def _progressed(self, item: QueueItem, share: float) -> None:
        item.share = min(max(share, 0.0), 1.0)
        self.changed.emit()

    def _settle(self, item: QueueItem, look: StateLook, problem: str = "") -> None:
        item.look, item.problem = look, problem

    def _ended(self, item: QueueItem) -> None:
        """An export that neither succeeded nor failed was cancelled."""
        item.task = None
        if item.look == RUNNING:
            item.look = CANCELLED
        self._go_on()
