"""One simulated participant tracked once and judged against the truth."""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import lru_cache
from importlib.resources import as_file
from typing import Any

import numpy as np

import resources
from tracker.evaluation.metrics import KEYPOINTS, Trial
from tracker.evaluation.vist_cases import (
    SETTLING,
    Ablation,
    Case,
    ablation_of,
    judged_in_outage,
)
from tracker.evaluation.vist_scenes import motion_of, simulation_of
from tracker.glove.files import load_glove
from tracker.glove.model import GloveModel
from tracker.hand.files import load_hand
from tracker.hand.model import HandModel
from tracker.messages import (
    Array,
    BlobFrame,
    Estimate,
    FrameResult,
    ImuSample,
    StereoFrame,
    Tracking,
)
from tracker.pipeline import Pipeline
from tracker.settings import Settings
from tracker.simulation.scenario import Simulation

CHECK_EVERY = 5  # frames between two whose matches are compared with the truth
SAME_BLOB_PX = 6.0  # a blob farther than this from every true marker is something else


@lru_cache(maxsize=1)
def models() -> tuple[HandModel, GloveModel]:
    """The reference hand and the paper's glove."""
    with as_file(resources.folder("hands") / "reference-right.toml") as path:
        hand = load_hand(path)
    with as_file(resources.folder("gloves") / "vist-small.toml") as path:
        glove = load_glove(path, hand)
    return hand, glove


@dataclass(eq=False)
class _Record:
    """What is kept while a trial runs."""

    estimates: list[Estimate] = field(default_factory=list)
    seen: list[int] = field(default_factory=list)
    latest_seen: int = 0
    matches: int = 0
    wrong: int = 0
    core_s: float = 0.0


def run_trial(case: Case, participant: int) -> Trial:
    """Simulate, track and judge. A function of its arguments alone (but for ``core_s``)."""
    hand, glove = models()
    variant = ablation_of(case)
    seed = 1000 * case.seed + participant
    motion = motion_of(case, hand, seed, variant)
    simulation = simulation_of(case, hand, glove, motion, seed, variant)
    settings = replace(Settings(), engine=case.engine)
    if variant is not None:
        settings = variant.settings(settings)
    pipeline = Pipeline(hand, glove, simulation.rig, settings)
    record = _track(case, simulation, pipeline, variant)
    return _judge(simulation, pipeline, record, participant, variant)


def _track(
    case: Case, simulation: Simulation, pipeline: Pipeline, variant: Ablation | None
) -> _Record:
    record = _Record()
    check = MatchCheck(simulation)
    images = case.level == "images"
    detect = _detector(simulation) if images else _as_it_is
    feed = simulation.feed(images)
    for message in feed if variant is None else variant.feed(feed):
        begin = time.process_time()
        if isinstance(message, ImuSample):
            record.estimates.append(pipeline.feed_imu(message))
        else:
            frame = detect(message, pipeline)
            pipeline.feed_frame(frame)
            check.remember(frame)
        results = pipeline.take_results()
        record.core_s += time.process_time() - begin
        for result in results:
            record.latest_seen = result.stereo_points
            matches, wrong = check(result)
            record.matches += matches
            record.wrong += wrong
        if isinstance(message, ImuSample):
            record.seen.append(record.latest_seen)
    return record


def _as_it_is(frame: BlobFrame | StereoFrame, pipeline: Pipeline) -> BlobFrame:
    """Blobs need no detector."""
    assert isinstance(frame, BlobFrame)
    return frame


def _detector(
    simulation: Simulation,
) -> Callable[[BlobFrame | StereoFrame, Pipeline], BlobFrame]:
    """Pictures to blobs, with the pipeline's hints, as the live tracker does it."""
    from tracker.vision.colours import load_profile
    from tracker.vision.detector import Detector, detect_frame

    with as_file(resources.folder("colours") / "fabric-default.toml") as path:
        detector = Detector(load_profile(path), fx=simulation.rig.fx)

    def detect(frame: BlobFrame | StereoFrame, pipeline: Pipeline) -> BlobFrame:
        if isinstance(frame, BlobFrame):
            return frame
        return detect_frame(detector, frame, pipeline.hints(frame.t))

    return detect


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
    """The marker (n,) whose true place is nearest to each blob, -1 where none is near."""
    d = np.linalg.norm(uv[:, None] - true_uv[None], axis=2)
    d = np.where(np.isfinite(d), d, np.inf)
    nearest = d.argmin(axis=1)
    return np.where(d.min(axis=1) <= SAME_BLOB_PX, nearest, -1)


def _judge(
    simulation: Simulation,
    pipeline: Pipeline,
    record: _Record,
    participant: int,
    variant: Ablation | None,
) -> Trial:
    names = pipeline.keypoint_names
    columns = [names.index(k) for k in KEYPOINTS]
    t = np.array([e.t for e in record.estimates])
    outage = variant.outage if variant is not None else 0.0
    ok = t > min(SETTLING, simulation.duration / 3)  # some recordings are short
    if outage:
        ok &= np.array([judged_in_outage(x, outage) for x in t])
    rows = np.flatnonzero(ok)
    truths = simulation.truths(t[rows])
    kept = [record.estimates[i] for i in rows]
    if outage:
        error = _articulation_error(pipeline, kept, truths, columns)
    else:
        true = np.array([x.keypoints[columns] for x in truths]).reshape(-1, len(columns), 3)
        given = np.array([e.keypoints[columns] for e in kept]).reshape(true.shape)
        error = np.linalg.norm(given - true, axis=2)
    sd = np.array([e.keypoint_sd[columns] for e in kept]).reshape(error.shape)
    hand_length = simulation.hand.length * float(simulation.wearer.scale[:, 0].mean())
    return Trial(
        participant,
        hand_length,
        t[rows],
        error,
        sd if not outage else np.full_like(sd, np.nan),
        np.array(record.seen, np.int64)[rows],
        record.matches,
        record.wrong,
        record.core_s,
        simulation.duration,
    )


def _articulation_error(
    pipeline: Pipeline, estimates: list[Estimate], truths: list[Any], columns: list[int]
) -> Array:
    """(n, 4) m in the dorsum's frame, from segment poses: keypoints themselves are given up."""
    calibration = pipeline.calibration()
    factor = float(np.nanmean(calibration.scale[:, 0]))
    hand, glove = pipeline.hand, pipeline.glove
    scale = np.full((len(hand.segments), 3), factor)
    for name, row in zip(calibration.segments, calibration.scale, strict=True):
        scale[hand.index[name]] = row
    out = np.full((len(estimates), len(columns)), np.nan)
    for i, (e, truth) in enumerate(zip(estimates, truths, strict=True)):
        if e.tracking == Tracking.SEARCHING:
            continue
        given = glove.keypoint_positions(hand, e.segment_R, e.segment_p, scale)[columns]
        given = (given - e.segment_p[0]) @ e.segment_R[0]
        true = (truth.keypoints[columns] - truth.p_GB[0]) @ truth.R_GB[0]
        out[i] = np.linalg.norm(given - true, axis=1)
    return out
