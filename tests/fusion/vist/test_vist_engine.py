"""The engine as a whole on simulated people."""

import numpy as np
import pytest

from tests.fixtures import RESOURCES
from tests.notices import raises
from tracker.base.errors import ConfigError
from tracker.fusion.vist.engine import VistEngine
from tracker.fusion.vist.params import VistParams
from tracker.glove.files import load_glove
from tracker.glove.model import GloveModel
from tracker.messages import ImuSample, Tracking
from tracker.simulation.random_postures import RandomPostures, leaving
from tracker.simulation.scenario import Simulation

KEYPOINTS = ("thumb_tip", "index_tip", "middle_tip", "dorsum")


def simulate(hand, glove, motion, seed=1) -> tuple[Simulation, list]:
    simulation = Simulation(hand, glove, motion, seed=seed, fps=30)
    return simulation, list(simulation.feed())


def run(engine, messages):
    """(estimates, results) of all messages."""
    estimates, results = [], []
    for m in messages:
        if isinstance(m, ImuSample):
            estimates.append(engine.feed_imu(m))
        else:
            engine.feed_frame(m)
        results += engine.take_results()
    return estimates, results


def errors_mm(simulation, estimates, hand, glove):
    names = glove.keypoint_names(hand)
    columns = [names.index(k) for k in KEYPOINTS]
    truth = np.array([x.keypoints for x in simulation.truths(np.array([e.t for e in estimates]))])
    given = np.array([e.keypoints for e in estimates])
    return 1000 * np.linalg.norm(given - truth, axis=2)[:, columns]


@pytest.fixture(scope="module")
def session(hand, glove):
    return simulate(hand, glove, RandomPostures(hand, seed=1, duration=12.0))


@pytest.fixture(scope="module")
def tracked(session, hand, glove):
    simulation, messages = session
    return run(VistEngine(hand, glove, simulation.rig, VistParams()), messages)


def test_it_finds_and_tracks_a_stranger(session, tracked, hand, glove):
    simulation, _ = session
    estimates, _ = tracked
    late = [e for e in estimates if e.t > 3.0]
    error = errors_mm(simulation, late, hand, glove)
    assert np.isfinite(error).all()
    assert error.mean() < 8.0
    assert (error.max(axis=1) < 35).mean() > 0.98


def test_the_claimed_uncertainty_matches_the_errors(session, tracked, hand, glove):
    """Squared errors over variances: within a factor of ten of the filter's variances."""
    simulation, _ = session
    late = [e for e in tracked[0] if e.t > 3.0]
    names = glove.keypoint_names(hand)
    columns = [names.index(k) for k in KEYPOINTS]
    sd_mm = 1000 * np.array([e.keypoint_sd for e in late])[:, columns]
    nees = np.mean(errors_mm(simulation, late, hand, glove) ** 2 / (3 * sd_mm**2))
    assert 0.2 < nees < 3.0


def test_matches_are_the_markers_that_were_seen(session, tracked):
    simulation, messages = session
    frames = {m.t: m for m in messages if not isinstance(m, ImuSample)}
    good = total = 0
    for result in tracked[1][::7]:
        now = simulation.scene.instant(result.t)
        true_uv = simulation.scene.markers_seen(now, False).uv
        marker = np.flatnonzero(result.match_left >= 0)
        blob = frames[result.t].left.uv[result.match_left[marker]]
        good += int(np.sum(np.linalg.norm(blob - true_uv[marker], axis=1) < 3.0))
        total += len(marker)
    assert total > 100
    assert good >= 0.99 * total


def test_it_continues_identically_from_a_saved_state(session, tracked, hand, glove):
    simulation, messages = session
    half = len(messages) // 2
    first = VistEngine(hand, glove, simulation.rig, VistParams())
    run(first, messages[:half])
    second = VistEngine(hand, glove, simulation.rig, VistParams())
    second.set_state(first.get_state())
    estimates, _ = run(second, messages[half : half + 60])
    whole = {e.t: e for e in tracked[0]}
    for e in estimates:
        np.testing.assert_array_equal(e.keypoints, whole[e.t].keypoints)
        np.testing.assert_array_equal(e.keypoint_sd, whole[e.t].keypoint_sd)


