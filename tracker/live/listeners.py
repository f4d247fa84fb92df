"""What other packages attach to a tracked hand: each listener receives every estimate of it.

A package declares a `ListenerKind` as an entry point of the group ``glovetrack.listeners``. Its
listeners are fed by live tracking and by the replay of a recording. If a process of its own tracks
for the window, they are in the window's process; those of a `RemoteListenerKind` are in the process
that tracks, so that they receive estimates and drive motors without waiting for the window.
"""

from __future__ import annotations

import logging
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from functools import partial
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, Protocol, cast

from tracker.base.errors import notice_of
from tracker.base.notices import Notice, failure
from tracker.base.registry import Registry

if TYPE_CHECKING:  # a descriptor is imported to list it
    from tracker.glove.model import GloveModel
    from tracker.hand.model import HandModel
    from tracker.live.telemetry import Telemetry
    from tracker.live.work_priority import WorkPriority
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
    priority: WorkPriority
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


class RemoteListener(Listener, Protocol):
    """A listener that a process of its own can track for; the window has a `ListenerProxy`."""

    def news(self) -> object:
        """What the window shows, for pickle; None if that has not changed. Called by one thread."""


class ListenerLine(Protocol):
    """Calls methods of a `RemoteListener` from the window."""

    def ask(self, method: str, *args: object) -> Any:
        """The result. Raises what the method has raised, or DeviceError without an answer."""

    def tell(self, method: str, *args: object) -> None:
        """Does not wait."""


class ListenerProxy(Listener, Protocol):
    """The window's representative of a `RemoteListener`."""

    def take(self, news: Any) -> None:
        """What `RemoteListener.news` has returned; each, in order, on one thread."""


@dataclass(frozen=True)
class RemoteListenerKind(ListenerKind):
    """Describes a listener that runs in the process that tracks: ``make`` makes a `RemoteListener`,
    and ``proxy`` the window's representative of it."""

    proxy: Callable[[ListenerLine], ListenerProxy] = field(kw_only=True)


LISTENERS = Registry("listeners", "listener", ListenerKind)


def remote_kinds() -> list[RemoteListenerKind]:
    """Kinds of the listeners that run in the process that tracks."""
    return [kind for kind in LISTENERS.all().values() if isinstance(kind, RemoteListenerKind)]


def local_kinds() -> list[ListenerKind]:
    """Kinds of the others."""
    return [k for k in LISTENERS.all().values() if not isinstance(k, RemoteListenerKind)]


class Listeners:
    """The listeners of one hand; empty until `attach`.

    A listener that raises is closed and removed, and ``report`` receives a notice about it.
    """

    def __init__(self, report: Callable[[Notice], None]) -> None:
        self._report = report
        self.by_name: Mapping[str, Listener] = MappingProxyType({})  # replaced, never changed

    def attach(self, hand: ListenedHand, kinds: Iterable[ListenerKind] | None = None) -> None:
        """Make a listener of each of the ``kinds``, by default of all that packages declare."""
        wanted = LISTENERS.all().values() if kinds is None else kinds
        self._add({kind.name: partial(kind.make, hand) for kind in wanted})

    def attach_proxies(self, line_to: Callable[[str], ListenerLine]) -> None:
        """Make the representatives of the listeners in another process; ``line_to`` returns the
        way to the one of a name."""
        self._add({kind.name: partial(kind.proxy, line_to(kind.name)) for kind in remote_kinds()})

    def _add(self, makers: Mapping[str, Callable[[], Listener]]) -> None:
        made = dict(self.by_name)
        for name, make in makers.items():
            try:
                made[name] = make()
            except Exception as error:  # noqa: BLE001 - another package must not stop tracking
                self._fail(name, error)
        self.by_name = MappingProxyType(made)

    def feed(self, estimate: Estimate, t_arrival: float) -> None:
        """Give all an estimate whose packet arrived at ``t_arrival`` (s)."""
        for name, listener in self.by_name.items():
            try:
                listener.feed(estimate, t_arrival)
            except Exception as error:  # noqa: BLE001 - another package must not stop tracking
                self._remove(name, listener, error)

    def take(self, news: Mapping[str, object]) -> None:
        """Give the representatives of listeners in another process their news, by name."""
        for name, its in news.items():
            proxy = cast("ListenerProxy | None", self.by_name.get(name))
            if proxy is None:
                continue
            try:
                proxy.take(its)
            except Exception as error:  # noqa: BLE001 - another package must not stop tracking
                self._remove(name, proxy, error)

    def _remove(self, name: str, listener: Listener, error: Exception) -> None:
        left = {n: other for n, other in self.by_name.items() if n != name}
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
