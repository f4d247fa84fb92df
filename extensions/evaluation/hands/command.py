"""The command ``evaluate hands``: pairs of simulated hands, tracked together and each alone."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from extensions.evaluation.commands import EvaluateHandsArguments
from extensions.evaluation.sessions import blobs_of, people_of
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.base.terminal import check_json, finish, progress_line
from tracker.base.workers import WorkItem, run_all, some_workers
from tracker.engine.hands import Hands
from tracker.engine.kinds import ENGINES
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.engine.side_watch import ExchangeWatch, SideWatch
from tracker.glove import library
from tracker.hand.names import MARKED_KEYPOINTS, SIDES
from tracker.messages import Array, BlobFrame, Estimate, ImuSample, Tracking
from tracker.online.hue_names import hue_names_event
from tracker.simulation.scenario import Simulation, SimulationParams
from tracker.simulation.two_hands import GlovedHand, TwoHandsSimulation

LONGEST_RATIO, LONGEST_OFF = 1.2, 0.2
"""Goals: error together relative to error alone, and longest time in s with a wrong position."""


def evaluate_hands(args: EvaluateHandsArguments) -> int:
    """Track the pairs and print the figures."""
    check_json(args)
    ENGINES.get(args.engine)  # raises ConfigError if the name is unknown
    if args.pairs < 1 or args.seconds < 4 or not 5 <= args.fps <= 240:
        raise ConfigError(notice("evaluation.hands_options"))
    seeds = range(args.seed, args.seed + args.pairs)
    tasks = [
        WorkItem(run_trial, (seed, args.seconds, args.engine, args.fps, args.session))
        for seed in seeds
    ]
    with some_workers(max(1, min(args.processes, args.pairs))) as workers:
        outcomes = run_all(tasks, workers, progress_line(f"tracking {args.pairs} pairs"))
    failed = [outcome.error for outcome in outcomes if outcome.error]
    if failed:
        raise ConfigError(failed[0])
    rows = [row for outcome in outcomes for row in outcome.value]
    found = summary(rows)
    finish(args, found, table(rows, found))
    return 0 if found["ok"] else 1


def summary(rows: Sequence[HandFigures]) -> dict[str, Any]:
    """JSON values: each hand, means over all, and whether the goals are met."""
    together = sum(r.together_mm for r in rows) / len(rows)
    alone = sum(r.alone_mm for r in rows) / len(rows)
    covered = sum(r.covered_mm for r in rows) / len(rows)
    longest = max(r.longest_off_s for r in rows)
    return {
        "rows": [asdict(r) | {"ratio": r.ratio, "confusion": r.confusion} for r in rows],
        "together_mm": together,
        "alone_mm": alone,
        "covered_mm": covered,
        "ratio": together / alone,
        "confusion": together / covered,
        "longest_off_s": longest,
        "ok": together <= LONGEST_RATIO * alone and longest <= LONGEST_OFF,
    }


def table(rows: Sequence[HandFigures], found: dict[str, Any]) -> list[str]:
    """The table as lines of text."""
    head = f"{'pair':>5} {'hand':<6}{'together mm':>12}{'alone mm':>10}{'ratio':>7}"
    head += f"{'covered mm':>12}{'ratio':>7}"
    lines = [head + f"{'known':>8}{'tracked':>9}{'off, longest s':>16}"]
    for r in rows:
        lines.append(
            f"{r.seed:>5} {r.side:<6}{r.together_mm:>12.2f}{r.alone_mm:>10.2f}{r.ratio:>7.2f}"
            f"{r.covered_mm:>12.2f}{r.confusion:>7.2f}"
            f"{r.known:>8.1%}{r.tracked:>9.1%}{r.longest_off_s:>16.2f}"
        )
    lines.append(
        f"{'all':>5} {'':<6}{found['together_mm']:>12.2f}{found['alone_mm']:>10.2f}"
        f"{found['ratio']:>7.2f}{found['covered_mm']:>12.2f}{found['confusion']:>7.2f}"
        f"{'':>17}{found['longest_off_s']:>16.2f}"
    )
    return lines


# ---- tracks one simulated pair of hands together, and each hand alone and covered

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
