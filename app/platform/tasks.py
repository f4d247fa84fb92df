"""Background jobs: plain functions with progress and cancellation, one thread each, joined by one
owner."""

from __future__ import annotations

import logging
import threading
from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QObject, Qt, Signal

from app.words import error_text, notice_text, tr
from tracker.base.callbacks import ignore
from tracker.base.damage import gather, reports
from tracker.base.errors import GlovetrackError

_log = logging.getLogger(__name__)


class Cancelled(Exception):
    """Raised inside a job after the user cancelled it."""


class JobProgress:
    """Passed to a job to report progress and to check for cancellation."""

    def __init__(self, report: Callable[[float, str], None]) -> None:
        self._report = report
        self._cancel = threading.Event()

    def __call__(self, fraction: float, text: str = "") -> None:
        """Report ``fraction`` (0..1, negative if unknown); raises Cancelled after cancellation."""
        if self._cancel.is_set():
            raise Cancelled
        self._report(fraction, text)

    def cancel(self) -> None:
        self._cancel.set()

    @property
    def cancelled(self) -> bool:
        return self._cancel.is_set()


Job = Callable[[JobProgress], Any]


class RunningJob(QObject):
    """A running job. Signals arrive in the window's thread."""

    progressed = Signal(float, str)
    done = Signal(object)
    failed = Signal(str)
    noted = Signal(str)  # a message about parts of a session that were skipped
    ended = Signal()

    def __init__(self, title: str, job: Job) -> None:
        super().__init__()
        self.title = title
        self._job = job
        self._progress = JobProgress(self.progressed.emit)
        self._thread = threading.Thread(target=self._run, name=f"glovetrack-task {title}")

    def start(self) -> None:
        self._thread.start()

    def cancel(self) -> None:
        self._progress.cancel()

    def join(self, timeout: float | None = None) -> None:
        self._thread.join(timeout)

    @property
    def is_running(self) -> bool:
        return self._thread.is_alive()

    def _run(self) -> None:
        try:
            with gather() as left_out:
                result = self._job(self._progress)
        except Cancelled:
            pass  # requested by the user: only `ended` is emitted
        except GlovetrackError as error:
            self.failed.emit(error_text(error))
        except Exception as error:  # noqa: BLE001 - a job's crash must reach the window, whatever it is
            _log.exception("%s failed", self.title)
            self.failed.emit(
                tr("{} failed: {}: {}").format(self.title, type(error).__name__, error)
            )
        else:
            for what in reports(left_out):
                self.noted.emit(notice_text(what))
            self.done.emit(result)
        self.ended.emit()


class TaskOwner(QObject):
    """Starts, lists, cancels and joins jobs."""

    changed = Signal()
    failed = Signal(str)
    noted = Signal(str)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._tasks: list[RunningJob] = []

    @property
    def tasks(self) -> tuple[RunningJob, ...]:
        return tuple(self._tasks)

    def run(
        self,
        title: str,
        job: Job,
        done: Callable[[Any], None] = ignore,
        ended: Callable[[], None] = ignore,
        progressed: Callable[[float, str], None] = ignore,
        failed: Callable[[str], None] = ignore,
    ) -> RunningJob:
        """Run ``job`` in its own thread. In this thread, ``progressed`` is called with its
        progress, ``done`` with its result or ``failed`` with a message, and ``ended`` in any case:
        all are connected before the job starts."""
        # Not a child of the owner: an object connected to a task may have the last reference to the
        # owner, whose deletion would delete the task a second time, during its own deletion.
        task = RunningJob(title, job)
        task.progressed.connect(progressed, Qt.ConnectionType.QueuedConnection)
        task.failed.connect(failed, Qt.ConnectionType.QueuedConnection)
        task.ended.connect(ended, Qt.ConnectionType.QueuedConnection)
        task.done.connect(done, Qt.ConnectionType.QueuedConnection)
        task.failed.connect(self.failed, Qt.ConnectionType.QueuedConnection)
        task.noted.connect(self.noted, Qt.ConnectionType.QueuedConnection)
        task.ended.connect(lambda: self._forget(task), Qt.ConnectionType.QueuedConnection)
        self._tasks.append(task)
        task.start()
        self.changed.emit()
        return task

    def _forget(self, task: RunningJob) -> None:
        if task in self._tasks:
            task.join()
            self._tasks.remove(task)
            task.deleteLater()
            self.changed.emit()

    def shut_down(self) -> None:
        """Cancel all jobs and wait for them."""
        for task in self._tasks:
            task.cancel()
        for task in self._tasks:
            task.join()
        self._tasks.clear()


class LatestJob(QObject):
    """Runs short jobs, of which only the newest counts; they are not listed.

    One job runs at a time. A job that is superseded before it starts is never run, and the result
    of an outdated job is dropped, so that `done` receives only the newest.
    """

    failed = Signal(str)

    def __init__(self, title: str, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._title = title
        self._owner = TaskOwner(self)
        self._owner.failed.connect(self.failed)
        self._waiting: tuple[Job, Callable[[Any], None]] | None = None
        self._busy = False
        self._done: Callable[[Any], None] = ignore  # callback of the running job, while wanted

    def run(self, job: Job, done: Callable[[Any], None]) -> None:
        """Schedule a job and return. ``done`` receives the result in this thread, unless it is
        outdated."""
        self.forget()
        self._waiting = job, done
        if not self._busy:
            self._begin()

    @property
    def is_busy(self) -> bool:
        """Whether a job is running."""
        return self._busy

    def forget(self) -> None:
        """Discard the result of the running job."""
        self._waiting, self._done = None, ignore

    def _begin(self) -> None:
        if self._waiting is None:
            return
        (job, self._done), self._waiting = self._waiting, None
        self._busy = True
        self._owner.run(self._title, job, self._answer, self._ended)

    def _answer(self, result: Any) -> None:
        """One job runs at a time, so the result belongs to the current callback, if any."""
        self._done(result)

    def _ended(self) -> None:
        self._busy = False
        self._begin()

    def shut_down(self) -> None:
        """Discard, and wait for the running job."""
        self.forget()
        self._owner.shut_down()
