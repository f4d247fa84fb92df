"""Simulate, track, and track again, through files."""

import json
from pathlib import Path

import numpy as np
import pytest

from tests.notices import shows
from tracker.base.errors import FileError
from tracker.cli import main
from tracker.messages import Estimate, StereoFrame
from tracker.offline.options import TrackOptions
from tracker.offline.simulate import SimulateOptions, simulate
from tracker.offline.track import track
from tracker.session.compare import compare
from tracker.session.images import PackedFrame
from tracker.session.reader import SessionReader


@pytest.fixture(scope="module")
def session(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("sessions") / "in.mcap"
    simulate(path, SimulateOptions(seed=1, duration=6.0, fps=30, images=False))
    return path


def estimates(path: Path) -> list[Estimate]:
    with SessionReader(path) as reader:
        return [m for m in reader.messages((Estimate,)) if isinstance(m, Estimate)]


def images(path: Path) -> list[bytes]:
    with SessionReader(path) as reader:
        frames = reader.packed_messages((StereoFrame,))
        found = [p.data for f in frames if isinstance(f, PackedFrame) for p in f.parts.values()]
    assert len(found) > 50
    return found


def test_tracks_a_simulated_session(session: Path, tmp_path: Path) -> None:
    shares: list[float] = []
    report = track(session, tmp_path / "out.mcap", progress=shares.append)
    assert report.estimates == len(estimates(tmp_path / "out.mcap")) > 550
    assert report.duration_s == pytest.approx(6.0, abs=0.1)
    assert report.error_mm["mean"] < 8 and report.lost_s < 0.5
    assert shares == sorted(shares) and shares[-1] > 0.98
    with SessionReader(tmp_path / "out.mcap") as reader:
        assert reader.metadata["source"] == "in.mcap"
        assert len(reader.metadata["source_sha256"]) == 64


@pytest.mark.long
def test_tracking_twice_gives_the_same_bits(session: Path, tmp_path: Path) -> None:
    track(session, tmp_path / "a.mcap", TrackOptions(with_sensors=True))
    track(tmp_path / "a.mcap", tmp_path / "b.mcap")
    a, b = estimates(tmp_path / "a.mcap"), estimates(tmp_path / "b.mcap")
    assert len(a) == len(b)
    for x, y in zip(a, b, strict=True):
        assert np.array_equal(x.keypoints, y.keypoints, equal_nan=True)
        assert np.array_equal(x.angles, y.angles, equal_nan=True)


@pytest.mark.long
def test_another_engine_by_command_line(
    session: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "hybrid.mcap"
    assert main(["track", str(session), "-o", str(out), "--engine", "madgwick", "--json", "-"]) == 0
    report = json.loads(capsys.readouterr().out)
    assert report["error_mm"]["dorsum"] < 5 and report["frames"] > 170


@pytest.mark.long
def test_images_are_searched_if_there_are_no_blobs(tmp_path: Path) -> None:
    path = tmp_path / "images.mcap"
    simulate(path, SimulateOptions(seed=2, duration=2.0, fps=15))
    options = TrackOptions(colours="fabric-default", with_sensors=True)
    report = track(path, tmp_path / "out.mcap", options)
    assert report.error_mm["mean"] < 12 and report.frames > 25
    assert images(path) == images(tmp_path / "out.mcap"), "copied byte for byte"
    track(tmp_path / "out.mcap", tmp_path / "again.mcap", TrackOptions(with_sensors=True))
    assert images(path) == images(tmp_path / "again.mcap")
    assert compare(tmp_path / "out.mcap", tmp_path / "again.mcap")["identical"]


@pytest.mark.parametrize(
    ("arguments", "code", "values"),
    [
        (["--engine", "magic"], "part.unknown", {"name": "magic"}),
        (["--hand", "absent"], "library.unknown", {"name": "absent"}),
        (["--colours", "fabric-default"], "track.no_images", {}),
    ],
)
def test_impossible_arguments_are_reported(
    session: Path,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
    arguments: list[str],
    code: str,
    values: dict[str, object],
) -> None:
    out = tmp_path / "out.mcap"
    assert main(["track", str(session), "-o", str(out), *arguments]) == 1
    message = capsys.readouterr().err
    assert shows(message, code, **values) and "Traceback" not in message
    assert not out.exists(), "nothing half-made is left behind"


def test_never_overwrites(session: Path, tmp_path: Path) -> None:
    out = tmp_path / "out.mcap"
    out.write_text("precious")
    with pytest.raises(FileError):
        track(session, out)
    assert out.read_text() == "precious"
