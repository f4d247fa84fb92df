"""`write_report` writes the page, the table and the figures of a report."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path

from extensions.movement.report.figures import all_figures, figure_names, png, svg
from extensions.movement.report.measure import MeasuredTake, measure_hands
from extensions.movement.report.page import page
from extensions.movement.report.table import table
from tracker.base.errors import ConfigError
from tracker.base.files import check_target, whole_files
from tracker.base.notices import notice

SVG_HEAD = '<?xml version="1.0" encoding="utf-8"?>\n'


def write_report(
    sessions: Sequence[Path],
    out: Path,
    anonymous: bool = False,
    force: bool = False,
    watch: Callable[[float], None] = lambda share: None,
) -> list[MeasuredTake]:
    """Write ``out`` (HTML), a CSV file of the same name and each figure as ``NAME_ranges.png`` and
    ``.svg``, ``NAME_1_flexion.png``…; either all files are written or none.

    ``watch`` receives the share of sessions read so far and may raise to cancel. Raises ConfigError
    if the name does not end in .html, FileError for a session without estimates.
    """
    if out.suffix.lower() not in (".html", ".htm"):
        raise ConfigError(notice("option.html", file=out.name))
    for target in (out, out.with_suffix(".csv")):
        check_target(target, force, sessions)
    takes = []
    for k, path in enumerate(sessions):
        watch(k / len(sessions))
        takes += [replace(hand, session=k) for hand in measure_hands(path, anonymous)]

    for name in figure_names(takes):
        for ending in (".png", ".svg"):
            check_target(out.with_name(f"{out.stem}_{name}{ending}"), force, sessions)
    made: dict[str, str | bytes] = {}
    drawn = {}
    for name, figure in all_figures(takes):
        drawn[name] = svg(figure)
        made |= {f"_{name}.png": png(figure), f"_{name}.svg": SVG_HEAD + drawn[name]}
    made |= {".csv": table(takes), out.suffix: page(takes, drawn)}
    files = {out.with_name(out.stem + ending): data for ending, data in made.items()}
    with whole_files(*files, force=force, inputs=sessions) as parts:
        for part, data in zip(parts, files.values(), strict=True):
            part.write_bytes(data if isinstance(data, bytes) else data.encode())
    return takes
