"""Display names of joints, segments, sensors and hues, which the files identify by words."""

from __future__ import annotations

from app.words import mark, tr
from tracker.base.errors import ConfigError
from tracker.engine.kinds import ENGINES

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
"""Words used in the shipped files; words of other files are not translated."""


BONES = {
    "thumb_metacarpal": mark("thumb, first bone"),
    "thumb_proximal": mark("thumb, second bone"),
    "thumb_distal": mark("thumb, third bone"),
    "index_proximal": mark("index finger, first bone"),
    "index_intermediate": mark("index finger, second bone"),
    "index_distal": mark("index finger, third bone"),
    "middle_proximal": mark("middle finger, first bone"),
    "middle_intermediate": mark("middle finger, second bone"),
    "middle_distal": mark("middle finger, third bone"),
    "ring_proximal": mark("ring finger, first bone"),
    "ring_intermediate": mark("ring finger, second bone"),
    "ring_distal": mark("ring finger, third bone"),
    "little_proximal": mark("little finger, first bone"),
    "little_intermediate": mark("little finger, second bone"),
    "little_distal": mark("little finger, third bone"),
    "dorsum": mark("back of the hand"),
}
"""Names of the segments with IMUs, for use in a sentence."""


def bone(segment: str) -> str:
    """``index_intermediate`` as ``index finger, second bone``, in the user's language."""
    return tr(BONES[segment]) if segment in BONES else display_name(segment)


def engine_name(name: str) -> str:
    """``vist`` as ``VIST``, where the whole title is too long. The unchanged name for an engine
    that is not installed, as in recordings."""
    try:
        return tr(ENGINES.get(name).short) or name
    except ConfigError:
        return name


def display_name(name: str) -> str:
    """``index_mcp_flexion`` as ``index mcp flexion``, in the user's language."""
    return " ".join(tr(WORDS[part]) if part in WORDS else part for part in name.split("_"))
