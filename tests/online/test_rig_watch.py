"""A stereo camera that does not match its calibration, detected in simulated blobs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
import pytest

from extensions.evaluation.vist.scenes import Distractors
from tracker.engine.pipeline import Pipeline
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import BlobFrame, Blobs, FrameResult, ImuSample, Tracking
from tracker.online.rig_watch import SHIFTS, RigWatch, leaders, row_votes
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation
from tracker.vision.rig import ideal_rig

MARKERS = 37
LENS_5_MM_PX = 640 * 0.005 / 0.4  # at the hand's distance
Shift = tuple[float, float]


def shifted(frame: BlobFrame, left: Shift = (0, 0), right: Shift = (0, 0)) -> BlobFrame:
    """All blobs of a side shifted by (u, v) px."""

    def moved(blobs: Blobs | None, by: Shift) -> Blobs | None:
        return replace(blobs, uv=blobs.uv + np.array(by)) if blobs else None

    return replace(frame, left=moved(frame.left, left), right=moved(frame.right, right))


def swapped(frame: BlobFrame) -> BlobFrame:
    return replace(frame, left=frame.right, right=frame.left)


@pytest.fixture(scope="module")
def frames(hand: HandModel, glove: GloveModel) -> list[BlobFrame]:
    sim = Simulation(hand, glove, RandomPostures(hand, 5, duration=8.0), 5, fps=15)
    return list(sim.frames())  # type: ignore[arg-type]


@pytest.fixture(scope="module")
def crowded(hand: HandModel, glove: GloveModel) -> list[BlobFrame]:
    """With sixty coloured balls in the background."""
    motion = RandomPostures(hand, 6, duration=4.0)
    sim = Simulation(hand, glove, motion, 6, fps=15, extras=(Distractors(6),))
    return list(sim.frames())  # type: ignore[arg-type]


def test_votes_of_three_blobs() -> None:
    left = np.array([[300.0, 100.0], [320.0, 120.0], [340.0, 140.0]])
    right = left - [100.0, 2.25]  # as seen by a camera 2.25 px lower
    hue = np.zeros(3, np.int64)
    counts, means = row_votes(left, hue, right, hue, (45.0, 270.0), 1.5)
    best = int(np.argmax(counts[0]))
    assert counts[0, best] == 3 and abs(best - SHIFTS - 2.25) < 1.5
    assert means[0, best] == pytest.approx(2.25)
    assert counts[1].sum() == 0
    counts, _ = row_votes(right, hue, left, hue, (45.0, 270.0), 1.5)
    assert counts[0].sum() == 0 and counts[1].max() == 3
    counts, _ = row_votes(left, hue, right, hue + 1, (45.0, 270.0), 1.5)
    assert counts.sum() == 0


def test_a_calibrated_camera_is_accepted(frames, crowded) -> None:
    for stream in (frames, crowded):
        watch = RigWatch(ideal_rig())
        assert all(watch.usable(f) for f in stream)
        assert watch.notices.drain() == []
        assert abs(watch.state.row_shift_px) < 0.3
        assert not watch.state.moved and not watch.state.swapped


def test_swapped_images_are_rejected_and_reported(frames, crowded) -> None:
    for stream in (frames, crowded):
        watch = RigWatch(ideal_rig())
        usable = [watch.usable(swapped(f)) for f in stream[:30]]
        assert np.mean(usable) < 0.05
        assert watch.state.swapped and watch.state.refused > 25
        assert [n.code for n in watch.notices.drain()] == ["camera.swapped"]
        assert all(watch.usable(f) for f in stream[30:])
        assert [n.code for n in watch.notices.drain()] == ["camera.in_order"]


@pytest.mark.parametrize("rows", [LENS_5_MM_PX, -LENS_5_MM_PX, 2.0])
def test_a_camera_that_moved_up_or_down(frames, rows: float) -> None:
    watch = RigWatch(ideal_rig())
    assert all(watch.usable(shifted(f, right=(0, rows))) for f in frames[:40])
    assert watch.state.moved
    assert watch.state.row_shift_px == pytest.approx(-rows, abs=0.3)
    assert watch.notices.drain()[0].code == "camera.lens_moved"
    for f in frames[40:]:
        watch.usable(f)
    assert not watch.state.moved
    assert [n.code for n in watch.notices.drain()] == ["camera.fits_again"]


def run(sim: Simulation, left: Shift, right: Shift) -> Iterator[RigWatch]:
    """A tracked hand whose camera is moved after 4 s; the watch after 4 and 5 s."""
    pipeline, watch = Pipeline(sim.hand, sim.glove, sim.rig), RigWatch(sim.rig)
    before = False
    for message in sim.feed():
        if isinstance(message, ImuSample):
            pipeline.feed_imu(message)
            watch.packet(message.t, message.t_arrival)
        else:
            assert isinstance(message, BlobFrame)
            if message.t >= 4.0:
                message = shifted(message, left, right)
                if not before:
                    before = True
                    yield watch
            pipeline.feed_frame(message)
        for result in pipeline.take_results():
            watch.check(result)
    yield watch


@pytest.mark.long
@pytest.mark.parametrize(
    ("left", "right", "code"),
    [
        ((0, 0), (-LENS_5_MM_PX, 0), "camera.lens_knocked"),
        ((LENS_5_MM_PX, 0), (LENS_5_MM_PX, 0), "camera.moved"),
    ],
)
def test_a_jump_is_reported_once(hand, glove, left: Shift, right: Shift, code: str) -> None:
    sim = Simulation(hand, glove, RandomPostures(hand, 7, duration=5.0), 7, fps=30)
    stages = run(sim, left, right)
    assert next(stages).state.jumps == 0
    watch = next(stages)
    assert watch.state.jumps == 1
    (reported,) = watch.notices.drain()
    assert reported.code == code and reported.values["jump_px"] == pytest.approx(8.0, abs=0.5)


def result(t: float, off_px: float, at: Shift = (0.0, 0.0)) -> FrameResult:
    """All markers predicted ``at`` a position (px), and measured with this offset."""
    expected = np.tile(np.array(at, float), (MARKERS, 1))
    nothing = FrameResult.nothing(t, Tracking.TRACKING, MARKERS)
    return replace(
        nothing,
        predicted_left=expected,
        predicted_right=expected,
        residual=np.full((MARKERS, 4), off_px),
    )


def packets(watch: RigWatch, begin: float, end: float) -> None:
    for t in np.arange(begin, end, 0.01):
        watch.packet(t, t)


def agree(watch: RigWatch, begin: float, end: float) -> None:
    """Packets up to ``end`` from two seconds before, and consistent images from ``begin`` on."""
    packets(watch, end - 2.0, end + 0.04)
    for t in np.arange(begin, end, 0.033):
        watch.check(result(t, 0.1))


def see(watch: RigWatch, off_px: Sequence[float], begin: float = 4.02) -> None:
    """An image every 33 ms, with this constant offset from the prediction."""
    for k, off in enumerate(off_px):
        t = begin + 0.033 * k
        packets(watch, t, t + 0.033)
        watch.check(result(t, off))


@pytest.mark.parametrize(("seen", "jumps"), [(0.5, 1), (0.1, 0)])
def test_a_hand_that_has_just_returned_explains_a_jump(seen: float, jumps: int) -> None:
    """Its velocity is hardly known after one image or two."""
    watch = RigWatch(ideal_rig())
    agree(watch, 4.0 - seen, 4.0)
    see(watch, [9.0] * 5)
    assert watch.state.jumps == jumps


@pytest.mark.parametrize(
    ("off_px", "jumps"),
    [
        ([9.0] * 4, 1),
        ([9.0] * 3, 0),
        ([9.0, 0.0, 0.0, 0.0, 0.0], 0),
        ([9.0, 9.0, 0.0, 0.0, 0.0], 0),
        ([9.0, -9.0, 9.0, -9.0, 9.0, -9.0], 0),
        ([9.0, 9.0, 9.0, 1.0, 9.0, 9.0], 0),
    ],
)
def test_a_jump_is_reported_once_the_following_images_confirm_it(off_px, jumps: int) -> None:
    watch = RigWatch(ideal_rig())
    agree(watch, 3.0, 4.0)
    see(watch, off_px)
    assert watch.state.jumps == jumps


def test_a_filter_that_follows_a_jump_does_not_hide_it() -> None:
    """It predicts the markers at their last positions: the measurements remain off the earlier
    path."""
    watch = RigWatch(ideal_rig())
    agree(watch, 3.0, 4.0)
    for k, (off, at) in enumerate([(9.0, 0.0), (2.0, 7.0), (0.5, 8.5), (0.1, 8.9)]):
        t = 4.02 + 0.033 * k
        packets(watch, t, t + 0.033)
        watch.check(result(t, off, (at, at)))
    assert watch.state.jumps == 1


@pytest.mark.parametrize(
    ("packet_late", "image_late", "uneven", "jumps"),
    [(0.0, 0.0, 0.0, 1), (0.2, 0.0, 0.0, 0), (0.0, 0.2, 0.0, 0), (0.0, 0.0, 0.03, 0)],
)
def test_unreliable_timestamps_explain_a_jump(packet_late, image_late, uneven, jumps: int) -> None:
    """Once in the last second a packet or an image was late, or two images arrived as a pair."""
    watch = RigWatch(ideal_rig())
    for k in range(400):
        t = k / 100
        late = packet_late if k == 340 else 0.0
        watch.packet(t, t + late)
        if k % 4 == 0 and k < 396:
            t += uneven if k == 340 else 0.0
            frame = BlobFrame(t, t + (image_late if k == 340 else 0.0), None, None, None)
            watch.usable(frame)
            watch.check(result(t, 0.1))
    see(watch, [9.0] * 5, begin=4.0)
    assert watch.state.jumps == jumps


@pytest.mark.parametrize(("late", "jumps"), [(0.01, 1), (0.03, 0)])
def test_missing_packets_explain_a_jump(late: float, jumps: int) -> None:
    watch = RigWatch(ideal_rig())
    agree(watch, 3.0, 4.0)
    watch.check(result(4.03 + late, 9.0))
    for k in range(1, 5):
        t = 4.03 + late + 0.033 * k
        packets(watch, 4.04 if k == 1 else t - 0.033, t)
        watch.check(result(t, 9.0))
    assert watch.state.jumps == jumps


@pytest.mark.parametrize(("silence", "jumps"), [(0.0, 1), (0.1, 0)])
def test_a_glove_without_data_explains_a_jump(silence: float, jumps: int) -> None:
    watch = RigWatch(ideal_rig())
    agree(watch, 3.0, 4.0)
    packets(watch, 4.04 + silence, 4.06 + silence)
    see(watch, [9.0] * 5, begin=4.06 + silence)
    assert watch.state.jumps == jumps


@pytest.mark.parametrize(
    ("velocity", "jumps"), [((200, 200), 0), ((-200, -200), 0), ((200, -200), 1), ((20, 20), 1)]
)
def test_an_image_of_another_time_explains_a_jump(velocity: Shift, jumps: int) -> None:
    """A hand moves by 9 px in either direction in 45 ms, but not across its path, and not a slow
    one."""

    watch = RigWatch(ideal_rig())
    packets(watch, 2.0, 4.3)
    for t in np.arange(3.0, 4.2, 0.033):
        off_px = 0.1 if t < 4.0 else 9.0
        watch.check(result(t, off_px, (velocity[0] * t, velocity[1] * t)))
    assert watch.state.jumps == jumps


def overloaded(sim: Simulation, seed: int) -> list[ImuSample | BlobFrame]:
    """The messages of a computer at load 20: stalls in which nothing is read, packets in bursts,
    images dropped, and stamped on arrival rather than at exposure."""
    rng = np.random.default_rng(seed)
    stalls = [(t, t + rng.exponential(0.12)) for t in np.cumsum(rng.exponential(0.6, 40))]

    def read(t: float) -> float:
        return max([t, *(end for begin, end in stalls if begin <= t < end)])

    out: list[ImuSample | BlobFrame] = []
    for m in sim.feed():
        assert isinstance(m, ImuSample | BlobFrame)
        arrival = read(m.t_arrival)
        if isinstance(m, ImuSample):
            out.append(replace(m, t_arrival=arrival))
        elif rng.random() < 0.6:
            taken = m.t + rng.choice([0.0, 1.0], p=[0.7, 0.3]) * (read(m.t) - m.t)
            jitter = rng.choice([0.0, 0.045, 0.09], p=[0.85, 0.1, 0.05])
            out.append(replace(m, t=taken + jitter, t_arrival=max(arrival, taken + jitter)))
    return sorted(out, key=lambda m: (m.t_arrival, isinstance(m, BlobFrame)))


@pytest.mark.long
@pytest.mark.parametrize("seed", range(4))
def test_an_overloaded_computer_is_not_a_moved_camera(hand, glove, seed: int) -> None:
    sim = Simulation(hand, glove, RandomPostures(hand, seed, duration=12.0), seed, fps=30)
    pipeline, tracked = Pipeline(sim.hand, sim.glove, sim.rig), 0
    for message in overloaded(sim, seed):
        if isinstance(message, ImuSample):
            tracked += pipeline.feed_imu(message).tracking == Tracking.TRACKING
        else:
            pipeline.feed_frame(message)
        pipeline.take_results()
    assert tracked > 300
    assert pipeline.rig_state.jumps == 0
    assert not {"camera.moved", "camera.lens_knocked"} & {n.code for n in pipeline.drain_notices()}


def test_no_jump_without_earlier_agreement() -> None:
    watch = RigWatch(ideal_rig())
    packets(watch, 0.0, 3.0)
    see(watch, [9.0] * 5, begin=3.0)
    assert watch.state.jumps == 0


def test_one_missing_side_gives_no_result(frames) -> None:
    watch = RigWatch(ideal_rig())
    assert all(watch.usable(replace(f, right=None)) for f in frames)
    assert np.isnan(watch.state.row_shift_px) and watch.notices.drain() == []


@pytest.mark.parametrize("rows", [-SHIFTS, SHIFTS])
def test_images_with_the_largest_tested_offset(frames, rows: float) -> None:
    """The most frequent shift may be the first or the last tested."""
    watch = RigWatch(ideal_rig())
    for frame in frames[:20]:
        assert watch.usable(shifted(frame, right=(0, rows)))


def test_maxima_of_a_vote() -> None:
    """The first of equal values is the maximum; its neighbours within three rows do not compete."""
    rng = np.random.default_rng(3)
    for _ in range(50):
        counts, means = (
            rng.integers(0, 9, (2, 2 * SHIFTS + 1)),
            rng.normal(size=(2, 2 * SHIFTS + 1)),
        )
        best = int(np.argmax(counts[0]))
        others = np.delete(counts[0], range(max(best - 3, 0), min(best + 4, counts.shape[1]))).max()
        expected = counts[0, best], counts[1].max(), others, means[0, best]
        assert leaders(counts, means) == expected
