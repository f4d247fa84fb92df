"""Gloves that were set up before, recognized by their number on any port."""

from __future__ import annotations

from dataclasses import asdict, dataclass, replace
from typing import Any, Protocol

from app.storage.settings import AppSettings
from app.words import tr


@dataclass(frozen=True)
class BoundGlove:
    """Side, files and wearer (a name, or empty) of one glove; ``port`` if the system does not list
    it, such as Bluetooth ports."""

    side: str
    glove: str
    hand: str
    wearer: str = ""
    port: str = ""


class GloveSettings(Protocol):
    """The settings that contain the gloves."""

    @property
    def gloves(self) -> dict[str, Any]: ...


def bound(settings: GloveSettings, glove_id: int | None) -> BoundGlove | None:
    """The stored glove of that number; None if it is new or has not reported a number."""
    stored = settings.gloves.get(str(glove_id)) if glove_id is not None else None
    if not isinstance(stored, dict):
        return None
    words = [stored.get(name) for name in ("side", "glove", "hand", "wearer")]
    words.append(stored.get("port", ""))  # older versions did not store it
    if not all(isinstance(word, str) for word in words):
        return None
    return BoundGlove(*map(str, words))


def bound_of(settings: GloveSettings, side: str) -> tuple[int, BoundGlove] | None:
    """Number and files of the glove used last on this side."""
    for number in reversed([n for n in settings.gloves if n.isdecimal()]):
        known = bound(settings, int(number))
        if known is not None and known.side == side:
            return int(number), known
    return None


def ports_of(settings: GloveSettings) -> list[str]:
    """Ports of gloves that the system does not list."""
    known = (bound(settings, int(number)) for number in settings.gloves if number.isdecimal())
    return [glove.port for glove in known if glove is not None and glove.port]


def with_bound(settings: GloveSettings, glove_id: int, glove: BoundGlove) -> dict[str, Any]:
    """The gloves of the settings including this one, to be stored."""
    others = {number: g for number, g in settings.gloves.items() if number != str(glove_id)}
    return {**others, str(glove_id): asdict(glove)}


def as_bound(settings: AppSettings, glove_id: int | None) -> tuple[AppSettings, str]:
    """The settings with the files of the recognized glove, and a message if they differ from those
    used last: a left glove must not be tracked with the files of a right one."""
    known = bound(settings, glove_id)
    if known is None or (known.glove, known.hand) == (settings.glove, settings.hand):
        return settings, ""
    words = tr("Glove {} ({} hand) was recognized. Its own files {} and {} are used.")
    side = tr("left") if known.side == "left" else tr("right")
    message = words.format(glove_id, side, known.glove, known.hand)
    return replace(settings, glove=known.glove, hand=known.hand), message
