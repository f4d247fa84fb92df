"""Texts in the user's language, for code that does not import Qt: view-models.

Widgets use ``self.tr``, which has the same catalogue (`app.platform.translation`).
"""

from __future__ import annotations

from collections.abc import Callable

from tracker.base.callbacks import ignore
from tracker.base.errors import notice_of
from tracker.base.notices import Language, Notice, render, try_render
from tracker.messages import Event


class _Catalogue:
    """Translates texts of the source; unchanged until a language is in use."""

    look_up: Callable[[str], str | None] = ignore
    decimal = "."
    language = "en"


def use(
    look_up: Callable[[str], str | None] = ignore,
    decimal: str = ".",
    language: str = "en",
) -> None:
    """Translates with ``look_up`` from now on, which returns None for an unknown text.
    ``decimal``: the separator in numbers; ``language``: the code of the language."""
    _Catalogue.look_up, _Catalogue.decimal, _Catalogue.language = look_up, decimal, language


def language() -> str:
    """The code of the language in use."""
    return _Catalogue.language


def tr(text: str) -> str:
    """``text`` in the user's language. Values are inserted afterwards: ``tr("{} m").format(x)``."""
    return _Catalogue.look_up(text) or text


def mark(text: str) -> str:
    """``text`` unchanged, listed for translation: for tables, whose words pass `tr` when shown."""
    return text


SIDES = {"left": mark("Left"), "right": mark("Right")}


def local(value: float) -> LocalFloat:
    """``value``, to be formatted in the user's language: ``f"{local(0.5):.1f}"``, German 0,5."""
    return LocalFloat(value)


def decimal() -> str:
    """The decimal separator of the user's language."""
    return _Catalogue.decimal


class LocalFloat(float):
    """A number whose formatted text has the decimal separator of the user's language."""

    def __format__(self, spec: str) -> str:
        return format(float(self), spec).replace(".", _Catalogue.decimal)


def notice_text(what: Notice) -> str:
    """Translates a notice of the engine to the user's language."""
    return render(what, Language(_word, _Catalogue.decimal))


def shown(text: str | Notice) -> str:
    """A finished text unchanged, a notice translated."""
    return notice_text(text) if isinstance(text, Notice) else text


def error_text(error: BaseException) -> str:
    """Translates an error's notice to the user's language."""
    return notice_text(notice_of(error))


def event_text(event: Event) -> str:
    """Translates an event's notice to the user's language; English if it was recorded without a
    notice, or with one that this version does not have. A note is the user's own text."""
    if event.notice is None:
        return event.text
    return try_render(event.notice, Language(_word, _Catalogue.decimal)) or event.text


def _word(text: str) -> str:
    """A template or a value of a notice in the user's language. A side is translated as by itself,
    since the word before a noun may be inflected."""
    return tr(SIDES[text]).lower() if text in SIDES else tr(text)
