"""The JSON file that describes an export, and its remains after a killed export."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping
from pathlib import Path

from tracker.base.errors import FileError
from tracker.base.files import sha256
from tracker.base.toml_reader import read_text

OTHER_FILES = "beside"  # key in the JSON: SHA-256 of the other files of the export, by name


def forget_orphan(sidecar: Path, path: Path) -> None:
    """Delete our JSON, and the unchanged files that it lists, where the export ``path`` does not
    exist: its process was killed. No other file is deleted."""
    if os.path.lexists(path) or not sidecar.is_file():
        return
    try:
        content = json.loads(read_text(sidecar))
    except (ValueError, FileError, RecursionError):
        return
    if not (
        isinstance(content, dict) and "glovetrack" in content and content.get("file") == path.name
    ):
        return
    listed = content.get(OTHER_FILES)
    for name, digest in listed.items() if isinstance(listed, Mapping) else ():
        other = path.parent / Path(str(name)).name
        if other.is_file() and sha256(other) == digest:
            other.unlink()
    sidecar.unlink()
