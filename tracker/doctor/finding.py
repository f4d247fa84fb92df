"""What a check finds, and the registry of all checks."""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

from tracker.base.errors import GlovetrackError
from tracker.base.notices import Notice, Severity, notice, warning
from tracker.base.registry import Registry
from tracker.doctor.machine import Machine

_log = logging.getLogger(__name__)


class Verdict(StrEnum):
    """How serious a finding is."""

    OK = "ok"
    WARNING = "warning"
    """Tracking works, but less accurately or with interruptions."""
    ERROR = "error"
    """Tracking or recording does not work."""


VERDICTS = {
    Severity.INFO: Verdict.OK,
    Severity.WARNING: Verdict.WARNING,
    Severity.ERROR: Verdict.ERROR,
}


@dataclass(frozen=True)
class Finding:
    """One line of the result. The severity of ``what`` is the verdict. Without a ``remedy``, the
    sentences of ``what`` after the first one give the remedy."""

    what: Notice
    remedy: Notice | None = None

    @property
    def verdict(self) -> Verdict:
        return VERDICTS[self.what.severity]

    @property
    def values(self) -> dict[str, float]:
        """The figures of ``what``, with the unit in each name."""
        found = self.what.values.items()
        return {n: v for n, v in found if isinstance(v, int | float) and not isinstance(v, bool)}

    def texts(self, translate: Callable[[Notice], str] = str) -> tuple[str, str]:
        """What was found and what to do about it; the second is empty if there is nothing to do."""
        what = translate(self.what)
        if self.remedy is not None:
            return what, translate(self.remedy)
        if self.verdict is Verdict.OK:
            return what, ""
        first, _, rest = what.partition(". ")
        return f"{first.rstrip('.')}.", rest

    @property
    def line(self) -> str:
        """``warning  what was found  what to do about it``."""
        return "  ".join(filter(None, (f"{self.verdict:7}", *self.texts())))


def graded(what: Notice, severity: Severity, remedy: Notice) -> Finding:
    """A finding that needs its remedy only if it is more than information."""
    if severity is Severity.INFO:
        return Finding(what)
    return Finding(what.with_severity(severity), remedy)


@dataclass(frozen=True)
class Check:
    """A check, as an entry point of ``glovetrack.checks`` names it."""

    name: str
    title: str
    run: Callable[[Machine], Iterable[Finding]]
    order: int = 50
    """Checks run from the lowest to the highest."""


CHECKS: Registry[Check] = Registry("checks", "check", Check)


@dataclass(frozen=True)
class Result:
    """A finding with the title of its check."""

    check: Check
    finding: Finding

    def as_json(self) -> dict[str, Any]:
        finding = self.finding
        what, remedy = finding.texts()
        return {
            "check": self.check.name,
            "verdict": finding.verdict.value,
            "code": finding.what.code,
            "what": what,
            "remedy": remedy,
            "values": finding.values,
        }


def examine(machine: Machine, checks: Iterable[Check] | None = None) -> Iterator[Result]:
    """Runs the checks one after the other (default: all registered ones).

    A check that fails is a warning with its message and does not stop the others.
    """
    chosen = CHECKS.all().values() if checks is None else checks
    for check in sorted(chosen, key=lambda c: (c.order, c.name)):
        try:
            for finding in check.run(machine):
                yield Result(check, finding)
        except GlovetrackError as problem:
            yield Result(check, Finding(problem.notice.with_severity(Severity.WARNING)))
        except Exception as problem:  # noqa: BLE001 - another package's check must not end ours
            _log.exception("The check %s failed", check.name)
            failed = warning("doctor.check_failed", why=str(problem))
            yield Result(check, Finding(failed, notice("doctor.attach_report")))
