"""The command ``evaluate gaps``: hands that leave the view for a while and return."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from extensions.evaluation.commands import DEVICES, EvaluateGapsArguments
from extensions.evaluation.effects.trial import ALL, CLEAN, EffectsCase, simulation_of
from extensions.evaluation.trials import run_trials
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.base.terminal import check_json, finish
from tracker.engine.kinds import ENGINES
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.hand.names import MARKED_KEYPOINTS
from tracker.messages import Array, BlobFrame, Blobs, ImuSample, Tracking, Validity
from tracker.simulation.scenario import Simulation

FIRST = 4.0  # s until the hand first leaves the view; figures are computed from then on
BETWEEN = 1.5  # s in view between two gaps
GAPS = {0.2: 6, 0.5: 5, 1.0: 4, 3.0: 2, 10.0: 1}
"""Duration of each gap (s): how many of them one trial has."""
MANY_GAPS = 2  # of a duration that is not in `GAPS`
RETURN = 0.15  # s that a hand in view again may take to be found
ENOUGH = 5  # blobs in both images, from which on the hand should be found
WRONG = 0.05  # m, a larger error of a measured keypoint is wrong
BACK = 3.0  # standard deviations within which a hand that was found again must be
NO_BLOBS = Blobs.empty()


@dataclass(frozen=True)
class GapsCase:
    """Gaps of ``gap`` s; ``errors``: of real devices. ``fps`` in Hz."""

    gap: float
    errors: bool = False
    engine: str = "chain"
    fps: float = 60.0

    @property
    def count(self) -> int:
        """Number of gaps in a trial."""
        return GAPS.get(self.gap, MANY_GAPS)

    @property
    def seconds(self) -> float:
        """Duration of a trial."""
        return FIRST + self.count * (self.gap + BETWEEN)

    def is_out(self, t: float) -> bool:
        """Whether the hand is out of view at ``t`` s."""
        return t >= FIRST and (t - FIRST) % (self.gap + BETWEEN) < self.gap


class GapsFigures(NamedTuple):
    """For one person. ``out``: instants (packets) out of view with a position; ``true``: those with
    four keypoints within three standard deviations, as a sum of shares; ``no_position``:
    instants out of view without one. ``back_s``: for each gap, the time from the first image with
    `ENOUGH` markers until the hand is tracked and its dorsum within 3 sd. ``enough``: instants with
    as many markers in view, from `RETURN` after the first such image on; ``lost``: those without a
    position. ``wrong``: instants at which a keypoint is called measured and is more than 50 mm
    wrong."""

    seed: int
    out: int
    true: float
    no_position: int
    back_s: tuple[float, ...]
    enough: int
    lost: int
    wrong: int


class _Instants(NamedTuple):
    """Of n packets: t (n,) s, keypoints (n, K, 3) m, sd (n, K) m, measured (n, K), and the state of
    tracking (n,)."""

    t: Array
    keypoints: Array
    sd: Array
    measured: NDArray[np.bool_]
    tracking: NDArray[np.int64]


def run_trial(
    case: GapsCase, seed: int, progress: Callable[[float], None] = lambda share: None
) -> GapsFigures:
    """Simulate and track; a task of `tracker.base.workers`."""
    effects = ALL if case.errors else CLEAN
    sim = simulation_of(EffectsCase(effects, case.engine, fps=case.fps, seconds=case.seconds), seed)
    pipeline = Pipeline(sim.hand, sim.glove, sim.rig, Settings(engine=case.engine))
    found, seen = _tracked(case, sim, pipeline, progress)
    return _figures(case, seed, sim, found, seen, pipeline.keypoint_names)


def _tracked(
    case: GapsCase, sim: Simulation, pipeline: Pipeline, progress: Callable[[float], None]
) -> tuple[_Instants, Array]:
    """The estimates, and the times (m,) s of the images that show `ENOUGH` markers."""
    estimates, seen = [], [-np.inf]
    for message in sim.messages():
        if isinstance(message, ImuSample):
            estimates.append(pipeline.feed_imu(message))
            progress(message.t / sim.duration)
        elif isinstance(message, BlobFrame):
            if case.is_out(message.t):
                message = replace(message, left=NO_BLOBS, right=NO_BLOBS)
            if min(len(message.left or ()), len(message.right or ())) >= ENOUGH:
                seen.append(message.t)
            pipeline.feed_frame(message)
    late = [e for e in estimates if e.t >= FIRST]
    instants = _Instants(
        np.array([e.t for e in late]),
        np.array([e.keypoints for e in late]),
        np.array([e.keypoint_sd for e in late]),
        np.array([e.keypoint_state for e in late]) == Validity.MEASURED,
        np.array([e.tracking for e in late]),
    )
    return instants, np.array(seen)


def _figures(
    case: GapsCase,
    seed: int,
    sim: Simulation,
    found: _Instants,
    seen: Array,
    names: tuple[str, ...],
) -> GapsFigures:
    truths = np.array([truth.keypoints for truth in sim.truths(found.t)])
    error = np.linalg.norm(found.keypoints - truths, axis=2)
    rows = [names.index(name) for name in MARKED_KEYPOINTS]
    true = error[:, rows] <= BACK * found.sd[:, rows]
    somewhere = np.isfinite(error[:, rows]).all(axis=1)
    tracked = found.tracking == int(Tracking.TRACKING)
    out = np.array([case.is_out(t) for t in found.t])
    last = np.searchsorted(seen, found.t, side="right") - 1
    into = (found.t - FIRST) % (case.gap + BETWEEN) - case.gap
    enough = (into > RETURN) & (found.t - seen[last] <= 1.5 / case.fps)
    dorsum = true[:, MARKED_KEYPOINTS.index("dorsum")]
    return GapsFigures(
        seed=seed,
        out=int(np.count_nonzero(out & somewhere)),
        true=float(true[out & somewhere].mean(axis=1).sum()),
        no_position=int(np.count_nonzero(out & ~somewhere)),
        back_s=tuple(_returns(case, found.t, seen, tracked & dorsum)),
        enough=int(np.count_nonzero(enough)),
        lost=int(np.count_nonzero(enough & ~somewhere)),
        wrong=int(np.count_nonzero((found.measured & (error > WRONG)).any(axis=1))),
    )


def _returns(case: GapsCase, t: Array, seen: Array, good: NDArray[np.bool_]) -> list[float]:
    """For each gap after which an image showed `ENOUGH` markers: s from it until ``good``, at most
    until the next gap."""
    out = []
    for k in range(case.count):
        end = FIRST + k * (case.gap + BETWEEN) + case.gap
        first = seen[(seen >= end) & (seen < end + BETWEEN)]
        if len(first):
            when = t[(t >= first[0]) & (t < end + BETWEEN) & good]
            out.append(float(when[0] - first[0]) if len(when) else BETWEEN)
    return out


LONGEST_RETURN = 0.15
"""Goal: s from the first image with five markers until the hand is tracked."""


MOST_LOST = 0.003
"""Goal: share of later instants with five markers in view at which the hand has no position."""


LEAST_TRUE = 0.97
"""Goal: share of errors within three standard deviations while the hand is out of view."""


class GapsRow(NamedTuple):
    """For several people out of view for ``gap`` s, with errors of real devices or without:
    number of gaps; share of errors within three standard deviations, out of view, and of the
    instants there that have a position; median and longest time (s) until the hand is found;
    share of instants in view without a position; instants that are wrong."""

    gap: float
    errors: bool
    gaps: int
    true: float
    position: float
    back_s: float
    longest_s: float
    lost: float
    wrong: int

    @property
    def is_good(self) -> bool:
        """Whether the goals are met."""
        back = self.longest_s <= LONGEST_RETURN and self.lost <= MOST_LOST
        return back and self.true >= LEAST_TRUE and not self.wrong


def evaluate_gaps(args: EvaluateGapsArguments) -> int:
    """Track the people with gaps of each duration and print the figures."""
    check_json(args.trials)
    ENGINES.get(args.trials.engine)  # raises ConfigError if the name is unknown
    if args.participants < 1 or not 0.1 <= min(args.gaps) <= max(args.gaps) <= 60:
        raise ConfigError(notice("evaluation.gaps_options"))
    cases = [
        GapsCase(gap, errors, args.trials.engine, args.trials.fps)
        for errors in DEVICES[args.devices]
        for gap in args.gaps
    ]
    figures = run_trials(run_trial, cases, args.participants, args.trials)
    people = args.participants
    rows = [
        row_of(case.gap, case.errors, figures[k * people : (k + 1) * people])
        for k, case in enumerate(cases)
    ]
    found = summary(rows)
    finish(args.trials, found, table(rows))
    return 0 if found["ok"] else 1


def row_of(gap: float, errors: bool, figures: Sequence[GapsFigures]) -> GapsRow:
    """The figures of several people in one case as a row."""
    back = sorted(s for f in figures for s in f.back_s)
    out, nowhere = sum(f.out for f in figures), sum(f.no_position for f in figures)
    return GapsRow(
        gap=gap,
        errors=errors,
        gaps=len(back),
        true=sum(f.true for f in figures) / max(out, 1),
        position=out / max(out + nowhere, 1),
        back_s=back[len(back) // 2] if back else float("nan"),
        longest_s=back[-1] if back else float("nan"),
        lost=sum(f.lost for f in figures) / max(sum(f.enough for f in figures), 1),
        wrong=sum(f.wrong for f in figures),
    )


def summary(rows: Sequence[GapsRow]) -> dict[str, Any]:
    """JSON values: the rows, and whether all of them meet the goals."""
    return {"rows": [row._asdict() for row in rows], "ok": all(row.is_good for row in rows)}


def table(rows: Sequence[GapsRow]) -> list[str]:
    """The table as lines of text."""
    lines = [
        f"{'gap s':>6}{'devices':>9}{'gaps':>6}{'within 3 sd %':>15}{'with position %':>17}"
        f"{'back s':>8}{'longest s':>11}{'lost %':>8}{'wrong':>7}"
    ]
    lines += [
        f"{r.gap:>6.1f}{'real' if r.errors else 'ideal':>9}{r.gaps:>6d}{100 * r.true:>15.1f}"
        f"{100 * r.position:>17.1f}{r.back_s:>8.3f}{r.longest_s:>11.3f}{100 * r.lost:>8.2f}"
        f"{r.wrong:>7d}"
        for r in rows
    ]
    return lines
