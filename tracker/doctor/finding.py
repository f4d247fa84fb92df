"""What a check finds, and the registry of all checks."""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterable, Iterator
from dataclasses import asdict, dataclass, field
from enum import StrEnum
from typing import Any

from tracker.base.errors import GlovetrackError
from tracker.base.frozen_dict import FrozenDict
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


@dataclass(frozen=True)
class Finding:
    """One line of the result. ``values`` are its figures, with the unit in each name."""

    verdict: Verdict
    what: str
    remedy: str = ""
    values: FrozenDict[str, float] = field(default_factory=FrozenDict)

    @property
    def line(self) -> str:
        """``warning  what was found  what to do about it``."""
        return "  ".join(filter(None, (f"{self.verdict:7}", self.what, self.remedy)))


def ok(what: str, **values: float) -> Finding:
    return Finding(Verdict.OK, what, "", FrozenDict(values))


def warning(what: str, remedy: str, **values: float) -> Finding:
    return Finding(Verdict.WARNING, what, remedy, FrozenDict(values))


def error(what: str, remedy: str, **values: float) -> Finding:
    return Finding(Verdict.ERROR, what, remedy, FrozenDict(values))


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
        found = asdict(self.finding)
        found["values"] = dict(self.finding.values)
        return {"check": self.check.name, **found}


def examine(machine: Machine, checks: Iterable[Check] | None = None) -> Iterator[Result]:
    """Runs the checks one after the other (default: all registered ones).

    A check that fails is a warning with its message and does not stop the others.
    """
    chosen = CHECKS.all().values() if checks is None else checks
    for check in sorted(chosen, key=lambda c: (c.order, c.name)):
        try:
            for finding in check.run(machine):
                yield Result(check, finding)
        except (GlovetrackError, OSError) as trouble:
            yield Result(check, warning(f"{check.title}: {trouble}", ""))
        except Exception as trouble:  # noqa: BLE001 - another package's check must not end ours
            _log.exception("The check %s failed", check.name)
            text = f"{check.title}: the check itself failed ({trouble})."
            yield Result(check, warning(text, "Attach this report to a bug report."))
