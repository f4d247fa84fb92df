"""Notices: what the program reports to people, as a code and values rather than as a sentence.

Code reports `Notice`s. Window and command line render them with the templates of the catalogue:
`tracker.base.catalogue` and, for extensions, the entry points ``glovetrack.notices``. Logs, tests
and files compare codes; a sentence may be reworded, and is translated as a template.
"""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum
from functools import lru_cache
from importlib.metadata import entry_points
from os import PathLike, fspath
from string import Formatter
from typing import Any

from tracker.base.catalogue import TEMPLATES
from tracker.base.frozen_dict import FrozenDict

GROUP = "glovetrack.notices"
"""Entry points of extensions: each names a dictionary of templates by code."""
_log = logging.getLogger(__name__)


class Severity(StrEnum):
    """How urgent a notice is."""

    INFO = "info"
    WARNING = "warning"  # something is worse than it should be
    ERROR = "error"  # something that was asked for, or is required, is not possible


@dataclass(frozen=True)
class Notice:
    """``code`` selects the template, ``values`` fill its placeholders.

    A value is a text, a number, a notice or a tuple of these; angles and lengths are in the units
    that the template prints.
    """

    code: str
    severity: Severity
    values: Mapping[str, object]

    def __str__(self) -> str:
        """The English text."""
        return render(self)

    def __hash__(self) -> int:
        return hash(self.code)

    def replaced(self, old: str, new: str) -> Notice:
        """The same report with ``new`` in place of ``old`` in its texts."""
        return replace(
            self,
            values=FrozenDict(
                {
                    name: value.replace(old, new) if isinstance(value, str) else value
                    for name, value in self.values.items()
                }
            ),
        )

    def with_severity(self, severity: Severity) -> Notice:
        """The same report with another severity."""
        return self if severity is self.severity else replace(self, severity=severity)


def notice(code: str, /, **values: object) -> Notice:
    """Something to know; nothing to worry about."""
    return Notice(code, Severity.INFO, _frozen(values))


def warning(code: str, /, **values: object) -> Notice:
    """Something is worse than it should be."""
    return Notice(code, Severity.WARNING, _frozen(values))


def failure(code: str, /, **values: object) -> Notice:
    """Something that was asked for, or is required, is not possible."""
    return Notice(code, Severity.ERROR, _frozen(values))


PLAIN = "plain"
"""The code of a text that has no template: from a plug-in, or from the operating system."""


def plain(text: str, severity: Severity = Severity.INFO) -> Notice:
    """A notice with a finished text, which is shown unchanged in every language."""
    return Notice(PLAIN, severity, FrozenDict(text=text))


def _frozen(values: Mapping[str, object]) -> FrozenDict[str, object]:
    return FrozenDict({name: _value(value) for name, value in values.items()})


def _value(value: object) -> object:
    """As text, number, notice or tuple, whatever the code that reports it works with."""
    if isinstance(value, bool | int | str | Notice):
        return value if not isinstance(value, StrEnum) else str(value)
    if isinstance(value, float):
        return float(value)
    if isinstance(value, PathLike):
        return fspath(value)
    number = getattr(value, "item", None)  # a scalar of NumPy, which need not be imported here
    if number is not None and getattr(value, "shape", None) == ():
        return number()
    if isinstance(value, Iterable):
        return tuple(_value(one) for one in value)
    carried = getattr(value, "notice", None)  # an error of ours
    return carried if isinstance(carried, Notice) else str(value)


class Outbox:
    """Notices that wait until their reader drains them. For one thread."""

    def __init__(self) -> None:
        self._waiting: list[Notice] = []

    def post(self, report: Notice) -> None:
        self._waiting.append(report)

    def drain(self) -> list[Notice]:
        """The notices since the last call, oldest first."""
        waiting, self._waiting = self._waiting, []
        return waiting


# ---- rendering


@dataclass(frozen=True)
class Language:
    """``translate`` gives templates and words in the reader's language, unknown ones unchanged;
    ``decimal`` is the decimal separator."""

    translate: Callable[[str], str]
    decimal: str = "."


ENGLISH = Language(lambda text: text)


def render(report: Notice, language: Language = ENGLISH) -> str:
    """The text of a notice; without a template that fits, its code and values."""
    text = try_render(report, language)
    if text is not None:
        return text
    values = ", ".join(f"{name}={value}" for name, value in report.values.items())
    return f"{report.code} ({values})" if values else report.code


