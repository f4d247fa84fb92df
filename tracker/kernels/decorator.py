"""The decorator `kernel`, which selects the code that a function runs."""

from __future__ import annotations

import os
from collections.abc import Callable
from functools import cache
from typing import Any, TypeVar, overload

from tracker.kernels import parts
from tracker.kernels.library import Library, load
from tracker.kernels.parts import MODE

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
    """Compile a function, ahead of time or on its first call. Other options are numba's.

    ``nogil`` False is for functions that take less time than the interval after which a waiting
    thread requests the GIL: releasing and reacquiring it would cost a loaded process more. ``wide``
    is for functions that process images: they are compiled a second time, for processors with
    256-bit vectors (`tracker.kernels.parts.WIDE`); without fast-math the results are bit-identical.
    """

    def make(function: F) -> F:
        made: F = _make(function, options)
        return made

    return make(function) if function is not None else make


def are_compiled() -> bool:
    """Whether no first call of an imported kernel requires compilation: the library exists and was
    compiled from the present source. Takes about 20 ms; a kernel newer than the library, and so
    unknown to it, is not detected.
    """
    library = _library()
    return library is not None and library.is_current()


def compiler() -> str:
    """numba's version: the one that compiled the library, else the one that compiles now."""
    made = parts.compiler()
    if made is None:
        from numba import __version__  # deferred: not installed everywhere

        made = f"numba {__version__}"
    return made


def _make(function: Callable[..., Any], options: dict[str, Any]) -> Any:
    library, mode = _library(), os.environ.get(MODE, "")
    if library is not None:
        return library.kernel(function, options)
    if mode == "build":
        from tracker.kernels.target import declare  # deferred: loads numba

        return declare(function, options)
    from tracker.kernels.jit import compiled  # deferred: loads numba

    return compiled(function, options)


@cache
def _library() -> Library | None:
    """Loaded when the first kernel is created: the library's compiler sets the mode before that."""
    return None if os.environ.get(MODE) in ("numba", "build") else load()
