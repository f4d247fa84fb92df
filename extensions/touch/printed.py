"""Descriptor of the touch test's sheet for ``glovetrack print``."""

from __future__ import annotations

from extensions.sheets.kinds import SheetKind
from tracker.base.registry import deferred

TOUCH = SheetKind(
    "touch", "the sheet of the touch test", deferred("extensions.touch.page:printed_pages")
)
