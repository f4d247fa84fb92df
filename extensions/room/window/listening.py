"""Whether poses arrive from a source, and of which trackers: a background job."""

from __future__ import annotations

import threading
from collections.abc import Mapping
from concurrent.futures import Future
from dataclasses import dataclass
from typing import Any, Protocol, cast

from app.platform.tasks import Job, JobProgress
from app.words import tr
from extensions.room.placement import ANY
from extensions.room.taker import PoseTaker, ReceivedPoses
from tracker.base.notices import Notice, failure, notice, warning
from tracker.hand.names import SIDES
from tracker.streaming.remote.doors import Door
from tracker.streaming.remote.registry import DoorKind, open_door
from tracker.streaming.remote.request import Reply, Request

ROOM_KINDS = ("room", "natnet", "lslpose", "vrpn")
"""Names of the sources, as in the list."""
LISTEN_S, STEP_S = 2.0, 0.1
LISTEN_S_LSL = 4.0  # it looks for streams first


class PoseDoor(Door, Protocol):
    """A door that receives poses."""

    @property
    def taker(self) -> PoseTaker: ...


@dataclass(frozen=True)
class Listened:
    """What a source sent in ``seconds``: trackers by name with their poses, packets that cannot be
    read, and whether there is a connection; None where the protocol has none."""

    address: str | Notice
    seconds: float
    trackers: Mapping[str, ReceivedPoses]
    unreadable: int
    connected: bool | None


def pose_door(door: Door | None) -> PoseDoor | None:
    """The door if it receives poses."""
    return cast(PoseDoor, door) if isinstance(getattr(door, "taker", None), PoseTaker) else None


def listen_job(kind: DoorKind[Any], options: Any, door: PoseDoor | None) -> Job:
    """A job that returns what was `Listened` at ``door``, or at one of its own where there is
    none."""
    seconds = LISTEN_S_LSL if kind.name == "lslpose" else LISTEN_S

    def run(progress: JobProgress) -> Listened:
        if door is not None:
            return _listened(door, seconds, progress)
        own = cast(PoseDoor, open_door(kind, options, _ignored))
        try:
            return _listened(own, seconds, progress)
        finally:
            own.close()

    return run


def _ignored(request: Request) -> Future[Reply]:
    """Takes the poses of a test, which are of no use to any hand."""
    future: Future[Reply] = Future()
    future.set_result(Reply(True, request.do, ""))
    return future


def _listened(door: PoseDoor, seconds: float, progress: JobProgress) -> Listened:
    before, refused = door.taker.received(), door.taker.refused
    pause = threading.Event()
    for k in range(round(seconds / STEP_S)):
        progress(k * STEP_S / seconds)
        pause.wait(STEP_S)
    trackers = {}
    for name, received in door.taker.received().items():
        count = received.count - (before[name].count if name in before else 0)
        if count:
            trackers[name] = ReceivedPoses(count, received.with_rotation)
    counts = door.counts()
    connected = None if counts.clients is None else counts.clients > 0
    unread = door.taker.refused - refused
    return Listened(counts.name, seconds, trackers, unread, connected)


def verdict(found: Listened, wanted: Mapping[str, str]) -> Notice:
    """``wanted``: the names of the trackers on the hands, by side."""
    if not found.trackers and found.connected is False:
        return failure("room.test_no_connection", address=found.address)
    if not found.trackers and found.unreadable:
        return failure("room.test_unreadable", address=found.address, count=found.unreadable)
    if not found.trackers:
        return failure("room.test_nothing", address=found.address, seconds=found.seconds)
    names = [wanted.get(side, "") for side in SIDES]
    missing = [n for n in names if n and n != ANY and n not in found.trackers]
    if missing:
        return warning("room.test_missing", names=missing)
    if not any(names):
        return warning("room.test_unnamed", count=len(found.trackers))
    return notice("room.test_received", count=len(found.trackers))


def tracker_lines(found: Listened) -> list[str]:
    """A line for each tracker, those that send most often first."""
    ordered = sorted(found.trackers.items(), key=lambda item: (-item[1].count, item[0]))
    lines = []
    for name, received in ordered[:12]:
        text = (
            tr("{}: {:.0f} poses per second")
            if received.with_rotation
            else tr("{}: {:.0f} positions per second, without rotation")
        )
        lines.append(text.format(name, received.count / found.seconds))
    if len(ordered) > 12:
        lines.append(tr("and {} more").format(len(ordered) - 12))
    return lines
