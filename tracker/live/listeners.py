"""What other packages attach to a tracked hand: each listener receives every estimate of it.

A package declares a `ListenerKind` as an entry point of the group ``glovetrack.listeners``. Its
listeners are fed by live tracking and by the replay of a recording.
"""

from __future__ import annotations

import logging
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import TYPE_CHECKING, Protocol

from tracker.base.errors import notice_of
from tracker.base.notices import Notice, failure
from tracker.base.registry import Registry

if TYPE_CHECKING:  # a descriptor is imported to list it
    from tracker.glove.model import GloveModel
    from tracker.hand.model import HandModel
    from tracker.live.right_of_way import RightOfWay
    from tracker.live.telemetry import Telemetry
    from tracker.messages import Estimate, Event

_log = logging.getLogger(__name__)

Vibrate = Callable[[int, int, int], bool]
"""Drives a motor: channel, amplitude 0..255, duration in ms; returns whether the glove was sent
the command."""


class Listener(Protocol):
    """Receives all estimates of one hand, in order, on one thread."""

    def feed(self, estimate: Estimate, t_arrival: float) -> None:
        """Process an estimate whose packet arrived at ``t_arrival`` (s).

        Live, this is called on the engine's thread, so it must not wait.
        """

    def restart(self) -> None:
        """Start over with the next estimate: a recording begins or a replay has jumped.

        May be called from any thread.
        """

    def close(self) -> None:
        """Stop devices and end threads. May be called again."""


@dataclass(frozen=True, eq=False)
class LiveAccess:
    """The parts of live tracking that a listener may use.

    ``record`` adds an event to a running recording, from any thread. ``clock`` returns s.
    ``priority`` must be entered for work on a thread of the listener's. ``vibrate`` is None for a
    glove without motors.
    """

    record: Callable[[Event], None]
    telemetry: Telemetry
    clock: Callable[[], float]
    priority: RightOfWay
    vibrate: Vibrate | None = None


@dataclass(frozen=True, eq=False)
class ListenedHand:
    """The hand that a listener is created for. Without ``live`` a recording is replayed: `feed` is
    then called on the player's thread and may block, and no device may be driven."""

    hand: HandModel
    glove: GloveModel
    live: LiveAccess | None = None


@dataclass(frozen=True)
class ListenerKind:
    """Describes a listener; ``make`` is called once for each hand, ``extra`` is what to install."""

    name: str
    title: str
    make: Callable[[ListenedHand], Listener]
    extra: str = ""


LISTENERS = Registry("listeners", "listener", ListenerKind)


class Listeners:
    """The listeners of one hand; empty until `attach`.

    A listener that raises is closed and removed, and ``report`` receives a notice about it.
    """

    def __init__(self, report: Callable[[Notice], None]) -> None:
        self._report = report
        self.by_name: Mapping[str, Listener] = MappingProxyType({})  # replaced, never changed

    def attach(self, hand: ListenedHand) -> None:
        """Make a listener of each kind that packages declare."""
        made = {}
        for name, kind in LISTENERS.all().items():
            try:
                made[name] = kind.make(hand)
            except Exception as error:  # noqa: BLE001 - another package must not stop tracking
                self._fail(name, error)
        self.by_name = MappingProxyType(made)

    def feed(self, estimate: Estimate, t_arrival: float) -> None:
        """Give all an estimate whose packet arrived at ``t_arrival`` (s)."""
        for name, listener in self.by_name.items():
            try:
                listener.feed(estimate, t_arrival)
            except Exception as error:  # noqa: BLE001 - another package must not stop tracking
                left = {n: listener for n, listener in self.by_name.items() if n != name}
                self.by_name = MappingProxyType(left)
                self._fail(name, error)
                _close(name, listener)

    def restart(self) -> None:
        """Have all start over with the next estimate."""
        for listener in self.by_name.values():
            listener.restart()

    def close(self) -> None:
        """Close all. May be called again."""
        for name, listener in self.by_name.items():
            _close(name, listener)

    def _fail(self, name: str, error: Exception) -> None:
        _log.error("The listener %s failed", name, exc_info=error)
        self._report(failure("listener.failed", name=name, why=notice_of(error)))


def _close(name: str, listener: Listener) -> None:
    try:
        listener.close()
    except Exception:  # noqa: BLE001 - another package must not stop tracking
        _log.exception("The listener %s could not be closed", name)
