"""Spacing and font sizes of the window; `tests/gui/test_theme.py` checks their use."""

from __future__ import annotations

TIGHT, NEAR, APART, WIDE, FAR = 4, 8, 12, 16, 24
SPACES = (0, TIGHT, NEAR, APART, WIDE, FAR)
"""px between and around widgets."""

SMALL, BODY, FIGURE, HEADING = 8, 9, 13, 18
TYPES = (SMALL, BODY, FIGURE, HEADING)
"""pt: annotations, text, main values, headings."""
