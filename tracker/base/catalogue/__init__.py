"""The English text of each notice, by its code: the one catalogue.

A text is a template: ``{name:spec}`` is replaced by the value of that name
(`tracker.base.notices` lists the specifications). Window translations use these texts as sources.
Extensions declare theirs as entry points of the group ``glovetrack.notices``.
"""

from __future__ import annotations

from tracker.base.catalogue import (
    devices,
    doctor,
    sessions,
    settings,
    stereo,
    tracking,
)

TEMPLATES: dict[str, str] = {
    **devices.TEXTS,
    **doctor.TEXTS,
    **tracking.TEXTS,
    **stereo.TEXTS,
    **sessions.TEXTS,
    **settings.TEXTS,
}

WORDS = (
    *("left", "right", "left lens", "right lens", "lens", "hand", "back of the hand"),
    *("red", "green", "blue", "yellow"),
    *("thumb", "index", "middle", "ring", "little"),
    *("top left", "top", "top right", "the middle", "bottom left", "bottom", "bottom right"),
    *("still", "silent", "unclear", "elsewhere", "turned"),
    *("hands", "gloves", "colours", "cameras", "robots", "the camera", "both cameras"),
    "too long",
    "nothing before or after it",
    "its ends or the sensors are not known",
    "a configuration file",
    "a mesh that can be read",
    "a folder",
    "a device, not a file",
    "the disk is full",
    "the disk quota is used up",
    "the disk allows no file this large",
    "you may not write there",
    "the disk can only be read",
    "the disk failed or was taken away",
    "the disk was taken away",
    "the network disk is disconnected",
    "the folder does not exist",
    "the name is too long",
    "a file of that name exists already",
    "a folder of that name exists already",
    "{} and {}",
    "{} or {}",
)
"""What values of notices may be, besides names and numbers: texts that have a translation."""
