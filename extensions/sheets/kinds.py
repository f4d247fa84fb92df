"""The sheets of ``glovetrack print``: an entry point of the group ``glovetrack.sheets`` each."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import TYPE_CHECKING

from tracker.base.registry import Registry

if TYPE_CHECKING:  # slow to import
    from extensions.sheets.page import Page
    from tracker.glove.model import GloveModel
    from tracker.hand.model import HandModel


@dataclass(frozen=True)
class SheetKind:
    """Something to print; ``name`` is the entry point's, ``what`` a few words for help texts.

    ``pages(hand, glove, paper)`` returns the pages on paper ``a4`` or ``letter`` and the title of
    the file.
    """

    name: str
    what: str
    pages: Callable[[HandModel, GloveModel, str], tuple[list[Page], str]]


SHEETS = Registry("sheets", "sheet", SheetKind)
