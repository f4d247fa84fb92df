"""Names of joints, segments, sensors and hues, which are words of files, as a person says them."""

from __future__ import annotations

from app.words import mark, tr

WORDS = {
    "wrist": mark("wrist"),
    "dorsum": mark("dorsum"),
    "palm": mark("palm"),
    "thumb": mark("thumb"),
    "index": mark("index"),
    "middle": mark("middle"),
    "ring": mark("ring"),
    "little": mark("little"),
    "metacarpal": mark("metacarpal"),
    "proximal": mark("proximal"),
    "intermediate": mark("intermediate"),
    "distal": mark("distal"),
    "tip": mark("tip"),
    "flexion": mark("flexion"),
    "abduction": mark("abduction"),
    "twist": mark("twist"),
    "red": mark("red"),
    "green": mark("green"),
    "blue": mark("blue"),
    "yellow": mark("yellow"),
}
"""What the files that come with the program are made of; other files' words stay as they are."""


def spoken(name: str) -> str:
    """``index_mcp_flexion`` as ``index mcp flexion``, in the user's language."""
    return " ".join(tr(WORDS[part]) if part in WORDS else part for part in name.split("_"))
