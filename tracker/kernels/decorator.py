"""The decorator `kernel`: which code a compiled function runs."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar, overload

import numba

F = TypeVar("F", bound=Callable[..., Any])


@overload
def kernel(function: F, /) -> F: ...


@overload
def kernel(
    *, fastmath: bool = False, inline: str = "never", error_model: str = "python"
) -> Callable[[F], F]: ...


def kernel(function: F | None = None, /, **options: Any) -> F | Callable[[F], F]:
    """Compile a function for the types with which it is called. The options are numba's."""

    def make(function: F) -> F:
        compiled: F = numba.njit(cache=True, nogil=True, **options)(function)
        return compiled

    return make(function) if function is not None else make
