"""What a door does with the poses that it receives, and what it remembers of their trackers."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from concurrent.futures import Future
from dataclasses import dataclass

import numpy as np

from extensions.room.osc_poses import RoomPose
from extensions.room.placement import Placement
from tracker.base.callbacks import ignore
from tracker.base.clock import monotonic
from tracker.streaming.remote.reception import Allowance, Answer, DoorCounts
from tracker.streaming.remote.request import Reply, Request

MOST_HZ = 2000.0  # poses of all trackers; more would only load the computer
MOST_NAMES = 256  # trackers that are remembered
WRIST = "wrist"
Tap = Callable[[RoomPose, float], None]
"""Called with each pose that arrives, of any tracker, and its instant (s); in the door's thread."""


@dataclass(frozen=True)
class ReceivedPoses:
    """Poses of one tracker so far, and whether the last one had a rotation."""

    count: int
    with_rotation: bool


class PoseTaker:
    """Passes poses on and counts them; calls come from one thread unless they say otherwise."""

    def __init__(self, answer: Answer, placement: Placement) -> None:
        self._answer, self._placement = answer, placement
        self._allowance = Allowance(MOST_HZ, monotonic())
        self._peers: dict[str, float] = {}
        self._received: dict[str, ReceivedPoses] = {}
        self._tap: Tap = ignore
        self.asked = self.refused = 0

    def take(self, poses: Sequence[RoomPose], t: float, peer: str) -> None:
        """Poses that were measured at ``t`` (s)."""
        for pose in poses:
            if not self._allowance.take(monotonic()):
                self.refused += 1
                continue
            self._remember(pose, t)
            for message in self._placement.of(pose, t):
                self.asked += 1
                self._note_peer(peer)
                request = Request(WRIST, message.t, data={"pose": message}, side=message.side)
                self._answer(request).add_done_callback(self._count)

    def refuse(self) -> None:
        """Counts a packet that cannot be read."""
        self.refused += 1

    def received(self) -> dict[str, ReceivedPoses]:
        """Trackers by name, those that are on no hand included. From any thread."""
        return dict(self._received)

    def tap(self, tap: Tap) -> None:
        """Passes every pose to ``tap`` too, from now on. From any thread."""
        self._tap = tap

    def untap(self) -> None:
        """Ends what `tap` began. From any thread."""
        self._tap = ignore

    def _remember(self, pose: RoomPose, t: float) -> None:
        before = self._received.get(pose.name)
        if before is not None or len(self._received) < MOST_NAMES:
            count = before.count if before is not None else 0
            turned = bool(np.isfinite(pose.q).all())
            self._received[pose.name] = ReceivedPoses(count + 1, turned)
        self._tap(pose, t)

    def _note_peer(self, peer: str) -> None:
        self._peers.pop(peer, None)
        self._peers[peer] = monotonic()
        while len(self._peers) > 8:
            del self._peers[next(iter(self._peers))]

    def _count(self, done: Future[Reply]) -> None:
        if not done.cancelled() and not done.result().ok:
            self.refused += 1

    def counts(self, name: str, clients: int | None = None) -> DoorCounts:
        """From any thread."""
        now = monotonic()
        peers = tuple((peer, now - t) for peer, t in list(self._peers.items()))
        return DoorCounts(name, self.asked, self.refused, peers, clients)
