"""A run resumes identically from its state at any point, after any events.

Runs are drawn at random: an engine, one hand or two, one camera or two, a static or head-mounted
camera, and events: images without a hand, missing packets, guided poses, another wearer, a measured
hand, a frozen or reset calibration. The state is written and read back.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, NamedTuple

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray

from tests.cloth_masks import cloth_of, looked_at
from tracker.engine.hands import Hands, Sided
from tracker.engine.kinds import ENGINES
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.fusion.chain.calibration.measured import measured_profile
from tracker.fusion.chain.engine import ChainEngine
from tracker.fusion.chain.guided.events import began, ended
from tracker.fusion.chain.params import BundleParams
from tracker.fusion.chain.pose_reset import reset_event
from tracker.messages import BlobFrame, Blobs, CameraImuSample, Estimate, Event, ImuSample, Message
from tracker.offline.simulate import SimulateOptions, build, build_both
from tracker.session.engine_state import pack, unpack
from tracker.session.state_check import require_match
from tracker.simulation.scenario import Simulation
from tracker.vision.rig import StereoRig

pytestmark = pytest.mark.long

DURATION, FPS = 2.0, 20.0
GOES_ON = 60  # messages after the cut
SEEN_AS = 0.009  # m: radius of the cloth that is drawn around each keypoint
EARLY = BundleParams(first_after=0.8, least_keyframes=4, least_blobs=6, apart=0.05, keyframes=4)
HAPPENS = (
    *("hidden", "silent", "pose", "skipped pose", "measured", "worn", "frozen", "freed"),
    *("reset", "forgotten", "straightened"),
)


QUIET = settings(
    deadline=None, derandomize=True, suppress_health_check=[HealthCheck.too_slow], print_blob=False
)
"""A run takes seconds on a loaded computer, and the same ones are drawn each time."""


class Scene(NamedTuple):
    """The tracked hands: by side a hand and a glove; the camera, and all sensor data."""

    worn: dict[str, tuple[Any, Any]]
    rig: StereoRig
    messages: Sequence[Message | Sided]


@functools.cache
def one_hand(lenses: str, camera: str) -> Scene:
    """Fingertips are measured by the glove's cloth."""
    options = SimulateOptions(
        seed=6, duration=DURATION, fps=FPS, images=False, lenses=lenses, camera=camera
    )
    sim, info = build(options)
    assert info.rig is not None
    messages = [
        with_cloth(m, sim) if isinstance(m, BlobFrame) else m
        for m in sim.messages()
        if isinstance(m, ImuSample | BlobFrame | CameraImuSample)
    ]
    return Scene({info.side: (info.hand, info.glove)}, info.rig, messages)


@functools.cache
def two_hands() -> Scene:
    sim, info = build_both(
        SimulateOptions(seed=6, duration=DURATION, fps=FPS, images=False, hands="both")
    )
    assert info.rig is not None
    messages = [
        Sided(m.message, m.side) if isinstance(m.message, ImuSample) else m.message
        for m in sim.messages()
        if isinstance(m.message, ImuSample | BlobFrame)
    ]
    return Scene({h.side: (h.hand, h.glove) for h in info.hands}, info.rig, messages)


def with_cloth(frame: BlobFrame, sim: Simulation) -> BlobFrame:
    """The frame with discs of cloth at the true hand."""
    (truth,) = sim.truths(np.array([frame.t]))
    rig = sim.rig
    pose = frame.pose or rig.pose
    p_C = (truth.keypoints[:21] - pose.p_GC) @ pose.R_GC
    x, y = looked_at(rig.left.height, rig.left.width)

    def side(blobs: Blobs | None, right: bool) -> Blobs | None:
        if blobs is None:
            return None
        mask = np.zeros(x.shape, bool)
        for (u, v), z in zip(rig.project(p_C, right), p_C[:, 2], strict=True):
            r = rig.fx * SEEN_AS / z
            rows, columns = pixels_within(y[:, 0], v, r), pixels_within(x[0], u, r)
            disc = np.hypot(x[rows, columns] - u, y[rows, columns] - v) < r
            mask[rows, columns] |= disc
        return replace(blobs, cloth=cloth_of(mask))

    return replace(frame, left=side(frame.left, False), right=side(frame.right, True))


def pixels_within(along: NDArray[np.int64], centre: float, radius: float) -> slice:
    """The indices of ascending coordinates that are closer than ``radius`` to ``centre``."""
    first, end = np.searchsorted(along, (centre - radius, centre + radius))
    return slice(int(first), int(end))


@dataclass(frozen=True)
class Course:
    """One run: its events (when, what, which hand), and when it is cut; both in thousandths of the
    messages."""

    engine: str
    scene: Callable[[], Scene]
    happens: tuple[tuple[int, str, int], ...]
    cut: int


