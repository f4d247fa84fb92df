"""Kernels compiled by numba when they are first called; this alone imports numba."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numba


def compiled(function: Callable[..., Any], options: dict[str, Any], *, cache: bool = True) -> Any:
    """numba's function, which compiles for the types it meets and keeps that on the disk."""
    made = numba.njit(cache=cache, nogil=True, **options)(function)
    made.options = options
    return made
