"""Resources opened and closed by name in jobs; only the newest request for each name is
executed."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Generic, Protocol, TypeVar

from app.platform.tasks import JobProgress, TaskOwner


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
        self._fresh: list[T] = []  # open, but not yet passed to ``use``
        self._wanted: dict[str, int] = {}  # number of the latest request for each name

    def get(self, name: str) -> T | None:
        """The resource open under a name."""
        return self._open.get(name)

    def renew(
        self, name: str, title: str, make: Callable[[], T] | None, use: Callable[[T], bool]
    ) -> None:
        """Close the resource open under ``name``, then open the result of ``make``: in one job,
        since both may block, and the new resource may need the port of the old one. ``use`` is
        called in the window's thread; if it returns False, the resource is closed."""
        wish = self._wanted[name] = self._wanted.get(name, 0) + 1
        self.problems.pop(name, None)
        before = self._open.pop(name, None)

        def job(progress: JobProgress) -> T | None:
            if before is not None:  # first, so that a cancelled job does not leave it open
                before.close()
            progress(-1.0, name)
            if make is None:
                return None
            made = make()
            self._fresh.append(made)
            return made

        if before is not None or make is not None:
            done = partial(self._opened, name, wish, use)
            self._tasks.run(title, job, done=done, failed=partial(self._failed, name, wish))
        self._changed()

    def _opened(self, name: str, wish: int, use: Callable[[T], bool], made: T | None) -> None:
        """Use the resource, unless there is a newer request or all were closed."""
        if made is None or made not in self._fresh:
            return
        self._fresh.remove(made)
        if wish != self._wanted[name] or not use(made):
            made.close()
            return
        self._open[name] = made
        self._changed()

    def _failed(self, name: str, wish: int, text: str) -> None:
        if wish == self._wanted[name]:
            self.problems[name] = text
            self._changed()

    def shut_down(self) -> None:
        """After the last job: close all resources, including those not yet in use."""
        for each in (*self._open.values(), *self._fresh):
            each.close()
        self._open.clear()
        self._fresh.clear()
