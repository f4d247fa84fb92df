"""Standard deviations of inferred points: errors of unmeasured points match their claimed sd."""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tests.fusion.test_late_data import Message, feed, starved
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.fusion.chain.confidence import MEASURED_SD
from tracker.fusion.chain.distal import DistalSegments
from tracker.fusion.chain.driven_ends import EndDeviations
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import SynergyParams
from tracker.fusion.chain.state import initial_state, inject
from tracker.fusion.output.output import HandOutput, Sensed
from tracker.fusion.time.imu_buffer import Moment
from tracker.fusion.vist.layout import VistLayout
from tracker.fusion.vist.params import VistNoise
from tracker.fusion.vist.propagate import propagate
from tracker.fusion.vist.state import blank_state
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.hand.names import FINGERS
from tracker.messages import Array, BlobFrame, Estimate, ImuSample, Tracking, Validity
from tracker.session.reader import SessionReader
from tracker.simulation.postures import posture
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation
from tracker.simulation.wearer import Wearer

Spans = list[tuple[float, float]]
FOLLOW = ("ring", "little")  # have no sensors


def bursts(sim: Simulation, seed: int) -> list[Message]:
    """Images are dropped for 0.2 to 1.6 s at a time and half of the others arrive up to 0.4 s late;
    packets are delayed by 0.1 to 1 s at a time and then arrive together."""
    rng = np.random.default_rng(1000 + seed)
    dropped = _spans(rng, sim.duration, (0.2, 1.6), (0.4, 1.5))
    withheld = _spans(rng, sim.duration, (0.1, 1.0), (0.8, 3.0))
    out: list[Message] = []
    newest = 0.0  # images keep their order
    for message in sim.feed():
        if isinstance(message, ImuSample):
            end = next((b for a, b in withheld if a < message.t < b), message.t_arrival)
            out.append(replace(message, t_arrival=max(message.t_arrival, end)))
        elif isinstance(message, BlobFrame) and not any(a < message.t < b for a, b in dropped):
            late = rng.uniform(0.0, 0.4) if rng.random() < 0.5 else 0.0
            newest = max(newest, message.t_arrival + late)
            out.append(replace(message, t_arrival=newest))
    return sorted(out, key=lambda m: m.t_arrival)


def _spans(
    rng: np.random.Generator,
    duration: float,
    lasting: tuple[float, float],
    between: tuple[float, float],
) -> Spans:
    out: Spans = []
    t = 1.5
    while t < duration:
        t += rng.uniform(*between)
        end = t + rng.uniform(*lasting)
        out.append((t, end))
        t = end
    return out


def within_3_sd(estimates: list[Estimate], truth: list[Array]) -> float:
    """Share of all inferred points whose distance from the truth is at most three standard
    deviations of a coordinate. A Gaussian error in space has 97.1 %."""
    held = []
    for e, true in zip(estimates, truth, strict=True):
        error = np.linalg.norm(e.keypoints - true, axis=1)
        shown = (e.keypoint_state == int(Validity.INFERRED)) & np.isfinite(error)
        held.append(error[shown] <= 3 * e.keypoint_sd[shown])
    together = np.concatenate(held)
    assert len(together) > 4000
    return float(together.mean())


@pytest.mark.long
@pytest.mark.parametrize("engine", ["chain", "vist"])
@pytest.mark.parametrize(("make", "seed"), [(starved, 26), (bursts, 11), (bursts, 22)])
def test_inferred_points_are_within_3_sd_under_overload(
    hand: HandModel, glove: GloveModel, engine: str, make, seed: int
) -> None:
    sim = Simulation(hand, glove, RandomPostures(hand, seed, duration=12.0), seed, fps=30)
    estimates = feed(Pipeline(hand, glove, sim.rig, Settings(engine=engine)), make(sim, seed))
    truth = [x.keypoints for x in sim.truths(np.array([e.t for e in estimates]))]
    # 97.1 % of normal errors, of four postures: in one of seed 11, ring and little finger deviate
    # from their neighbour by three standard deviations
    assert within_3_sd(estimates, truth) >= 0.95


