"""What receives every estimate of a hand: a plug-in under ``glovetrack.listeners``.

A `ListenerKind` makes a `Listener` for each hand, live and in a replay. A `RemoteListenerKind`
makes one that runs in the process that tracks, and its representative in the window's process.
"""

from tracker.live.listeners import (
    ListenedHand,
    Listener,
    ListenerKind,
    ListenerLine,
    ListenerProxy,
    LiveAccess,
    RemoteListener,
    RemoteListenerKind,
    Vibrate,
)
from tracker.messages import Estimate, Event

__all__ = [
    "Estimate",
    "Event",
    "ListenedHand",
    "Listener",
    "ListenerKind",
    "ListenerLine",
    "ListenerProxy",
    "LiveAccess",
    "RemoteListener",
    "RemoteListenerKind",
    "Vibrate",
]
