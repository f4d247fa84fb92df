"""Lines of the Hand Tracking Streamer (github.com/wengmister/hand-tracking-streamer).

    Right wrist | f=12 | t=1732538096123456789:, x, y, z, qx, qy, qz, qw
    Right landmarks | f=12 | t=1732538096123456789:, 63 numbers

in m and Unity's axes (x right, y up, z forward); landmarks in the wrist's axes, with the wrist at
0 0 0. A hand that lies flat, palm down, and points ahead has no rotation. What is lost is not sent:
without the wrist neither line, without a landmark only the wrist's.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from extensions.landmarks.lines import LineSender, open_lines
from extensions.landmarks.points import UNITY_OF_G, WRIST, Landmarks, landmarks_of
from tracker.base.notices import Notice
from tracker.geometry import so3
from tracker.messages import Array, Estimate
from tracker.streaming.connection import LOOPBACK, option
from tracker.streaming.publisher import Names, Publisher
from tracker.streaming.registry import StreamKind

DECIMALS = 6  # µm
NUMBER = f", %.{DECIMALS}f"


@dataclass(frozen=True)
class HtsOptions:
    host: str = option(LOOPBACK, "destination; with transport server, the listening address")
    port: int = option(9000, "port")
    transport: str = option(
        "udp",
        "udp; tcp: connect to a program that listens; server: wait for programs to connect",
        ("udp", "tcp", "server"),
    )
    numbered: bool = option(False, "whether lines have a frame number and a time")


class HtsPublisher:
    """The lines of one hand; ``owner`` closes what they are sent by."""

    def __init__(self, names: Names, lines: LineSender, numbered: bool, owner: bool) -> None:
        self._names, self._lines, self._numbered, self._owner = names, lines, numbered, owner
        self.name = lines.name

    @property
    def clients(self) -> int | None:
        """Connections by TCP; None by UDP."""
        return getattr(self._lines, "clients", None)

    def send(self, estimate: Estimate) -> None:
        lines = hts_lines(estimate, self._names, self._numbered)
        if lines:
            self._lines.send(lines)

    def probe(self) -> Notice | None:
        return self._lines.probe()

    def close(self) -> None:
        if self._owner:
            self._lines.close()


def hts_lines(e: Estimate, names: Names, numbered: bool) -> list[str]:
    """What is known of the hand, as lines without their ends."""
    hand = landmarks_of(e, names)
    if not hand.has_wrist:
        return []
    meta = ""
    if numbered:
        unix_ns = names.wall_ns(e.t)
        meta = f" | f={e.seq} | t={round(e.t * 1e9) if unix_ns is None else unix_ns}"
    side = names.side.title()
    out = [f"{side} wrist{meta}:{_numbers(_wrist(hand))}"]
    if hand.whole:
        out.append(f"{side} landmarks{meta}:{_numbers(_local(hand).ravel())}")
    return out


def _wrist(hand: Landmarks) -> Array:
    """Position and quaternion in Unity's axes."""
    R = UNITY_OF_G @ hand.R_GB @ UNITY_OF_G.T
    return np.concatenate([UNITY_OF_G @ hand.points[WRIST], so3.quat_from_matrix(R)])


def _local(hand: Landmarks) -> Array:
    """(21, 3) m in the wrist's axes, which Unity's name."""
    from_wrist: Array = (hand.points - hand.points[WRIST]) @ hand.R_GB @ UNITY_OF_G.T
    return from_wrist


def _numbers(values: Array) -> str:
    rounded = (np.round(values, DECIMALS) + 0.0).tolist()  # no -0
    return NUMBER * len(rounded) % tuple(rounded)


def _publishers(options: HtsOptions, hands: Sequence[Names]) -> Iterator[Publisher]:
    lines = open_lines(options.transport, "HTS", options.host, options.port)
    for i, names in enumerate(hands):
        yield HtsPublisher(names, lines, options.numbered, owner=i == 0)


HTS = StreamKind(
    name="hts", title="Hand Tracking Streamer", options=HtsOptions, make=_publishers, order=24
)
