"""The hand as input of applications: points, palm and gestures with their states.

It contains only values that a session stores without loss, so an application behaves identically
for recorded estimates.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from tracker.base.clock import nanoseconds, seconds
from tracker.geometry import so3
from tracker.gestures.recogniser import GestureRecogniser, Phase
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.hand.names import CHAINS, KEYPOINTS
from tracker.messages import Array, Estimate, IntArray, Tracking, Validity

TIPS = tuple(f"{finger}_tip" for finger in CHAINS)
FASTEST = 3.0  # m/s, maximum speed of a fingertip between two samples


@dataclass(frozen=True, eq=False)
class HandSample:
    """One hand at one instant ``t`` (s); everything in m in G.

    p (K, 3), q (K, 4) xyzw, state (K,) of Validity and sd (K,) of the keypoints ``names``; NaN
    where lost. radius (K,) m: half the finger's thickness. ``gestures`` are the active ones,
    ``phases`` those that begin or end with this sample, ``values`` 0..1 or NaN. ``between``: the
    sample is predicted from the previous two.
    """

    t: float
    side: str
    tracking: Tracking
    names: Mapping[str, int]
    p: Array
    q: Array
    state: IntArray
    sd: Array
    radius: Array
    gestures: tuple[str, ...] = ()
    phases: tuple[Phase, ...] = ()
    values: Mapping[str, float] | None = None
    between: bool = False

    @property
    def located(self) -> bool:
        """Whether the hand's position is known."""
        placed = self.tracking in (Tracking.TRACKING, Tracking.COASTING)
        return placed and self.point("wrist") is not None

    def point(self, name: str) -> Array | None:
        """Position (3,) m of a keypoint such as ``index_tip``; None if it is lost."""
        row = self.names.get(name, -1)
        if row < 0 or self.state[row] == Validity.LOST or not np.isfinite(self.p[row]).all():
            return None
        return np.asarray(self.p[row])

    def rotation(self, name: str) -> Array | None:
        """R_GB (3, 3) of a keypoint's segment (x to the tip, z dorsal)."""
        row = self.names.get(name, -1)
        if row < 0 or self.state[row] == Validity.LOST or not np.isfinite(self.q[row]).all():
            return None
        return np.asarray(so3.matrix_from_quat(self.q[row]))

    @cached_property
    def palm(self) -> tuple[Array, Array] | None:
        """R_GB (3, 3) of the dorsum and the palm's centre (3,) m; None without a position."""
        R, wrist, knuckle = self.rotation("wrist"), self.point("wrist"), self.point("middle_mcp")
        if R is None or wrist is None or knuckle is None or not self.located:
            return None
        return R, wrist + 0.625 * (knuckle - wrist)

    def pinch_point(self, finger: str = "index") -> Array | None:
        """Midpoint (3,) m of the tips of thumb and finger."""
        thumb, tip = self.point("thumb_tip"), self.point(f"{finger}_tip")
        return None if thumb is None or tip is None else (thumb + tip) / 2

    def shows(self, gesture: str) -> bool:
        return gesture in self.gestures

    def begins(self, gesture: str) -> bool:
        """Whether a gesture begins with this sample."""
        return any(p.gesture == gesture and p.begins for p in self.phases)

    def value(self, gesture: str) -> float:
        """Value of a gesture, 0..1; 0 if unknown."""
        value = (self.values or {}).get(gesture, np.nan)
        return 0.0 if np.isnan(value) else value


class HandReader:
    """Converts the estimates of one hand, in order, to samples."""

    def __init__(self, hand: HandModel, glove: GloveModel) -> None:
        names = glove.keypoint_names(hand)
        self.side = hand.side
        self._names = {name: i for i, name in enumerate(names)}
        self._gestures = GestureRecogniser(hand, names)
        radius = {s.name: s.radius for s in hand.segments}
        self._radius = np.array([radius.get(KEYPOINTS.get(n, ("", 0))[0], 0.0) for n in names])

    def read(self, estimate: Estimate) -> HandSample:
        """The next sample."""
        e = estimate
        phases = tuple(self._gestures.feed(e))
        lost = e.keypoint_state == Validity.LOST
        return HandSample(
            e.t,
            self.side,
            e.tracking,
            self._names,
            np.where(lost[:, None], np.nan, e.keypoints),
            e.keypoint_q,
            e.keypoint_state,
            e.keypoint_sd,
            self._radius,
            self._gestures.active,
            phases,
            self._gestures.values,
        )


def predicted(before: HandSample, now: HandSample, ahead: float) -> HandSample:
    """The hand ``ahead`` s after ``now`` at constant velocity of each point; same gestures."""
    step, t = now.t - before.t, seconds(nanoseconds(now.t + ahead))  # as stored in a session
    if not 0 < step < 0.1:
        return replace(now, t=t, phases=(), between=True)
    velocity = (now.p - before.p) / step
    slow = np.linalg.norm(velocity, axis=1) < FASTEST
    p = np.where(slow[:, None], now.p + ahead * velocity, now.p)
    return replace(now, t=t, p=p, phases=(), between=True)
