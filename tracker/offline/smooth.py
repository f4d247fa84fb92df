"""Fixed-interval smoothing of a whole session, in memory that does not grow with it.

The filter runs forward once and leaves its state behind every few seconds. From the end, each block
is then run again from its first state, this time with a tape (`smooth_chain`), and gone back over.
Messages and results wait in temporary files.
"""

from __future__ import annotations

import pickle
import tempfile
from collections.abc import Callable, Iterator
from typing import IO, Any

import numpy as np

from tracker.base.errors import ConfigError
from tracker.engine.kinds import capabilities_of
from tracker.engine.settings import Settings
from tracker.fusion.chain.engine import ChainEngine
from tracker.fusion.chain.guided.events import GuidedSaid, guided_of
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.pose_reset import is_reset
from tracker.messages import BlobFrame, Calibration, Estimate, Event, ImuSample, Tracking
from tracker.offline.smooth_chain import ChainTape, smoothing_params
from tracker.session.description import SessionInfo

BLOCK_S = 4.0  # s; a tape takes some 25 MB a second

Message = ImuSample | BlobFrame | Event
Fed = tuple[Message, Estimate | None]
"""A message and, for a packet, an estimate."""


class Smoother:
    """Feed a session, then take its `results`.

    Raises ConfigError for an engine whose estimates cannot be smoothed.
    """

    def __init__(self, info: SessionInfo, settings: Settings) -> None:
        if not capabilities_of(settings.engine).smoothing:
            raise ConfigError(f"Smoothing is for the engine chain, not for {settings.engine}.")
        assert info.rig is not None
        self.side = info.side
        layout, params = ChainLayout(info.hand, info.glove), smoothing_params(settings.chain)
        self._tape, self._size = ChainTape(layout), layout.blocks.size
        self._engine = ChainEngine(info.hand, info.glove, info.rig, params, self._tape)
        self._blocks = Shelf()  # (state at the start, messages)
        self._state: Any = None
        self._fed: list[Fed] = []
        self._until = -np.inf
        self._fresh: Any = None  # the state before anything was fed
        self._anew: set[int] = set()  # blocks that begin with it

    @property
    def engine(self) -> ChainEngine:
        """The filter that runs forward."""
        return self._engine

    def feed(self, message: Message) -> None:
        """The next message of the session, in feed order."""
        now = message.t if isinstance(message, Event) else message.t_arrival
        if now > self._until and self._fed:
            self._close_block()
        if self._state is None:
            self._state = self._fresh = self._engine.get_state()
        if not self._fed:
            self._until = now + BLOCK_S
        self._fed.append((message, _run(self._engine, message)))

    def begin_anew(self) -> None:
        """What was taken for the hand is none: what comes tells nothing of what was before."""
        if self._fed:
            self._close_block()
        if self._state is not None:
            self._anew.add(len(self._blocks))
            self._engine.set_state(self._fresh)
            self._state = self._fresh

    def _close_block(self) -> None:
        self._blocks.put((self._state, self._fed))
        self._state, self._fed = self._engine.get_state(), []

    def calibration(self) -> Calibration:
        """What the filter has learned by now."""
        return self._engine.calibration()

    def results(self, progress: Callable[[float], None]) -> Iterator[Fed]:
        """All messages again, each packet with its smoothed estimate."""
        self._close_block()
        smoothed = Shelf()
        self._tape.wear(*self._engine.wearer.synergies)
        adjoint = np.zeros(self._size)
        n = len(self._blocks)
        for i in reversed(range(n)):
            state, fed = self._blocks.get(i)
            self._engine.set_state(state)
            self._tape.recording = True
            for message, _ in fed:
                _run(self._engine, message)
            if i == n - 1 or i + 1 in self._anew:
                self._engine.catch_up()
                adjoint = np.zeros(self._size)
            estimates, adjoint = self._tape.back(adjoint)
            smoothed.put(estimates)
            progress((n - i) / n)
        yield from self._merged(smoothed)

    def _merged(self, smoothed: Shelf) -> Iterator[Fed]:
        """The filter lags, so a packet's estimate is in its own block or in the next one."""
        n, loaded = len(self._blocks), 0
        ready: dict[float, Estimate] = {}
        for i in range(n):
            while loaded < min(i + 2, n):
                ready.update((e.t, e) for e in smoothed.get(n - 1 - loaded))
                loaded += 1
            for message, estimate in self._blocks.get(i)[1]:
                if isinstance(message, ImuSample):
                    estimate = ready.pop(message.t, estimate)
                yield message, estimate


def _run(engine: ChainEngine, message: Message) -> Estimate | None:
    """Feed the engine; what it shows of a packet for which nothing better will come."""
    if isinstance(message, Event):
        said = guided_of(message)
        if is_reset(message):
            engine.reset_pose()
        elif isinstance(said, GuidedSaid):
            engine.wearer.hear(said, message.t)
        return None
    if isinstance(message, BlobFrame):
        engine.feed_frame(message)
        engine.take_results()
        return None
    estimate = engine.feed_imu(message)
    on_tape = engine.tracking != Tracking.SEARCHING and engine.newest == message.t
    return None if on_tape else estimate


class Shelf:
    """Objects in a temporary file, by number."""

    def __init__(self) -> None:
        self._file: IO[bytes] = tempfile.TemporaryFile()  # noqa: SIM115 - lives with the shelf
        self._at: list[int] = []

    def __len__(self) -> int:
        return len(self._at)

    def put(self, value: Any) -> None:
        self._at.append(self._file.seek(0, 2))
        pickle.dump(value, self._file, pickle.HIGHEST_PROTOCOL)

    def get(self, number: int) -> Any:
        self._file.seek(self._at[number])
        return pickle.load(self._file)
