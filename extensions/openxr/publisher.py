"""The stream: every estimate as a sample in the shared memory, of both hands."""

from __future__ import annotations

import os
import sys
import threading
import time
from collections import deque
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.transform import Rotation

from extensions.openxr.extension import MOST_AHEAD_MS, OpenXrOptions
from extensions.openxr.layout import (
    HEADER,
    JOINT,
    MAGIC,
    READER,
    READERS,
    READERS_AT,
    RING,
    RINGS_AT,
    SAMPLE,
    SIDES,
    SIZE,
    VERSION,
    Clock,
    Space,
    Velocity,
)
from extensions.openxr.memory import OpenXrMemory
from extensions.openxr.readers import clock_ns, readers_of
from tracker import __version__
from tracker.base.clock import nanoseconds
from tracker.base.notices import notice
from tracker.hand.openxr import JOINTS, WRIST, OpenXrHand, keypoint_rows, openxr_motion
from tracker.messages import Array, Estimate, Validity
from tracker.streaming.payload import openxr_of
from tracker.streaming.publisher import Names, OtherHand, Publisher, StreamError

STALE_NS = 250_000_000
REPLAYED_NS = 1_000_000_000
"""An estimate that is older is from a recording, and is stamped when it is sent."""


@dataclass(frozen=True)
class WorldPlacement:
    """Where Glovetrack's world is in one of OpenXR's reference spaces.

    position (m) of its origin, and the angle (deg) by which its forward direction (G's x) is turned
    to the left of the space's -z. ``ahead``: s by which poses are predicted at most.
    """

    space: Space
    position: tuple[float, float, float]
    yaw_deg: float
    ahead: float


class OpenXrPublisher:
    """Writes one hand; `for_other_hand` adds the other one.

    Raises StreamError where the memory cannot be created or another program has it.
    """

    def __init__(
        self,
        names: Names,
        placement: WorldPlacement,
        memory: str = "",
        now_ns: Callable[[], int] = time.monotonic_ns,
    ) -> None:
        """``memory``: its path, if it is not the usual one."""
        self.name = notice("openxr.layer")
        self._clock = Clock.PERFORMANCE_COUNTER if sys.platform == "win32" else Clock.MONOTONIC
        self._shift_ns = (
            clock_ns(self._clock) - time.monotonic_ns() if sys.platform == "win32" else 0
        )
        self._now_ns = now_ns
        self._writing, self._fence = threading.Lock(), threading.Lock()
        self._side, self._series = names.side, {names.side: JointSeries(names)}
        self._memory = OpenXrMemory(memory)
        buffer = self._memory.buffer
        self._header = np.frombuffer(buffer, HEADER, 1)
        self._entries = np.frombuffer(buffer, READER, READERS, READERS_AT)
        rings = np.frombuffer(buffer, SAMPLE, len(SIDES) * RING, RINGS_AT)
        self._rings = rings.reshape(len(SIDES), RING)
        self._begin(placement)
        self._add(names.side)

    def for_other_hand(self, names: Names) -> OtherHand:
        """The other hand in the same memory. Raises StreamError for the same side again."""
        if names.side in self._series:
            raise StreamError(notice("openxr.one_hand", side=names.side))
        self._series[names.side] = JointSeries(names)
        self._add(names.side)
        return OtherHand(self.name, partial(self._send, names.side))

    def send(self, estimate: Estimate) -> None:
        self._send(self._side, estimate)

    @property
    def clients(self) -> int:
        """Applications that read the hand within the last second."""
        with self._writing:
            readers = [] if self._memory.is_closed else readers_of(self._entries)
        now = self._now_ns() + self._shift_ns
        return sum(reader.is_reading(now) for reader in readers)

    def missed(self) -> dict[str, int]:
        """Nothing: a reader takes the newest sample."""
        return {}

    def close(self) -> None:
        """Hands become inactive, and layers look for another memory. May be called again."""
        with self._writing:
            if self._memory.is_closed:
                return
            self._header["running"] = 0
            del self._header, self._entries, self._rings
            self._memory.close()

    def _begin(self, placement: WorldPlacement) -> None:
        header = self._header
        header["version"], header["size"], header["ring"] = VERSION, SIZE, RING
        header["clock"], header["process"] = self._clock, os.getpid()
        header["program"] = f"glovetrack {__version__}".encode()
        header["ahead"], header["stale"] = nanoseconds(placement.ahead), STALE_NS
        header["space"], header["position"] = placement.space, placement.position
        turned = Rotation.from_euler("y", placement.yaw_deg, degrees=True)
        header["orientation"] = turned.as_quat()
        header["running"] = 1
        with self._fence:  # see _write
            pass
        header["magic"] = MAGIC

    def _add(self, side: str) -> None:
        self._header["hands"]["present"][0, SIDES.index(side)] = 1

    def _send(self, side: str, estimate: Estimate) -> None:
        """Each hand has a thread of its own."""
        with self._writing:
            if self._memory.is_closed:
                raise StreamError(notice("stream.closed", what="OpenXR stream"))
            self._write(SIDES.index(side), estimate, self._series[side].add(estimate))

    def _write(self, h: int, estimate: Estimate, joints: HandJoints) -> None:
        """Another sample. A lock that is released and acquired again keeps the stores before it
        before those after it, on ARM too."""
        counts = self._header["hands"]["count"][0]
        n = int(counts[h]) + 1
        k = (n - 1) % RING
        slot, sequence = self._rings[h, k], self._rings["sequence"]
        now, t = self._now_ns(), nanoseconds(estimate.t)
        sequence[h, k] = 0
        with self._fence:
            pass
        with self._fence:
            slot["t"] = (t if abs(now - t) < REPLAYED_NS else now) + self._shift_ns
            slot["written"] = now + self._shift_ns
            slot["active"] = joints.array is not None
            slot["tracking"], slot["velocity"] = int(estimate.tracking), joints.velocity
            if joints.array is not None:
                slot["joints"] = joints.array
        with self._fence:
            sequence[h, k] = n
        with self._fence:
            counts[h] = n


