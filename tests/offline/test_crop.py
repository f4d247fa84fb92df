"""A part of a session is a complete session, tracked again to the same bits."""

from __future__ import annotations

import numpy as np
import pytest

from tests.notices import raises
from tests.simulated_sessions import SimulatedSessions
from tracker.base.errors import ConfigError, FileError
from tracker.cli import main
from tracker.messages import BlobFrame, Estimate, ImuSample
from tracker.offline.crop import crop
from tracker.offline.simulate import SimulateOptions
from tracker.offline.track import track
from tracker.session.overview import session_summary
from tracker.session.reader import SessionReader
from tracker.session.verify import is_ok, verify

pytestmark = pytest.mark.long

SECONDS, START, STOP = 4.0, 1.5, 3.2


@pytest.fixture(scope="module")
def tracked(simulated_sessions: SimulatedSessions):
    """Sensors and `chain`'s estimates."""
    return simulated_sessions.tracked(
        SimulateOptions(seed=5, duration=SECONDS, fps=30, images=False)
    )


@pytest.fixture(scope="module")
def part(tracked, tmp_path_factory):
    out = tmp_path_factory.mktemp("crop") / "part.mcap"
    report = crop(tracked, out, START, STOP)
    assert report["engine_state"]
    return out


def read(path, *kinds):
    with SessionReader(path) as reader:
        return list(reader.messages(kinds))


def test_a_part_is_complete_and_has_the_requested_length(part):
    assert is_ok(verify(part))
    found = session_summary(part)
    assert found["duration_s"] == pytest.approx(STOP - START, abs=0.03)
    imu = next(v for k, v in found["topics"].items() if "/imu/" in k)
    assert imu["rate_hz"] == pytest.approx(100, rel=0.03)
    with SessionReader(part) as reader:
        assert reader.anchor.wall_ns <= reader.span_ns[0] < reader.anchor.wall_ns + 5e7


def test_sensor_data_are_copied_unchanged(part, tracked):
    with SessionReader(tracked) as reader:
        begin = reader.anchor.monotonic(reader.span_ns[0])
    for kind in (ImuSample, BlobFrame):
        whole = [m for m in read(tracked, kind) if begin + START <= m.t_arrival < begin + STOP]
        cut = read(part, kind)
        assert [m.t for m in cut] == [m.t for m in whole]
    assert np.array_equal(read(part, ImuSample)[3].gyro, [
        m for m in read(tracked, ImuSample) if m.t_arrival >= begin + START
    ][3].gyro)  # fmt: skip


def test_a_part_is_tracked_again_to_the_same_bits(part, tracked, tmp_path):
    """The filter continues from its state: no searching, no other wearer."""
    again = tmp_path / "again.mcap"
    track(part, again)
    ours = {m.t: m for m in read(again, Estimate)}
    theirs = [m for m in read(tracked, Estimate) if m.t in ours]
    assert len(theirs) == len(ours) > 150
    for m in theirs:
        for name in ("keypoints", "angles", "keypoint_state"):
            assert np.array_equal(getattr(m, name), getattr(ours[m.t], name), equal_nan=True)


def test_a_part_of_a_part_is_valid_too(part, tracked, tmp_path):
    smaller, again = tmp_path / "smaller.mcap", tmp_path / "again.mcap"
    crop(part, smaller, 0.5, 1.0)
    track(smaller, again)
    ours = read(again, Estimate)
    theirs = {m.t: m for m in read(tracked, Estimate)}
    assert len(ours) > 40
    assert all(np.array_equal(m.keypoints, theirs[m.t].keypoints, equal_nan=True) for m in ours)


def test_invalid_intervals_are_rejected(tracked, tmp_path):
    for start, stop in ((2.0, 1.0), (-1.0, 1.0), (9.0, None), (9.0, 10.0), (float("nan"), 1.0)):
        with raises(ConfigError, "crop.range"):
            crop(tracked, tmp_path / "x.mcap", start, stop)
    with pytest.raises(FileError):
        crop(tracked, tracked, 1.0, 2.0, force=True)
    assert list(tmp_path.iterdir()) == []


def test_the_command_crops_and_overwrites_only_with_force(tracked, tmp_path, capsys):
    out = tmp_path / "part.mcap"
    words = ["crop", str(tracked), "-o", str(out), "--start", "1", "--stop", "2"]
    assert main(words) == 0
    output = capsys.readouterr().out  # the last message is slightly before the end
    length = float(output.removeprefix(f"{out}: ").removesuffix(" s of tracked.mcap\n"))
    assert length == pytest.approx(1.0, abs=0.04)
    assert main(words) == 1
    assert "exists" in capsys.readouterr().err
    assert main([*words, "--force"]) == 0
