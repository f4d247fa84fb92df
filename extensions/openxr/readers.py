"""Which applications read the hand: what each layer writes into the shared memory."""

from __future__ import annotations

import time
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from extensions.openxr.layout import (
    HEADER,
    MAGIC,
    READER,
    READERS,
    READERS_AT,
    SIDES,
    VERSION,
    Clock,
)
from extensions.openxr.memory import attach

RECENT_NS = 1_000_000_000


@dataclass(frozen=True)
class Reader:
    """An application: its process, the instant of its latest reading, how many readings there were
    and how many of them returned a hand."""

    process: int
    name: str
    last_ns: int
    readings: int
    active: int

    def is_reading(self, now_ns: int) -> bool:
        """Whether it read the hand within the last second."""
        return now_ns - self.last_ns < RECENT_NS


@dataclass(frozen=True)
class Link:
    """What the shared memory contains at the instant ``now_ns`` of its own clock."""

    running: bool
    hands: tuple[int, ...]
    """Samples of the left and of the right hand; none: the hand is not sent."""
    readers: tuple[Reader, ...]
    now_ns: int


def readers_of(entries: NDArray[np.void]) -> list[Reader]:
    """Those of (READERS,) of `READER`; an entry that is being written is returned unchanged."""
    return [
        Reader(
            int(entry["process"]),
            bytes(entry["name"]).decode("utf-8", "replace"),
            int(entry["last"]),
            int(entry["readings"]),
            int(entry["active"]),
        )
        for entry in entries.copy()
        if entry["process"]
    ]


def read_link(name: str = "") -> Link | None:
    """The state of the memory, ``name`` if it is not the usual one; None if there is none."""
    memory = attach(name)
    if memory is None:
        return None
    with memory:
        header = np.frombuffer(memory, HEADER, 1)[0].copy()
        entries = np.frombuffer(memory, READER, READERS, READERS_AT).copy()
    if header["magic"] != MAGIC or header["version"] != VERSION:
        return None
    return Link(
        bool(header["running"]),
        tuple(int(hand["count"]) for hand in header["hands"]),
        tuple(readers_of(entries)),
        clock_ns(Clock(int(header["clock"]))),
    )


def link_lines(link: Link | None) -> list[str]:
    """What a running program sends, and a line for each application that read it."""
    if link is None or not link.running:
        return ["stream: off"]
    hands = [f"{side} {n}" for side, n in zip(SIDES, link.hands, strict=True) if n]
    lines = [f"stream: on, estimates: {', '.join(hands) or 'none'}"]
    if not link.readers:
        return [*lines, "applications: none has read the hand"]
    return [*lines, *(_reader_line(reader, link.now_ns) for reader in link.readers)]


def _reader_line(reader: Reader, now_ns: int) -> str:
    since = (now_ns - reader.last_ns) / 1e9
    when = "now" if reader.is_reading(now_ns) else f"{since:.0f} s ago"
    return (
        f"application: {reader.name} (process {reader.process}), last reading: {when}, "
        f"readings: {reader.readings}, with an active hand: {reader.active}"
    )


def clock_ns(clock: Clock) -> int:
    """Now, ns of the clock whose stamps the memory has."""
    return time.monotonic_ns() if clock == Clock.MONOTONIC else time.perf_counter_ns()
