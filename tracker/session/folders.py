"""Sessions that a command line names: files, and folders with all below them."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from tracker.errors import FileError


def sessions_in(sources: Sequence[Path], leave_out: Path | None = None) -> list[tuple[Path, Path]]:
    """(session, name for what is made of it) of files and folders; folders with all below them.

    ``leave_out`` is a folder that is not looked into. Raises FileError for a folder without any.
    """
    found: list[tuple[Path, Path]] = []
    for source in sources:
        if not source.is_dir():
            found.append((source, Path(source.name)))
            continue
        inside = [
            p for p in sorted(source.rglob("*.mcap")) if leave_out not in p.parents and p.is_file()
        ]
        if not inside:
            raise FileError(f"There is no session in {source}.")
        found += [(p, p.relative_to(source)) for p in inside]
    return found
