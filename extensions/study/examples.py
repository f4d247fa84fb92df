"""The protocols that come with the program."""

from __future__ import annotations

from pathlib import Path

FOLDER = Path(__file__).parent / "protocols"


def names() -> list[str]:
    """Names of the examples."""
    return sorted(path.stem for path in FOLDER.glob("*.toml"))


def protocol_path(given: str) -> Path:
    """The path of a protocol file, or of an example by its name."""
    path = Path(given)
    if path.suffix or path.exists() or given not in names():
        return path
    return FOLDER / f"{given}.toml"
