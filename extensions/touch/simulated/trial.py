"""One simulated wearer takes the touch test; its figures beside the true error of the tracker."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from extensions.touch.pose import SheetPose, find_sheet
from extensions.touch.protocol import TouchCue, touches
from extensions.touch.rest import CrossTouch, find_touches
from extensions.touch.result import TouchResult, evaluate
from extensions.touch.sheet import RULER
from extensions.touch.simulated.images import SheetPlace, placed_sheet, sheet_frames
from extensions.touch.simulated.wearer import OtherHandFinger, TouchMotion
from extensions.touch.track import tip_tracks
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.geometry import so3
from tracker.glove import library
from tracker.hand.model import HandModel
from tracker.messages import Array, BlobFrame, Calibration, Estimate, ImuSample
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation
from tracker.simulation.smooth import rng_for
from tracker.simulation.wearer import Wearer
from tracker.vision.rig import Camera, StereoRig, ideal_rig

LEAD = 4.0  # s of free movement before the test
RULER_SD = 0.00015  # m, of reading a ruler
SHEET_IMAGES = 2


@dataclass(frozen=True)
class Fault:
    """What is wrong: the print's scale, the baseline of the calibration (a factor), the length of
    the last segments in the hand file (a factor)."""

    name: str = "none"
    print_scale: float = 1.0
    baseline: float = 1.0
    distal: float = 1.0


FAULTS = (
    Fault(),
    Fault("print", print_scale=0.99),
    Fault("camera", baseline=1.01),
    Fault("glove", distal=1.10),
)


@dataclass(frozen=True)
class FingerFigures:
    """One finger of one wearer, mm: bias found and true along G's axes, pooled sd found and true,
    number of touches."""

    seed: int
    fault: str
    finger: str
    touches: int
    bias_found: tuple[float, ...]
    bias_true: tuple[float, ...]
    sd_found: float
    sd_true: float


@dataclass(frozen=True)
class WearerFigures:
    """One wearer; ``codes`` are the notices without a ruler and with one."""

    seed: int
    fault: str
    fingers: tuple[FingerFigures, ...]
    missed: int
    codes: tuple[str, ...]
    codes_ruler: tuple[str, ...]
    stereo_scale: float
    within: tuple[float, ...]


class SimulatedTrial:
    """A wearer, a sheet, a rig with its fault, and a simulation of the test."""

    def __init__(
        self,
        seed: int,
        fault: Fault | None = None,
        cues: Sequence[TouchCue] | None = None,
        fps: float = 30.0,
        lead: float = LEAD,
    ) -> None:
        self.seed, self.fault = seed, fault or Fault()
        self.hand, self.glove = library.load()
        self.true_rig = ideal_rig()
        self.rig = with_baseline(self.true_rig, self.fault.baseline)
        wearer = Wearer.random(self.hand, self.glove, seed)
        self.sheet: SheetPlace = placed_sheet(seed, self.fault.print_scale)
        before = RandomPostures(self.hand, seed, duration=lead)
        asked = touches() if cues is None else cues
        self.motion = TouchMotion(wearer, self.sheet, asked, before, seed)
        extras = [OtherHandFinger(self.hand, self.motion.cued)]
        self.sim = Simulation(
            self.hand, self.glove, self.motion, seed, fps=fps, rig=self.true_rig, extras=extras
        )

    @property
    def ruler(self) -> float:
        """m that the wearer reads for the printed line."""
        reading = rng_for(self.seed, "ruler").normal(0, RULER_SD)
        return float(RULER * self.fault.print_scale + reading)

    @property
    def filed_hand(self) -> HandModel:
        """The hand as the tracker's file has it."""
        return with_distal(self.hand, self.fault.distal)

    def track(
        self, engine: str = "chain", progress: Callable[[float], None] = lambda share: None
    ) -> tuple[list[Estimate], Calibration]:
        """All estimates of the wearer's movement."""
        pipeline = Pipeline(self.filed_hand, self.glove, self.rig, Settings(engine=engine))
        estimates = []
        for message in self.sim.feed():
            if isinstance(message, BlobFrame):
                pipeline.feed_frame(message)
            elif isinstance(message, ImuSample):
                estimates.append(pipeline.feed_imu(message))
                progress(message.t / self.motion.duration)
        return estimates, pipeline.calibration()


