"""Kernels compiled by numba on their first call."""

from __future__ import annotations

import logging
from collections.abc import Callable
from typing import Any

import numba
from numba.core.caching import FunctionCache

_log = logging.getLogger(__name__)


def compiled(function: Callable[..., Any], options: dict[str, Any]) -> Any:
    """numba's dispatcher, which compiles for the argument types and caches the result on disk."""
    made = numba.njit(**numba_options(options))(function)
    if not numba.config.DISABLE_JIT:
        made._cache = KernelCache(function)
    made.options = options
    return made


def numba_options(options: dict[str, Any]) -> dict[str, Any]:
    """The options of `decorator.kernel` for numba.njit."""
    return {"nogil": True, **{name: value for name, value in options.items() if name != "wide"}}


class KernelCache(FunctionCache):
    """numba's disk cache, cleared where it refers to classes that no longer exist.

    Its entries are pickles of argument types, and for a named tuple they refer to its class: if
    that was renamed or moved, numba cannot read them and would raise the error of pickle.
    """

    def load_overload(self, sig: Any, target_context: Any) -> Any:
        """The function compiled for ``sig`` earlier; None if there is no readable one."""
        try:
            return super().load_overload(sig, target_context)
        except (AttributeError, ImportError) as error:
            _log.debug("compiled again, %s: %s", self._name, error)
            self.flush()
            return None
