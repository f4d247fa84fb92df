"""Tracks one simulated participant (`judge` compares the result with the truth)."""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache
from importlib.resources import as_file
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

import resources
from extensions.evaluation.sessions import blobs_of
from extensions.evaluation.vist.cases import PAPERS_GLOVE, Ablation, Case, ablation_of
from extensions.evaluation.vist.judge import Judge, TrialRecord
from extensions.evaluation.vist.metrics import JOINTS, Trial
from extensions.evaluation.vist.scenes import guided_motion, motion_of, simulation_of
from tracker.base.clock import ClockAnchor
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.engine.side_watch import SideWatch
from tracker.fusion import wearer_learning
from tracker.fusion.chain.calibration.measured import LONGEST, RULER_SD, SHORTEST
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.reports import length_gain
from tracker.fusion.engine import Engine
from tracker.glove.files import load_glove
from tracker.glove.model import GloveModel
from tracker.hand.files import load_hand
from tracker.hand.model import HandModel
from tracker.hand.names import MARKED_KEYPOINTS
from tracker.messages import (
    Array,
    BlobFrame,
    CameraImuSample,
    Event,
    FrameResult,
    ImuSample,
    StereoFrame,
    Tracking,
)
from tracker.offline.smooth import Smoother
from tracker.online.hue_names import hue_names_event
from tracker.session.description import SessionInfo
from tracker.simulation.guided import with_events
from tracker.simulation.scenario import Simulation
from tracker.simulation.smooth import rng_for
from tracker.simulation.wearer import Wearer
from tracker.vision.colours import load_profile
from tracker.vision.detector import Detector, detect_frame
from tracker.vision.region_prediction import RegionPrediction, SearchPlan

FIRST_SESSION = 0.5  # min of free motion in a wearer's earlier session
ANOTHER_TIME = 500  # between the seeds of one person's sessions; more than the participants
CHECK_EVERY = 5  # frames between two whose matches are compared with the truth
SAME_BLOB_PX = 6.0  # a blob farther than this from every true marker is not a marker


@lru_cache(maxsize=2)
def models(glove_name: str = PAPERS_GLOVE) -> tuple[HandModel, GloveModel]:
    """The reference hand and the paper's glove, or another one."""
    with as_file(resources.folder("hands") / "reference-right.toml") as path:
        hand = load_hand(path)
    with as_file(resources.folder("gloves") / f"{glove_name}.toml") as path:
        glove = load_glove(path, hand)
    return hand, glove


def run_trial(case: Case, participant: int) -> Trial:
    """Simulate, track and evaluate. Deterministic, except for ``core_s``."""
    hand, glove = models(case.glove)
    variant = ablation_of(case)
    seed = 1000 * case.seed + participant
    motion = motion_of(case, hand, seed, variant)
    events: list[Event] = []
    judged_from = 0.0
    if case.is_led:
        motion = led = guided_motion(case, hand, glove, motion, seed)
        events, judged_from = [] if case.guided == "unannounced" else led.events, led.free_from
    simulation = simulation_of(case, hand, glove, motion, seed, variant)
    settings = replace(Settings(), engine=case.engine)
    if variant is not None:
        settings = variant.settings(settings)
    pipeline = Pipeline(hand, glove, simulation.rig if case.has_camera else None, settings)
    if case.measured:
        measure(pipeline.engine, case, simulation.wearer, seed)
    if case.wearer:
        wearer_learning.load_wearer(pipeline.engine, Path(case.wearer))
    if case.guided == "known":
        meet_again(pipeline, case, seed)
    record = _track(case, simulation, pipeline, variant, events)
    if case.smoothed:
        _smoothed(case, simulation, pipeline, record)
    outage = variant.outage if variant is not None else 0.0
    columns = [pipeline.keypoint_names.index(k) for k in (*MARKED_KEYPOINTS, *JOINTS)]
    place = "camera" if case.experiment == "head" else "world"
    if outage or not case.has_camera:
        place = "dorsum"
    judge = Judge(simulation, pipeline, columns, place, judged_from)
    return judge.trial(record, participant, outage)


def measure(engine: Engine, case: Case, wearer: Wearer, seed: int) -> None:
    """Set the length of the wearer's hand as measured with a ruler."""
    layout = ChainLayout(*models(case.glove))
    true = float(length_gain(layout) @ wearer.scale[list(layout.active), 0])
    read = true + rng_for(seed, "ruler").normal(0.0, RULER_SD)
    wearer_learning.start_with_length(engine, float(np.clip(read, SHORTEST, LONGEST)))


def meet_again(pipeline: Pipeline, case: Case, person: int) -> None:
    """Load the profile from an earlier session of the ``person`` (a seed) with guided poses, in
    which the glove was put on separately."""

    first, seed = replace(case, guided="guided", minutes=FIRST_SESSION), person + ANOTHER_TIME
    hand, glove = models(case.glove)
    motion = guided_motion(first, hand, glove, motion_of(first, hand, seed, None), person)
    simulation = simulation_of(first, hand, glove, motion, seed, None, person)
    before = Pipeline(hand, glove, simulation.rig if case.has_camera else None, pipeline.settings)
    if case.measured:
        measure(before.engine, case, simulation.wearer, person)
    _track(first, simulation, before, None, motion.events)
    with TemporaryDirectory() as folder:
        profile = Path(folder) / "wearer.toml"
        wearer_learning.save_wearer(before.engine, profile)
        wearer_learning.load_wearer(pipeline.engine, profile)


