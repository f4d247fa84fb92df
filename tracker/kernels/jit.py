"""Kernels compiled by numba when they are first called; this alone imports numba."""

from __future__ import annotations

import logging
from collections.abc import Callable
from typing import Any

import numba
from numba.core.caching import FunctionCache

_log = logging.getLogger(__name__)


def compiled(function: Callable[..., Any], options: dict[str, Any], *, cache: bool = True) -> Any:
    """numba's function, which compiles for the types it meets and keeps that on the disk."""
    of_numba = {name: value for name, value in options.items() if name != "wide"}
    made = numba.njit(**{"nogil": True, **of_numba})(function)
    if cache and not numba.config.DISABLE_JIT:
        made._cache = KernelCache(function)
    made.options = options
    return made


class KernelCache(FunctionCache):
    """What numba keeps on the disk, emptied where it names what is no longer there.

    Its entries are pickles of argument types, and those of a named tuple its class: once that was
    renamed or moved, numba cannot read them and would raise what pickle raises.
    """

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """The function compiled for ``sig`` earlier; None where there is none that can be read."""
        try:
            return super().load_overload(sig, target_context)
        except (AttributeError, ImportError) as error:
            _log.debug("compiled again, %s: %s", self._name, error)
            self.flush()
            return None
