"""Words for the user in the user's language, for code that knows no Qt: view-models.

Widgets have ``self.tr``, which comes to the same catalogue (`app.platform.translation`).
"""

from __future__ import annotations

from collections.abc import Callable


class _Catalogue:
    """What turns words of the source into the user's; as they stand until one is in use."""

    look_up: Callable[[str], str | None] | None = None
    sentences: Callable[[str], str] | None = None
    decimal = "."


def use(
    look_up: Callable[[str], str | None] | None,
    sentences: Callable[[str], str] | None = None,
    decimal: str = ".",
) -> None:
    """Translate by ``look_up`` from now on, which gives None for what it does not hold; and what
    the engine says by ``sentences``. ``decimal``: the separator in numbers."""
    _Catalogue.look_up, _Catalogue.sentences = look_up, sentences
    _Catalogue.decimal = decimal


def tr(text: str) -> str:
    """``text`` in the user's language. Values are put in afterwards: ``tr("{} m").format(x)``."""
    found = _Catalogue.look_up(text) if _Catalogue.look_up is not None else None
    return found or text


def mark(text: str) -> str:
    """``text`` as it is, listed for translation: for tables, whose words pass `tr` when shown."""
    return text


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


def told(text: str) -> str:
    """What the engine says, which knows no window, in the user's language. A text of the window,
    that has passed `tr`, stays as it is."""
    return _Catalogue.sentences(text) if _Catalogue.sentences is not None and text else text
