"""Errors of the program, compared by the codes of their notices rather than by their English."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager

import pytest

from tracker.base.errors import GlovetrackError


@contextmanager
def raises(
    kind: type[GlovetrackError], *codes: str
) -> Iterator[pytest.ExceptionInfo[GlovetrackError]]:
    """The block raises a ``kind`` whose notice has one of these codes."""
    with pytest.raises(kind) as caught:
        yield caught
    assert caught.value.notice.code in codes, str(caught.value)
