"""A simulated wearer's motion, interrupted for requested postures."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.base.notices import notice
from tracker.geometry import so3
from tracker.messages import Array, Event, IntArray
from tracker.simulation.motion import Poses, SimulatedMotion
from tracker.simulation.smooth import SmoothNoise, minimum_jerk, rng_for

MOVE = 0.8  # s for the transition from the motion to the posture, and back
AHEAD = 1.6
"""s before which nothing can change: packets are generated one second at a time, a third of a
second before they are sent (`tracker.simulation.drawn_ahead`)."""
TURN = np.deg2rad(60.0)  # of the wrist, to either side
SWAY_DEG = 0.8  # sd of a hand that holds a posture
AT_REST = 0.2  # share of the sway that remains while the hand rests on something
SWAY_TIME = 0.8  # s, correlation


class PostureRequest(NamedTuple):
    """From ``t`` (s) on, the hand assumes a posture of ``angles`` (J,) rad in front of the camera;
    without angles it resumes its own motion. ``turning`` is the period (s) of an alternating
    rotation about the forearm during the posture; 0: none. ``place``: R_GB by rows and p_GB (m) of
    a hand that rests there. ``move`` (s): of the transition."""

    t: float
    angles: tuple[float, ...] = ()
    turning: float = 0.0
    place: tuple[float, ...] = ()
    move: float = MOVE


def request_event(request: PostureRequest, pose: str, t: float) -> Event:
    """The recorded event at ``t`` (s): the posture is of ``pose``, or (empty) the wearer's own."""
    data: dict[str, object] = {
        "t": request.t,
        "angles": list(request.angles),
        "turning": request.turning,
    }
    if request.place:
        data |= {"place": list(request.place), "move": request.move}
    if pose:
        return Event.of(t, "device", notice("simulation.pose_shown", pose=pose), {"asked": data})
    return Event.of(t, "device", notice("simulation.pose_over"), {"asked": data})


def request_in(event: Event) -> PostureRequest | None:
    """The data of `request_event`; None for any other event."""
    data = event.data.get("asked")
    if not isinstance(data, dict):
        return None
    return PostureRequest(
        data["t"],
        tuple(data["angles"]),
        data.get("turning", 0.0),
        tuple(data.get("place", ())),
        data.get("move", MOVE),
    )


class RequestedMotion:
    """``own`` except for the postures requested by `ask`. Postures are held where
    ``own`` begins.

    Before the first request it equals ``own`` exactly. Another simulation of the same wearer must
    be given the same requests.
    """

    def __init__(self, own: SimulatedMotion, seed: int) -> None:
        self._own, self.request = own, tuple[PostureRequest, ...]()
        self.duration, self.follows_synergies = own.duration, own.follows_synergies
        first = own.poses(np.zeros(1))
        self._R, self._p = first.R_GB[0], first.p_GB[0]
        count = first.angles.shape[1] + 3
        self._sway = SmoothNoise(rng_for(seed, "asked postures"), (count,), SWAY_TIME)

    def ask(self, request: PostureRequest) -> None:
        """Thread-safe; replaces earlier requests that are not reached yet."""
        if request not in self.request:
            self.request = (*self.request, request)

    def turned(self, roll: float, length: float) -> tuple[float, ...]:
        """``place`` of a request: where the motion begins, with the hand of this ``length`` (m)
        rolled (rad) about the axis of the forearm through its middle."""
        R, half = self._R @ so3.exp(np.array([roll, 0.0, 0.0])), np.array([length / 2, 0.0, 0.0])
        return (*R.reshape(-1).tolist(), *(self._p + self._R @ half - R @ half).tolist())

    def poses(self, t: Array) -> Poses:
        t = np.asarray(t, float)
        count = self._relevant(float(t.min(initial=np.inf)))
        # including the times of requests: they determine the sign of the quaternions
        at = np.concatenate([t, [a.t for a in count]])
        out = own = self._own.poses(at)
        for k, request in enumerate(count):
            share = minimum_jerk((at - request.t) / request.move)
            there = self._held(at, request) if request.angles else own
            out = _between(out, there, share, len(t) + k)
        n = len(t)
        return Poses(out.angles[:n], out.R_GB[:n], out.p_GB[:n])

    def _relevant(self, t: float) -> tuple[PostureRequest, ...]:
        """The last request reached by ``t``, and all later ones."""
        request = self.request
        reached = [k for k, a in enumerate(request) if a.t + a.move <= t]
        return request[reached[-1] :] if reached else request

    def _held(self, t: Array, request: PostureRequest) -> Poses:
        sway = np.deg2rad(SWAY_DEG) * self._sway(t)
        R_0, p_0 = self._R, self._p
        if request.place:
            sway *= AT_REST
            R_0, p_0 = np.reshape(request.place[:9], (3, 3)), np.array(request.place[9:])
        p = np.tile(p_0, (len(t), 1))
        R = R_0 @ so3.exp(sway[:, -3:])
        if request.turning:
            since = t - request.t - request.move
            roll = TURN * np.cos(2 * np.pi * since / request.turning)
            R = R @ so3.exp(np.outer(roll, [1.0, 0.0, 0.0]))
        return Poses(np.array(request.angles) + sway[:, :-3], R, p)


def _between(one: Poses, other: Poses, share: Array, begin: int) -> Poses:
    """Interpolates from ``one`` (share 0) to ``other`` (share 1); row ``begin`` belongs to both.

    Rotations are interpolated as quaternions, which preserves smoothness.
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
    """(n + 1, 4) quaternions of the rows (n,) of R (m, 3, 3), and of row ``begin``, which
    determines the sign of all."""
    q = so3.quat_from_matrix(R[np.append(rows, begin)])
    return np.where((q @ q[-1])[:, None] < 0, -q, q)
