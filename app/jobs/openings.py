"""What is opened and closed by its name, in jobs: only the newest wish for each name counts."""

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
    """``changed`` is called whenever what is open, or why it is not, has changed."""

    def __init__(self, tasks: TaskOwner, changed: Callable[[], None]) -> None:
        self._tasks, self._changed = tasks, changed
        self.problems: dict[str, str] = {}
        self._open: dict[str, T] = {}
        self._fresh: list[T] = []  # open, and not yet taken over
        self._wanted: dict[str, int] = {}  # number of the latest wish for each name

    def get(self, name: str) -> T | None:
        """What is open under a name."""
        return self._open.get(name)

    def renew(
        self, name: str, title: str, make: Callable[[], T] | None, use: Callable[[T], bool]
    ) -> None:
        """Close what is open under ``name``, then open what ``make`` gives: one job, since both may
        wait, and what is opened may need what is closed (a port). ``use`` hears of it in the
        window's thread; what it refuses is closed."""
        wish = self._wanted[name] = self._wanted.get(name, 0) + 1
        self.problems.pop(name, None)
        before = self._open.pop(name, None)

        def job(progress: JobProgress) -> T | None:
            if before is not None:  # first, lest a job that is cancelled leave it open
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
        """Take it over, unless something else is wanted by now, or all was closed."""
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
        """After the last job: close what is open, and what was opened and nobody took."""
        for each in (*self._open.values(), *self._fresh):
            each.close()
        self._open.clear()
        self._fresh.clear()