def try_render(report: Notice, language: Language = ENGLISH) -> str | None:
    """The text of a notice; None where this version has no template for its code and values, as
    with a recording of another version."""
    template = template_of(report.code)
    if template is None:
        return None
    values = _Values(language)
    try:
        return values.vformat(language.translate(template), (), report.values).rstrip()
    except (LookupError, TypeError, ValueError):
        return None


def template_of(code: str) -> str | None:
    """The English template of a code."""
    return TEMPLATES.get(code) or _extensions().get(code)


def all_templates() -> dict[str, str]:
    """Every template, by code, those of extensions included."""
    return {**TEMPLATES, **_extensions()}


@lru_cache(maxsize=1)
def _extensions() -> Mapping[str, str]:
    """The templates of extensions; not by a `Registry`, whose errors are notices."""
    found: dict[str, str] = {}
    for entry in entry_points(group=GROUP):
        try:
            found.update(entry.load())
        except Exception:  # noqa: BLE001 - another package must not prevent a report
            _log.exception("The notices of %s cannot be loaded", entry.name)
    return found


class _Values(Formatter):
    """Fills a template. A placeholder ``{name:spec}`` has one of these specifications:

    ``word``      a word or name that has a translation (side, finger, hue)
    ``words``     several of them: *red, green and blue*
    ``list``      several values, separated by commas
    ``or``        several values: *a, b or c*
    ``one|more``  a word that depends on a number
    ``.1f``, ``d``, …  a format of Python for numbers
    """

    def __init__(self, language: Language) -> None:
        self._language = language

    def get_value(self, key: int | str, args: Sequence[Any], kwargs: Mapping[str, Any]) -> Any:
        return kwargs[str(key)]

    def format_field(self, value: Any, format_spec: str) -> str:
        spec, translate = format_spec, self._language.translate
        if "|" in spec:
            one, more = spec.split("|")
            return one if value == 1 else more
        if spec == "word":
            return self._one(value) if isinstance(value, Notice) else translate(str(value))
        if spec in ("words", "list", "or"):
            return self._several(value, spec)
        if isinstance(value, tuple):
            return " ".join(self._one(one) for one in value)
        if spec and isinstance(value, int | float):
            return format(value, spec).replace(".", self._language.decimal)
        return self._one(value)

    def _one(self, value: object) -> str:
        if isinstance(value, Notice):
            return render(value, self._language)
        if isinstance(value, float):
            return f"{value:g}".replace(".", self._language.decimal)
        return str(value)

    def _several(self, value: object, spec: str) -> str:
        values = value if isinstance(value, tuple) else (value,)
        translate = self._language.translate
        texts = [
            translate(one) if spec == "words" and isinstance(one, str) else self._one(one)
            for one in values
        ]
        if spec == "list" or len(texts) < 2:
            return ", ".join(texts)
        pair = translate("{} and {}" if spec == "words" else "{} or {}")
        return pair.format(", ".join(texts[:-1]), texts[-1])


# ---- in files and streams


def to_json(report: Notice) -> dict[str, object]:
    """The form in recordings and streams: ``code``, ``severity`` and ``values``."""
    values = {name: _to_json(value) for name, value in report.values.items()}
    return {"code": report.code, "severity": report.severity.value, "values": values}


def _to_json(value: object) -> object:
    if isinstance(value, Notice):
        return to_json(value)
    return [_to_json(one) for one in value] if isinstance(value, tuple) else value


def from_json(record: Mapping[str, object]) -> Notice | None:
    """Returns the notice that `to_json` wrote; None if it is missing or invalid."""
    code, values = record.get("code"), record.get("values", {})
    if not isinstance(code, str) or not code or not isinstance(values, Mapping):
        return None
    try:
        severity = Severity(str(record.get("severity", "info")))
    except ValueError:
        severity = Severity.INFO
    return Notice(
        code, severity, FrozenDict({str(n): _from_json(value) for n, value in values.items()})
    )


def _from_json(value: object) -> object:
    if isinstance(value, Mapping):
        return from_json(value) or str(dict(value))
    if isinstance(value, list):
        return tuple(_from_json(one) for one in value)
    return value if isinstance(value, str | int | float | bool) else str(value)
