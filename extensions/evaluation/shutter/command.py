"""The command ``evaluate shutter``: fast hands and a turning head in front of a rolling shutter."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

from extensions.evaluation.commands import EvaluateShutterArguments
from extensions.evaluation.tracked import compared, estimates_of
from extensions.evaluation.trials import run_trials
from extensions.evaluation.vist.trial import models
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.base.terminal import check_json, finish
from tracker.engine.kinds import ENGINES
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.simulation.head import HeadParams
from tracker.simulation.motion import Swinging
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation, SimulationParams
from tracker.vision.rig import ideal_rig, with_readout

POSTURE_EVERY = 3.0  # s


@dataclass(frozen=True)
class ShutterCase:
    """A hand whose swings reach ``speed`` m/s before a camera whose turns reach ``turning_deg``
    °/s; ``readout`` s from the first row to the last. ``engine`` gets the camera's line time where
    it is ``compensated``."""

    speed: float
    turning_deg: float
    readout: float
    compensated: bool = True
    engine: str = "chain"
    images: bool = False
    fps: float = 60.0
    seconds: float = 20.0


@dataclass(frozen=True)
class ShutterFigures:
    """For one person in one case: mean error (mm) of the four keypoints in the camera's frame,
    share of instants at which the hand is tracked, and the estimated time offset (ms)."""

    seed: int
    error_mm: float
    tracked: float
    offset_ms: float


def simulation_of(case: ShutterCase, seed: int) -> Simulation:
    """The person of a seed in a case; the same hand with every camera."""
    hand, glove = models()
    rig = with_readout(ideal_rig(), case.readout)
    own = RandomPostures(hand, seed, POSTURE_EVERY, case.seconds + 0.1, camera=rig.pose)
    motion = Swinging(own, case.speed, rig.pose) if case.speed else own
    params = SimulationParams(head=HeadParams(turn_deg=case.turning_deg))
    return Simulation(hand, glove, motion, seed, params, case.fps, rig)


def run_trial(
    case: ShutterCase, seed: int, progress: Callable[[float], None] = lambda share: None
) -> ShutterFigures:
    """Simulate and track; a task of `tracker.base.workers`."""
    sim = simulation_of(case, seed)
    rig = sim.rig if case.compensated else replace(sim.rig, line_time=0.0)
    pipeline = Pipeline(sim.hand, sim.glove, rig, Settings(engine=case.engine))
    estimates = estimates_of(sim, pipeline, case.images, progress)
    found = compared(sim, pipeline, estimates)
    offset = pipeline.timing.offset.value
    return ShutterFigures(seed, found.error_mm, found.tracked, 1e3 * offset)


LARGEST_RATIO = 1.03
"""Goal: error with a rolling shutter relative to the error with a global one."""


class ShutterRow(NamedTuple):
    """Mean errors (mm) with a global shutter, with a rolling one whose line time is not known, and
    with one whose line time is known."""

    speed: float
    turning_deg: float
    global_mm: float
    unknown_mm: float
    known_mm: float

    @property
    def ratio(self) -> float:
        return self.known_mm / self.global_mm


def evaluate_shutter(args: EvaluateShutterArguments) -> int:
    """Track the people in front of three cameras each and print the figures."""
    check_json(args.trials)
    ENGINES.get(args.trials.engine)  # raises ConfigError if the name is unknown
    if args.participants < 1 or args.seconds < 5 or not 0 < args.readout_ms <= 50:
        raise ConfigError(notice("evaluation.shutter_options"))
    movements = [(speed, 0.0) for speed in args.speeds]
    if args.turning_deg:
        movements.append((args.speeds[0], args.turning_deg))
    shutters = ((0.0, True), (args.readout_ms / 1000, False), (args.readout_ms / 1000, True))
    how = args.trials.engine, args.trials.images, args.trials.fps, args.seconds
    cases = [
        ShutterCase(speed, turning, readout, known, *how)
        for speed, turning in movements
        for readout, known in shutters
    ]
    figures = run_trials(run_trial, cases, args.participants, args.trials)
    rows = rows_of(movements, figures, args.participants)
    found = summary(rows)
    finish(args.trials, found, table(rows))
    return 0 if found["ok"] else 1


def rows_of(
    movements: Sequence[tuple[float, float]], figures: Sequence[ShutterFigures], people: int
) -> list[ShutterRow]:
    """The figures, in the order of the trials, as one row for each movement."""
    errors = iter(f.error_mm for f in figures)
    means = [sum(next(errors) for _ in range(people)) / people for _ in range(3 * len(movements))]
    return [ShutterRow(*m, *means[3 * i : 3 * i + 3]) for i, m in enumerate(movements)]


def summary(rows: Sequence[ShutterRow]) -> dict[str, Any]:
    """JSON values: the rows, the largest ratio, and whether the goal is met."""
    largest = max(row.ratio for row in rows)
    return {
        "rows": [row._asdict() | {"ratio": row.ratio} for row in rows],
        "ratio": largest,
        "ok": largest <= LARGEST_RATIO,
    }


def table(rows: Sequence[ShutterRow]) -> list[str]:
    """The table as lines of text."""
    head = f"{'hand m/s':>9}{'camera °/s':>12}{'global mm':>11}{'not corrected mm':>18}"
    lines = [head + f"{'corrected mm':>14}{'ratio':>8}"]
    for r in rows:
        lines.append(
            f"{r.speed:>9.1f}{r.turning_deg:>12.0f}{r.global_mm:>11.2f}{r.unknown_mm:>18.2f}"
            f"{r.known_mm:>14.2f}{r.ratio:>8.3f}"
        )
    return lines
