"""Arguments of functions: their types are checked, and errors name them.

The functions beneath are those of the command line, so their errors name its options.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import fields
from numbers import Integral, Real
from os import PathLike
from typing import Any

import numpy as np

from tracker.base.errors import GlovetrackError
from tracker.base.notices import Notice

_OPTION = re.compile(r"(?<![^\s(])--([a-z][a-z-]*)")
"""At the start of a word, so not in the name of a file."""
_TYPES = {
    bool: (bool | np.bool_, "True or False"),
    int: (Integral, "an integer"),
    float: (Real, "a number"),
    str: (str | PathLike, "a string"),
}


class ArgumentNotice(Notice):
    """A notice whose text names arguments: ``right_late`` for ``--right-late``."""

    def __str__(self) -> str:
        return _OPTION.sub(_argument, super().__str__())


def _argument(option: re.Match[str]) -> str:
    name = option[1].replace("-", "_")
    return "force=True" if name == "force" else name


@contextmanager
def argument_errors() -> Iterator[None]:
    """Errors of the block name arguments of functions, not options of the command line."""
    try:
        yield
    except GlovetrackError as error:
        found = error.notice
        error.notice = ArgumentNotice(found.code, found.severity, found.values)
        raise


def check_types(options: Any) -> None:
    """Raises TypeError for a field of a dataclass that has another type than its default."""
    for field in fields(options):
        value, default = getattr(options, field.name), field.default
        wanted, name = _TYPES.get(type(default), (object, ""))
        if not isinstance(value, wanted) or (isinstance(value, bool) and wanted is Real):
            raise TypeError(f"{field.name} must be {name}, not {value!r}")
