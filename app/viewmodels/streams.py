"""Table rows of live outputs and of remote control servers."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any

from app.viewmodels.states import BAD, GOOD, IDLE, WARN, StateLook
from app.words import notice_text, shown, tr
from tracker.base.notices import Notice, Severity
from tracker.hand.names import CHAINS
from tracker.streaming.connection import HOST, ConnectionKind
from tracker.streaming.publisher import OPENXR as OPENXR
from tracker.streaming.publisher import OWN as OWN
from tracker.streaming.remote.doors import is_loopback as is_loopback
from tracker.streaming.remote.reception import DoorCounts
from tracker.streaming.streams import StreamCounts

MOTORS = tuple(CHAINS)
"""The fingers, in the order of the glove's vibration motors."""


RECENT = 60.0  # s for which the sender of a datagram counts as connected


@dataclass(frozen=True)
class StreamRow:
    """Texts of one row; ``tip`` explains the state."""

    look: StateLook
    state: str
    clients: str
    sent: str
    dropped: str
    tip: str


def stream_row(on: bool, running: bool, counts: StreamCounts | None, problem: str) -> StreamRow:
    """``running``: an engine runs; ``problem``: why the stream could not be opened."""
    if problem:
        return StreamRow(BAD, tr("not open"), "–", "–", "–", problem)
    if not on:
        return StreamRow(IDLE, tr("off"), "–", "–", "–", "")
    if counts is None:
        state = tr("opening") if running else tr("waiting for tracking")
        return StreamRow(IDLE, state, "–", "–", "–", "")
    clients = "–" if counts.clients is None else str(counts.clients)
    look, state = (WARN, tr("failing")) if counts.error else (GOOD, tr("sending"))
    if not counts.error and counts.clients == 0:
        state = tr("no listeners")
    tip = "\n".join([shown(counts.error or counts.name), *_missed(counts)])
    return StreamRow(look, state, clients, _sent(counts), str(counts.left_out), tip)


def _sent(counts: StreamCounts) -> str:
    """Number of messages, and messages per second, of each hand: ``1200 (100 + 99 Hz)``."""
    rates = " + ".join(f"{rate:.0f}" for rate in counts.rates_hz)
    return f"{counts.sent} ({rates} Hz)" if rates else str(counts.sent)


def _missed(counts: StreamCounts) -> list[str]:
    """A line for each cause of messages that were not sent."""
    lines = [
        (counts.dropped, tr("{} discarded: this computer is overloaded").format(counts.dropped)),
        (counts.failed, tr("{} could not be sent").format(counts.failed)),
    ]
    for client, n in counts.missed.items():
        who = client or tr("disconnected clients")
        lines.append((n, tr("{} missed by {}").format(n, who)))
    return [text for n, text in lines if n]


def door_row(on: bool, counts: DoorCounts | None, problem: str) -> StreamRow:
    """``sent``: accepted requests; ``dropped``: refused ones."""
    if problem:
        return StreamRow(BAD, tr("not open"), "–", "–", "–", problem)
    if not on:
        return StreamRow(IDLE, tr("off"), "–", "–", "–", "")
    if counts is None:
        return StreamRow(IDLE, tr("opening"), "–", "–", "–", "")
    recent = [(peer, ago) for peer, ago in counts.peers if ago < RECENT]
    clients = len(recent) if counts.clients is None else counts.clients
    state = tr("connected") if clients else tr("no clients")
    requests = [tr("{}, {} s ago").format(peer, f"{ago:.0f}") for peer, ago in reversed(recent)]
    tip = "\n".join([shown(counts.name), *requests[:8]])
    return StreamRow(GOOD, state, str(clients), str(counts.asked), str(counts.refused), tip)


ELSEWHERE = (HOST, "port", "file")
"""Options that the row of a connection has, or all connections share."""


@dataclass(frozen=True)
class OptionField:
    """One option of a connection in a form: its value, and the values it can have if these are
    few. ``help`` is a text to be translated."""

    name: str
    help: str
    value: Any
    choices: tuple[Any, ...] = ()


def option_fields(kind: ConnectionKind[Any], options: Any = None) -> list[OptionField]:
    """The fields of a form for ``options``, by default for the default values."""
    values = kind.options() if options is None else options
    return [
        OptionField(
            each.name,
            each.metadata.get("help", ""),
            getattr(values, each.name),
            each.metadata.get("choices", ()),
        )
        for each in fields(kind.options)
        if each.name not in ELSEWHERE
    ]


TEST_LOOKS = {Severity.INFO: GOOD, Severity.WARNING: WARN, Severity.ERROR: BAD}
"""Received; unknown; not received."""


def tested(found: Notice) -> tuple[StateLook, str]:
    """For a test whether a program receives a stream."""
    return TEST_LOOKS[found.severity], notice_text(found)
