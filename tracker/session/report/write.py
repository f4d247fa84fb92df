"""`write_report`: the page and, beside it, its numbers."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from tracker.errors import ConfigError
from tracker.files import check_target, whole_files
from tracker.session.report.measure import Told, tell


def write_report(
    sessions: Sequence[Path],
    out: Path,
    anonymous: bool = False,
    force: bool = False,
    watch: Callable[[float], None] = lambda share: None,
) -> list[Told]:
    """``out`` (HTML) and a CSV of the same name, both whole or not at all.

    ``watch`` hears which share of the sessions is read, and may raise to end it. Raises
    ConfigError for a name that does not end in .html, FileError for a session without estimates.
    """
    if out.suffix.lower() not in (".html", ".htm"):
        raise ConfigError(f"A report is a page: {out.name} should end in .html.")
    numbers = out.with_suffix(".csv")
    for target in (numbers, out):
        check_target(target, force, sessions)
    takes = []
    for k, path in enumerate(sessions):
        watch(k / len(sessions))
        takes.append(tell(path, anonymous))
    from tracker.session.report.page import page
    from tracker.session.report.table import table

    with whole_files(numbers, out, force=force, inputs=sessions) as (csv, html):
        csv.write_text(table(takes), "utf-8")
        html.write_text(page(takes), "utf-8")
    return takes