@pytest.mark.long
@pytest.mark.data
@pytest.mark.parametrize("engine", ["chain", "vist", "switching"])
def test_inferred_points_of_an_overloaded_recording(data_folder: Path, engine: str) -> None:
    """For 3 s the wearer points with two fingers: ring and little finger do not follow."""
    path = data_folder / "overload" / "session.mcap"
    if not path.exists():
        pytest.skip(f"there is no {os.fspath(path)}")
    with SessionReader(path) as reader:
        info, rig = reader.info, reader.rig()
        messages = [m for m in reader.messages() if isinstance(m, ImuSample | BlobFrame)]
        truth = {e.t: e.keypoints for e in reader.truth()}
    pipeline = Pipeline(info.hand, info.glove, rig, Settings(engine=engine))
    known = [e for e in feed(pipeline, messages) if e.t in truth]
    assert within_3_sd(known, [truth[e.t] for e in known]) >= 0.97


def test_fingers_beside_straight_ones_may_be_closed(hand: HandModel, glove: GloveModel) -> None:
    """Two fingers point. The opposite, straight fingers beside a closed one, is not covered: their
    extensor tendons are connected."""
    bends = {f"{f}_{j}_flexion": v for f in FOLLOW for j, v in (("mcp", 80), ("pip", 90))}
    e, error = shown(hand, glove, bends)
    names = glove.keypoint_names(hand)
    for tip in ("ring_tip", "little_tip"):
        k = names.index(tip)
        assert 0.06 < error[k] < 3 * e.keypoint_sd[k] < 0.2
    assert e.keypoint_sd[names.index("index_dip")] == pytest.approx(1e-3)
    together = {f"{f}_{j}_flexion": v for f in FINGERS for j, v in (("mcp", 80), ("pip", 90))}
    fist = shown(hand, glove, together)[0]
    assert fist.keypoint_sd[names.index("ring_tip")] < 0.016


def test_half_bent_fingers_are_less_certain_than_closed_ones(
    hand: HandModel, glove: GloveModel
) -> None:
    """Beside a half bent, and beside a closed middle finger, 95 to 99 % of the joints of ring and
    little finger of 60 people are within 3 sd, whose errors are mainly along one line. (97 ± 1 %,
    from 10 postures of each person, of which a third and a fifth are of the two kinds.)"""
    layout = ChainLayout(hand, glove)
    output, active = HandOutput(layout), layout.active
    sensed = Sensed(np.ones(len(active), np.int64), Tracking.TRACKING)
    names = glove.keypoint_names(hand)
    rows = [names.index(f"{f}_{k}") for f in FOLLOW for k in ("pip", "dip", "tip")]
    bent = [hand.angle_index[f"middle_{k}_flexion"] for k in ("mcp", "pip")]
    within: dict[str, list[Array]] = {"half": [], "closed": []}
    for seed in range(60):
        wearer, motion = Wearer.random(hand, glove, seed), RandomPostures(hand, seed, duration=32.0)
        hands = wearer.truth(motion, np.arange(3.0, 32.0, 3.0))
        for angles, R, p in zip(*hands, strict=True):
            degrees = float(np.rad2deg(angles[bent].sum()))
            kind = "half" if 60 < degrees < 125 else "closed" if degrees > 145 else None
            if kind is None:
                continue
            sd = np.full(len(active), 1e-3)
            e = output.estimate(0.0, R[active], p[active], wearer.scale[active], sensed, sd)
            error = np.linalg.norm(e.keypoints - wearer.keypoints(R, p), axis=1)
            within[kind].append(error[rows] <= 3 * e.keypoint_sd[rows])
    for kind, found in within.items():
        assert len(found) > 80
        assert 0.95 <= np.mean(found) <= 0.99, (kind, np.mean(found))


def shown(hand: HandModel, glove: GloveModel, bends: dict[str, float]) -> tuple[Estimate, Array]:
    """The output for a posture (degrees) whose sensed segments are known to 1 mm, and its
    errors."""
    straight = {f"{f}_{j}_flexion": 0.0 for f in FOLLOW for j in ("mcp", "pip")}
    layout = ChainLayout(hand, glove)
    true_R, true_p = hand.forward(posture(hand, straight | bends), np.eye(3), np.zeros(3))
    e = HandOutput(layout).estimate(
        0.0,
        true_R[layout.active],
        true_p[layout.active],
        initial_state(layout).scale3(),
        Sensed(np.ones(len(layout.active), np.int64), Tracking.TRACKING),
        np.full(len(layout.active), 1e-3),
    )
    true = glove.keypoint_positions(hand, true_R, true_p)
    return e, np.linalg.norm(e.keypoints - true, axis=1)


