"""Resetting, freezing and storing the chain filter's calibration."""

import numpy as np
import pytest

from tests.fusion.test_chain_engine import errors, feed, simulation
from tests.notices import raises
from tracker.base.errors import ConfigError
from tracker.engine.pipeline import Pipeline
from tracker.fusion.chain.calibration import control
from tracker.fusion.chain.engine import ChainEngine
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import ChainParams
from tracker.fusion.chain.prior import initial_covariance
from tracker.fusion.chain.state import initial_state
from tracker.session.engine_state import pack, unpack

FIELDS = ("scale", "mounting", "gyro_bias", "accel_bias")


@pytest.fixture(scope="module")
def tracked(hand, glove):
    """(simulation, its messages, the state of a pipeline after the first half, messages left)."""
    sim = simulation(hand, glove, 5, 8.0)
    messages = list(sim.feed())
    half = next(i for i, m in enumerate(messages) if m.t > 4.0)
    pipeline = Pipeline(hand, glove, sim.rig)
    feed(pipeline, messages[:half])
    return sim, pipeline.get_state(), messages[half:]


@pytest.fixture
def pipeline(hand, glove, tracked):
    sim, state, _ = tracked
    out = Pipeline(hand, glove, sim.rig)
    out.set_state(state)
    assert isinstance(out.engine, ChainEngine)
    return out


@pytest.mark.long
def test_only_the_named_segment_is_reset(pipeline):
    before = pipeline.calibration()
    row = before.segments.index("index_proximal")
    pipeline.engine.wearer.reset(["index_proximal"])
    after = pipeline.calibration()
    prior = ChainParams().prior
    assert after.scale[row] == pytest.approx(np.ones(3))
    assert after.mounting[row] == pytest.approx(np.zeros(3), abs=1e-9)
    assert after.mounting_sd[row] == pytest.approx(np.full(3, prior.mounting))
    assert after.gyro_bias_sd[row] == pytest.approx(np.full(3, prior.gyro_bias))
    others = np.arange(len(before.segments)) != row
    for name in FIELDS:
        for kind in (name, f"{name}_sd"):
            np.testing.assert_array_equal(
                getattr(after, kind)[others], getattr(before, kind)[others], kind
            )


def test_a_full_reset_gives_the_prior_and_a_valid_covariance(pipeline):
    engine = pipeline.engine
    engine.wearer.reset()
    layout, state = engine.layout, engine.get_state().tracker.filter.state
    n = layout.n_dynamic
    P = initial_covariance(layout, ChainParams().prior)
    np.testing.assert_array_equal(state.P[n:, n:], P[n:, n:])
    assert not state.P[:n, n:].any()
    assert np.linalg.eigvalsh(state.P).min() > -1e-12


def test_tracking_continues_after_a_reset_and_learns_again(hand, glove, tracked, pipeline):
    sim, _, rest = tracked
    learned = pipeline.calibration().scale_sd.mean()
    pipeline.engine.wearer.reset()
    assert pipeline.calibration().scale_sd.mean() > 2 * learned
    error = errors(sim, feed(pipeline, rest))
    assert error.mean() < 0.012
    assert pipeline.calibration().scale_sd.mean() < 2 * learned


def test_while_frozen_the_hand_is_tracked_and_nothing_is_learned(tracked, pipeline):
    sim, _, rest = tracked
    before = pipeline.calibration()
    pipeline.engine.wearer.freeze(True)
    error = errors(sim, feed(pipeline, rest))
    after = pipeline.calibration()
    for name in FIELDS:
        for kind in (name, f"{name}_sd"):
            np.testing.assert_array_equal(getattr(after, kind), getattr(before, kind), kind)
    assert error.mean() < 0.010


def test_after_unfreezing_learning_resumes(tracked, pipeline):
    _, _, rest = tracked
    before = pipeline.calibration()
    pipeline.engine.wearer.freeze(True)
    third = len(rest) // 3
    feed(pipeline, rest[:third])
    pipeline.engine.wearer.freeze(False)
    np.testing.assert_array_equal(pipeline.calibration().scale_sd, before.scale_sd)
    feed(pipeline, rest[third:])
    after = pipeline.calibration()
    assert after.scale_sd.mean() < before.scale_sd.mean()
    assert np.abs(after.scale - before.scale).max() > 0


def test_a_frozen_state_resumes_identically(hand, glove, tracked, pipeline):
    sim, _, rest = tracked
    pipeline.engine.wearer.freeze(True)
    twin = Pipeline(hand, glove, sim.rig)
    twin.set_state(pipeline.get_state())
    part = rest[: len(rest) // 4]
    ours, theirs = feed(pipeline, part), feed(twin, part)
    np.testing.assert_array_equal(ours[-1].keypoints, theirs[-1].keypoints)


def test_a_loaded_profile_is_part_of_the_state(hand, glove, tracked, pipeline):
    """A recording that begins before the hand is found starts with the same profile again."""
    sim, _, rest = tracked
    waiting = Pipeline(hand, glove, sim.rig)
    waiting.engine.apply_profile(pipeline.engine.profile())
    twin = Pipeline(hand, glove, sim.rig)
    engine, state = unpack(pack("chain", waiting.get_state()))
    twin.set_state(state)
    part = rest[: len(rest) // 4]
    ours, theirs = feed(waiting, part), feed(twin, part)
    assert engine == "chain" and np.isfinite(ours[-1].keypoints).all()
    np.testing.assert_array_equal(ours[-1].keypoints, theirs[-1].keypoints)


def test_a_profile_loaded_while_frozen_is_frozen(hand, glove, tracked, pipeline):
    sim, _, rest = tracked
    profile = pipeline.engine.profile()
    other = Pipeline(hand, glove, sim.rig)
    other.engine.wearer.freeze(True)
    other.engine.apply_profile(profile)
    feed(other, rest[: len(rest) // 3])
    np.testing.assert_array_equal(other.engine.profile().scale, profile.scale)
    np.testing.assert_array_equal(other.calibration().scale, pipeline.calibration().scale)


def test_an_earlier_session_fixes_bones_but_not_sensors(pipeline):
    engine = pipeline.engine
    profile = engine.profile()
    renewed = control.renewed(profile, engine.layout)
    engine.apply_profile(renewed)
    shown, params = pipeline.calibration(), control.RenewParams()
    assert np.nanmin(shown.mounting_sd) > params.mounting
    assert np.nanmin(shown.gyro_bias_sd) > params.gyro_bias
    np.testing.assert_array_equal(renewed.scale, profile.scale)
    n, layout = engine.layout.n_dynamic, engine.layout
    bones = slice(layout.blocks.scale - n, layout.blocks.joint - n)
    np.testing.assert_array_equal(renewed.P[bones, bones], profile.P[bones, bones])


def test_every_calibration_row_belongs_to_one_segment(hand, glove):
    layout = ChainLayout(hand, glove)
    each = [control.calibration_rows(layout, [name]) for name in layout.names]
    together = np.sort(np.concatenate(each))
    np.testing.assert_array_equal(together, np.arange(layout.n_dynamic, layout.blocks.size))
    assert control.fits(control.profile_of(initial_state(layout), layout), layout)


def test_an_unknown_segment_is_reported(pipeline):
    with raises(ConfigError, "calibration.no_segment"):
        pipeline.engine.wearer.reset(["tail"])
