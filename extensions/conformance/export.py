"""Exports a session as a hand record of NVIDIA's Isaac tools (`extensions.conformance.isaac`)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from heapq import merge
from pathlib import Path
from typing import NamedTuple

import numpy as np

from extensions.conformance.isaac.record import HandRecord, Stamps, joints_of
from extensions.conformance.isaac.writer import IsaacWriter
from tracker.base.clock import NS
from tracker.hand.openxr import OpenXrHand, joint_radii, openxr_joints
from tracker.messages import Array, ImuSample, IntArray
from tracker.session.export.load import load_series
from tracker.session.export.options import ExportOptions
from tracker.session.export.series import EstimateSeries
from tracker.session.mcap.ordering import ordered
from tracker.session.reader import SessionReader
from tracker.session.ros import topics


class ArrivalTimes(NamedTuple):
    """Times (N,) ns since 1970 at which estimates were available, and times on the glove's
    clock."""

    available_ns: IntArray
    device_ns: IntArray


def export_isaac(reader: SessionReader, path: Path, options: ExportOptions) -> EstimateSeries:
    """Write both hands to one file; returns the estimates of the main one."""
    hands: dict[str, tuple[EstimateSeries, ArrivalTimes]] = {}
    for one in readers_of_hands(reader):
        with one:
            m = load_series(one, options)
            hands[m.info.side] = (m, arrivals(one, m))
    with path.open("wb") as file:
        write_hands(IsaacWriter(file), hands)
    return hands[reader.info.side][0]


def readers_of_hands(reader: SessionReader) -> Iterator[SessionReader]:
    """A reader of the session per hand, left first; the caller closes them."""
    for side in reader.sides or ("",):
        yield SessionReader(reader.path, side=side)


def write_hands(
    writer: IsaacWriter, hands: Mapping[str, tuple[EstimateSeries, ArrivalTimes]]
) -> None:
    """Write one series per side, in G, in the order of available times."""
    streams = [hand_records(side, *given) for side, given in hands.items()]
    for _, side, record in merge(*streams, key=lambda item: item[0]):
        writer.write(side, record)
    writer.finish()


def hand_records(
    side: str, m: EstimateSeries, arrivals: ArrivalTimes
) -> Iterator[tuple[int, str, HandRecord]]:
    """Yields (available time in ns, side, record) in order for a series in G."""
    to_monotonic = m.info.anchor.monotonic_ns - m.info.anchor.wall_ns + m.zero_ns
    radii = joint_radii(m.info.hand)
    hand = openxr_joints(m.keypoints, m.q, m.state, m.keypoint_names, radii)
    sample = m.stamp_ns + to_monotonic
    available = np.maximum.accumulate(np.maximum(arrivals.available_ns + to_monotonic, sample))
    for i in range(len(m)):
        one = OpenXrHand(
            np.nan, hand.position[i], hand.orientation[i], hand.state[i], hand.radius[i]
        )
        stamps = Stamps(int(available[i]), int(sample[i]), int(arrivals.device_ns[i]))
        yield stamps.available, side, HandRecord(stamps, joints_of(one))


def arrivals(reader: SessionReader, m: EstimateSeries) -> ArrivalTimes:
    """Arrival times from the log times of a session's keypoints and the glove's packets.

    Times of estimates between recorded ones are interpolated; without a glove clock the sample time
    is used.
    """
    topic = frozenset([topics.hand(m.info.side, "keypoints")])
    found = [(r.publish_time, r.log_time) for r in ordered(reader.source, topic)]
    stamp, log = np.array(sorted(found), np.int64).reshape(-1, 2).T
    at = m.stamp_ns + m.zero_ns
    delay = np.interp(at - stamp[0], stamp - stamp[0], (log - stamp).astype(float))
    available = m.stamp_ns + np.maximum(np.round(delay), 0).astype(np.int64)
    return ArrivalTimes(available, _device_ns(reader, m, at))


def _device_ns(reader: SessionReader, m: EstimateSeries, at: IntArray) -> IntArray:
    """The instants ``at`` (N,) ns since 1970 on the glove's clock, ns."""
    packets = [s for s in reader.messages([ImuSample]) if isinstance(s, ImuSample)]
    t = np.array([s.t for s in packets])
    device = np.array([s.t_device for s in packets])
    known = np.isfinite(device)
    seconds: Array = (at - m.info.anchor.wall_ns + m.info.anchor.monotonic_ns) / NS
    if not known.any():
        return np.asarray(np.round(seconds * NS), np.int64)
    order = np.argsort(t[known])
    return np.asarray(
        np.round(np.interp(seconds, t[known][order], device[known][order]) * NS), np.int64
    )
