"""The command ``touch-test``."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from html import escape
from pathlib import Path
from typing import Any

import numpy as np

from extensions.touch.analyse import analyse
from extensions.touch.command import TouchTestArguments
from extensions.touch.report import MM, as_json, mm, write_report
from extensions.touch.result import AXES, FingerResult, TouchResult
from extensions.touch.statistics import ConfidenceInterval, sd_interval
from tracker import __version__
from tracker.base.errors import ConfigError
from tracker.base.files import check_target, whole_file
from tracker.base.notices import failure, notice
from tracker.base.report_page import html_page, html_table
from tracker.base.terminal import check_json, finish, progress_line

RULER_MM = (240.0, 280.0)


def touch_test(args: TouchTestArguments) -> int:
    """Write the report."""
    if args.ruler is not None and not RULER_MM[0] <= args.ruler <= RULER_MM[1]:
        raise ConfigError(notice("touch.ruler_range"))
    check_json(args, args.sessions)
    ruler = None if args.ruler is None else args.ruler / 1000
    results = [analyse(s, ruler, args.side, progress_line("reading")) for s in args.sessions]
    if len(results) > 1:
        page = write_repeated(results, args.output, args.force, args.sessions)
        found = repeated_json(results)
        finish(args, found, [found["line"], str(page)], [*args.sessions, page])
        return 0
    result = results[0]
    written = write_report(result, args.output, args.force, args.sessions)
    lines = [result.line, *(str(n) for n in result.notices)]
    lines.append(", ".join(str(path) for path in written))
    finish(args, as_json(result), lines, [*args.sessions, *written])
    return 0


# ---- the report of several touch tests of one person as HTML and JSON, with their repeatability
#
# Repeatability: the test after putting the glove on again. One-way random effects (ISO
# 5725-2:2019, 7.4): the bias of a session is that of one wearing.

AGREEMENT = 1.96 * np.sqrt(2.0)
"""For the standard deviation of one touch: two touches differ by less in 95 % of cases."""


@dataclass(frozen=True)
class Repeated:
    """One finger over several wearings, m per axis of the sheet.

    ``within`` is the SD of touches in one wearing, ``between`` that of the bias from wearing to
    wearing as it was found, ``wearing`` what remains of it without the part that the number of
    touches explains, ``limit`` the 95 % limit for the difference of two touches in two wearings.
    """

    finger: str
    sessions: int
    within: ConfidenceInterval
    between: ConfidenceInterval
    wearing: float
    limit: float


def repeatability(results: Sequence[TouchResult]) -> list[Repeated]:
    """For the fingers that all sessions have. Raises ConfigError without any, or with sessions of
    several persons or hands."""
    for what in ("participant", "side"):
        found = {r.session.get(what, "") for r in results} - {""}
        if len(found) > 1:
            raise ConfigError(failure("touch.several_people", found=sorted(found)))
    by_finger = [{f.finger: f for f in r.fingers} for r in results]
    common = [name for name in by_finger[0] if all(name in fingers for fingers in by_finger)]
    if not common:
        raise ConfigError(failure("touch.no_common_finger"))
    return [_repeated(name, [fingers[name] for fingers in by_finger]) for name in common]


def _repeated(finger: str, sessions: Sequence[FingerResult]) -> Repeated:
    """Mean squares of one-way analysis of variance, pooled over the three axes."""
    counts = np.array([f.count for f in sessions], float)
    means = np.array([f.error_S.mean(axis=0) for f in sessions])
    rest = sum(float(np.sum((f.error_S - m) ** 2)) for f, m in zip(sessions, means, strict=True))
    dof_within = 3 * float(np.sum(counts - 1))
    grand = np.average(means, axis=0, weights=counts)
    dof_between = 3 * (len(sessions) - 1)
    ms_within = rest / dof_within
    ms_between = float(np.sum(counts[:, None] * (means - grand) ** 2)) / dof_between
    effective = (counts.sum() - np.sum(counts**2) / counts.sum()) / (len(sessions) - 1)
    wearing = max(0.0, (ms_between - ms_within) / effective)
    spread = float(np.sqrt(np.mean(np.var(means, axis=0, ddof=1))))
    return Repeated(
        finger=finger,
        sessions=len(sessions),
        within=sd_interval(float(np.sqrt(ms_within)), dof_within),
        between=sd_interval(spread, dof_between),
        wearing=float(np.sqrt(wearing)),
        limit=float(AGREEMENT * np.sqrt(wearing + ms_within)),
    )


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
