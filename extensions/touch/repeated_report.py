"""The report of several touch tests of one person as HTML and JSON."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape
from pathlib import Path
from typing import Any

from extensions.touch.repeatability import Repeated, repeatability
from extensions.touch.report import MM, mm
from extensions.touch.result import AXES, TouchResult
from tracker import __version__
from tracker.base.errors import ConfigError
from tracker.base.files import check_target, whole_file
from tracker.base.notices import notice
from tracker.base.report_page import html_page, html_table


def write_repeated(
    results: Sequence[TouchResult], out: Path, force: bool = False, inputs: Sequence[Path] = ()
) -> Path:
    """Write ``out`` (HTML). Raises ConfigError if its name does not end in .html or the sessions
    do not belong together, FileError if it exists."""
    if out.suffix.lower() not in (".html", ".htm"):
        raise ConfigError(notice("option.html", file=out.name))
    check_target(out, force, inputs)
    text = _page(results, repeatability(results))
    with whole_file(out, force=force, inputs=inputs) as part:
        part.write_bytes(text.encode())
    return out


def repeated_line(repeated: Sequence[Repeated]) -> str:
    """One line to quote."""
    parts = [f"{r.finger} {MM * r.limit:.1f} mm" for r in repeated]
    return (
        f"Repeatability of fingertips over {repeated[0].sessions} wearings of the glove "
        f"(95 % limit for the difference of two touches, per axis): {', '.join(parts)}"
    )


def repeated_json(results: Sequence[TouchResult]) -> dict[str, Any]:
    """All figures in mm."""
    repeated = repeatability(results)
    return {
        "line": repeated_line(repeated),
        "sessions": [dict(r.session) for r in results],
        "fingers": {
            r.finger: {
                "within_sd_mm": MM * r.within.value,
                "between_sd_mm": MM * r.between.value,
                "wearing_sd_mm": MM * r.wearing,
                "limit_mm": MM * r.limit,
            }
            for r in repeated
        },
    }


def _page(results: Sequence[TouchResult], repeated: Sequence[Repeated]) -> str:
    head = ("finger", "wearings", "SD of touches in one wearing mm",
            "SD of the bias between wearings mm", "of it due to the wearing mm",
            "95 % limit of two touches mm")  # fmt: skip
    rows = [
        [r.finger, str(r.sessions), mm(r.within), mm(r.between)]
        + [f"{MM * r.wearing:.1f}", f"{MM * r.limit:.1f}"]
        for r in repeated
    ]
    parts = [
        "<h1>Touch test: repeatability</h1>",
        f'<p class="quote">{escape(repeated_line(repeated))}</p>',
        html_table(head, rows),
        "<h2>Bias in each wearing (mm)</h2>",
        html_table(("session", "finger", "touches", *AXES), _biases(results)),
        "<h2>Definitions</h2><p>All figures are per axis of the sheet, pooled over the three axes. "
        "The part that is due to the wearing is what the number of touches does not explain, by "
        "one-way analysis of variance with random effects (ISO 5725-2); 0 means that no "
        "difference between wearings was found. The limit is 1.96 √2 times the SD of one touch "
        "in one wearing. In brackets: "
        "95 % confidence interval by chi-square.</p>",
        f"<p>Glovetrack {escape(__version__)}</p>",
    ]
    return html_page("Touch test: repeatability", parts)


def _biases(results: Sequence[TouchResult]) -> list[list[str]]:
    return [
        [result.session.get("name", ""), f.finger, str(f.count), *(mm(b) for b in f.bias)]
        for result in results
        for f in result.fingers
    ]
