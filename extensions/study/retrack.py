"""Tracks a recorded trial again in memory: with an engine, or with a variant of one (ablation).

The variants are those of `extensions.evaluation.vist.cases` that need no other recording; messages
are fed at times counted from the beginning of the session.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from extensions.evaluation.vist.cases import ABLATIONS, Ablation, Feed
from tracker.base.errors import ConfigError
from tracker.base.notices import failure
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.fusion.chain.guided.events import guided_of
from tracker.messages import (
    BlobFrame,
    Calibration,
    CameraImuSample,
    Estimate,
    Event,
    ImuSample,
    IntArray,
    StereoFrame,
)
from tracker.session.reader import SessionReader
from tracker.session.ros import topics
from tracker.vision.colours import parse_profile
from tracker.vision.detector import Detector, detect_frame

RECORDED = "recorded"
COMPLETE = "complete"
ENGINES = ("chain", "vist")
SENSED = (ImuSample, BlobFrame, CameraImuSample, Event)


@dataclass(frozen=True)
class Variant:
    """``name`` of a row in the tables: ``recorded`` (the estimates in the file), or
    ``ENGINE`` and ``ENGINE NAME-OF-ABLATION``, tracked again with the default settings."""

    name: str
    engine: str = ""
    ablation: Ablation | None = None

    @property
    def text(self) -> str:
        """What it is."""
        if not self.engine:
            return "as recorded"
        return "tracked again" if self.ablation is None else self.ablation.text

    @property
    def outage(self) -> float:
        """s without images, repeatedly; 0 for none."""
        return 0.0 if self.ablation is None else self.ablation.outage


def variants(engines: tuple[str, ...] = ENGINES) -> dict[str, Variant]:
    """All variants that a recording can be tracked with, by name."""
    out = {RECORDED: Variant(RECORDED)}
    for engine in engines:
        out[engine] = Variant(engine, engine)
        for ablation in ABLATIONS.values():
            same_data = ablation.fps is None and ablation.speed == 1.0
            if engine in ablation.engines and same_data and ablation.experiment == "free":
                name = f"{engine} {ablation.name}"
                out[name] = Variant(name, engine, ablation)
    return out


def chosen(names: tuple[str, ...]) -> list[Variant]:
    """The variants of these names. Raises ConfigError for an unknown one."""
    known = variants()
    for name in names:
        if name not in known:
            raise ConfigError(failure("study.unknown_variant", name=name, known=tuple(known)))
    return [known[name] for name in names]


@dataclass(frozen=True, eq=False)
class RetrackedTrial:
    """Estimates at t (N,) s since the beginning of the session ``seen`` (N,): markers matched in
    both images of the latest exposure; -1 if unknown. ``scale`` (S, 3) learned by the engine."""

    estimates: list[Estimate]
    t: list[float]
    seen: IntArray
    calibration: Calibration | None


def recorded(path: Path, side: str = "") -> RetrackedTrial:
    """The estimates in a file, without retracking. Raises FileError."""
    with SessionReader(path, side=side) as reader:
        start = reader.anchor.monotonic(reader.span_ns[0])
        estimates: list[Estimate] = []
        calibration = None
        for m in reader.messages((Estimate, Calibration)):
            if isinstance(m, Estimate):
                estimates.append(m)
            elif isinstance(m, Calibration):
                calibration = m
    t = [e.t - start for e in estimates]
    return RetrackedTrial(estimates, t, np.full(len(t), -1, np.int64), calibration)


def retracked(path: Path, variant: Variant, side: str = "") -> RetrackedTrial:
    """The estimates of a variant. Deterministic. Raises FileError for a session without data."""
    if not variant.engine:
        return recorded(path, side)
    with SessionReader(path, side=side) as reader:
        info = reader.info
        settings = replace(Settings(), engine=variant.engine)
        if variant.ablation is not None:
            settings = variant.ablation.settings(settings)
        pipeline = Pipeline(info.hand, info.glove, info.rig, settings)
        feed: Feed = _from_zero(reader)
        if variant.ablation is not None:
            feed = variant.ablation.feed(feed)
        return _track(pipeline, feed)


def _track(pipeline: Pipeline, feed: Feed) -> RetrackedTrial:
    estimates: list[Estimate] = []
    seen: list[int] = []
    latest = 0
    for message in feed:
        if isinstance(message, ImuSample):
            estimates.append(pipeline.feed_imu(message))
        elif isinstance(message, BlobFrame):
            pipeline.feed_frame(message)
        elif isinstance(message, CameraImuSample):
            pipeline.feed_camera_imu(message)
        elif isinstance(message, Event):
            pipeline.feed_event(message)
        for result in pipeline.take_results():
            latest = result.stereo_points
        if isinstance(message, ImuSample):
            seen.append(latest)
    t = [e.t for e in estimates]
    return RetrackedTrial(estimates, t, np.array(seen, np.int64), pipeline.calibration())


def _from_zero(reader: SessionReader) -> Feed:
    """What was fed to the engine, with times from the beginning of the session; images without
    blobs are searched."""
    start = reader.anchor.monotonic(reader.span_ns[0])
    for m in _messages(reader):
        if isinstance(m, Event):
            if guided_of(m) is not None:
                yield replace(m, t=m.t - start)
        elif isinstance(m, ImuSample | BlobFrame | CameraImuSample):
            yield replace(m, t=m.t - start, t_arrival=m.t_arrival - start)


def _messages(reader: SessionReader) -> Iterator[object]:
    if topics.blobs("left") in reader.topic_names or reader.info.rig is None:
        yield from reader.messages(SENSED)
        return
    profile = parse_profile(reader.attachment("colours.toml"))
    detector = Detector(profile, fx=reader.rig().fx)
    for m in reader.messages((*SENSED, StereoFrame)):
        yield detect_frame(detector, m) if isinstance(m, StereoFrame) else m
