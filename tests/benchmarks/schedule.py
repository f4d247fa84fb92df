"""One second of data through everything, and the same schedule from off-the-shelf parts.

100 packets of seven IMUs and 60 stereo exposures. Images are rendered, searched and timed by
themselves: some of the second's 120, with the time scaled to all. They are searched as the app does
it: one in six as a whole, the others around what the engine expected before it saw them. The
exposures arrive late by 30 to 50 ms. Times are of the processor, not of the wall, so that a second
core that helps is counted.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from tests.benchmarks.fusion import STATES, update_case
from tests.benchmarks.mediapipe import NAME as HANDS
from tests.benchmarks.mediapipe import HandsPeer, PeerAbsentError
from tests.benchmarks.peers_fusion import (
    FrameCloud,
    PlainFilter,
    plain_second,
    pycpd_installed,
)
from tests.benchmarks.peers_vision import PlainOpenCv
from tests.benchmarks.rows import BenchRow, Call, interleaved, row
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.glove import library
from tracker.messages import Array, BlobFrame, ImuSample, StereoFrame
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation
from tracker.vision.colours import ColourProfile, parse_profile
from tracker.vision.detector import Detector, detect_frame
from tracker.vision.region_prediction import RegionPrediction, SearchPlan
from tracker.vision.stereo import match_stereo

START, SECOND = 3.0, 1.0  # s: tracked for so long before the second that is timed
IMAGES = 120  # a second, both cameras
OFF_THE_SHELF = "plain OpenCV, pycpd, dense numpy"
Messages = Sequence[ImuSample | BlobFrame]


@dataclass(frozen=True, eq=False)
class Second:
    """What a second brings: messages in order of arrival, what came before, and images."""

    sim: Simulation
    before: Messages
    messages: Messages
    images: Sequence[StereoFrame]
    predictions: Sequence[RegionPrediction | None]  # per image, what was known before it came

    @property
    def frames(self) -> list[BlobFrame]:
        return [m for m in self.messages if isinstance(m, BlobFrame)]


def make_second(seed: int = 1, images: int = 6) -> Second:
    """A simulated hand in random postures; ``images`` stereo pairs spread over the second."""
    hand, glove = library.load()
    motion = RandomPostures(hand, seed, duration=START + SECOND + 0.2)
    sim = Simulation(hand, glove, motion, seed)
    feed = [m for m in sim.feed() if isinstance(m, ImuSample | BlobFrame)]
    before = [m for m in feed if m.t_arrival < START]
    during = [m for m in feed if START <= m.t_arrival < START + SECOND]
    times = START + SECOND * np.arange(images) / max(images, 1)
    frames = [sim.renderer.frame(float(t), float(t), k) for k, t in enumerate(times)]
    return Second(sim, before, during, frames, _predictions(sim, feed, times))


def _predictions(sim: Simulation, feed: Messages, times: Array) -> list[RegionPrediction | None]:
    """The default engine's latest before each of ``times``; live there are newer ones."""
    pipeline, known = Pipeline(sim.hand, sim.glove, sim.rig), None
    out: list[RegionPrediction | None] = []
    for message in feed:
        if isinstance(message, ImuSample):
            t = pipeline.feed_imu(message).t
            while len(out) < len(times) and t > times[len(out)]:
                out.append(known)
        else:
            pipeline.feed_frame(message)
            if pipeline.take_results():
                known = pipeline.ahead.markers(t, known)
    return out


def schedule_rows(rounds: int, seed: int = 1, images: int = 6) -> list[BenchRow]:
    """Pipeline and detection of both engines, and their sum beside the off-the-shelf schedule."""
    second = make_second(seed, images)
    profile = _profile()
    calls = [
        pipeline_call(second, "chain"),
        pipeline_call(second, "vist"),
        detection_call(second, profile),
        _plain_detection(second, profile),
    ]
    if pycpd_installed():
        calls.append(_plain_filtering(second))
    s, hands = _with_hands(calls, second, rounds)
    scale = IMAGES / (2 * len(second.images))
    theirs = s[3] * scale + s[4] if len(s) > 4 else None
    rows = _rows(s[0], s[1], s[2] * scale, s[3] * scale, theirs)
    return [*rows, _exposure_row(s[0] + s[2] * scale, hands)]