def test_prediction_moves_nothing(session, hand, glove):
    simulation, messages = session
    a = VistEngine(hand, glove, simulation.rig, VistParams())
    b = VistEngine(hand, glove, simulation.rig, VistParams())
    for m in messages[:200]:
        for engine in (a, b):
            engine.feed_imu(m) if isinstance(m, ImuSample) else engine.feed_frame(m)
        a.predict(m.t_arrival + 0.03)
        a.predicted_markers(m.t_arrival + 0.03)
    t = messages[200].t
    np.testing.assert_array_equal(a.predict(t).keypoints, b.predict(t).keypoints)


def test_a_late_image_changes_nothing_but_its_time_of_use(session, hand, glove):
    """The filter after two images is the same whether the first came early or late."""
    simulation, messages = session
    imu = [m for m in messages if isinstance(m, ImuSample)][:140]
    frames = [m for m in messages if not isinstance(m, ImuSample)]
    until = imu[-1].t - 0.06
    frames = [f for f in frames if f.t < until]
    orders = []
    for delay in (0.0, 0.05):  # the start, which looks at all packets there are, is the same

        def arrival(m, delay=delay):
            if isinstance(m, ImuSample):
                return m.t
            return max(m.t + delay, 0.551) if m.t > 0.5 else m.t + 0.05  # never overtaking

        orders.append(sorted([*imu, *frames], key=arrival))
    keypoints = []
    for order in orders:
        engine = VistEngine(hand, glove, simulation.rig, VistParams())
        run(engine, order)
        keypoints.append(engine.predict(imu[-1].t).keypoints)
    np.testing.assert_allclose(keypoints[0], keypoints[1], rtol=0, atol=1e-9)


@pytest.mark.long
def test_a_hand_out_of_view_is_lost_and_found_again(hand, glove):
    motion = leaving(RandomPostures(hand, seed=2, duration=13.0), ((5.0, 10.0),))
    simulation, messages = simulate(hand, glove, motion, seed=2)
    engine = VistEngine(hand, glove, simulation.rig, VistParams())
    estimates, _ = run(engine, messages)
    away = [e for e in estimates if 6.5 < e.t < 9.5]
    assert all(e.tracking in (Tracking.COASTING, Tracking.LOST) for e in away)
    reach = [np.linalg.norm(e.segment_p[0] - simulation.rig.pose.p_GC) for e in away]
    assert max(reach) < 2.5
    back = [e for e in estimates if e.t > 11.5]
    assert all(e.tracking == Tracking.TRACKING for e in back)
    assert errors_mm(simulation, back, hand, glove).mean() < 12


@pytest.mark.long
@pytest.mark.parametrize("name", ["five-finger", "vist-small-distal"])
def test_other_gloves_need_no_other_code(hand, name):
    glove = load_glove(RESOURCES / "gloves" / f"{name}.toml", hand)
    simulation, messages = simulate(hand, glove, RandomPostures(hand, seed=3, duration=4.0))
    engine = VistEngine(hand, glove, simulation.rig, VistParams())
    estimates, results = run(engine, messages)
    assert len(engine.calibration().segments) == len(glove.imus)
    assert results[-1].visible.shape == (len(glove.markers),)
    late = [e for e in estimates if e.t > 1.0]
    assert errors_mm(simulation, late, hand, glove).mean() < 15


def test_a_gap_in_a_finger_is_refused(hand, glove):
    imus = tuple(i for i in glove.imus if i.segment != "index_proximal")
    broken = GloveModel(
        glove.name, glove.side, glove.hand_name, imus, glove.markers, glove.keypoints
    )
    simulation = Simulation(hand, glove, RandomPostures(hand, seed=0, duration=2.0), seed=0)
    with raises(ConfigError, "engine.vist_gaps"):
        VistEngine(hand, broken, simulation.rig, VistParams())
