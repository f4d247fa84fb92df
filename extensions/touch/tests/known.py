"""A tracker whose errors are known: the true hand of a simulated wearer, moved."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from extensions.touch.protocol import FINGERS
from extensions.touch.simulated.session import session_info
from extensions.touch.simulated.trial import SimulatedTrial
from tracker.messages import Array, Estimate
from tracker.offline.simulate import truth_message

RATE = 12.5  # estimates a second: errors are those of touches, which last a second


class KnownTracker:
    """Adds to each tip a bias (3,) m in G and, touch by touch, normal noise of ``sd`` m per axis;
    claims ``claimed`` m."""

    def __init__(
        self, trial: SimulatedTrial, bias: dict[str, list[float]], sd: float, claimed: float
    ) -> None:
        self.trial, self.bias, self.sd, self.claimed = trial, bias, sd, claimed
        rng = np.random.default_rng(trial.seed)
        self.noise = rng.normal(0, sd, (len(trial.motion.cued), 3))

    def estimates(self) -> list[Estimate]:
        trial, info = self.trial, session_info(self.trial)
        names = trial.glove.keypoint_names(trial.hand)
        rows = {f: names.index(f"{f}_tip") for f in FINGERS}
        first = trial.motion.cued[0].begin
        t = np.arange(first, trial.motion.duration, 1 / RATE)
        begins = np.array([c.begin for c in trial.motion.cued])
        out = []
        for instant, truth in zip(t, trial.sim.truths(t), strict=True):
            estimate = truth_message(float(instant), truth, info)
            touch = int(np.searchsorted(begins, instant, side="right")) - 1
            keypoints = truth.keypoints.copy()
            for finger, row in rows.items():
                keypoints[row] += np.array(self.bias[finger]) + self.noise[touch]
            sd = np.full(len(keypoints), self.claimed)
            out.append(replace(estimate, keypoints=keypoints, keypoint_sd=sd))
        return out

    def true_bias(self, finger: str) -> Array:
        """(3,) m: with the mean of the noise over the finger's touches."""
        mine = [k for k, c in enumerate(self.trial.motion.cued) if c.cue.finger == finger]
        return np.array(self.bias[finger]) + self.noise[mine].mean(axis=0)

    def true_variance(self, finger: str) -> float:
        """m² per axis, of the noise over the finger's touches."""
        mine = [k for k, c in enumerate(self.trial.motion.cued) if c.cue.finger == finger]
        return float(np.mean(np.var(self.noise[mine], axis=0, ddof=1)))