def with_baseline(rig: StereoRig, factor: float) -> StereoRig:
    """A calibration with ``factor`` times the true distance of the cameras."""
    right, P = rig.right, rig.right.P.copy()
    P[0, 3] *= factor
    return replace(rig, right=Camera(right.width, right.height, right.K, right.D, right.R, P))


def with_distal(hand: HandModel, factor: float) -> HandModel:
    """A hand file whose last segments are ``factor`` times as long."""
    segments = tuple(
        replace(s, length=s.length * factor) if s.name.endswith("_distal") else s
        for s in hand.segments
    )
    return replace(hand, segments=segments)


def run_trial(
    seed: int,
    fault: Fault,
    engine: str = "chain",
    progress: Callable[[float], None] = lambda share: None,
) -> WearerFigures:
    """One wearer; a task of `tracker.base.workers`."""
    trial = SimulatedTrial(seed, fault)
    estimates, calibration = trial.track(engine, progress)
    return figures(trial, estimates, calibration)


def figures(
    trial: SimulatedTrial, estimates: list[Estimate], calibration: Calibration | None
) -> WearerFigures:
    """The test's result beside the truth."""
    frames = list(sheet_frames(trial.sheet, trial.true_rig, SHEET_IMAGES, trial.seed))
    result = measured(trial, estimates, calibration, find_sheet(frames, trial.rig, trial.ruler))
    without = find_sheet(frames, trial.rig)
    fingers = []
    for f in result.fingers:
        true = np.array([_true_error(trial, estimates, t) for t in f.touches])
        sd_true = float(np.sqrt(np.mean(np.var(true, axis=0, ddof=1))))
        fingers.append(
            FingerFigures(
                trial.seed,
                trial.fault.name,
                f.finger,
                f.count,
                _mm(f.pulp.error.mean(axis=0)),
                _mm(true.mean(axis=0)),
                1e3 * f.sd.value,
                1e3 * sd_true,
            )
        )
    return WearerFigures(
        seed=trial.seed,
        fault=trial.fault.name,
        fingers=tuple(fingers),
        missed=len(result.missed),
        codes=tuple(n.code for n in without.notices()),
        codes_ruler=tuple(n.code for n in result.notices),
        stereo_scale=result.pose.scale,
        within=tuple(c.value for c in result.claims),
    )


def _mm(vector: Array) -> tuple[float, ...]:
    return tuple(float(v) for v in 1e3 * vector)


def measured(
    trial: SimulatedTrial,
    estimates: list[Estimate],
    calibration: Calibration | None,
    pose: SheetPose,
) -> TouchResult:
    """The test's result from tracked hands and a sheet that was found."""
    tracks = tip_tracks(estimates, trial.filed_hand, trial.glove, calibration)
    found, missed = find_touches(tracks, trial.motion.cued, pose)
    return evaluate(found, missed, pose, trial.rig.pose.p_GC)


def _true_error(trial: SimulatedTrial, estimates: list[Estimate], touch: CrossTouch) -> Array:
    """(3,) m in G: the tracker's mean error of the middle of the fingertip's round end."""
    row = trial.glove.keypoint_names(trial.hand).index(f"{touch.cue.finger}_tip")
    segment = trial.hand.index[f"{touch.cue.finger}_distal"]
    radius = trial.hand.segments[segment].radius * trial.sim.wearer.scale[segment, 2]
    during = [e for e in estimates if touch.begin <= e.t <= touch.end]
    off = []
    for e, true in zip(during, trial.sim.truths(np.array([e.t for e in during])), strict=True):
        x = so3.matrix_from_quat(e.keypoint_q[row])[:, 0]
        found = e.keypoints[row] - touch.radius * x
        off.append(found - true.keypoints[row] + radius * true.R_GB[segment][:, 0])
    return np.mean(off, axis=0)