def _track(
    case: Case,
    simulation: Simulation,
    pipeline: Pipeline,
    variant: Ablation | None,
    events: Sequence[Event],
) -> TrialRecord:
    record = TrialRecord()
    names = CorrectedNames(pipeline, case.session == "exchanged")
    check = MatchCheck(simulation)
    search, images = TrialImageSearch(simulation), case.level == "images"
    sensed = simulation.messages(images) if case.has_camera else simulation.imu_samples()
    feed = with_events(sensed, events)
    for message in feed if variant is None else variant.feed(feed):
        begin = time.process_time()
        if isinstance(message, ImuSample):
            record.estimates.append(pipeline.feed_imu(message))
            names.packet(message, record.estimates[-1].tracking)
        elif isinstance(message, CameraImuSample):
            pipeline.feed_camera_imu(message)
        elif isinstance(message, Event):
            pipeline.feed_event(message)
        else:
            frame = message if isinstance(message, BlobFrame) else search.blobs(message, pipeline)
            frame = blobs_of(case.session, frame)
            pipeline.feed_frame(frame)
            names.frame(frame)
            message = pipeline.hues.corrected(frame)
            check.remember(frame)
        if case.smoothed and not isinstance(message, CameraImuSample | StereoFrame):
            record.fed.append(message)
        results = pipeline.take_results()
        if images and results and record.estimates:
            search.look_ahead(pipeline, record.estimates[-1].t)
        record.core_s += time.process_time() - begin
        for result in results:
            record.latest_seen = result.stereo_points
            matches, wrong = check(result)
            record.matches += matches
            record.wrong += wrong
        if isinstance(message, ImuSample):
            record.seen.append(record.latest_seen)
            reported = simulation.scene.reported_pose(message.t)
            record.poses.append(reported or pipeline.camera_pose(message.t))
    return record


def _smoothed(case: Case, simulation: Simulation, live: Pipeline, record: TrialRecord) -> None:
    """Replaces the estimates of a record by those of the same messages, smoothed."""
    anchor = ClockAnchor(0, 0)
    about = SessionInfo(live.hand, live.glove, "", "", anchor, live.calibrated_rig)
    smoother = Smoother(about, live.settings)
    if case.measured:
        measure(smoother.engine, case, simulation.wearer, simulation.seed)
    for message in record.fed:
        smoother.feed(message)
    found = (e for m, e in smoother.results(lambda share: None) if isinstance(m, ImuSample))
    record.estimates = [e or was for e, was in zip(found, record.estimates, strict=True)]


class CorrectedNames:
    """Names of hues that a live run corrects, if they are ``exchanged``."""

    def __init__(self, pipeline: Pipeline, exchanged: bool) -> None:
        self._pipeline = pipeline
        self._watch = SideWatch(pipeline) if exchanged else None

    def frame(self, frame: BlobFrame) -> None:
        """What was found in an image."""
        if self._watch is not None:
            self._watch.frame(frame)

    def packet(self, sample: ImuSample, tracking: Tracking) -> None:
        """A packet, and the state of tracking after it."""
        if self._watch is None:
            return
        self._watch.packet(sample, tracking)
        if names := self._watch.take_names():
            event = hue_names_event(self._pipeline.glove.hues, names, sample.t)
            self._pipeline.feed_event(event)


class TrialImageSearch:
    """Images to blobs as the live tracker does it: around what was expected, some as a whole."""

    def __init__(self, simulation: Simulation) -> None:
        self._rig, self._plan = simulation.rig, SearchPlan()
        self._predicted: RegionPrediction | None = None
        with as_file(resources.folder("colours") / "fabric-default.toml") as path:
            self._profile = load_profile(path)
        self._detector = Detector(self._profile, fx=self._rig.fx)

    def blobs(self, frame: StereoFrame, pipeline: Pipeline) -> BlobFrame:
        """What is found in both images."""
        names = self._profile.hue_names
        pose = frame.pose or pipeline.camera_pose(frame.t)
        hints = self._plan.hints(self._predicted, self._rig, frame.t, pose, names)
        return detect_frame(self._detector, frame, hints)

    def look_ahead(self, pipeline: Pipeline, t: float) -> None:
        """Where markers are expected from the newest packet at ``t`` on."""
        self._predicted = pipeline.ahead.markers(t, self._predicted)


class MatchCheck:
    """Whether the blobs that an engine took for markers are those markers."""

    def __init__(self, simulation: Simulation) -> None:
        self._simulation = simulation
        self._frames: dict[float, BlobFrame] = {}
        self._count = 0

    def remember(self, frame: BlobFrame) -> None:
        """Keep a frame whose result will come, every `CHECK_EVERY`-th of them."""
        self._count += 1
        if self._count % CHECK_EVERY == 0:
            self._frames[frame.t] = frame

    def __call__(self, result: FrameResult) -> tuple[int, int]:
        """(matches, wrong ones) of a result whose frame was kept, else zeros."""
        frame = self._frames.pop(result.t, None)
        if frame is None:
            return 0, 0
        now = self._simulation.scene.instant(frame.t)
        matches = wrong = 0
        for right, blobs, match in (
            (False, frame.left, result.match_left),
            (True, frame.right, result.match_right),
        ):
            marker = np.flatnonzero(match >= 0)
            if blobs is None or len(marker) == 0:
                continue
            true_uv = self._simulation.scene.markers_seen(now, right).uv
            owner = owners(blobs.uv[match[marker]], true_uv)
            matches += len(marker)
            wrong += int(np.sum(owner != marker))
        return matches, wrong


def owners(uv: Array, true_uv: Array) -> Array:
    """The marker (n,) whose true position is nearest to each blob, -1 where none is near."""
    d = np.linalg.norm(uv[:, None] - true_uv[None], axis=2)
    d = np.where(np.isfinite(d), d, np.inf)
    nearest = d.argmin(axis=1)
    return np.where(d.min(axis=1) <= SAME_BLOB_PX, nearest, -1)