def _with_hands(
    calls: list[Call], second: Second, rounds: int
) -> tuple[Array, tuple[str, float | None]]:
    """Seconds of each call, and MediaPipe's name and seconds a pair from the same rounds."""
    pairs = [(p.left, p.right) for p in second.images if p.left is not None]
    try:
        with HandsPeer(np.array(pairs)) as hands:
            s = interleaved([*calls, hands], rounds)
            name = f"{HANDS} (a hand found in {100 * hands.found_share:.0f} % of the images)"
            return s[:-1], (name, hands.pair_s)
    except PeerAbsentError as absent:
        return interleaved(calls, rounds), (f"{HANDS} ({absent})", None)


def _exposure_row(second_s: float, hands: tuple[str, float | None]) -> BenchRow:
    """A sixtieth of the second beside two calls of MediaPipe."""
    name, pair_s = hands
    theirs_ms = None if pair_s is None else 1e3 * pair_s
    ours_ms = 1e3 * second_s / (IMAGES / 2)
    return row("one stereo exposure, vision and filter", ours_ms, "ms", name, theirs_ms, "0.15")


def _rows(
    chain: float, vist: float, detect: float, plain_detect: float, theirs: float | None
) -> list[BenchRow]:
    peer, goal = OFF_THE_SHELF, "0.10"
    return [
        row("one second, whole schedule, chain", chain + detect, "s", peer, theirs, goal),
        row("one second, whole schedule, vist", vist + detect, "s", peer, theirs, "-"),
        row("core seconds per second, chain", chain + detect, "s", "-", None, "<= 0.15 s"),
        row("  of it pipeline, chain", chain, "s", "-", None, "-"),
        row("  of it pipeline, vist", vist, "s", "-", None, "-"),
        row("  of it detection, 120 images", detect, "s", "plain OpenCV", plain_detect, "-"),
    ]


def _profile() -> ColourProfile:
    name = library.DEFAULT_COLOURS
    return parse_profile(library.text("colours", name), name)


def pipeline_call(second: Second, engine: str) -> Call:
    """A call that feeds the second's messages to a pipeline that is tracking, from one state."""
    sim = second.sim
    pipeline = Pipeline(sim.hand, sim.glove, sim.rig, replace(Settings(), engine=engine))
    feed(pipeline, second.before)
    state = pipeline.get_state()

    def call() -> None:
        pipeline.set_state(state)
        feed(pipeline, second.messages)

    return call


def feed(pipeline: Pipeline, messages: Messages) -> None:
    """As the runner does it: results are fetched after every message."""
    for message in messages:
        if isinstance(message, ImuSample):
            pipeline.feed_imu(message)
        else:
            pipeline.feed_frame(message)
        pipeline.take_results()


def _marker_size(second: Second) -> float:
    return float(np.median(second.sim.glove.marker_size))


def detection_call(second: Second, profile: ColourProfile) -> Call:
    """Both images of every image, as the app searches them."""
    rig, names = second.sim.rig, profile.hue_names
    detector = Detector(profile, _marker_size(second), rig.fx)

    def call() -> None:
        plan = SearchPlan()
        for image, predicted in zip(second.images, second.predictions, strict=True):
            detect_frame(detector, image, plan.hints(predicted, rig, image.t, None, names))

    return call


def _plain_detection(second: Second, profile: ColourProfile) -> Call:
    extent = _marker_size(second) * second.sim.rig.fx
    plain = PlainOpenCv(profile, (extent / 0.9, extent / 0.15))
    images = [i for p in second.images for i in (p.left, p.right) if i is not None]
    return lambda: [plain.detect(image) for image in images]


def _plain_filtering(second: Second) -> Call:
    clouds, markers = list(_clouds(second)), second.sim.scene.instant(START).markers
    u, rng = update_case(np.random.default_rng(1)), np.random.default_rng(2)
    F = np.eye(STATES) + rng.normal(0, 1e-3, (STATES, STATES))
    plain = PlainFilter(F, np.full(STATES, 1e-8), u.P, u.H, u.r, u.R)
    packets = sum(isinstance(m, ImuSample) for m in second.messages)
    return lambda: plain_second(clouds, markers, plain, packets)


def _clouds(second: Second) -> Iterator[FrameCloud]:
    """The second's blobs without hue, and the points that their stereo matches make."""
    rig = second.sim.rig
    for f in second.frames:
        if f.left is None or f.right is None:
            continue
        points: Array = match_stereo(f.left.uv, f.left.hue, f.right.uv, f.right.hue, rig).p_C
        if len(points) >= 3:
            yield FrameCloud(f.left.uv, f.right.uv, points)