@st.composite
def courses(draw: st.DrawFn, engines: Sequence[str], both: bool) -> Course:
    engine, scene = draw(st.sampled_from(engines)), two_hands
    if not both:
        lenses = draw(st.sampled_from(("both", "one"))) if engine != "vist" else "both"
        camera = draw(st.sampled_from(("stand", "head-imu")))
        scene = partial(one_hand, lenses, camera)  # type: ignore[assignment]
    happening = st.tuples(st.integers(0, 950), st.sampled_from(HAPPENS), st.integers(0, 1))
    happens = draw(st.lists(happening, max_size=5))
    return Course(engine, scene, tuple(sorted(happens)), draw(st.integers(0, 950)))


class Run:
    """One or two hands that process a course's messages."""

    def __init__(self, course: Course) -> None:
        scene, chosen = course.scene(), Settings(engine=course.engine)
        chosen = replace(chosen, chain=replace(chosen.chain, bundle=EARLY))
        make = {s: partial(Pipeline, *worn, scene.rig, chosen) for s, worn in scene.worn.items()}
        self.hands = Hands(make)

    def feed(self, message: Message | Sided) -> Estimate | None:
        if isinstance(message, Sided):
            return self.hands.feed_imu(message.side, message.sample)
        if isinstance(message, ImuSample):
            return self.hands.feed_imu(next(iter(self.hands.pipelines)), message)
        if isinstance(message, BlobFrame):
            self.hands.feed_frame(message)
        elif isinstance(message, Event):
            self.hands.feed_event(message)
        else:
            assert isinstance(message, CameraImuSample)
            self.hands.feed_camera_imu(message)
        return None

    def command(self, what: str, side: int) -> None:
        """A user's commands on the calibration."""
        pipelines = list(self.hands.pipelines.values())
        engine = pipelines[side % len(pipelines)].engine
        if not isinstance(engine, ChainEngine):
            return
        if what == "measured":
            engine.apply_profile(measured_profile(engine.layout, 0.19))
        elif what == "worn":
            engine.apply_profile(engine.profile())
        elif what in ("frozen", "freed"):
            engine.wearer.freeze(what == "frozen")
        elif what == "reset":
            engine.wearer.reset()
        elif what == "forgotten":
            engine.wearer.reset(["index_proximal"])


def steps(course: Course) -> Iterator[Message | Sided | tuple[str, int]]:
    """Messages modified by the course, and commands."""
    hidden = silent = 0
    waiting = list(course.happens)
    pose_ends: list[Event] = []
    messages = course.scene().messages
    for k, message in enumerate(messages):
        t = (message.sample if isinstance(message, Sided) else message).t_arrival  # type: ignore[union-attr]
        while waiting and waiting[0][0] * len(messages) <= 1000 * k:
            _, what, side = waiting.pop(0)
            hidden, silent = (
                k + 90 if what == "hidden" else hidden,
                k + 40 if what == "silent" else silent,
            )
            if "pose" in what:
                yield began("flat", t)
                pose_ends.append(ended("flat", t + 0.5, what == "pose"))
            elif what == "straightened":
                yield reset_event(t)
            elif what not in ("hidden", "silent"):
                yield what, side
        while pose_ends and pose_ends[0].t <= t:
            yield pose_ends.pop(0)
        if isinstance(message, BlobFrame) and k < hidden:
            none = Blobs.empty()
            message = replace(message, left=message.left and none, right=message.right and none)
        if k < silent and isinstance(message, Sided | ImuSample):
            continue
        yield message


def check(course: Course) -> None:
    """The uninterrupted run and the one resumed from bytes have the same estimates."""
    run, again, after = Run(course), Run(course), 0
    cut = course.cut * len(course.scene().messages) // 1000
    for k, step in enumerate(steps(course)):
        if k == cut:
            engine, state = unpack(pack(course.engine, run.hands.get_state()))
            require_match(state, again.hands.get_state(), engine)
            again.hands.set_state(state)
        if k >= cut:
            after += 1
        if isinstance(step, tuple) and not isinstance(step, Sided):
            run.command(*step)
            if k >= cut:
                again.command(*step)
            continue
        a = run.feed(step)
        if k >= cut:
            b = again.feed(step)
            assert (a is None) == (b is None)
            if a is not None and b is not None:
                assert_same(a, b)
        if after > GOES_ON:
            return


def assert_same(a: Estimate, b: Estimate) -> None:
    assert (a.t, a.tracking) == (b.t, b.tracking)
    for name in ("keypoints", "angles", "keypoint_sd"):
        np.testing.assert_array_equal(getattr(a, name), getattr(b, name), name)


@pytest.mark.timeout(600)
@settings(QUIET, max_examples=10)
@given(courses(("chain",), both=False))
def test_one_hand_resumes_from_any_time(course: Course) -> None:
    check(course)


@pytest.mark.timeout(600)
@settings(QUIET, max_examples=10)
@given(courses([e for e in ENGINES.names() if e != "chain"], both=False))
def test_every_other_engine_resumes_from_any_time(course: Course) -> None:
    check(course)


@pytest.mark.timeout(600)
@settings(QUIET, max_examples=5)
@given(courses(("chain", "vist"), both=True))
def test_both_hands_resume_from_any_time(course: Course) -> None:
    check(course)
