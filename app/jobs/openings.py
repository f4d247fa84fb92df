"""Resources opened and closed by name in jobs; only the newest request for each name is
executed."""

from __future__ import annotations

import threading
from collections import Counter, defaultdict
from collections.abc import Callable
from functools import partial
from typing import Generic, Protocol, TypeVar

from app.platform.tasks import JobProgress, TaskOwner
from tracker.base.callbacks import ignore


class Closable(Protocol):
    """A socket, a file, a server."""

    def close(self) -> None: ...


T = TypeVar("T", bound=Closable)


class Openings(Generic[T]):
    """``changed`` is called when the set of open resources or of problems has changed."""

    def __init__(self, tasks: TaskOwner, changed: Callable[[], None]) -> None:
        self._tasks, self._changed = tasks, changed
        self.problems: dict[str, str] = {}
        self._open: dict[str, T] = {}
        self._fresh: dict[tuple[str, int], T] = {}  # by name and number; not yet passed to ``use``
        self._jobs: Counter[str] = Counter()  # that have not ended
        self._wanted: dict[str, int] = {}  # number of the latest request for each name
        self._opening: dict[str, threading.Lock] = defaultdict(threading.Lock)
        self._stale: dict[str, list[T]] = defaultdict(list)  # to be closed by the next job

    def get(self, name: str) -> T | None:
        """The resource open under a name."""
        return self._open.get(name)

    def renew(self, name: str, title: str, make: Callable[[], T], use: Callable[[T], bool]) -> None:
        """Close the resource open under ``name``, then open the result of ``make``: in one job,
        since both may block, and the new resource may need the port of the old one. ``use`` is
        called in the window's thread; if it returns False, the resource is closed. A request that
        a newer one follows opens nothing, or is closed before the newer one opens anything."""
        self._replace(name, title, make, use)

    def close(self, name: str, title: str) -> None:
        """Close the resource open under ``name`` in a job, as `renew` does."""
        if name in self._open or self._jobs[name]:
            self._replace(name, title, ignore, ignore)
        else:
            self._wanted[name] = self._wanted.get(name, 0) + 1
            if self.problems.pop(name, None) is not None:
                self._changed()

    def _replace(
        self, name: str, title: str, make: Callable[[], T | None], use: Callable[[T], bool | None]
    ) -> None:
        request = self._wanted[name] = self._wanted.get(name, 0) + 1
        problem = self.problems.pop(name, None)
        before = self._open.pop(name, None)

        opening, stale = self._opening[name], self._stale[name]
        if before is not None:
            stale.append(before)

        def job(progress: JobProgress) -> T | None:
            with opening:
                while stale:  # first, so that a cancelled job does not leave it open
                    stale.pop().close()
                self._close_outdated(name, request)
                progress(-1.0, name)
                made = make() if request == self._wanted[name] else None
                if made is not None:
                    self._fresh[name, request] = made
            return made

        self._jobs[name] += 1
        self._tasks.run(
            title,
            job,
            done=partial(self._opened, name, request, use),
            failed=partial(self._failed, name, request),
            ended=partial(self._end, name),
        )
        if before is not None or problem is not None:
            self._changed()

    def _opened(
        self, name: str, request: int, use: Callable[[T], bool | None], made: T | None
    ) -> None:
        """Use the resource, unless all were closed or there is a newer request, whose job closes
        it."""
        if made is None or request != self._wanted[name] or (name, request) not in self._fresh:
            return
        del self._fresh[name, request]
        if not use(made):
            made.close()
            return
        self._open[name] = made
        self._changed()

    def _end(self, name: str) -> None:
        self._jobs[name] -= 1

    def _close_outdated(self, name: str, request: int) -> None:
        """Close objects that were opened under ``name`` for an older request; called in a job."""
        for key in [k for k in list(self._fresh) if k[0] == name and k[1] < request]:
            self._fresh.pop(key).close()

    def _failed(self, name: str, request: int, text: str) -> None:
        if request == self._wanted[name]:
            self.problems[name] = text
            self._changed()

    def shut_down(self) -> None:
        """After the last job: close all resources, including those not yet in use."""
        for each in (*self._open.values(), *self._fresh.values()):
            each.close()
        self._open.clear()
        self._fresh.clear()
