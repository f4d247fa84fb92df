"""Names of the gloves' own files: copies of their glove files in the user's folder, with the
measurements of each glove."""

from __future__ import annotations

from pathlib import Path

from tracker.glove import library

SIMULATED, UNNUMBERED = "simulated", "own"
"""Marks of the demo's glove, and of a glove that reports no number."""


def own_name(file: str, mark: str) -> str:
    """Name of the own file of a glove that uses ``file``; ``mark`` tells it from other gloves with
    the same file."""
    stem = Path(file).stem
    return stem if stem.endswith(f"-{mark}") else f"{stem}-{mark}"


def own_path(name: str) -> Path:
    """The path of an own file; it need not exist."""
    return library.user_folder("gloves") / f"{name}.toml"


def own_or(file: str, mark: str) -> str:
    """The name of the own file if it exists, else ``file``."""
    own = own_name(file, mark)
    return own if own_path(own).is_file() else file
