"""A way in of remote control as a row: whether it is open and who asks."""

from __future__ import annotations

from app.viewmodels.states import BAD, GOOD, IDLE
from app.viewmodels.streams import StreamRow
from app.words import tr
from tracker.streaming.remote.doors import is_loopback as is_loopback
from tracker.streaming.remote.reception import DoorCounts

LATELY = 60.0  # s for which who asked by a datagram counts as there


def door_row(on: bool, counts: DoorCounts | None, problem: str) -> StreamRow:
    """Its ``sent`` are the requests taken, its ``dropped`` those that were not."""
    if problem:
        return StreamRow(BAD, tr("not open"), "–", "–", "–", problem)
    if not on:
        return StreamRow(IDLE, tr("off"), "–", "–", "–", "")
    if counts is None:
        return StreamRow(IDLE, tr("opening"), "–", "–", "–", "")
    lately = [(peer, ago) for peer, ago in counts.peers if ago < LATELY]
    clients = len(lately) if counts.clients is None else counts.clients
    state = tr("somebody is there") if clients else tr("nobody asks")
    told = [tr("{}, {} s ago").format(peer, f"{ago:.0f}") for peer, ago in reversed(lately)]
    tip = "\n".join([counts.name, *told[:8]])
    return StreamRow(GOOD, state, str(clients), str(counts.asked), str(counts.refused), tip)
