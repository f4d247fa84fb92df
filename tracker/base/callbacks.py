"""Callbacks for those who want none."""

from __future__ import annotations


def ignore(*_values: object) -> None:
    """Takes what it is called with, and does nothing."""
