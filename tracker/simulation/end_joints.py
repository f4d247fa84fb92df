"""Flexion of people's end joints: a personal linear relation, with deviations from posture to
posture.

Numbers and their sources: extensions/evaluation/docs/evaluation.md, "Simulated people".
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker.hand.model import HandModel
from tracker.messages import Array
from tracker.simulation.smooth import SmoothNoise

WAVES = 24
POSTURES_ALIKE = 0.7
"""rad, all joints together: postures that are closer than this have related deviations."""
SOFT_LIMIT = np.deg2rad(4.0)
"""Within this distance of a joint's limits, tissue yields instead of stopping the joint."""


@dataclass(frozen=True)
class EndJointParams:
    """For one kind of end joint: standard deviations over people, unless stated otherwise."""

    ratio_mean: float  # difference of the mean ratio over people from the hand file's
    ratio: float
    middle_deg: float  # angle of the preceding joint at which people agree with the hand file
    offset_deg: float
    posture_deg: float  # median over people, from posture to posture
    posture_spread: float  # of the logarithm of the line above
    drift_deg: float  # with time, in the same posture


FINGER = EndJointParams(-0.27, 0.30, 40.0, 5.0, 11.0, 0.3, 3.0)
THUMB = EndJointParams(-0.80, 0.50, 20.0, 8.0, 16.0, 0.3, 3.0)
AS_IN_FILE = EndJointParams(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


class EndJoints:
    """The end joints of one person: deviations from the hand file's synergies."""

    def __init__(
        self,
        hand: HandModel,
        rng: np.random.Generator,
        finger: EndJointParams,
        thumb: EndJointParams,
        correlation: float,
    ) -> None:
        """``correlation`` is that of the drift, s."""
        driven = [s for s in hand.synergies if s.angle.split("_")[1] in ("dip", "ip")]
        self.angle = np.array([hand.angle_index[s.angle] for s in driven], np.int64)
        self._source = np.array([hand.angle_index[s.of] for s in driven], np.int64)
        kinds = [thumb if s.angle.startswith("thumb") else finger for s in driven]
        of = {name: np.array([getattr(k, name) for k in kinds]) for name in _FIELDS}
        self.ratio = of["ratio_mean"] + rng.normal(0, of["ratio"])
        self.offset: Array = rng.normal(0, np.deg2rad(of["offset_deg"]))
        self._middle = np.deg2rad(of["middle_deg"])
        self._drift = SmoothNoise(rng, (len(driven),), correlation)
        self._drift_sd = np.deg2rad(of["drift_deg"])
        self.posture_sd: Array = np.deg2rad(of["posture_deg"]) * np.exp(
            rng.normal(0, of["posture_spread"])
        )
        self._draw_postures(hand, rng)
        self._low, self._high = hand.angle_limits[self.angle].T

    def _draw_postures(self, hand: HandModel, rng: np.random.Generator) -> None:
        """Random Fourier features of the joints that people move voluntarily."""
        n = len(self.angle)
        self._omega = rng.normal(0, 1 / POSTURES_ALIKE, (n, WAVES, len(hand.joint_names)))
        self._omega[:, :, self.angle] = 0.0
        self._phase = rng.uniform(0, 2 * np.pi, (n, WAVES))
        self._amplitude = rng.normal(0, np.sqrt(2.0 / WAVES), (n, WAVES))

    def deviation(self, t: Array, angles: Array) -> Array:
        """(n, d) rad to add to the angles (n, J) rad of ``angle`` at the times t (n,) s, where
        these follow the hand file's synergies."""
        source, before = angles[:, self._source], angles[:, self.angle]
        line = self.ratio * (source - self._middle) + self.offset
        off = self.posture_sd * self._in_posture(angles) + self._drift_sd * self._drift(t)
        return self._within(before + line + off) - self._within(before)

    def _in_posture(self, angles: Array) -> Array:
        """(n, d) of unit variance over people and postures."""
        phase = np.einsum("dwj,nj->ndw", self._omega, angles) + self._phase
        return np.asarray(np.sum(self._amplitude * np.cos(phase), axis=2))

    def _within(self, x: Array) -> Array:
        """Angles (n, d) rad, smoothly kept within the joints' limits."""
        above = self._low + SOFT_LIMIT * np.logaddexp(0.0, (x - self._low) / SOFT_LIMIT)
        return self._high - SOFT_LIMIT * np.logaddexp(0.0, (self._high - above) / SOFT_LIMIT)


_FIELDS = tuple(EndJointParams.__dataclass_fields__)
