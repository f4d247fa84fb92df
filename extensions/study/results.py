"""Writes the files of a study's report."""

from __future__ import annotations

from pathlib import Path

from extensions.study.folder import Study
from extensions.study.report import report_page, touch_lines
from tracker.base.errors import ConfigError
from tracker.base.files import make_folder, write_whole
from tracker.base.report_page import html_table


def write_report(study: Study, folder: Path) -> Path:
    """Write ``report.html`` and the reports of touch tests into ``folder``; returns the page's
    path. Raises ConfigError without accepted trials."""
    make_folder(folder)
    touch = list(touch_lines(study, folder))
    page = folder / "report.html"
    write_whole(page, report_page(study, touch, _errors(study)))
    return page


def _errors(study: Study) -> str:
    """The table of errors as recorded, as HTML; empty without references, or without the extension
    that computes it."""
    try:
        from extensions.study import retrack, tables  # deferred: need another extension

        evaluated = tables.evaluate(study, retrack.chosen((retrack.RECORDED,)), processes=1)
    except (ConfigError, ModuleNotFoundError):
        return ""
    return html_table(*tables.as_table(tables.rows_of(evaluated)))
