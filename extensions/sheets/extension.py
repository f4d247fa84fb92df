"""Descriptor of the command ``print``."""

from __future__ import annotations

from extensions.sheets.command import add_print, print_sheets
from tracker.base.command import Command

PRINT = Command(
    "print", "create PDF sheets at true scale for building a glove", print_sheets, add=add_print
)
