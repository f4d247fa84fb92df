"""A left and a right hand before one camera: each pipeline sees the markers of both."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tracker import library
from tracker.messages import BlobFrame, Blobs, CameraPose, ImuSample, Tracking
from tracker.pipeline import Pipeline
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation
from tracker.vision.rig import ideal_rig

APART = 0.2  # m
SECONDS = 3.0


def hand(glove_name: str, seed: int, aside: float) -> Simulation:
    """A hand ``aside`` m of the camera's middle, in a frame of its own."""
    model, glove = library.load(glove_name, "")
    rig = ideal_rig()
    pose = CameraPose(rig.pose.R_GC.copy(), rig.pose.p_GC + np.array([0.0, aside, 0.0]))
    motion = RandomPostures(model, seed, duration=SECONDS)
    return Simulation(model, glove, motion, seed, fps=20, rig=replace(rig, pose=pose))


def together(a: Blobs | None, b: Blobs | None) -> Blobs:
    assert a is not None and b is not None
    both = (np.concatenate([getattr(a, k), getattr(b, k)]) for k in ("uv", "size", "hue", "score"))
    return Blobs(*both)


def test_each_is_tracked_as_if_it_were_alone() -> None:
    sims = (hand("vist-small", 1, APART / 2), hand("vist-small-left", 2, -APART / 2))
    assert sims[0].glove.hues == sims[1].glove.hues, "one colour profile serves both"
    pipelines = [Pipeline(s.hand, s.glove, s.rig) for s in sims]
    messages: list[tuple[float, int, ImuSample | BlobFrame]] = []
    for i, sim in enumerate(sims):
        messages += [(m.t_arrival, i, m) for m in sim.imu_samples()]
    for index, t, arrival in sims[0].exposures():
        a, b = (s.scene.blobs(t, arrival, index) for s in sims)
        frame = replace(a, left=together(a.left, b.left), right=together(a.right, b.right))
        messages += [(arrival, i, frame) for i in range(2)]
    errors: list[list[float]] = [[], []]
    for _, i, message in sorted(messages, key=lambda m: (m[0], isinstance(m[2], BlobFrame))):
        if isinstance(message, BlobFrame):
            pipelines[i].feed_frame(message)
            continue
        estimate = pipelines[i].feed_imu(message)
        if message.t > 1.0 and message.seq % 10 == 0:
            assert estimate.tracking == Tracking.TRACKING
            off = estimate.keypoints[:21] - sims[i].truth(estimate.t).keypoints[:21]
            errors[i].append(float(np.linalg.norm(off, axis=1).mean()))
    assert max(np.mean(e) for e in errors) < 0.012
