"""The chain engine on simulated people: accuracy, faults, recovery, saving."""

from __future__ import annotations

import dataclasses
import functools
from collections.abc import Callable, Iterable

import numpy as np
import pytest

from tracker.engine.pipeline import Pipeline
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array, BlobFrame, Estimate, ImuSample, Tracking, Validity
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation

KEYPOINTS = ("thumb_tip", "index_tip", "middle_tip", "dorsum")
Message = ImuSample | BlobFrame
Edit = Callable[[Message], Message | None]


def simulation(hand: HandModel, glove: GloveModel, seed: int, duration: float) -> Simulation:
    return Simulation(hand, glove, RandomPostures(hand, seed, duration=duration), seed, fps=30)


@functools.cache
def messages_of(sim: Simulation) -> tuple[Message, ...]:
    """As the simulation feeds them; `edit` makes others of them."""
    return tuple(sim.feed())


def run(
    sim: Simulation, hand: HandModel | None = None, edit: Edit = lambda m: m
) -> tuple[list[Estimate], Array]:
    """Estimates and the error of the four keypoints (n, 4) m."""
    pipeline = Pipeline(hand or sim.hand, sim.glove, sim.rig)
    fed = (edited for m in messages_of(sim) if (edited := edit(m)) is not None)
    estimates = feed(pipeline, fed)
    return estimates, errors(sim, estimates)


def feed(pipeline: Pipeline, messages: Iterable[Message]) -> list[Estimate]:
    estimates = []
    for message in messages:
        if isinstance(message, ImuSample):
            estimates.append(pipeline.feed_imu(message))
        else:
            pipeline.feed_frame(message)
    return estimates


def errors(sim: Simulation, estimates: list[Estimate]) -> Array:
    names = sim.glove.keypoint_names(sim.hand)
    rows = [names.index(k) for k in KEYPOINTS]
    truth = sim.truths(np.array([e.t for e in estimates]))
    return np.array(
        [
            np.linalg.norm(e.keypoints[rows] - t.keypoints[rows], axis=1)
            for e, t in zip(estimates, truth, strict=True)
        ]
    )


def times(estimates: list[Estimate]) -> Array:
    return np.array([e.t for e in estimates])


@pytest.fixture(scope="module")
def sim(hand: HandModel, glove: GloveModel) -> Simulation:
    return simulation(hand, glove, 1, 9.0)


@pytest.fixture(scope="module")
def tracked(sim: Simulation) -> tuple[list[Estimate], Array]:
    return run(sim)


def test_tracks_a_person(tracked: tuple[list[Estimate], Array]) -> None:
    """12 mm is the first goal; this person is tracked at about 4 mm."""
    estimates, error = tracked
    t = times(estimates)
    assert np.isfinite(error[t > 0.5]).all()
    assert error[t > 3].mean() < 0.008
    assert all(e.tracking == Tracking.TRACKING for e in estimates if e.t > 0.5)


def test_reports_what_is_measured_and_what_is_inferred(
    sim: Simulation, tracked: tuple[list[Estimate], Array]
) -> None:
    names, joints = sim.glove.keypoint_names(sim.hand), sim.hand.joint_names
    shown = [e for e in tracked[0] if 2.0 < e.t < 4.5]  # then the index finger is occluded
    state = dict(zip(names, np.transpose([e.keypoint_state for e in shown]), strict=True))
    angle = dict(zip(joints, np.transpose([e.angle_state for e in shown]), strict=True))
    assert np.mean(state["index_pip"] == Validity.MEASURED) > 0.95
    assert np.mean(angle["index_pip_flexion"] == Validity.MEASURED) > 0.95
    assert np.all(state["little_tip"] == Validity.INFERRED)
    assert np.all(angle["index_dip_flexion"] == Validity.INFERRED)


def test_joints_are_rigid(sim: Simulation, tracked: tuple[list[Estimate], Array]) -> None:
    """The distance between joints is a calibrated constant."""
    hand = sim.hand
    pip, mcp = hand.index["index_intermediate"], hand.index["index_proximal"]
    length = [np.linalg.norm(e.segment_p[pip] - e.segment_p[mcp]) for e in tracked[0][-100:]]
    assert np.ptp(length) < 1e-3


def test_is_reproducible_bit_for_bit(
    sim: Simulation, tracked: tuple[list[Estimate], Array]
) -> None:
    again = feed(Pipeline(sim.hand, sim.glove, sim.rig), sim.feed())
    for a, b in zip(tracked[0], again, strict=True):
        assert np.array_equal(a.keypoints, b.keypoints, equal_nan=True)
        assert np.array_equal(a.angles, b.angles, equal_nan=True)


@pytest.mark.long
def test_a_restored_state_resumes_identically(sim: Simulation) -> None:
    messages = messages_of(sim)
    half = len(messages) // 2
    first = Pipeline(sim.hand, sim.glove, sim.rig)
    feed(first, messages[:half])
    second = Pipeline(sim.hand, sim.glove, sim.rig)
    second.set_state(first.get_state())
    a, b = feed(first, messages[half:]), feed(second, messages[half:])
    assert all(np.array_equal(x.keypoints, y.keypoints) for x, y in zip(a, b, strict=True))


def broken(change: Callable[[ImuSample], ImuSample | None]) -> Edit:
    """Applies ``change`` to packets between 4 and 5.5 s."""

    def edit(m: Message) -> Message | None:
        return change(m) if isinstance(m, ImuSample) and 4 < m.t < 5.5 else m

    return edit


