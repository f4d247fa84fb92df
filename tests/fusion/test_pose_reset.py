"""A pose reset aligns a hand that has drifted with the pose held by the wearer."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tracker.base.config import to_toml
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.fusion.chain.engine import ChainEngine
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.pose_reset import bends, flat_rows, heading, reset_event
from tracker.fusion.chain.state import ChainState, initial_state, inject
from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array, Estimate, Event, ImuSample
from tracker.offline.options import TrackOptions
from tracker.offline.simulate import SimulateOptions, build
from tracker.offline.track import track
from tracker.session.compare import compare
from tracker.session.reader import SessionReader
from tracker.session.writer import SessionRecorder
from tracker.simulation.guided import HeldHand, HoldParams
from tracker.simulation.posture_requests import PostureRequest, RequestedMotion
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation
from tracker.simulation.smooth import rng_for

INERTIAL = Settings(engine="inertial")
DRIFTS, HELD, RESET = (4.0, 14.0), 15.0, 18.0
"""s: the heading drifts in an interval, the hand is held flat from a given time on, and reset."""
RATE = np.deg2rad(4.0)  # rad/s of the drift


def held_flat(hand: HandModel, glove: GloveModel, seed: int) -> Simulation:
    """A wearer who moves freely, holds the hand flat around `RESET`, and moves on."""
    motion = RequestedMotion(RandomPostures(hand, seed, duration=23.0), seed)
    sim = Simulation(hand, glove, motion, seed)
    held = HeldHand(sim.wearer, HoldParams(), rng_for(3, "flat"))
    motion.ask(PostureRequest(HELD, tuple(held.angles("flat", HELD).tolist())))
    motion.ask(PostureRequest(RESET + 1.0))
    return sim


@pytest.fixture(scope="module")
def wearer(hand: HandModel, glove: GloveModel) -> Simulation:
    return held_flat(hand, glove, seed=3)


@pytest.fixture(scope="module")
def drifting(wearer: Simulation) -> list[ImuSample]:
    """Packets of a glove whose gyroscopes drift about the vertical for some time."""
    everything = np.ones(len(wearer.glove.imus))
    return [_drifting(sample, wearer, everything) for sample in wearer.imu_samples()]


def _drifting(sample: ImuSample, sim: Simulation, share: Array) -> ImuSample:
    """With ``share`` (n,) of the drift on each IMU."""
    if not DRIFTS[0] < sample.t < DRIFTS[1]:
        return sample
    R_GB = sim.truth(sample.t).R_GB
    rows = [sim.hand.index[imu.segment] for imu in sim.glove.imus]
    up = [i.R_BI.T @ R_GB[r][2] for i, r in zip(sim.glove.imus, rows, strict=True)]
    return replace(sample, gyro=sample.gyro + RATE * share[:, None] * np.array(up))


def _off(e: Estimate, sim: Simulation) -> float:
    """rad between the estimated and the true heading."""
    shown, true = heading(e.segment_R[0]), heading(sim.truth(e.t).R_GB[0])
    assert shown is not None and true is not None
    return float(np.angle(np.exp(1j * (shown - true))))


def _run(pipeline: Pipeline, samples: list[ImuSample], reset: bool) -> dict[float, Estimate]:
    """Estimates by instant, to 0.01 s."""
    out, waits = {}, reset
    for sample in samples:
        if waits and sample.t >= RESET:
            waits = False
            pipeline.feed_event(reset_event(sample.t_arrival))
        out[round(sample.t, 2)] = pipeline.feed_imu(sample)
    return out


@pytest.mark.long
def test_a_drifted_heading_is_reset_to_straight_ahead(
    wearer: Simulation, drifting: list[ImuSample]
) -> None:
    pipeline = Pipeline(wearer.hand, wearer.glove, None, INERTIAL)
    found = _run(pipeline, drifting, reset=True)
    ahead = heading(wearer.truth(RESET).R_GB[0])
    assert ahead is not None and abs(ahead) < np.deg2rad(5.0)  # the wearer does point ahead
    before, after = (min(found, key=lambda t: abs(t - at)) for at in (RESET - 0.1, RESET + 0.3))
    assert abs(_off(found[before], wearer)) > np.deg2rad(25.0)
    assert abs(_off(found[after], wearer)) < np.deg2rad(6.0)
    later = [_off(e, wearer) for t, e in found.items() if RESET + 2.0 < t < RESET + 4.5]
    assert np.abs(later).max() < np.deg2rad(12.0), "it goes on from there"
    (reported,) = pipeline.drain_notices()
    assert (reported.code, reported.values["side"]) == ("pose_reset.done_heading", "right")


@pytest.mark.long
def test_tilt_and_the_size_of_the_hand_are_unchanged(
    wearer: Simulation, drifting: list[ImuSample]
) -> None:
    samples = [s for s in drifting if s.t < RESET + 0.2]
    runs = [Pipeline(wearer.hand, wearer.glove, None, INERTIAL) for _ in range(2)]
    plain, reset = (
        list(_run(p, samples, r).values())[-1] for p, r in zip(runs, (0, 1), strict=True)
    )
    up, up_reset = plain.segment_R[0][2], reset.segment_R[0][2]
    assert np.arccos(up @ up_reset) < np.deg2rad(3.0)
    scales = [run.calibration().scale for run in runs]
    np.testing.assert_allclose(scales[0], scales[1], atol=0.005)


@pytest.fixture
def layout(hand: HandModel, glove: GloveModel) -> ChainLayout:
    return ChainLayout(hand, glove)


def _turned(layout: ChainLayout, size: float) -> ChainState:
    rng = np.random.default_rng(1)
    state = initial_state(layout)
    state.R_GB = np.array(
        [
            R @ so3.exp(size * v)
            for R, v in zip(state.R_GB, rng.normal(size=(len(state.R_GB), 3)), strict=True)
        ]
    )
    return state


def test_rows_are_the_derivative_of_the_bends(layout: ChainLayout) -> None:
    state = _turned(layout, 0.3)
    H, r, _ = flat_rows(state, layout)
    children = [c for c, a in enumerate(layout.parent) if a >= 0 and layout.imu_of[c] >= 0]
    assert np.array_equal(r, -bends(state, layout)[children].ravel())
    columns = np.arange(layout.blocks.theta, layout.n_dynamic)

    def moved(column: int, by: float) -> Array:
        other, dx = state.copy(), np.zeros(layout.blocks.size)
        dx[column] = by
        inject(other, layout, dx)
        return bends(other, layout)[children].ravel()

    numeric = [(moved(c, 1e-6) - moved(c, -1e-6)) / 2e-6 for c in columns]
    np.testing.assert_allclose(H[:, columns], np.array(numeric).T, atol=1e-6)
    assert not np.delete(H, columns, axis=1).any()


@pytest.mark.long
def test_a_drifted_finger_is_straightened(hand: HandModel, glove: GloveModel) -> None:
    sim = held_flat(hand, glove, seed=4)
    index = np.array([imu.segment.startswith("index") for imu in glove.imus])
    samples = [_drifting(s, sim, 2.5 * index) for s in sim.imu_samples() if s.t < RESET]
    pipeline = Pipeline(hand, glove, None, INERTIAL)
    for sample in samples:
        pipeline.feed_imu(sample)
    before = _bent(pipeline)
    pipeline.feed_event(reset_event(RESET))
    # the oblique axes of a thumb, 5° about each axis, remain
    assert before > np.deg2rad(20.0) and _bent(pipeline) < np.deg2rad(9.0)
    again = pipeline.feed_imu(replace(samples[-1], t=RESET, t_arrival=RESET))
    root, finger = (hand.index[name] for name in ("dorsum", "index_proximal"))
    apart = so3.log(again.segment_R[root].T @ again.segment_R[finger])
    assert np.linalg.norm(apart) < np.deg2rad(7.0), "what is shown follows at once"


def _bent(pipeline: Pipeline) -> float:
    """rad, maximum deviation of a joint of the filter's state from straight."""
    engine = pipeline.engine
    assert isinstance(engine, ChainEngine)
    state = engine.get_state().tracker.filter.state
    return float(np.linalg.norm(bends(state, engine.layout), axis=1).max())


