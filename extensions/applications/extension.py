"""What applications add to the program."""

from __future__ import annotations

from tracker.live.listeners import ListenedHand, Listener, ListenerKind


def _listener(hand: ListenedHand) -> Listener:
    from extensions.applications.live import listener

    return listener(hand)


LISTENER = ListenerKind("applications", "Applications", _listener)
