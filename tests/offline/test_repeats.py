"""A packet that a session contains more than once is used once, and reported."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import groupby
from pathlib import Path

import numpy as np
import pytest

from tracker.engine.hands import Sided
from tracker.messages import Estimate, Event, ImuSample, Tracking
from tracker.offline.options import TrackOptions
from tracker.offline.repeats import Repeats
from tracker.offline.simulate import SimulateOptions, simulate
from tracker.offline.track import track
from tracker.session.mcap.container import Copier, McapOutput
from tracker.session.mcap.input import McapInput, RawMessage
from tracker.session.reader import SessionReader
from tracker.session.verify import is_ok, verify

Twice = Callable[[list[RawMessage]], Iterator[RawMessage]]


def each_message(messages: list[RawMessage]) -> Iterator[RawMessage]:
    """Every message of the glove twice, one after the other."""
    for m in messages:
        yield from [m, m] if m.topic.startswith("/glove") else [m]


def each_packet(messages: list[RawMessage]) -> Iterator[RawMessage]:
    """All messages of a packet, then all of them again."""
    for glove, group in groupby(messages, key=lambda m: (m.topic.startswith("/glove"), m.log_time)):
        found = list(group)
        yield from [*found, *found] if glove[0] else found


def copy(source: Path, out: Path, twice: Twice) -> None:
    reader = McapInput(source)
    made = McapOutput(out, sync=False)
    for record in reader.metadata():
        made.metadata(record.name, dict(record.metadata))
    for a in reader.attachments():
        made.attach_bytes(a.name, a.media_type, a.data, a.log_time)
    copier = Copier(reader, made)
    spans = reader.contents.spans
    messages = [m for i in range(len(spans)) for m in reader.messages_in(spans[i])]
    for m in twice(sorted(messages, key=lambda m: m.log_time)):
        copier.copy(m)
    made.finish()
    reader.close()


def estimates(path: Path) -> list[Estimate]:
    with SessionReader(path) as reader:
        return [m for m in reader.messages((Estimate,)) if isinstance(m, Estimate)]


@pytest.fixture(scope="module", params=["right", "both"])
def session(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("sessions") / "in.mcap"
    simulate(path, SimulateOptions(hands=request.param, duration=1.0, fps=30, images=False))
    return path


@pytest.mark.long
def test_repeated_packets_change_no_estimate(session: Path, tmp_path: Path) -> None:
    """Each message twice for one hand; for both hands, each packet."""
    with SessionReader(session) as reader:
        twice = each_packet if reader.sides else each_message
    doubled = tmp_path / "doubled.mcap"
    copy(session, doubled, twice)
    plain = track(session, tmp_path / "plain.mcap")
    assert not plain.notices and "imu_repeated" not in plain.losses
    report = track(doubled, tmp_path / "again.mcap", TrackOptions(with_sensors=True))
    assert report.losses.pop("imu_repeated") == report.estimates == plain.estimates
    assert report.losses == plain.losses
    before, after = estimates(tmp_path / "plain.mcap"), estimates(tmp_path / "again.mcap")
    assert before[-1].tracking == Tracking.TRACKING
    for one, other in zip(before, after, strict=True):
        assert one.t == other.t
        assert np.array_equal(one.keypoints, other.keypoints, equal_nan=True)
        assert np.array_equal(one.keypoint_sd, other.keypoint_sd, equal_nan=True)
    reported = [n for n in report.notices if n.code == "track.packets_repeated"]
    assert reported
    with SessionReader(tmp_path / "again.mcap") as reader:
        found = [m.notice for m in reader.messages((Event,)) if isinstance(m, Event)]
        assert all(n in found for n in reported)
    assert not [f for f in verify(tmp_path / "again.mcap") if f.what.code == "check.repeated"]


@pytest.mark.long
@pytest.mark.parametrize("twice", [each_message, each_packet])
def test_verify_reports_repeated_packets(session: Path, tmp_path: Path, twice: Twice) -> None:
    doubled = tmp_path / "doubled.mcap"
    copy(session, doubled, twice)
    found = [f for f in verify(doubled) if f.what.code == "check.repeated"]
    with SessionReader(session) as reader:
        imus = [t for t in reader.topic_names if "/imu/" in t]
    assert len(found) == len(imus) and all(f.severity == "warning" for f in found)
    assert is_ok(verify(doubled))
    assert not [f for f in verify(session) if f.what.code == "check.repeated"]


def test_packets_that_differ_are_all_used(session: Path) -> None:
    """The same number and instant with other readings, or the same readings with another number."""
    with SessionReader(session) as reader:
        first = next(m for m in reader.messages((ImuSample,)) if isinstance(m, ImuSample))
    other = replace(first, accel=first.accel + 1e-9)
    later = replace(first, seq=first.seq + 1)
    repeats = Repeats()
    packets = [Sided(packet, "right") for packet in (first, other, first, later)]
    assert list(repeats.without(packets)) == [packets[0], packets[1], packets[3]]
    assert repeats.counts == {"right": 1}