def test_a_bent_or_vertical_hand_is_rejected(
    wearer: Simulation, hand: HandModel, glove: GloveModel
) -> None:
    pipeline = Pipeline(hand, glove, None, INERTIAL)
    pipeline.feed_event(reset_event(0.0))
    assert pipeline.drain_notices()[-1].code == "pose_reset.searching"
    for sample in [s for s in wearer.imu_samples() if s.t < 1.0]:
        pipeline.feed_imu(sample)
    for turn, code in (
        (so3.ry(np.deg2rad(-80.0)), "pose_reset.steep"),
        (None, "pose_reset.bent"),
    ):
        state = pipeline.get_state()
        R_GB = state.engine.tracker.filter.state.R_GB
        if turn is None:
            finger = pipeline.engine.layout.names.index("index_proximal")  # type: ignore[attr-defined]
            R_GB[finger] = R_GB[0] @ so3.ry(np.deg2rad(85.0))
        else:
            R_GB[:] = turn @ R_GB
        other = Pipeline(hand, glove, None, INERTIAL)
        other.set_state(state)
        other.feed_event(reset_event(1.0))
        assert other.drain_notices()[-1].code == code
        stored = other.get_state().engine.tracker.filter.state
        assert np.array_equal(stored.R_GB, R_GB), "nothing is changed"


def test_an_engine_without_it_reports_it(wearer: Simulation) -> None:
    pipeline = Pipeline(wearer.hand, wearer.glove, wearer.rig, Settings(engine="vist"))
    pipeline.feed_event(reset_event(0.0))
    (reported,) = pipeline.drain_notices()
    assert (reported.code, reported.values["engine"]) == ("pose_reset.not_supported", "vist")


@pytest.mark.long
def test_a_recorded_reset_is_tracked_again_bit_for_bit(
    wearer: Simulation, drifting: list[ImuSample], tmp_path: Path
) -> None:
    path, again, once_more = (tmp_path / f"{n}.mcap" for n in ("glove", "again", "once_more"))
    _, info = build(SimulateOptions(seed=3, duration=1.0, fps=30, images=False))
    info = replace(info, rig=None, engine="inertial", settings_text=to_toml(INERTIAL))
    pipeline, waits = Pipeline(wearer.hand, wearer.glove, None, INERTIAL), True
    with SessionRecorder(path, info) as recorder:
        for sample in drifting:
            if waits and sample.t >= RESET:
                waits, event = False, reset_event(sample.t_arrival - 1e-6)
                pipeline.feed_event(event)
                recorder.write(event)
            recorder.write(sample)
            recorder.write(pipeline.feed_imu(sample))
    track(path, again, TrackOptions(with_sensors=True))
    assert compare(path, again)["identical"]
    track(again, once_more)  # the output of tracking contains the reset as well
    assert compare(path, once_more)["identical"]
    with SessionReader(again) as reader:
        kinds = [m.kind for m in reader.messages((Event,)) if isinstance(m, Event)]
    assert kinds.count("pose_reset") == 1
