"""Tracks one simulated person whose hand repeatedly leaves the view of the camera."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from extensions.evaluation.effects.trial import ALL, CLEAN, EffectsCase, simulation_of
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
