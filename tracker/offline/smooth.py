"""Fixed-interval smoothing of a whole session, in memory that does not grow with it.

The filter runs forward once and leaves its state behind every few seconds. From the end, each block
is then run again from its first state, this time with a tape, which is then read backwards.
Messages and results wait in temporary files.

The backward pass is that of Bryson and Frazier (G. J. Bierman: Fixed interval smoothing with
discrete measurements. Int. J. Control 18 (1), 65-75, 1973, doi:10.1080/00207177308932487), on error
states. The adjoint λ (N,) accumulates what later measurements show: the best correction of a state
with covariance P is P λ. Nothing is inverted, and the estimates' own linearisation is reused.
"""

from __future__ import annotations

import pickle
import tempfile
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from typing import IO, Any

import numpy as np
from scipy.linalg import cho_factor, cho_solve

from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.engine.kinds import capabilities_of
from tracker.engine.settings import Settings
from tracker.fusion.chain.distal import DistalSegments
from tracker.fusion.chain.engine import ChainEngine
from tracker.fusion.chain.guided.events import GuidedPoseEvent, guided_of
from tracker.fusion.chain.layout import ChainLayout, P, V
from tracker.fusion.chain.params import ChainParams, NoiseParams, SynergyParams
from tracker.fusion.chain.pose_reset import is_reset
from tracker.fusion.chain.propagate import transition
from tracker.fusion.chain.shown import ShownHand
from tracker.fusion.chain.state import ChainState, inject
from tracker.fusion.output.output import Sensed
from tracker.fusion.time.imu_buffer import Moment
from tracker.messages import (
    Array,
    BlobFrame,
    Calibration,
    Estimate,
    Event,
    ImuSample,
    IntArray,
    Tracking,
)
from tracker.session.description import SessionInfo


@dataclass(frozen=True, eq=False)
class SmootherStep:
    """Phi (D, w): the dynamic rows of a transition against the first w columns."""

    Phi: Array

    def back(self, adjoint: Array) -> Array:
        D, width = self.Phi.shape
        out = adjoint.copy()
        out[:D] = 0.0
        out[:width] += self.Phi.T @ adjoint[:D]
        return out


@dataclass(frozen=True, eq=False)
class Update:
    """H (m, N), H P (m, N), the innovation's covariance S (m, m), innovation r (m,)."""

    H: Array
    HP: Array
    S: Array
    r: Array

    def back(self, adjoint: Array) -> Array:
        """λ + Hᵀ S⁻¹ (r - H P λ): the step through (I - K H)ᵀ and the innovation at once."""
        weighed = cho_solve(cho_factor(self.S, lower=True), self.r - self.HP @ adjoint)
        return adjoint + self.H.T @ weighed


@dataclass(frozen=True, eq=False)
class Forgotten:
    """The first ``rows`` error states were reset: later measurements do not affect earlier ones."""

    rows: int

    def back(self, adjoint: Array) -> Array:
        out = adjoint.copy()
        out[: self.rows] = 0.0
        return out


@dataclass(frozen=True, eq=False)
class _Shown:
    """An instant whose estimate is wanted: nominal state and the rows of P that it shows."""

    state: ChainState
    P_rows: Array  # (k, N)
    sensed: Sensed
    tip_sd: Array


def shown_rows(layout: ChainLayout) -> IntArray:
    """Error states that an estimate depends on: position, orientations, scales, joint offsets."""
    at = layout.blocks
    return np.r_[P:V, at.theta : layout.n_dynamic, at.scale : at.marker]


def smoothing_params(params: ChainParams) -> ChainParams:
    """Returns the filter's settings for smoothing.

    Errors of a marker's position and of anatomy hardly change from one image to the next, although
    the filter treats them as independent. A filter forgets older ones; smoothing accumulates them
    all, so each must have less weight. The factors are from simulated wearers.
    """
    c, prior, noise = params.constraint, params.prior, params.noise
    constraint = replace(
        c,
        rotation=4 * c.rotation,
        stiff_abduction=4 * c.stiff_abduction,
        synergy=4 * c.synergy,
        limit=8 * c.limit,
        tilt=0.7 * c.tilt,
    )
    return replace(
        params,
        constraint=constraint,
        prior=replace(prior, marker=1.5 * prior.marker),
        noise=replace(noise, marker=1.3 * noise.marker),
    )


