"""A chain engine learns from guided poses that are held, and ignores those that are not."""

from collections.abc import Iterable
from dataclasses import replace

import numpy as np
import pytest

from tracker.base.records import RECORDS
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.fusion.chain.distal import Synergies
from tracker.fusion.chain.guided.holds import HeldSample, Hold, chosen
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import BlobFrame, Event, ImuSample
from tracker.session.engine_state import pack, unpack
from tracker.simulation.guided import GuidedPoses, with_events
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation, SimulationParams
from tracker.simulation.wearer import THUMB, Wearer, WearerParams

pytestmark = pytest.mark.long

BENT = np.deg2rad(18.0)  # bend of this wearer's thumb beyond that of most people


class BentThumb(Wearer):
    """A wearer whose thumb's end joint is bent more than usual, with the slope of people, otherwise
    as in the files."""

    def __init__(self, hand: HandModel, glove: GloveModel) -> None:
        super().__init__(hand, glove, 0, WearerParams.none())
        self.end_joints.offset[0], self.end_joints.ratio[0] = BENT, THUMB.ratio_mean


@pytest.fixture(scope="module")
def scene(hand: HandModel, glove: GloveModel):
    """A simulation of guided poses by that wearer, and its messages and events."""
    wearer = BentThumb(hand, glove)
    motion = GuidedPoses(wearer, RandomPostures(hand, 3, duration=2.0), 3)
    sim = Simulation(hand, glove, motion, 3, SimulationParams(wearer=wearer.params), fps=20.0)
    sim.wearer = sim.imus._wearer = sim.scene.wearer = wearer
    return sim, list(sim.messages()), motion.events


def run(scene, events: Iterable[Event]) -> Pipeline:
    sim, messages, _ = scene
    pipeline = Pipeline(sim.hand, sim.glove, sim.rig, Settings())
    feed(pipeline, with_events(iter(messages), events))
    return pipeline


def feed(pipeline: Pipeline, messages) -> None:
    for m in messages:
        if isinstance(m, Event):
            pipeline.feed_event(m)
        elif isinstance(m, ImuSample):
            pipeline.feed_imu(m)
        elif isinstance(m, BlobFrame):
            pipeline.feed_frame(m)


def thumb_offset(pipeline: Pipeline) -> float:
    """Of the learned synergy, rad beyond that of an unknown wearer."""
    gains, _ = pipeline.engine.wearer.synergies
    k = next(k for k, s in enumerate(pipeline.hand.synergies) if s.angle == "thumb_ip_flexion")
    prior = pipeline.get_state().engine.tracker.guided.prior
    return float(gains[k, 1] - prior.value[0, 1])


@pytest.fixture(scope="module")
def learned(scene) -> Pipeline:
    return run(scene, scene[2])


def test_touching_pads_determine_the_bend_of_the_thumb(learned):
    """A small part of it: the end joint also bends independently (15°), which one pinch does not
    separate, and pads are known to 10 mm, the bend moves them by 6 mm."""
    assert 0.03 * BENT < thumb_offset(learned) < BENT


def test_nothing_is_learned_without_pose_events(scene):
    assert thumb_offset(run(scene, [])) == 0.0


def test_nothing_is_learned_from_a_skipped_pose(scene):
    skipped = [replace(e, data=e.data | {"held": False}) for e in scene[2]]
    assert thumb_offset(run(scene, skipped)) == 0.0


def test_a_different_pose_is_rejected(scene):
    """Flat hands, announced as pinches and fists."""
    wrong = [
        replace(
            e, data=e.data | {"pose": {"flat": "pinch_index", "spread": "fist"}[e.data["pose"]]}
        )
        for e in scene[2]
        if e.data["pose"] in ("flat", "spread")
    ]
    pipeline = run(scene, wrong)
    assert pipeline.get_state().engine.tracker.guided.accepted == []
    assert thumb_offset(pipeline) == 0.0


def test_learned_poses_are_saved_and_resumed(scene, learned):
    state = unpack(pack("chain", learned.get_state()))[1]
    again = Pipeline(learned.hand, learned.glove, learned.rig, Settings())
    again.set_state(state)
    now, before = again.engine.wearer, learned.engine.wearer
    np.testing.assert_array_equal(now.synergies[0], before.synergies[0])
    t = learned.engine.newest + 0.01
    np.testing.assert_array_equal(again.predict(t).keypoints, learned.predict(t).keypoints)
    assert "chain.guided" in RECORDS


def test_a_state_without_synergies_continues_with_the_hand_files_line(scene):
    """Older recordings were started with it; a new state is independent of a changed prior."""
    sim, _, _ = scene
    hand, fresh = sim.hand, Pipeline(sim.hand, sim.glove, sim.rig, Settings())
    state = fresh.get_state()
    prior = state.engine.tracker.guided.prior
    np.testing.assert_array_equal(prior.value[:, 0], [0.0, 0.40, 0.40])
    prior.value[:, 0] = 0.1
    fresh.set_state(state)
    assert set(fresh.engine.wearer.synergies[0][:3, 0]) == {0.1}
    state.engine.tracker.guided.prior = Synergies.none()
    fresh.set_state(state)
    gains, _ = fresh.engine.wearer.synergies
    np.testing.assert_array_equal(gains, [(s.ratio, s.offset) for s in hand.synergies])


def test_unknown_poses_are_reported_and_ignored(scene):
    pipeline = Pipeline(scene[0].hand, scene[0].glove, scene[0].rig, Settings())
    pipeline.feed_event(Event(1.0, "guided", "", {"pose": "salute", "phase": "begin"}))
    (unknown,) = pipeline.drain_notices()
    assert (unknown.code, unknown.values["pose"]) == ("guided.unknown", "salute")
    pipeline.feed_event(Event(1.0, "note", "fine"))
    assert pipeline.drain_notices() == []


def test_an_engine_that_does_not_learn_reports_it(scene):
    settings = replace(Settings(), engine="vist")
    pipeline = Pipeline(scene[0].hand, scene[0].glove, scene[0].rig, settings)
    for event in scene[2]:
        pipeline.feed_event(event)
    (reported,) = pipeline.drain_notices()
    assert (reported.code, reported.values["engine"]) == ("guided.not_learned", "vist")


def test_samples_during_transitions_are_ignored():
    def sample(t: float, bend: float) -> HeldSample:
        return HeldSample(t, np.full((6, 3), bend), [])

    hold = Hold("fist", 10.0, 12.0, True)
    assert not hold.may_count(10.3)
    assert not hold.may_count(11.9)
    late = [sample(10.5 + 0.2 * k, 0.5 if k < 2 else 0.0) for k in range(7)]
    best = chosen(hold, late, moving=0.12)
    assert best is not None and best.posture.max() == 0.0
    restless = [sample(10.5 + 0.2 * k, 0.3 * k) for k in range(7)]
    assert chosen(hold, restless, moving=0.12) is None
