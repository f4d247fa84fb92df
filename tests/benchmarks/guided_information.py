"""What each guided pose teaches about the end joints: its bound, and what the engine learns.

    python -m tests.benchmarks.guided_information --people 4

For each end joint, the standard deviation of its flexion where the joint before is bent as people
agree on (`EndJointParams.middle_deg`), before and after each pose alone, by the information matrix
H_o^T (H P_cc H^T + R)^-1 H_o of the pose's rows (docs/chain.md, eqs. 53 and 54), and the error of
the wearer's line there before and after all poses.
"""

from __future__ import annotations

import argparse
from typing import NamedTuple

import numpy as np

from extensions.evaluation.vist.cases import Case
from extensions.evaluation.vist.scenes import guided_motion, motion_of, simulation_of
from extensions.evaluation.vist.trial import models
from tracker.engine.pipeline import Pipeline
from tracker.fusion.chain.distal import OWN, DistalSegments
from tracker.fusion.chain.engine import ChainEngine
from tracker.fusion.chain.guided.holds import ReducedRows
from tracker.fusion.chain.params import SynergyParams
from tracker.messages import Array, Event, ImuSample
from tracker.simulation.guided import with_events
from tracker.simulation.wearer import FINGER, THUMB, Wearer

CASE = Case("free", "chain", minutes=0.02, fps=30.0, guided="guided")


class Learned(NamedTuple):
    """Of one person, for d digits: sd (d,) rad by pose and for "none" and "all"; the errors (d,)
    rad of the line before and after the poses."""

    sd: dict[str, Array]
    before: Array
    after: Array


def information(rows: ReducedRows, P_cc: Array) -> Array:
    """(3 d, 3 d) about the synergies, the calibration with covariance P_cc eliminated."""
    S = rows.H @ P_cc @ rows.H.T + rows.R
    return np.asarray(rows.H_own.T @ np.linalg.solve(S, rows.H_own))


def sd_at(P: Array, at: Array) -> Array:
    """(d,) rad of the flexion, for the flexions ``at`` (d,) rad of the joints before."""
    out = []
    for k, q in enumerate(at):
        g = np.array([q, 1.0])
        out.append(np.sqrt(g @ P[OWN * k : OWN * k + 2, OWN * k : OWN * k + 2] @ g))
    return np.array(out)


def learn(seed: int) -> Learned:
    """One person holds all poses."""
    hand, glove = models(CASE.glove)
    motion = guided_motion(CASE, hand, glove, motion_of(CASE, hand, seed, None), seed)
    sim = simulation_of(CASE, hand, glove, motion, seed, None)
    pipeline = Pipeline(hand, glove, sim.rig)
    for m in with_events(sim.messages(), motion.events):
        if isinstance(m, ImuSample):
            pipeline.feed_imu(m)
        elif isinstance(m, Event):
            pipeline.feed_event(m)
        else:
            pipeline.feed_frame(m)
    engine = pipeline.engine
    assert isinstance(engine, ChainEngine)
    state = engine.get_state().tracker
    P_cc = state.filter.state.P[engine.layout.n_dynamic :, engine.layout.n_dynamic :]
    distal = DistalSegments(engine.layout, SynergyParams())
    prior, now = distal.prior(), state.guided.synergies or distal.prior()
    at = np.deg2rad([(THUMB if d.name == "thumb" else FINGER).middle_deg for d in distal.digits])
    known = np.linalg.inv(prior.P)
    by_pose: dict[str, Array] = {}
    for rows in state.guided.accepted:
        by_pose[rows.pose] = by_pose.get(rows.pose, 0) + information(rows, P_cc)
    sd = {"none": sd_at(prior.P, at)}
    sd |= {pose: sd_at(np.linalg.inv(known + known_by), at) for pose, known_by in by_pose.items()}
    sd["all"] = sd_at(np.linalg.inv(known + sum(by_pose.values(), np.zeros_like(known))), at)
    true = _line(sim.wearer, distal, at)
    return Learned(sd, _flexion(prior.value, at) - true, _flexion(now.value, at) - true)


def _flexion(value: Array, at: Array) -> Array:
    return np.asarray(value[:, 0] * at + value[:, 1])


def _line(wearer: Wearer, distal: DistalSegments, at: Array) -> Array:
    """(d,) rad: the wearer's own flexion there, on average over postures."""
    ends, hand = wearer.end_joints, wearer.hand
    angle = [hand.angle_index[hand.synergies[d.link].angle] for d in distal.digits]
    rows = [int(np.flatnonzero(ends.angle == i)[0]) for i in angle]
    return _flexion(distal.prior().value, at) + ends.offset[rows]


def main() -> None:
    """Prints a table."""
    parser = argparse.ArgumentParser()
    parser.add_argument("--people", type=int, default=4)
    parser.add_argument("--seed", type=int, default=9)
    args = parser.parse_args()
    people = [learn(1000 * args.seed + k) for k in range(args.people)]
    print("sd, degrees      thumb  index  middle   (accepted by)")
    for pose in dict.fromkeys(name for p in people for name in p.sd):
        rows = [p.sd[pose] for p in people if pose in p.sd]
        print(f"{pose:<15}", *(f"{x:6.1f}" for x in np.rad2deg(np.mean(rows, axis=0))), len(rows))
    for name in ("before", "after"):
        off = np.rad2deg([getattr(p, name) for p in people])
        print(f"error {name:<9}", *(f"{x:6.1f}" for x in np.sqrt(np.mean(off**2, axis=0))))


if __name__ == "__main__":
    main()