def test_points_of_the_palm_have_their_own_covariance(hand: HandModel, glove: GloveModel) -> None:
    """The sd of wrist, dorsum and knuckles is the spread of those points over states that are drawn
    from P, to 2.5 % (4000 draws of three coordinates: 0.65 % each), whatever correlations P has."""
    layout, rng = ChainLayout(hand, glove), np.random.default_rng(5)
    ends = EndDeviations(layout, DistalSegments(layout, SynergyParams()))
    state = initial_state(layout)
    state.joint[:] = rng.normal(0, 2e-3, state.joint.shape)
    root = rng.normal(0, 1e-3, (layout.blocks.size, layout.blocks.size + 9)) / 10
    state.P[:] = root @ root.T
    draws = rng.normal(0, 1, (4000, root.shape[1])) @ root.T
    k = len(ends.palm.keypoint)
    points = np.empty((len(draws), k, 3))
    for i, dx in enumerate(draws):
        moved = state.copy()
        inject(moved, layout, dx)
        points[i] = ends.positions(moved)[-k:]
    spread = np.sqrt(points.var(axis=0).mean(axis=1))
    assert {"wrist", "index_mcp", "ring_mcp", "dorsum"} < {
        glove.keypoint_names(hand)[row] for row in ends.palm.keypoint
    }
    np.testing.assert_allclose(ends(state)[-k:], spread, rtol=0.025)


def test_a_hand_that_moved_without_packets_is_doubted_until_it_is_seen(
    hand: HandModel, glove: GloveModel
) -> None:
    """Packets are lost for 0.3 s and images for 0.7 s: then only IMUs determine the position."""
    sim = Simulation(hand, glove, RandomPostures(hand, 4, duration=4.5), 4, fps=30)
    pipeline, shown = Pipeline(hand, glove, sim.rig), []
    for m in sim.feed():
        if isinstance(m, ImuSample) and not 3.0 < m.t < 3.3:
            shown.append(pipeline.feed_imu(m))
        elif isinstance(m, BlobFrame) and not 3.0 < m.t < 3.7:
            pipeline.feed_frame(m)
    before = [e for e in shown if 2.5 < e.t <= 3.0]
    blind = [e for e in shown if 3.3 < e.t < 3.7]
    again = [e for e in shown if e.t > 4.1]
    body = [glove.keypoint_names(hand).index(k) for k in ("wrist", "dorsum", "index_mcp")]
    assert max(e.keypoint_sd[body].max() for e in before) < MEASURED_SD / 2
    assert min(e.keypoint_sd[body].min() for e in blind if e.t > 3.6) > 0.3
    assert not any(np.any(e.keypoint_state == int(Validity.MEASURED)) for e in blind)
    assert max(e.keypoint_sd[body].max() for e in again) < MEASURED_SD / 2


def test_the_effect_of_damping_is_known(hand: HandModel, glove: GloveModel) -> None:
    """`vist`: the undamped trajectory is the damped one plus ``held_back``."""
    layout, rng = VistLayout(hand, glove), np.random.default_rng(3)
    n = len(glove.imus)
    damped, free = blank_state(layout), blank_state(layout)
    for state in (damped, free):
        state.v_GI = np.tile([0.4, -0.2, 0.1], (layout.n, 1))
    for _ in range(50):
        accel = rng.normal([0, 0, 9.8], 0.5, (n, 3))
        sample = Moment(0.0, accel, np.zeros((n, 3)), np.ones(n, bool))
        for state, coasting in ((damped, True), (free, False)):
            propagate(state, layout, VistNoise(), sample, 0.01, coasting, covariance=False)
    p_back, v_back = damped.held_back
    assert np.allclose(damped.p_GI[0] + p_back, free.p_GI[0], atol=1e-12)
    assert np.allclose(damped.v_GI[0] + v_back, free.v_GI[0], atol=1e-12)
    assert np.linalg.norm(p_back) > 0.05
    assert not free.held_back.any()
