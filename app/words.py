"""Words for the user in the user's language, for code that knows no Qt: view-models.

Widgets have ``self.tr``, which comes to the same catalogue (`app.platform.translation`).
"""

from __future__ import annotations

from collections.abc import Callable


class _Catalogue:
    """What turns words of the source into the user's; as they stand until one is in use."""

    look_up: Callable[[str], str | None] | None = None


def use(look_up: Callable[[str], str | None] | None) -> None:
    """Translate by ``look_up`` from now on; it gives None for what it does not hold."""
    _Catalogue.look_up = look_up


def tr(text: str) -> str:
    """``text`` in the user's language. Values are put in afterwards: ``tr("{} m").format(x)``."""
    found = _Catalogue.look_up(text) if _Catalogue.look_up is not None else None
    return found or text


def mark(text: str) -> str:
    """``text`` as it is, listed for translation: for tables, whose words pass `tr` when shown."""
    return text
