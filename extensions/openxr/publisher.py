"""The stream: every estimate as a sample in the shared memory, of both hands."""

from __future__ import annotations

import os
import sys
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np
from scipy.spatial.transform import Rotation

from extensions.openxr.extension import MOST_AHEAD_MS, OpenXrOptions
from extensions.openxr.joints import HandJoints, JointSeries
from extensions.openxr.layout import (
    HEADER,
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
)
from extensions.openxr.memory import OpenXrMemory
from extensions.openxr.readers import clock_ns, readers_of
from tracker import __version__
from tracker.base.clock import nanoseconds
from tracker.base.notices import notice
from tracker.messages import Estimate
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
    """Writes one hand; `beside` adds the other one.

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

    def beside(self, names: Names) -> OtherHand:
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
    yield from map(publisher.beside, others)
