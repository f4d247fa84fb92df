"""The one scale of spaces and the one of type sizes; `tests/gui/test_theme.py` holds all to it."""

from __future__ import annotations

TIGHT, NEAR, APART, WIDE, FAR = 4, 8, 12, 16, 24
SPACES = (0, TIGHT, NEAR, APART, WIDE, FAR)
"""px between widgets and round them."""

SMALL, BODY, FIGURE, HEADING = 8, 9, 13, 18
TYPES = (SMALL, BODY, FIGURE, HEADING)
"""pt: of what is beside the point, of text, of the number that a panel is about, of a page."""
