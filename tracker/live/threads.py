"""Threads that repeat a step until they are stopped; one that fails is logged and reported."""

from __future__ import annotations

import logging
import threading
import time
from collections.abc import Callable, Mapping

from tracker.base.channels import Closed
from tracker.base.errors import GlovetrackError
from tracker.base.notices import Notice, failure
from tracker.base.urgency import run_soon

_log = logging.getLogger(__name__)


class ThreadGroup:
    """``report`` receives a kind and a notice when a thread fails. Methods are for one owner.

    ``turn`` is called with a thread's name before each of its steps, in that thread: it may delay
    threads, as an overloaded computer does.
    """

    def __init__(
        self, report: Callable[[str, Notice], None], turn: Callable[[str], None] = lambda name: None
    ) -> None:
        self._report, self._turn = report, turn
        self._stopping = threading.Event()
        self._threads: dict[str, threading.Thread] = {}
        self.failure: Notice | None = None
        """What ended the first thread that failed; None while all run."""

    @property
    def stopping(self) -> bool:
        """Whether `request_stop` was called."""
        return self._stopping.is_set()

    def start(self, name: str, step: Callable[[], None], soon: bool = False) -> None:
        """Repeat ``step``, which waits for its work a moment at most, in a thread of this name;
        ``soon``: its work is short and cannot wait."""
        thread = threading.Thread(
            target=self._run, args=(name, step, soon), name=f"glovetrack-{name}", daemon=True
        )
        self._threads[name] = thread
        thread.start()

    def request_stop(self) -> None:
        """No further step begins."""
        self._stopping.set()

    def join(self, release: Mapping[str, Callable[[], None]], timeout: float) -> list[str]:
        """Waits for the last steps and for ``release``, by a thread's name, to free its device.

        Either may hang in a driver, so a device is released in a thread of its own, after the
        thread that used it has ended. Returns the names of those that take longer than
        ``timeout`` s; they continue in the background. May be called again.
        """
        ends = dict(self._threads)
        self._threads.clear()
        for name, free in release.items():
            ends[name] = threading.Thread(
                target=_free_after,
                args=(ends.get(name), free, name),
                name=f"glovetrack-free-{name}",
                daemon=True,
            )
            ends[name].start()
        until = time.monotonic() + timeout
        for thread in ends.values():
            thread.join(max(until - time.monotonic(), 0.0))
        late = [name for name, thread in ends.items() if thread.is_alive()]
        for name in late:
            _log.warning("%s does not end within %.1f s and is left behind", name, timeout)
        return late

    def _run(self, name: str, step: Callable[[], None], soon: bool) -> None:
        _log.info("The %s thread has started", name)
        if soon:
            run_soon()
        try:
            while not self._stopping.is_set():
                self._turn(name)
                step()
        except Closed:
            return
        except GlovetrackError as error:
            _log.error("The %s thread has ended: %s", name, error, exc_info=True)
            self._fail(error.notice)
        except Exception as error:  # noqa: BLE001 - the last line of defence of a thread
            _log.exception("The %s thread failed", name)
            kind = type(error).__name__
            self._fail(failure("thread.failed", thread=name, type=kind, why=str(error)))

    def _fail(self, why: Notice) -> None:
        self.failure = self.failure or why
        self._report("error", why)


def _free_after(thread: threading.Thread | None, free: Callable[[], None], name: str) -> None:
    if thread is not None:
        thread.join()
    try:
        free()
    except Exception:  # noqa: BLE001 - a driver may fail in any way
        _log.exception("%s could not be closed", name)
