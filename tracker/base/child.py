"""A child process for one job, with a pipe to it."""

from __future__ import annotations

import contextlib
import io
import multiprocessing as mp
import pickle
import sys
import threading
from collections.abc import Callable, Iterator
from multiprocessing.connection import Connection
from multiprocessing.process import BaseProcess
from types import FunctionType, ModuleType
from typing import Any

from tracker.base.numeric_threads import limit_this_process
from tracker.base.urgency import run_as_others


def start_child(
    name: str, serve: Callable[..., object], *args: Any, daemon: bool = True
) -> tuple[Connection, BaseProcess]:
    """Starts a process that runs ``serve(its end, *args)``; returns our end of the pipe and it.

    The process is spawned, since a fork would copy locks that threads hold. It does not import the
    program's main module, unless ``serve`` or ``args`` come from it: that could take seconds, and
    run a script without ``if __name__ == "__main__":`` again. It is stopped at the
    end of this one, unless ``daemon`` is false: then it may have processes of its own, and ends by
    itself when its pipe is closed.
    Its end of the pipe is closed here, so that ours reports when the process has ended.
    """
    context = mp.get_context("spawn")
    ours, theirs = context.Pipe()
    process = context.Process(target=_run, args=(serve, theirs, *args), name=name, daemon=daemon)
    with contextlib.nullcontext() if _is_from_main(serve, args) else _without_main():
        process.start()
    theirs.close()
    return ours, process


def _run(serve: Callable[..., object], *args: Any) -> None:
    run_as_others()
    limit_this_process()
    serve(*args)


class _Unseen(ModuleType):
    """The main module, for others than the one who would import it in a child."""

    def __init__(self, main: ModuleType) -> None:
        super().__init__("__main__")
        self._main = main

    def __getattr__(self, name: str) -> Any:
        if name == "__file__":
            raise AttributeError(name)
        return getattr(self._main, name)


_SWAPPED = threading.Lock()


@contextlib.contextmanager
def _without_main() -> Iterator[None]:
    """A child that is started meanwhile does not know which module or file is the main one."""
    with _SWAPPED:
        main = sys.modules["__main__"]
        sys.modules["__main__"] = _Unseen(main)
        try:
            yield
        finally:
            sys.modules["__main__"] = main


class _Origins(pickle.Pickler):
    """Notices functions and classes of the main module."""

    has_main = False

    def reducer_override(self, obj: Any) -> Any:
        if isinstance(obj, Connection):
            return int, ()  # can only be pickled while a process is started
        if isinstance(obj, (type, FunctionType)) and obj.__module__ == "__main__":
            self.has_main = True
        return NotImplemented


def _is_from_main(*parts: object) -> bool:
    """Whether a child needs the main module for these; also if that is unknown."""
    origins = _Origins(io.BytesIO())
    try:
        origins.dump(parts)
    except (pickle.PicklingError, AttributeError, TypeError, RuntimeError):
        return True
    return origins.has_main
