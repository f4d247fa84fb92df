"""Two recordings of one movement are aligned, by clocks or by the motion of the hand."""

import json
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from tests.made_once import made_once
from tests.notices import raises
from tracker.base.errors import FileError
from tracker.cli import main
from tracker.messages import Estimate, ImuSample
from tracker.offline.simulate import SimulateOptions, simulate
from tracker.offline.track import track
from tracker.session.align import SpeedCourse, align, best_match, course_of_angles, read_alignment
from tracker.session.compare import compare
from tracker.session.reader import SessionReader
from tracker.session.writer import SessionRecorder

pytestmark = pytest.mark.long

LATE = 1.37  # s from the start of the first to that of the second
CLOCK = 4.219  # s by which the second's clock is ahead


@pytest.fixture(scope="module")
def takes(shared_folder: Path) -> tuple[Path, Path]:
    """A tracked take, and a part of it as if recorded by another computer."""
    folder = made_once(shared_folder / "align", make_takes)
    return folder / "both.mcap", folder / "b.mcap"


def make_takes(folder: Path) -> None:
    simulate(folder / "in.mcap", SimulateOptions(images=False, duration=6.0, fps=30, seed=4))
    track(folder / "in.mcap", folder / "a.mcap")
    with SessionReader(folder / "in.mcap") as reader:
        imus = [m for m in reader.messages([ImuSample]) if isinstance(m, ImuSample)]
    with SessionReader(folder / "a.mcap") as reader:
        found = [m for m in reader.messages([Estimate]) if isinstance(m, Estimate)]
        info = reader.info
    ahead = replace(info.anchor, wall_ns=info.anchor.wall_ns + round(CLOCK * 1e9))
    start = imus[0].t + LATE
    for name, about, since in (("both", info, 0.0), ("b", replace(info, anchor=ahead), start)):
        with SessionRecorder(folder / f"{name}.mcap", about) as recorder:
            for m in sorted([*imus, *found], key=lambda m: m.t):
                if m.t >= since:
                    recorder.write(m)


def test_alignment_by_motion_finds_the_offset_of_the_clocks(takes: tuple[Path, Path]) -> None:
    found = align(*takes)
    assert found.offset_s == pytest.approx(LATE, abs=0.015)
    assert found.clocks_differ_s == pytest.approx(-CLOCK, abs=0.005)
    assert found.correlation is not None and found.correlation > 0.95


def test_alignment_by_clock_uses_the_computers_times(takes: tuple[Path, Path]) -> None:
    found = align(*takes, by="clock")
    assert found.offset_s == pytest.approx(LATE + CLOCK, abs=0.011) and found.clocks_differ_s == 0


def test_an_alignment_is_stored_and_compared(
    takes: tuple[Path, Path], tmp_path: Path, capsys: pytest.CaptureFixture
) -> None:
    alignment, picture = tmp_path / "o.json", tmp_path / "o.png"
    words = ["align", *map(str, takes), "-o", str(alignment), "--figure", str(picture)]
    assert main(words) == 0
    assert "by movement, correlation" in capsys.readouterr().out
    assert cv2.imread(str(picture)) is not None
    assert main(words) == 1, "nothing is written over"
    assert read_alignment(alignment).clocks_differ_s == pytest.approx(-CLOCK, abs=0.005)
    words = ["compare", *map(str, takes), "--json", "-"]
    assert main([*words, "--align", str(alignment)]) == 0
    data = json.loads(capsys.readouterr().out)
    assert data["compared"] > 400 and data["rms_deg"] < 0.5 and data["mean_mm"] < 1.0
    assert compare(*takes)["rms_deg"] > 5, "by their own clocks they do not fit"
    alignment.write_text('{"offset_s": "x"}')
    with raises(FileError, "align.not_alignment"):
        read_alignment(alignment)


def swings(seed: int, n: int, start: float = 0.0) -> SpeedCourse:
    """Speed of an aperiodic movement, seen from ``start`` on."""
    rng = np.random.default_rng(seed)
    t = np.arange(n) / 100
    waves = rng.uniform(0.2, 2.0, (12, 1)), rng.uniform(0, 7, (12, 1))
    angles = np.sin(2 * np.pi * waves[0] * (t + start) + waves[1])
    return course_of_angles(0, t, angles.T)


@pytest.mark.parametrize("offset", [-3.204, 0.0, 7.5])
def test_offsets_before_and_after_the_start_are_found_to_milliseconds(offset: float) -> None:
    found = best_match(swings(1, 2000, 10.0), swings(1, 1500, 10.0 + offset))
    assert found.offset == pytest.approx(offset, abs=0.003)


def test_a_different_movement_is_not_aligned() -> None:
    with raises(FileError, "align.no_fit"):
        best_match(swings(1, 2000), swings(2, 2000))


def test_a_periodic_movement_gives_no_offset() -> None:
    t = np.arange(3000) / 100
    even = course_of_angles(0, t, np.sin(2 * np.pi * t)[:, None] + 0 * t[:, None])
    with raises(FileError, "align.ambiguous"):
        best_match(even, replace(even, t=t[:2000], speed=even.speed[:2000]))


def test_holes_are_ignored() -> None:
    a, b = swings(3, 2000), swings(3, 2000, 2.0)
    b.speed[500:900] = np.nan
    assert best_match(a, b).offset == pytest.approx(2.0, abs=0.005)
