"""Writes the accuracy report of sessions."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from extensions.reference.accuracy import Measured, measure
from extensions.reference.page import page
from extensions.reference.pairs import anonymized, read_pairs
from tracker.base.files import check_target, write_whole


def write_report(
    sessions: Sequence[Path], out: Path, offsets: bool = True, anonymous: bool = False,
    force: bool = False, watch: Callable[[float], None] = lambda share: None,
) -> list[Measured]:  # fmt: skip
    """Writes the page ``out`` and returns what it reports for each hand, in the order of the
    sessions. ``offsets``: with marker offsets; ``watch`` receives the share done.

    Raises FileError if a session has no reference, or if ``out`` exists without ``force``.
    """
    check_target(out, force, sessions)
    pairs = []
    for n, path in enumerate(sessions):
        pairs += read_pairs(path)
        watch(_READ * (n + 1) / len(sessions))
    pairs = anonymized(pairs) if anonymous else pairs
    measured = []
    for n, each in enumerate(pairs):
        measured.append(measure(each, offsets))
        watch(_READ + (_MEASURED - _READ) * (n + 1) / len(pairs))
    write_whole(out, page(measured, offsets), force, sessions)
    return measured


_READ, _MEASURED = 0.4, 0.9  # shares of the progress
