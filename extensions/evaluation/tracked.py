"""Tracks a simulated person and compares keypoints with the truth; used by several evaluations."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from extensions.evaluation.vist.trial import TrialImageSearch
from tracker.engine.pipeline import Pipeline
from tracker.hand.names import MARKED_KEYPOINTS
from tracker.messages import Array, BlobFrame, Estimate, ImuSample, StereoFrame, Tracking, Validity
from tracker.simulation.scenario import Simulation

SETTLED = 3.0  # s until which a wearer's hand is learned first
EVERY = 4  # packets between compared instants


class Tracked(NamedTuple):
    """For one person: the mean error (mm) of the four keypoints, the share of instants at which the
    hand is tracked, and the number of keypoints that are called measured and ``wrong``."""

    error_mm: float
    tracked: float
    wrong: int


def estimates_of(
    simulation: Simulation,
    pipeline: Pipeline,
    images: bool,
    progress: Callable[[float], None] = lambda share: None,
) -> list[Estimate]:
    """One estimate for each packet."""
    search, estimates = TrialImageSearch(simulation), list[Estimate]()
    for message in simulation.messages(images):
        if isinstance(message, ImuSample):
            estimates.append(pipeline.feed_imu(message))
            progress(message.t / simulation.duration)
        elif isinstance(message, BlobFrame):
            pipeline.feed_frame(message)
        elif isinstance(message, StereoFrame):
            pipeline.feed_frame(search.blobs(message, pipeline))
        if pipeline.take_results() and images and estimates:
            search.look_ahead(pipeline, estimates[-1].t)
    return estimates


def compared(
    simulation: Simulation, pipeline: Pipeline, estimates: list[Estimate], wrong: float = 0.05
) -> Tracked:
    """Figures of the estimates after `SETTLED`; an error over ``wrong`` m of a measured keypoint is
    counted."""
    late = [e for e in estimates if e.t > SETTLED][::EVERY]
    truths = simulation.truths(np.array([e.t for e in late]))
    error: Array = np.linalg.norm(
        np.array([e.keypoints for e in late]) - np.array([t.keypoints for t in truths]), axis=2
    )
    rows = [pipeline.keypoint_names.index(name) for name in MARKED_KEYPOINTS]
    measured = np.array([e.keypoint_state for e in late]) == Validity.MEASURED
    return Tracked(
        1e3 * float(np.nanmean(error[:, rows])),
        float(np.mean([e.tracking == Tracking.TRACKING for e in late])),
        int(np.count_nonzero(measured & (error > wrong))),
    )