def open_stream(options: OpenXrOptions, hands: Sequence[Names]) -> Iterator[Publisher]:
    """Yields the publisher of each hand."""
    spaces = {space.name.lower(): space for space in Space}
    if options.space not in spaces:
        raise StreamError(
            notice("option.choice", option="space", known=tuple(spaces), value=options.space)
        )
    if not 0 <= options.ahead_ms <= MOST_AHEAD_MS:
        raise StreamError(notice("option.range", option="ahead_ms", low=0, high=MOST_AHEAD_MS))
    position = options.x, options.y, options.z
    placement = WorldPlacement(
        spaces[options.space], position, options.yaw, options.ahead_ms / 1000
    )
    first, *others = (names.with_openxr() for names in hands)
    publisher = OpenXrPublisher(first, placement)
    yield publisher
    yield from map(publisher.for_other_hand, others)


# ---- from estimates to the joints that an API layer may report: all of them, or no hand
#
# A layer must not call a hand active unless every joint has a pose. A joint that is lost
# therefore keeps its last pose relative to the wrist for `HOLD`, with state lost and without a
# velocity; after that, and whenever the wrist is lost, the hand is inactive.

HOLD = 1.0  # s for which a lost joint keeps its pose on the hand
SPAN = 0.015  # s over which a velocity is a difference at least; half of it is its delay
LONGEST_SPAN = 0.05  # s, beyond which no velocity is computed from a difference
JointArray = NDArray[np.void]
"""(26,) of `JOINT`."""
NONE = np.zeros(len(JOINTS), JOINT)


class JointPoses(NamedTuple):
    """p (26, 3) m and q (26, 4) xyzw of one instant; ``known`` (26,) bool."""

    t: float
    p: Array
    q: Array
    known: NDArray[np.bool_]


class HandJoints(NamedTuple):
    """``array`` (26,) of `JOINT`, None while the hand is inactive."""

    array: JointArray | None
    velocity: Velocity


