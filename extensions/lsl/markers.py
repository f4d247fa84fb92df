"""Records markers of other programs (Lab Streaming Layer) as notes with the markers' times.

Every stream of type ``Markers`` that is found is read. A marker's stamp is of its computer's LSL
clock; LSL measures how far that is from this one's, and the note keeps both, so that whoever reads
the session can do without that measurement or make a better one.
"""

from __future__ import annotations

import math
import threading
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import pylsl

from extensions.lsl.outlet import LOCAL_ONLY
from tracker.base.clock import monotonic
from tracker.streaming.remote.reception import Answer, DoorCounts, Reception
from tracker.streaming.remote.request import MOST_TEXT, Request

TYPE = "Markers"
POLL_EVERY, MEASURE_EVERY = 0.5, 5.0  # s: for streams, and how far their clocks are
PULL_EVERY = 0.005  # s
MEASURE_WAIT = 2.0  # s that the other side may take to report its clock
HOLD = 8.0  # s that a stream's first markers wait in its inlet for that
MOST_STREAMS = 16
MOST_BEHIND = 60  # s of markers that an inlet keeps
MARKERS_HZ = 100.0


@dataclass(eq=False)
class _Stream:
    """``offset``: s to add to its stamps for this computer's LSL clock; NaN where not known."""

    inlet: pylsl.StreamInlet
    name: str
    source: str
    since: float  # s of the clock
    offset: float = math.nan
    measured: float = -math.inf  # s of the clock
    lost: bool = False


class MarkerDoor:
    """Reads all streams of markers; ``network``: also other computers'. Raises as pylsl does."""

    port = 0

    def __init__(
        self, answer: Answer, network: bool = False, clock: Callable[[], float] = monotonic
    ) -> None:
        if not network:
            pylsl.set_config_content(LOCAL_ONLY)
        self._clock, self._reception = clock, Reception(answer, clock, MARKERS_HZ)
        self._streams: dict[str, _Stream] = {}
        self._lost: set[str] = set()
        self._resolver = pylsl.ContinuousResolver("type", TYPE, forget_after=5.0)
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._run, name="glovetrack-remote-lsl", daemon=True)
        self._thread.start()

    def counts(self) -> DoorCounts:
        where = "LSL, streams of markers"
        return self._reception.counts(where, len(self._streams))

    def close(self) -> None:
        self._ended.set()
        self._thread.join()

    def _run(self) -> None:
        due = -math.inf
        while not self._ended.wait(PULL_EVERY):
            now = self._clock()
            if now >= due:
                due = now + POLL_EVERY
                self._look()
            for stream in self._streams.values():
                if now >= stream.measured + MEASURE_EVERY:
                    self._measure(stream, now)
                if math.isfinite(stream.offset) or now > stream.since + HOLD:
                    self._pull(stream)
        for stream in self._streams.values():
            stream.inlet.close_stream()

    def _look(self) -> None:
        """Adds new streams and removes those that have ended."""
        found = {info.uid(): info for info in self._resolver.results()}
        removed = {uid for uid, stream in self._streams.items() if uid not in found or stream.lost}
        self._lost = (self._lost | removed) & set(found)  # the resolver lists them for a while
        for uid in removed:
            self._streams.pop(uid).inlet.close_stream()
        for uid, info in found.items():
            if (
                uid not in self._streams
                and uid not in self._lost
                and len(self._streams) < MOST_STREAMS
            ):
                inlet = pylsl.StreamInlet(info, max_buflen=MOST_BEHIND, recover=False)
                self._streams[uid] = _Stream(inlet, info.name(), info.source_id(), self._clock())

    def _measure(self, stream: _Stream, now: float) -> None:
        """How far its clock is; where that fails, what was known stays."""
        stream.measured = now if math.isfinite(stream.offset) else now - MEASURE_EVERY + POLL_EVERY
        try:
            stream.offset = stream.inlet.time_correction(MEASURE_WAIT)
            stream.measured = now
        except (pylsl.util.TimeoutError, pylsl.util.LostError):
            return

    def _pull(self, stream: _Stream) -> None:
        """All markers received."""
        try:
            while True:
                values, stamp = stream.inlet.pull_sample(timeout=0.0)
                if values is None or stamp is None:
                    return
                self._note(stream, [str(v) for v in values], stamp)
        except pylsl.util.LostError:
            stream.lost = True

    def _note(self, stream: _Stream, values: list[str], stamp: float) -> None:
        text = " ".join("".join(c if c.isprintable() else " " for c in v).strip() for v in values)
        arrived = self._reception.admit(stream.name)
        if arrived is None or not text.strip():
            return
        known = math.isfinite(stream.offset)
        to_clock = self._clock() - pylsl.local_clock()
        t = stamp + stream.offset + to_clock if known else arrived
        marker = {
            "stream": stream.name[:MOST_TEXT],
            "source": stream.source[:MOST_TEXT],
            "stamp": stamp,
            "clock_offset_s": stream.offset if known else None,
        }
        request = Request("note", t, text=text.strip()[:MOST_TEXT], data={"lsl": marker})
        self._reception.take(partial(_given, request))


def _given(request: Request) -> Request:
    return request
