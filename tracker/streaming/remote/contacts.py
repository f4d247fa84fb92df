"""Contacts of the wearer's fingers with objects of another program.

A contact is reported when it begins, when it changes, and at least every `LASTS` s: a program
that crashes leaves neither a motor running nor a contact without an end.
"""

from __future__ import annotations

import threading
from dataclasses import dataclass

from tracker.messages import Event
from tracker.streaming.remote.request import Request

KIND = "contact"
LASTS = 2.0  # s
MOST_CONTACTS = 64  # at one time, of all fingers
LEAST, MOST = 60, 255  # amplitudes of the faintest and of the strongest contact


@dataclass
class _Contact:
    """``reported``: time (s) of the last report."""

    strength: float
    reported: float


class ContactBook:
    """The current contacts of all fingers; for any thread."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._standing: dict[tuple[str, str], _Contact] = {}

    def tell(self, request: Request) -> list[Event]:
        """Applies a request; returns the contacts that it began or ended, and those that
        expired."""
        key = request.finger, request.object
        with self._lock:
            events = self._expire(request.t)
            known = self._standing.get(key)
            if request.strength <= 0.0:
                if known is not None:
                    del self._standing[key]
                    events.append(_event(request.t, key, "end", 0.0))
            elif known is not None:
                known.strength, known.reported = request.strength, request.t
            else:
                if len(self._standing) >= MOST_CONTACTS:
                    first = next(iter(self._standing))
                    del self._standing[first]
                    events.append(_event(request.t, first, "end", 0.0))
                self._standing[key] = _Contact(request.strength, request.t)
                events.append(_event(request.t, key, "begin", request.strength))
        return events

    def expired(self, t: float) -> list[Event]:
        """Ends of contacts that were not reported for `LASTS` s at ``t``."""
        with self._lock:
            return self._expire(t)

    def strength(self, finger: str) -> float:
        """Strength of a finger's strongest contact; 0 without one."""
        with self._lock:
            mine = [c.strength for key, c in self._standing.items() if key[0] == finger]
            return max(mine, default=0.0)

    def _expire(self, t: float) -> list[Event]:
        over = {k: c for k, c in self._standing.items() if t - c.reported > LASTS}
        for key in over:
            del self._standing[key]
        return [_event(c.reported + LASTS, key, "end", 0.0) for key, c in over.items()]


def motor_of(strength: float) -> tuple[int, int]:
    """Amplitude and duration (ms) of a motor's command; without a contact the motor stops at once.

    The amplitude grows with the square root of the strength, as the perceived one does.
    """
    if strength <= 0.0:
        return 0, 1
    return round(LEAST + (MOST - LEAST) * min(strength, 1.0) ** 0.5), round(1e3 * LASTS)


def _event(t: float, key: tuple[str, str], phase: str, strength: float) -> Event:
    finger, name = key
    data: dict[str, object] = {"finger": finger, "object": name, "phase": phase}
    return Event(t, KIND, "", {**data, "strength": round(strength, 3)})