class JointSeries:
    """The joints of one hand, estimate by estimate in order of time.

    Raises StreamError if the hand lacks one of OpenXR's joints.
    """

    def __init__(self, names: Names) -> None:
        self._names = names
        self._radii = np.array(names.radii)
        if not np.isfinite(self._radii).all():
            lacking = ", ".join(n for n, r in zip(JOINTS, names.radii, strict=True) if r != r)
            raise StreamError(notice("openxr.joints_missing", joints=lacking))
        self._rows = np.array(keypoint_rows(names.keypoints))
        self._seen = np.full(len(JOINTS), -np.inf)  # s, when each joint last had a pose
        self._p_W = np.zeros((len(JOINTS), 3))  # m in the wrist's axes, at that time
        self._q_W = np.tile([0.0, 0.0, 0.0, 1.0], (len(JOINTS), 1))
        self._before: deque[JointPoses] = deque()

    def add(self, estimate: Estimate) -> HandJoints:
        """The joints of the next estimate."""
        hand = openxr_of(estimate, self._names)
        known = hand.state != Validity.LOST
        poses = self._poses(hand, known) if known[WRIST] else None
        if poses is None:
            self._before.clear()
            return HandJoints(None, Velocity.UNKNOWN)
        out = NONE.copy()
        out["position"], out["orientation"] = poses.p, poses.q
        out["radius"], out["state"] = self._radii, hand.state
        out["sd"] = np.where(
            (self._rows >= 0) & known, estimate.keypoint_sd[np.maximum(self._rows, 0)], np.nan
        )
        velocity = self._add_motion(out, estimate, hand)
        if velocity == Velocity.UNKNOWN:
            velocity = self._add_differences(out, poses)
        self._before.append(poses)
        return HandJoints(out, velocity)

    def _add_motion(self, out: JointArray, estimate: Estimate, hand: OpenXrHand) -> Velocity:
        """The engine's own velocities; NaN of joints without such."""
        motion = openxr_motion(estimate, self._names.keypoints, hand)
        out["linear"], out["angular"] = motion.linear, motion.angular
        out["linear_sd"], out["angular_sd"] = motion.linear_sd, motion.angular_sd
        is_known = bool(np.isfinite(motion.linear[WRIST]).all())
        return Velocity.FILTER if is_known else Velocity.UNKNOWN

    def _poses(self, hand: OpenXrHand, known: NDArray[np.bool_]) -> JointPoses | None:
        """Every joint's, those that are lost where they were on the hand; None without such."""
        p, q = hand.position, hand.orientation
        back = inverse(q[WRIST])
        self._seen[known] = hand.t
        self._p_W[known] = rotate(back, p[known] - p[WRIST])
        self._q_W[known] = product(back, q[known])
        if (self._seen < hand.t - HOLD).any():
            return None
        if not known.all():
            p = np.where(known[:, None], p, p[WRIST] + rotate(q[WRIST], self._p_W))
            q = np.where(known[:, None], q, product(q[WRIST], self._q_W))
        return JointPoses(hand.t, p, q, known)

    def _add_differences(self, out: JointArray, now: JointPoses) -> Velocity:
        """Differences from the newest poses that are `SPAN` old; NaN of joints without such."""
        out["linear"], out["angular"] = np.nan, np.nan
        out["linear_sd"] = out["angular_sd"] = np.nan
        while len(self._before) > 1 and now.t - self._before[1].t >= SPAN:
            self._before.popleft()
        if not self._before or not SPAN <= now.t - self._before[0].t <= LONGEST_SPAN:
            return Velocity.UNKNOWN
        before = self._before[0]
        dt, known = now.t - before.t, now.known & before.known
        out["linear"][known] = ((now.p - before.p) / dt)[known]
        out["angular"][known] = rotation_vector(product(now.q, inverse(before.q)))[known] / dt
        return Velocity.DIFFERENCE


# Quaternions (..., 4) xyzw in arrays; for a hand's 26 in a tenth of the time of SciPy's class.

_CONJUGATE = np.array([-1.0, -1.0, -1.0, 1.0])
_AHEAD, _BEHIND = [1, 2, 0], [2, 0, 1]


def inverse(q: Array) -> Array:
    """For unit quaternions."""
    return np.asarray(q * _CONJUGATE)


def product(a: Array, b: Array) -> Array:
    """The turns ``a`` after ``b``."""
    va, wa, vb, wb = a[..., :3], a[..., 3:], b[..., :3], b[..., 3:]
    w = wa * wb - (va * vb).sum(axis=-1, keepdims=True)
    return np.concatenate([wa * vb + wb * va + _cross(va, vb), w], axis=-1)


def rotate(q: Array, v: Array) -> Array:
    """Vectors (..., 3) turned by unit quaternions."""
    u, w = q[..., :3], q[..., 3:]
    twice = 2 * _cross(u, v)
    return np.asarray(v + w * twice + _cross(u, twice))


def rotation_vector(q: Array) -> Array:
    """(..., 3) rad, at most π long, of unit quaternions."""
    q = np.where(q[..., 3:] < 0, -q, q)
    v, w = q[..., :3], q[..., 3:]
    n = np.sqrt((v * v).sum(axis=-1, keepdims=True))
    small = n < 1e-8
    return np.asarray(v * np.where(small, 2.0, 2 * np.arctan2(n, w) / np.where(small, 1.0, n)))


def _cross(a: Array, b: Array) -> Array:
    return np.asarray(a[..., _AHEAD] * b[..., _BEHIND] - a[..., _BEHIND] * b[..., _AHEAD])
