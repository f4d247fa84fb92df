"""Recordings of a computer that stalls: images long after their exposure, packets in bursts."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from tests.live.test_loop import feed, loop_on
from tracker.messages import BlobFrame, Event, ImuSample
from tracker.offline.crop import crop
from tracker.offline.options import TrackOptions
from tracker.offline.simulate import SimulateOptions, build
from tracker.offline.track import track
from tracker.session.compare import compare
from tracker.session.mcap.ordering import last_before
from tracker.session.reader import SessionReader
from tracker.session.ros import topics
from tracker.session.writer import RecorderParams, SessionRecorder

pytestmark = pytest.mark.long

STALL, DURATION = 0.5, 6.0  # s


def stalled(messages: list[ImuSample | BlobFrame], seed: int) -> list[ImuSample | BlobFrame]:
    """All of `STALL` s may arrive late, images and packets independently."""
    rng, late = np.random.default_rng(seed), {}
    out = []
    for m in messages:
        stall = np.floor(m.t / STALL)
        key = stall, isinstance(m, ImuSample)
        if key not in late:
            late[key] = rng.uniform(0.0, 0.9 * STALL) * (rng.random() < 0.7)
        out.append(replace(m, t_arrival=max(m.t_arrival, stall * STALL + late[key])))
    return sorted(out, key=lambda m: (m.t_arrival, isinstance(m, BlobFrame)))


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A live recording that begins while the hand is tracked."""
    path = tmp_path_factory.mktemp("stalled") / "live.mcap"
    sim, info = build(SimulateOptions(seed=5, duration=DURATION, fps=20, images=False))
    loop, clock = loop_on(sim)
    plain = [m for m in sim.feed() if isinstance(m, ImuSample | BlobFrame)]
    messages = stalled(plain, seed=3)
    first = next(i for i, m in enumerate(messages) if m.t_arrival > 2.0)
    feed(loop, clock, messages[:first])
    loop.set_recorder(SessionRecorder(path, info, RecorderParams(chunk_bytes=16_384)))
    for k in range(first, len(messages), 7):
        feed(loop, clock, messages[k : k + 7])
        earlier = Event(clock.now - 0.3, "note", "what happened earlier")
        loop.journal.record(earlier)  # like that of an image: chunks of the file overlap
    loop.set_recorder(None)
    with SessionReader(path) as reader:
        stamps = [e.t for e in reader.messages() if type(e).__name__ == "Estimate"]
    assert len(stamps) > 300 and min(np.diff(stamps)) < 0, "packets come after images have shown"
    return path


@pytest.mark.parametrize("with_sensors", [True, False])
def test_it_is_tracked_again_bit_for_bit(
    recorded: Path, tmp_path: Path, with_sensors: bool
) -> None:
    track(recorded, tmp_path / "again.mcap", TrackOptions(with_sensors=with_sensors))
    found = compare(recorded, tmp_path / "again.mcap")
    assert found["identical"], found


@pytest.mark.parametrize("start", np.linspace(0.31, 2.47, 9))
def test_its_parts_are_tracked_again_bit_for_bit(
    recorded: Path, tmp_path: Path, start: float
) -> None:
    part = tmp_path / "part.mcap"
    crop(recorded, part, float(start), float(start) + 0.7)
    track(part, tmp_path / "again.mcap")
    found = compare(part, tmp_path / "again.mcap")
    assert found["identical"], found


def test_the_last_value_before_a_time_is_found_across_chunks(recorded: Path) -> None:
    """Chunks overlap where messages are late; every message is a valid answer for some time."""
    with SessionReader(recorded) as reader:
        topic = topics.hand(reader.info.side, "keypoints")
        wanted = frozenset([topic])
        messages = list(reader.raw_messages(wanted))
        spans = list(reader.source.spans_with(wanted))
        assert any(a.end >= b.start for a, b in pairwise(spans))
        assert len(messages) > 300
        for before, after in pairwise(messages):
            if before.log_time < after.log_time:
                found = last_before(reader.source, topic, after.log_time)
                assert found is not None and found.log_time == before.log_time
                assert found.data == before.data
        assert last_before(reader.source, topic, messages[0].log_time) is None
