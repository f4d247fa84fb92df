"""A motion that a simulated wearer leaves for postures that he is asked for while it goes on."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.base.notices import notice
from tracker.geometry import so3
from tracker.messages import Array, Event, IntArray
from tracker.simulation.motion import Motion, Poses
from tracker.simulation.smooth import SmoothNoise, minimum_jerk, rng_for

MOVE = 0.8  # s from what the hand does to the posture, and back
AHEAD = 1.6
"""s before which nothing can change: packets are made a second at a time, and that a third of a
second before they are sent (`tracker.simulation.drawn_ahead`)."""
TURN = np.deg2rad(60.0)  # of the wrist, to either side
SWAY_DEG = 0.8  # of a hand that holds a posture; a standard deviation
SWAY_TIME = 0.8  # s, correlation


class Asked(NamedTuple):
    """From ``t`` (s) on the hand goes to a posture of ``angles`` (J,) rad, in front of the camera;
    without any it goes on with its own motion. ``turning`` is the period (s) in which it turns
    about the forearm meanwhile, from side to side; 0: it does not."""

    t: float
    angles: tuple[float, ...] = ()
    turning: float = 0.0


def asked_event(asked: Asked, pose: str, t: float) -> Event:
    """What a recording contains at ``t`` (s): the posture is of ``pose``, or (empty) his own."""
    data = {"t": asked.t, "angles": list(asked.angles), "turning": asked.turning}
    if pose:
        return Event.of(t, "device", notice("simulation.pose_shown", pose=pose), {"asked": data})
    return Event.of(t, "device", notice("simulation.pose_over"), {"asked": data})


def asked_in(event: Event) -> Asked | None:
    """The data of `asked_event`; None where it is another event."""
    data = event.data.get("asked")
    if not isinstance(data, dict):
        return None
    return Asked(data["t"], tuple(data["angles"]), data.get("turning", 0.0))


class AskedMotion:
    """``own`` but for what is `ask`-ed; a `Motion`. Postures are held where ``own`` begins.

    Until then it is ``own`` to the bit. Whoever simulates the same wearer elsewhere has to ask for
    the same.
    """

    def __init__(self, own: Motion, seed: int) -> None:
        self._own, self.asked = own, tuple[Asked, ...]()
        self.duration, self.follows_synergies = own.duration, own.follows_synergies
        first = own.poses(np.zeros(1))
        self._R, self._p = first.R_GB[0], first.p_GB[0]
        count = first.angles.shape[1] + 3
        self._sway = SmoothNoise(rng_for(seed, "asked postures"), (count,), SWAY_TIME)

    def ask(self, asked: Asked) -> None:
        """From any thread; what was asked for before is passed over."""
        if asked not in self.asked:
            self.asked = (*self.asked, asked)

    def poses(self, t: Array) -> Poses:
        t = np.asarray(t, float)
        count = self._that_count(float(t.min(initial=np.inf)))
        # the instants of asking, too: from them on a rotation goes one way or the other about
        at = np.concatenate([t, [a.t for a in count]])
        out = own = self._own.poses(at)
        for k, asked in enumerate(count):
            share = minimum_jerk((at - asked.t) / MOVE)
            there = self._held(at, asked) if asked.angles else own
            out = _between(out, there, share, len(t) + k)
        n = len(t)
        return Poses(out.angles[:n], out.R_GB[:n], out.p_GB[:n])

    def _that_count(self, t: float) -> tuple[Asked, ...]:
        """Of those asked for the last one that was reached by ``t``, and all after it."""
        asked = self.asked
        reached = [k for k, a in enumerate(asked) if a.t + MOVE <= t]
        return asked[reached[-1] :] if reached else asked

    def _held(self, t: Array, asked: Asked) -> Poses:
        sway = np.deg2rad(SWAY_DEG) * self._sway(t)
        p = np.tile(self._p, (len(t), 1))
        R = self._R @ so3.exp(sway[:, -3:])
        if asked.turning:
            since = t - asked.t - MOVE
            roll = TURN * np.cos(2 * np.pi * since / asked.turning)
            R = R @ so3.exp(np.outer(roll, [1.0, 0.0, 0.0]))
        return Poses(np.array(asked.angles) + sway[:, :-3], R, p)


def _between(one: Poses, other: Poses, share: Array, begin: int) -> Poses:
    """From ``one`` (share 0) to the ``other`` (share 1), which both are at the row ``begin``.

    Rotations go by way of their quaternions, which is as smooth as they are.
    """
    R = np.where((share == 1)[:, None, None], other.R_GB, one.R_GB)
    moving = np.flatnonzero((share > 0) & (share < 1))
    if len(moving):
        q, to = (_quaternions(x.R_GB, moving, begin) for x in (one, other))
        if q[-1] @ to[-1] < 0:
            to = -to
        blend = share[moving, None]
        R[moving] = so3.matrix_from_quat((1 - blend) * q[:-1] + blend * to[:-1])
    blend = share[:, None]
    angles = one.angles + blend * (other.angles - one.angles)
    return Poses(angles, R, one.p_GB + blend * (other.p_GB - one.p_GB))


def _quaternions(R: Array, rows: IntArray, begin: int) -> Array:
    """(n + 1, 4) of the rows (n,) of R (m, 3, 3), and of the one at ``begin``, which all have the
    sign of."""
    q = so3.quat_from_matrix(R[np.append(rows, begin)])
    return np.where((q @ q[-1])[:, None] < 0, -q, q)
