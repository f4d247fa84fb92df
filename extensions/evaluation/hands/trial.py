"""Tracks one simulated pair of hands together, and each hand alone and covered."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from extensions.evaluation.sessions import blobs_of, people_of
from tracker.engine.hands import Hands
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.engine.side_watch import ExchangeWatch, SideWatch
from tracker.glove import library
from tracker.hand.names import MARKED_KEYPOINTS, SIDES
from tracker.messages import Array, BlobFrame, Estimate, ImuSample, Tracking
from tracker.online.hue_names import hue_names_event
from tracker.simulation.scenario import Simulation, SimulationParams
from tracker.simulation.two_hands import GlovedHand, TwoHandsSimulation

GLOVES = {"left": "vist-small-left", "right": "vist-small"}
SETTLED = 2.0  # s until which a wearer's hand is learned first
EVERY = 5  # packets between compared instants
EXCHANGED_MM = 35.0  # m·1e-3: a larger error means that the hand follows the other hand's markers


@dataclass(frozen=True)
class HandFigures:
    """Figures of one hand in one trial: mean errors (mm) together, alone, and covered (occluded by
    the other hand, which has no markers) over instants at which its position is known in all three;
    ``known`` and ``tracked``: shares of the instants; and the longest time (s) with an error above
    `EXCHANGED_MM`."""

    seed: int
    side: str
    together_mm: float
    alone_mm: float
    covered_mm: float
    known: float
    tracked: float
    longest_off_s: float

    @property
    def ratio(self) -> float:
        return self.together_mm / self.alone_mm

    @property
    def confusion(self) -> float:
        """Error caused by the other hand's markers, in addition to that of its occlusion."""
        return self.together_mm / self.covered_mm


@dataclass(frozen=True)
class _TrialErrors:
    """One hand at instants t (n,) s: errors (n,) mm, NaN where lost, and whether it is tracked."""

    t: Array
    off_mm: Array
    tracked: Array


def run_trial(
    seed: int,
    seconds: float,
    engine: str = "chain",
    fps: float = 60.0,
    session: str = "",
    progress: Callable[[float], None] = lambda share: None,
) -> list[HandFigures]:
    """Run both hands of one seed; a task of `tracker.base.workers`."""
    dressed = {side: GlovedHand(*library.load(name, "")) for side, name in GLOVES.items()}
    params = SimulationParams(wearer=people_of(session))
    sim = TwoHandsSimulation(dressed, seed, seconds, fps, params)
    together = _together(sim, engine, session)
    return [
        _figures(
            seed,
            side,
            _shown(sim.hands[side], together[side]),
            _tracked_alone(sim.alone[side], engine, session),
            _tracked_alone(sim.hands[side], engine, session),
        )
        for side in SIDES
    ]


def _figures(
    seed: int, side: str, both: _TrialErrors, alone: _TrialErrors, covered: _TrialErrors
) -> HandFigures:
    known = np.isfinite(both.off_mm)
    common = known & np.isfinite(alone.off_mm) & np.isfinite(covered.off_mm)
    return HandFigures(
        seed,
        side,
        float(both.off_mm[common].mean()),
        float(alone.off_mm[common].mean()),
        float(covered.off_mm[common].mean()),
        float(known.mean()),
        float(both.tracked.mean()),
        longest(both.t, both.off_mm > EXCHANGED_MM),
    )


def longest(t: Array, wrong: NDArray[np.bool_]) -> float:
    """Duration in s of the longest run of True over the instants t (n,)."""
    best, since = 0.0, np.nan
    for instant, is_wrong in zip(t, wrong, strict=True):
        if not is_wrong:
            since = np.nan
            continue
        since = instant if np.isnan(since) else since
        best = max(best, float(instant - since))
    return best


def _make(hand: Simulation, engine: str) -> Pipeline:
    return Pipeline(hand.hand, hand.glove, hand.rig, Settings(engine=engine))


def _together(sim: TwoHandsSimulation, engine: str, session: str) -> dict[str, list[Estimate]]:
    hands = Hands({side: partial(_make, hand, engine) for side, hand in sim.hands.items()})
    watch = ExchangeWatch(hands) if session == "exchanged" else None
    out: dict[str, list[Estimate]] = {side: [] for side in SIDES}
    for side, message in sim.messages():
        if isinstance(message, BlobFrame):
            frame = blobs_of(session, message)
            hands.feed_frame(frame)
            if watch is not None:
                watch.frame(frame)
        elif isinstance(message, ImuSample):
            estimate = hands.feed_imu(side, message)
            if watch is not None:
                watch.packet(side, message, estimate.tracking)
                for of, names in watch.take_names().items():
                    own = hands.pipelines[of]
                    own.feed_event(hue_names_event(own.glove.hues, names, message.t))
            if message.seq % EVERY == 0:
                out[side].append(estimate)
    return out


def _tracked_alone(hand: Simulation, engine: str, session: str) -> _TrialErrors:
    """Errors of a simulated hand without the other hand's blobs."""
    pipeline, out = _make(hand, engine), []
    watch = SideWatch(pipeline) if session == "exchanged" else None
    for message in hand.feed():
        if isinstance(message, BlobFrame):
            frame = blobs_of(session, message)
            pipeline.feed_frame(frame)
            if watch is not None:
                watch.frame(frame)
        elif isinstance(message, ImuSample):
            estimate = pipeline.feed_imu(message)
            if watch is not None:
                watch.packet(message, estimate.tracking)
                if names := watch.take_names():
                    pipeline.feed_event(hue_names_event(hand.glove.hues, names, message.t))
            if message.seq % EVERY == 0:
                out.append(estimate)
    return _shown(hand, out)


def _shown(hand: Simulation, estimates: list[Estimate]) -> _TrialErrors:
    late = [e for e in estimates if e.t > SETTLED]
    names = hand.glove.keypoint_names(hand.hand)
    rows = [names.index(name) for name in MARKED_KEYPOINTS if name in names]
    t = np.array([e.t for e in late])
    truths = hand.truths(t)
    apart = [
        np.linalg.norm(e.keypoints[rows] - true.keypoints[rows], axis=1).mean()
        for e, true in zip(late, truths, strict=True)
    ]
    tracked = np.array([e.tracking == Tracking.TRACKING for e in late])
    return _TrialErrors(t, 1e3 * np.array(apart), tracked)