class ChainTape:
    """A `Tape` of a chain filter with this layout; an estimate is put on it for each packet.

    Nothing is taken while ``recording`` is off.
    """

    def __init__(self, layout: ChainLayout) -> None:
        self._layout = layout
        self._shown_hand = ShownHand(layout, NoiseParams(), DistalSegments(layout, SynergyParams()))
        self._rows = shown_rows(layout)
        self._entries: list[SmootherStep | Update | Forgotten | _Shown] = []
        self.recording = False

    def wear(self, gains: Array, lateral: Array) -> None:
        """Smooth the hand of a wearer with these synergies, as `Completion.wear`."""
        self._shown_hand.wear(gains, lateral)

    # ---- recording the tape

    def step(self, state: ChainState, readings: Moment, dt: float) -> None:
        if self.recording:
            self._entries.append(SmootherStep(transition(state, self._layout, readings, dt)))

    def update(self, H: Array, HP: Array, S: Array, r: Array) -> None:
        if self.recording:
            self._entries.append(Update(H, HP, S, r))

    def forgotten(self, rows: int) -> None:
        if self.recording:
            self._entries.append(Forgotten(rows))

    def shown(self, state: ChainState, sensed: Sensed, tip_sd: Array) -> None:
        if self.recording:
            nominal = replace(state, P=np.zeros((0, 0)))
            self._entries.append(_Shown(nominal.copy(), state.P[self._rows], sensed, tip_sd))

    # ---- the backward pass

    def back(self, adjoint: Array) -> tuple[list[Estimate], Array]:
        """Go back along the tape, which is empty then.

        ``adjoint`` (N,) is λ at the tape's end. Returns the smoothed estimates, earliest first, and
        λ at the tape's start.
        """
        out = []
        for entry in reversed(self._entries):
            if isinstance(entry, _Shown):
                out.append(self._smoothed(entry, adjoint))
            else:
                adjoint = entry.back(adjoint)
        self._entries.clear()
        return out[::-1], adjoint

    def _smoothed(self, shown: _Shown, adjoint: Array) -> Estimate:
        dx = np.zeros(self._layout.blocks.size)
        dx[self._rows] = shown.P_rows @ adjoint
        state = shown.state.copy()
        inject(state, self._layout, dx)
        return self._shown_hand.estimate_of(state, state.t, shown.sensed, shown.tip_sd)


BLOCK_S = 4.0  # s; a tape grows by about 25 MB a second

Message = ImuSample | BlobFrame | Event
Fed = tuple[Message, Estimate | None]
"""A message and, for a packet, an estimate."""


class Smoother:
    """Feed a session, then take its `results`.

    Raises ConfigError for an engine whose estimates cannot be smoothed.
    """

    def __init__(self, info: SessionInfo, settings: Settings) -> None:
        if not capabilities_of(settings.engine).smoothing:
            raise ConfigError(notice("track.smooth_engine", engine=settings.engine))
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
        self._restarted: set[int] = set()  # blocks that begin with it

    @property
    def engine(self) -> ChainEngine:
        """The filter that runs forward."""
        return self._engine

    def feed(self, message: Message) -> None:
        """Feeds the next message of the session, in feed order."""
        now = message.t if isinstance(message, Event) else message.t_arrival
        if now > self._until and self._fed:
            self._close_block()
        if self._state is None:
            self._state = self._fresh = self._engine.get_state()
        if not self._fed:
            self._until = now + BLOCK_S
        self._fed.append((message, _run(self._engine, message)))

    def restart(self) -> None:
        """Restarts, since the tracked blobs were not the hand: the messages before are
        independent."""
        if self._fed:
            self._close_block()
        if self._state is not None:
            self._restarted.add(len(self._blocks))
            self._engine.set_state(self._fresh)
            self._state = self._fresh

    def _close_block(self) -> None:
        self._blocks.put((self._state, self._fed))
        self._state, self._fed = self._engine.get_state(), []

    def calibration(self) -> Calibration:
        """Returns the filter's calibration."""
        return self._engine.calibration()

    def results(self, progress: Callable[[float], None]) -> Iterator[Fed]:
        """Yields all messages again, each packet with its smoothed estimate."""
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
            if i == n - 1 or i + 1 in self._restarted:
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
    """Feeds the engine; returns the estimate of a packet that will not be smoothed."""
    if isinstance(message, Event):
        guided = guided_of(message)
        if is_reset(message):
            engine.reset_pose()
        elif isinstance(guided, GuidedPoseEvent):
            engine.wearer.take_guided_pose(guided, message.t)
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
