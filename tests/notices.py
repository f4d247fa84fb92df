"""Errors of the program, compared by the codes of their notices rather than by their English."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager
from string import Formatter

import pytest

from tracker.base.errors import DataError, GlovetrackError
from tracker.base.notices import Notice, notice, template_of


@contextmanager
def raises(
    kind: type[GlovetrackError | DataError], *codes: str, **values: object
) -> Iterator[pytest.ExceptionInfo[GlovetrackError | DataError]]:
    """The block raises a ``kind`` whose notice, or a notice in its values, has one of these codes
    and has the ``values``."""
    with pytest.raises(kind) as caught:
        yield caught
    found = parts(caught.value.notice)
    assert any(part.code in codes for part in found), str(caught.value)
    given = {name: value for part in found for name, value in part.values.items()}
    wanted = notice("", **values).values
    assert {name: given.get(name) for name in wanted} == dict(wanted)


def parts(report: Notice) -> list[Notice]:
    """The notice, and those among its values, which explain it."""
    inner = [value for value in report.values.values() if isinstance(value, Notice)]
    return [report, *(part for value in inner for part in parts(value))]


def shows(output: str, code: str, **values: object) -> bool:
    """Whether an output contains the English text of a notice with this code and these values."""
    template = template_of(code)
    assert template is not None, code
    pattern = ""
    for literal, name, spec, _ in Formatter().parse(template):
        pattern += re.escape(literal)
        if name is not None:
            pattern += re.escape(_text(values[name], spec or "")) if name in values else ".*?"
    spaces = pattern.replace(r"\ ", r"\s+")
    return re.search(spaces, output, re.DOTALL) is not None


def _text(value: object, spec: str) -> str:
    """As `tracker.base.notices` renders it."""
    if "|" in spec:
        return spec.split("|")[value != 1]
    return format(value, spec) if spec and isinstance(value, int | float) else str(value)
