"""The decorator `kernel`: which code a compiled function runs."""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import cache
from typing import Any, TypeVar, overload

from tracker.kernels import parts
from tracker.kernels.library import Library, load

MODE = "GLOVETRACK_KERNELS"
"""Environment variable. ``numba``: ignore the compiled library. ``build``: kernels as required by
the library's compiler, without numba's cache."""

F = TypeVar("F", bound=Callable[..., Any])


@overload
def kernel(function: F, /) -> F: ...


@overload
def kernel(
    *,
    fastmath: bool = False,
    inline: str = "never",
    error_model: str = "python",
    nogil: bool = True,
    wide: bool = False,
) -> Callable[[F], F]: ...


def kernel(function: F | None = None, /, **options: Any) -> F | Callable[[F], F]:
    """Compile a function, ahead of time or when it is first called. Other options are numba's.

    ``nogil`` False is for those that take less than the time for which a thread that wants Python's
    lock waits before it asks for it: to give it up and to want it back costs a busy process more.
    ``wide`` is for those that go through images: they are compiled a second time, for processors
    that take eight numbers at a time (`tracker.kernels.parts.WIDE`); without fast-math to the same
    bits.
    """

    def make(function: F) -> F:
        made: F = _make(function, options)
        return made

    return make(function) if function is not None else make


def are_compiled() -> bool:
    """Whether no first call of a kernel imported so far waits for a compiler: there is a library,
    and it was compiled from today's source. Takes some 20 ms; a kernel that is newer than the
    library, and so unknown to it, is not missed.
    """
    library = _library()
    return library is not None and library.is_current()


def compiler() -> str:
    """numba and its version: the one that made the library, else the one that compiles now."""
    made = parts.compiler()
    if made is None:
        from numba import __version__

        made = f"numba {__version__}"
    return made


def _make(function: Callable[..., Any], options: dict[str, Any]) -> Any:
    library, mode = _library(), os.environ.get(MODE, "")
    if library is not None:
        return library.kernel(function, options)
    from tracker.kernels.jit import compiled

    return compiled(function, options, cache=mode != "build")


@cache
def _library() -> Library | None:
    """Looked for when the first kernel is made: the library's compiler sets the mode before."""
    return None if os.environ.get(MODE) in ("numba", "build") else load()
