"""Centres of patches in images, against the patches' visible area in simulated images."""

import numpy as np

from tracker.fusion.chain.layout import seen_centres
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation, SimulationParams
from tracker.simulation.wearer import WearerParams

WHOLE, SQUARELY = 0.999, 0.6  # visible share, and facing: patches of which all is seen


def test_whole_patches_appear_at_their_seen_centres(hand: HandModel, glove: GloveModel) -> None:
    """The patches' own centres are 0.8 px away on average. Half of that remains, because the point
    is a mean over directions and patches seen at an angle are partly behind the finger.
    """
    motion = RandomPostures(hand, 5, duration=4.0)
    people = SimulationParams(wearer=WearerParams.none())
    sim = Simulation(hand, glove, motion, 5, people, fps=30)
    segment = glove.marker_segment(hand)
    errors: dict[str, list[Array]] = {"own": [], "seen": []}
    bent = segment != hand.root
    for t in np.arange(0.5, 4.0, 0.1):
        now, pose = sim.scene.instant(t), sim.scene.pose(t)
        seen, truth = sim.scene.markers_seen(now, False), sim.truth(t)
        clear = bent & (seen.whole > WHOLE) & (seen.facing > SQUARELY)
        for name, at in (("own", glove.marker_position), ("seen", seen_centres(glove, hand))):
            p_G = truth.p_GB[segment] + np.einsum("mij,mj->mi", truth.R_GB[segment], at)
            uv = sim.rig.project((p_G - pose.p_GC) @ pose.R_GC)
            errors[name].append(uv[clear] - sim.rig.left.rectify(seen.uv[clear]))
    own, centre = (np.linalg.norm(np.concatenate(errors[k]), axis=1) for k in ("own", "seen"))
    assert len(own) > 100
    assert own.mean() > 0.5, "px: the difference matters"
    assert centre.mean() < 0.6 * own.mean()
