"""An ordinary day: recordings of the application, with every command of the command line.

Recordings start in the middle of tracking (`tests.live_recordings`), so each one contains the
engine's state at that time.
"""

import json
from pathlib import Path

import numpy as np
import pytest

from tests.live_recordings import KINDS, LiveRecordings
from tracker.cli import main
from tracker.messages import Estimate
from tracker.session.compare import compare
from tracker.session.reader import SessionReader

pytestmark = pytest.mark.timeout(600)

SPAN = ("--start", "0.5", "--stop", "2")  # s, of the recording
FORMATS = (
    *("csv", "c3d", "trc", "bvh", "glb", "h5", "isaac", "bids", "lerobot", "sto", "imu.csv"),
)


@pytest.fixture(
    params=[
        "one hand",
        *(pytest.param(k, marks=pytest.mark.long) for k in KINDS if k != "one hand"),
    ]
)
def kind(request: pytest.FixtureRequest) -> str:
    return str(request.param)


@pytest.fixture
def recording(live_recordings: LiveRecordings, kind: str) -> Path:
    return live_recordings.path(kind)


@pytest.fixture
def one_hand(live_recordings: LiveRecordings) -> Path:
    return live_recordings.path("one hand")


def run(*words: str | Path) -> None:
    assert main([str(w) for w in words]) == 0, words


def assert_identical(a: Path, b: Path) -> None:
    """Both files have bit-identical estimates at the same times."""
    found = compare(a, b)
    assert found["identical"], found


def sides(path: Path) -> tuple[str, ...]:
    """For a session of both hands; for one hand its name for the reader."""
    with SessionReader(path) as reader:
        return reader.sides or (reader.info.side,)


def estimates(path: Path, side: str | None = None) -> dict[float, np.ndarray]:
    """Keypoints (K, 3) m at the times of the estimates."""
    with SessionReader(path, side=side) as reader:
        return {m.t: m.keypoints for m in reader.messages((Estimate,)) if isinstance(m, Estimate)}


def n_estimates(path: Path) -> int:
    return len(estimates(path))


def test_a_recording_is_complete_and_tracked_again_bit_for_bit(
    recording: Path, tmp_path: Path
) -> None:
    run("info", recording)
    run("verify", recording)
    again, third = tmp_path / "again.mcap", tmp_path / "third.mcap"
    run("track", recording, "-o", again, "--with-sensors")
    assert n_estimates(recording) > 20  # a loaded computer estimates the last seconds later
    assert_identical(recording, again)
    run("track", again, "-o", third)
    assert_identical(again, third)


def test_a_part_of_a_recording_is_tracked_again(recording: Path, tmp_path: Path) -> None:
    part = tmp_path / "part.mcap"
    run("crop", recording, "-o", part, *SPAN)
    run("track", part, "-o", tmp_path / "again.mcap")
    assert_identical(part, tmp_path / "again.mcap")


def test_a_recovered_part_of_a_recording_is_tracked_again(recording: Path, tmp_path: Path) -> None:
    """Estimates of the last moments may be lost where packets are not, or images."""
    cut, whole = tmp_path / "cut.mcap", tmp_path / "whole.mcap"
    data = recording.read_bytes()
    cut.write_bytes(data[: len(data) * 6 // 10])
    run("recover", cut, "-o", whole)
    run("track", whole, "-o", tmp_path / "again.mcap")
    for side in sides(whole):
        one, other = (estimates(p, side) for p in (whole, tmp_path / "again.mcap"))
        both = sorted(one.keys() & other.keys())
        assert len(both) > 10 and len(both) >= 0.95 * len(one)
        for t in both[: len(both) // 2]:
            np.testing.assert_array_equal(one[t], other[t])


@pytest.mark.long
@pytest.mark.parametrize("engine", ["vist", "switching", "inertial"])
def test_another_engine_tracks_it(one_hand: Path, tmp_path: Path, engine: str) -> None:
    run("track", one_hand, "-o", tmp_path / "other.mcap", "--engine", engine)
    assert n_estimates(tmp_path / "other.mcap") == pytest.approx(n_estimates(one_hand), rel=0.05)


def test_it_is_smoothed(one_hand: Path, tmp_path: Path) -> None:
    run("track", one_hand, "-o", tmp_path / "smooth.mcap", "--smooth")
    assert n_estimates(tmp_path / "smooth.mcap") > 20


@pytest.mark.long
def test_its_colours_and_its_light_are_reported(one_hand: Path) -> None:
    run("colours", "check", one_hand)
    run("light", one_hand)


@pytest.mark.parametrize("name", FORMATS)
def test_it_is_exported(one_hand: Path, tmp_path: Path, name: str) -> None:
    out = tmp_path / f"out.{name}"
    run("export", one_hand, "--format", name, "-o", out)
    written = [p for p in tmp_path.rglob("*") if p.is_file()]
    assert written and all(p.stat().st_size for p in written)


@pytest.mark.long
def test_both_hands_are_exported(live_recordings: LiveRecordings, tmp_path: Path) -> None:
    run("export", live_recordings.path("both hands"), "--format", "csv", "-o", tmp_path / "b.csv")
    assert len(list(tmp_path.glob("*.csv"))) == 2


def test_it_is_reported_and_evaluated(
    recording: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    run("report", recording, "-o", tmp_path / "report.html")
    assert "<html" in (tmp_path / "report.html").read_text("utf-8")
    capsys.readouterr()
    run("verify", recording, "--json", "-")
    assert json.loads(capsys.readouterr().out)
