"""The cues of the touch test, as events of a session: which finger touches which cross, and how."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from extensions.touch.sheet import BY_NAME
from tracker.base.notices import notice
from tracker.messages import Event

KIND = "touch"
KINDS = (KIND, "note")
"""Kinds of events that carry cues: the window writes notes."""
FINGERS = ("thumb", "index", "middle")
HOW = ("slow", "fast", "turned_left", "turned_right", "covered", "away")
"""Ways to touch. *covered*: the other hand hides a part of the markers; *away*: after five seconds
out of view."""

_CROSSES = {
    "thumb": ("2", "9", "6", "3", "5", "10", "7", "2"),
    "index": ("3", "11", "7", "2", "6", "10", "5", "3"),
    "middle": ("3", "10", "8", "2", "7", "11", "6", "3"),
}
_HOW = ("slow", "slow", "fast", "fast", "turned_left", "turned_right", "covered", "away")
PINCHES = 20
STILL = 10.0  # s


@dataclass(frozen=True)
class TouchCue:
    """What the wearer is asked for. ``what``: touch, pinch or still; the rest of a touch alone."""

    number: int
    what: str = "touch"
    finger: str = ""
    target: str = ""
    how: str = ""


@dataclass(frozen=True)
class Cued:
    """A cue and its time, s."""

    cue: TouchCue
    begin: float
    end: float


def touches() -> list[TouchCue]:
    """The 24 touches: eight of each finger."""
    out: list[TouchCue] = []
    for finger in FINGERS:
        for target, how in zip(_CROSSES[finger], _HOW, strict=True):
            out.append(TouchCue(len(out) + 1, "touch", finger, target, how))
    return out


def protocol() -> list[TouchCue]:
    """The touches, then the pinches and the still hand."""
    out = touches()
    return [*out, TouchCue(len(out) + 1, "pinch"), TouchCue(len(out) + 2, "still")]


def began(cue: TouchCue, t: float) -> Event:
    """The wearer is asked for ``cue`` from ``t`` (s) on."""
    data = {"cue": cue.what, "number": cue.number, "phase": "begin"}
    if cue.what != "touch":
        cued = notice("touch.cue_pinch" if cue.what == "pinch" else "touch.cue_still")
        return Event.of(t, KIND, cued, data)
    data |= {"finger": cue.finger, "target": cue.target, "how": cue.how}
    how = cue.how.replace("_", " ")
    cued = notice("touch.cue", finger=cue.finger, target=cue.target, how=how)
    return Event.of(t, KIND, cued, data)


def ended(cue: TouchCue, t: float, done: bool = True) -> Event:
    """The cue is over at ``t`` (s); ``done``: not skipped or to be repeated."""
    data = {"cue": cue.what, "number": cue.number, "phase": "end", "done": done}
    return Event(t, KIND, "", data)


def ruler(length: float, t: float) -> Event:
    """The user measured ``length`` (m) of the printed line of 260 mm."""
    data = {"cue": "ruler", "length_mm": 1000 * length}
    return Event.of(t, KIND, notice("touch.ruler", length_mm=1000 * length), data)


def ruler_of(events: Iterable[Event]) -> float | None:
    """m; the last length that was entered, None without one."""
    found = None
    for event in events:
        length_mm = event.data.get("length_mm")
        if event.kind in KINDS and event.data.get("cue") == "ruler":
            found = length_mm / 1000 if isinstance(length_mm, int | float) else found
    return found


def cues_of(events: Iterable[Event]) -> list[Cued]:
    """The cues that were carried out, in order of time; one that was repeated counts once, with
    its last attempt."""
    begun: dict[int, tuple[TouchCue, float]] = {}
    done: dict[int, Cued] = {}
    for event in events:
        number, phase = event.data.get("number"), event.data.get("phase")
        if event.kind not in KINDS or "cue" not in event.data or not isinstance(number, int):
            continue
        if phase == "begin":
            cue = _cue(event, number)
            if cue is not None:
                begun[number] = (cue, event.t)
        elif phase == "end" and number in begun:
            cue, begin = begun.pop(number)
            if event.data.get("done") is True:
                done[number] = Cued(cue, begin, event.t)
    return sorted(done.values(), key=lambda c: c.begin)


def _cue(event: Event, number: int) -> TouchCue | None:
    """None where the event asks for nothing that this version knows."""
    what = str(event.data.get("cue"))
    if what in ("pinch", "still"):
        return TouchCue(number, what)
    finger, target, how = (str(event.data.get(k)) for k in ("finger", "target", "how"))
    known = what == "touch" and finger in FINGERS and target in BY_NAME and how in HOW
    return TouchCue(number, what, finger, target, how) if known else None
