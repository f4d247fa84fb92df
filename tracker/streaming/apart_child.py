"""The code of the outputs' process, see `tracker.streaming.apart`."""

from __future__ import annotations

import contextlib
import os
import pickle
import threading
from collections.abc import Sequence
from dataclasses import fields, replace
from functools import partial
from multiprocessing.connection import Connection
from typing import Any

from tracker.base.errors import notice_of
from tracker.base.notices import Notice
from tracker.hand.model import HandModel
from tracker.messages import Estimate
from tracker.streaming.apart_estimate import MARK, unpacked
from tracker.streaming.apart_messages import Counted, Reported, StreamReply, StreamRequest
from tracker.streaming.publisher import Names, Publisher, Title
from tracker.streaming.registry import STREAMS, close_all, open_stream
from tracker.streaming.streams import Streams, delivery

COUNT_EVERY = 0.5  # s
NICE = 5
CLOSE_WAIT = 10.0  # s to send what is queued, on a loaded computer; then the port is free


def _definition(hand: HandModel | None) -> list[Any]:
    """The fields of a hand, without what it has computed from them."""
    return [getattr(hand, f.name) for f in fields(HandModel)] if hand is not None else []


def _lower_priority() -> None:
    """On a loaded computer, tracking has priority: this process gets a smaller share of it, and
    does not interrupt another one when an estimate arrives (SCHED_BATCH; with SCHED_IDLE, two busy
    programs would stop all streams on two cores)."""
    if hasattr(os, "nice"):
        os.nice(NICE)
    if hasattr(os, "SCHED_BATCH"):
        with contextlib.suppress(OSError):  # not permitted in some containers
            os.sched_setscheduler(0, os.SCHED_BATCH, os.sched_param(0))


def serve(pipe: Connection) -> None:
    """Runs until the other end requests the end or disconnects."""
    _lower_priority()
    server = _StreamServer(pipe)
    try:
        while True:
            data = pipe.recv_bytes()
            if data.startswith(MARK):
                server.feed(*unpacked(data))
                continue
            item = pickle.loads(data)
            if item is None:
                break
            server.handle(item)
    except (EOFError, OSError):
        pass
    server.close()


class _Open:
    """One stream: its publishers, and a `Streams` for each hand once it sends."""

    def __init__(self, publishers: list[Publisher]) -> None:
        self.publishers = publishers
        self.streams: list[Streams] = []
        self.first: dict[int, int] = {}  # number of the first estimate of each hand

    def close(self) -> None:
        for each in self.streams:
            each.close(CLOSE_WAIT)
        if not self.streams:
            close_all(self.publishers)


class _StreamServer:
    """Requests are carried out in separate threads, since opening and testing take time. A stream
    that starts receives the next estimate."""

    def __init__(self, pipe: Connection) -> None:
        self._pipe, self._sending = pipe, threading.Lock()
        self._open: dict[int, _Open] = {}  # replaced, never changed
        self._changing = threading.Lock()
        self._hands: dict[bytes, Names] = {}
        self._ended = threading.Event()
        threading.Thread(target=self._count, name="glovetrack-counts", daemon=True).start()

    def feed(self, hand: int, estimate: Estimate) -> None:
        for stream in self._open.values():
            if hand < len(stream.streams):
                first = stream.first.setdefault(hand, estimate.seq)
                stream.streams[hand].offer(estimate, estimate.seq - first)

    def handle(self, request: StreamRequest) -> None:
        if request.do == "start":
            self._answer(request)
            return
        name = f"glovetrack-streams-{request.do}"
        threading.Thread(target=self._answer, args=(request,), name=name, daemon=True).start()

    def close(self) -> None:
        self._ended.set()
        for stream in self._open.values():
            stream.close()

    def _answer(self, request: StreamRequest) -> None:
        do = {
            "open": self._make,
            "start": self._start,
            "test": self._test,
            "close": self._end,
            "read": self._read,
        }
        try:
            result = do[request.do](request.key, request.data)
        except Exception as error:  # noqa: BLE001 - reported to the window
            self._send(StreamReply(request.number, problem=notice_of(error)))
        else:
            self._send(StreamReply(request.number, result))

    def _make(self, key: int, data: Any) -> list[Title]:
        kind, options, hands = data
        publishers = open_stream(STREAMS.get(kind), options, self._sharing(hands))
        with self._changing:
            self._open = {**self._open, key: _Open(publishers)}
        return [publisher.name for publisher in publishers]

    def _sharing(self, hands: Sequence[Names]) -> list[Names]:
        """The same hands of several streams share what is recognized of them."""
        out = []
        with self._changing:
            for names in hands:
                key = pickle.dumps((names.side, names.keypoints, _definition(names.hand)))
                known = self._hands.setdefault(key, names.sharing())
                out.append(replace(names, shared=known.shared))
        return out

    def _read(self, _key: int, line: Connection) -> None:
        """Estimates arrive by ``line``, too, from now on."""
        reader = threading.Thread(
            target=self._feed_from, args=(line,), name="glovetrack-line", daemon=True
        )
        reader.start()

    def _feed_from(self, line: Connection) -> None:
        try:
            while True:
                self.feed(*unpacked(line.recv_bytes()))
        except (EOFError, OSError):
            line.close()

    def _start(self, key: int, _data: Any) -> None:
        stream = self._open[key]
        stream.streams = [Streams([p], partial(self._report, key)) for p in stream.publishers]

    def _test(self, key: int, _data: Any) -> Notice:
        stream = self._open[key]
        sent = sum(counts.sent for each in stream.streams for counts in each.counts())
        return delivery(stream.publishers[0], sent)

    def _end(self, key: int, _data: Any) -> None:
        with self._changing:
            stream = self._open.get(key)
            self._open = {k: v for k, v in self._open.items() if k != key}
        if stream is not None:
            stream.close()

    def _report(self, key: int, what: Notice) -> None:
        self._send(Reported(key, what))

    def _count(self) -> None:
        while not self._ended.wait(COUNT_EVERY):
            every = self._open.items()
            self._send(Counted({k: tuple(s.counts()[0] for s in v.streams) for k, v in every}))

    def _send(self, item: object) -> None:
        with self._sending, contextlib.suppress(OSError, ValueError):
            self._pipe.send(item)