def stuck(s: ImuSample) -> ImuSample:
    accel, gyro = s.accel.copy(), s.gyro.copy()
    accel[3], gyro[3] = 1.0, 3.0
    return dataclasses.replace(s, accel=accel, gyro=gyro)


def not_a_number(s: ImuSample) -> ImuSample:
    gyro = s.gyro.copy()
    gyro[5] = np.nan
    return dataclasses.replace(s, gyro=gyro)


def root_dead(s: ImuSample) -> ImuSample:
    valid = np.ones(len(s.valid), bool)
    valid[0] = False
    return dataclasses.replace(s, valid=valid)


@pytest.mark.long
@pytest.mark.parametrize("fault", [stuck, not_a_number, root_dead])
def test_a_broken_imu_degrades_and_recovers(
    sim: Simulation, fault: Callable[[ImuSample], ImuSample | None]
) -> None:
    estimates, error = run(sim, edit=broken(fault))
    t = times(estimates)
    assert np.nanmax(error[(t > 4) & (t < 5.5)].mean(axis=1), initial=0) < 0.06
    assert error[t > 7].mean() < 0.010


@pytest.mark.long
def test_a_glove_without_packets_is_tracked_by_the_cameras_alone(sim: Simulation) -> None:
    """Fingers that moved meanwhile converge slowly: only the hand's position is tested at once."""
    estimates, error = run(sim, edit=broken(lambda s: None))
    t = times(estimates)
    assert error[t > 5.7, 3].max() < 0.012
    assert error[t > 8].mean() < 0.040


@pytest.mark.long
def test_one_camera_covered(sim: Simulation) -> None:
    def edit(m: Message) -> Message:
        hide = isinstance(m, BlobFrame) and 4 < m.t < 6
        return dataclasses.replace(m, right=None) if hide else m  # type: ignore[type-var]

    estimates, error = run(sim, edit=edit)
    assert error[times(estimates) > 4].mean() < 0.010


@pytest.mark.long
def test_a_hand_out_of_view_is_lost_and_found_again(sim: Simulation) -> None:
    def edit(m: Message) -> Message | None:
        return None if isinstance(m, BlobFrame) and 3 < m.t < 6 else m

    estimates, error = run(sim, edit=edit)
    t = times(estimates)
    away = [e for e in estimates if 4.5 < e.t < 6]
    assert all(e.tracking == Tracking.LOST and np.isnan(e.keypoints).all() for e in away)
    assert all(np.isfinite(e.angles).any() for e in away)
    assert np.nanmax(np.linalg.norm([e.segment_p[0] for e in away], axis=1)) < 2.0
    back = t > 6 + 2 / 30 + 0.06  # two images and their delay
    assert np.isfinite(error[back]).all() and error[t > 7].mean() < 0.010


def shrunk(hand: HandModel, glove: GloveModel, k: float) -> tuple[HandModel, GloveModel]:
    """The same files with every length times ``k``."""
    segments = tuple(
        dataclasses.replace(s, origin=k * s.origin, length=k * s.length, radius=k * s.radius)
        for s in hand.segments
    )
    imus = tuple(dataclasses.replace(i, position=k * i.position) for i in glove.imus)
    markers = tuple(dataclasses.replace(m, position=k * m.position) for m in glove.markers)
    points = tuple(dataclasses.replace(p, position=k * p.position) for p in glove.keypoints)
    return (
        dataclasses.replace(hand, segments=segments, length=k * hand.length),
        dataclasses.replace(glove, imus=imus, markers=markers, keypoints=points),
    )


@pytest.mark.long
@pytest.mark.parametrize("k", [0.9, 1.1])
def test_a_hand_file_of_the_wrong_size(hand: HandModel, glove: GloveModel, k: float) -> None:
    sim = simulation(hand, glove, 4, 10.0)
    pipeline = Pipeline(*shrunk(hand, glove, k), sim.rig)
    estimates = feed(pipeline, sim.feed())
    assert errors(sim, estimates)[times(estimates) > 6].mean() < 0.012
    assert pipeline.calibration().hand_length == pytest.approx(sim_length(sim), rel=0.04)


def sim_length(sim: Simulation) -> float:
    """The wearer's true length along dorsum and middle finger."""
    names, flat = sim.hand.keypoint_names, sim.truth(0.5).keypoints
    chain = [
        names.index(n) for n in ("wrist", "middle_mcp", "middle_pip", "middle_dip", "middle_tip")
    ]
    return float(np.linalg.norm(np.diff(flat[chain], axis=0), axis=1).sum())


@pytest.mark.long
def test_markers_on_the_fingertips_help(
    hand: HandModel, distal_glove: GloveModel, glove: GloveModel
) -> None:
    """A marker on the distal segment measures what would be inferred by the synergy."""
    with_tips = simulation(hand, distal_glove, 0, 12.0)
    without = simulation(hand, glove, 0, 12.0)
    means = []
    for s in (with_tips, without):
        estimates, error = run(s)
        means.append(np.nanmean(error[times(estimates) > 4, :3]))
    assert means[0] < 0.9 * means[1]


@pytest.mark.long
def test_late_images_are_waited_for(sim: Simulation) -> None:
    """An overloaded computer delivers images 200 ms late; the filter must not get ahead of them."""
    late = sorted(
        (
            dataclasses.replace(m, t_arrival=m.t_arrival + 0.2) if isinstance(m, BlobFrame) else m
            for m in sim.feed()
        ),
        key=lambda m: m.t_arrival,
    )
    pipeline = Pipeline(sim.hand, sim.glove, sim.rig)
    estimates = feed(pipeline, late)
    error = errors(sim, estimates)[times(estimates) > 2]
    assert np.isfinite(error).all() and error.mean() < 0.012
