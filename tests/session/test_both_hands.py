"""A session of both hands: written, read, tracked again, exported."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import numpy as np
import pytest

from extensions.conformance.run import read_records, read_take
from extensions.movement.report.measure import measure_hands
from tests.simulated_sessions import BOTH, SimulatedSessions
from tracker.cli import main
from tracker.glove.mirror import OTHER
from tracker.messages import BlobFrame, Estimate, ImuSample, StereoFrame
from tracker.offline.crop import crop
from tracker.offline.options import TrackOptions
from tracker.offline.simulate import SimulateOptions, build_both, simulate
from tracker.offline.track import track
from tracker.session.compare import compare, truth_error_mm
from tracker.session.reader import SessionReader
from tracker.session.verify import is_ok, verify

pytestmark = pytest.mark.long

OPTIONS = BOTH


@pytest.fixture(scope="module")
def recorded(simulated_sessions: SimulatedSessions) -> Path:
    return simulated_sessions.simulated(OPTIONS)


@pytest.fixture(scope="module")
def tracked(recorded: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("both") / "tracked.mcap"
    report = track(recorded, path, TrackOptions(with_sensors=True))
    assert set(report.hands) == {"left", "right"}
    assert all(hand.error_mm["mean"] < 15 for hand in report.hands.values())
    return path


def test_each_hand_is_read_with_its_own_glove(recorded: Path) -> None:
    for side in ("left", "right"):
        with SessionReader(recorded, side=side) as reader:
            assert reader.sides == ("left", "right")
            assert reader.info.side == reader.info.hand.side == side
            assert [other.side for other in reader.info.others] == [OTHER[side]]
            assert {"hand_left.toml", "glove_right.toml"} <= reader.attachments.keys()


def test_each_hand_is_read_bit_for_bit_as_written(recorded: Path) -> None:
    sim, _ = build_both(OPTIONS)
    sent = list(sim.messages())
    for side in ("left", "right"):
        with SessionReader(recorded, side=side) as reader:
            read = list(reader.messages((ImuSample, BlobFrame)))
        mine = [m.message for m in sent if m.side in (side, "")]
        assert [m.t for m in read] == [m.t for m in mine]
        for a, b in zip(read, mine, strict=True):
            if isinstance(a, ImuSample) and isinstance(b, ImuSample):
                assert a.gyro.tobytes() == b.gyro.tobytes()
            elif isinstance(a, BlobFrame) and isinstance(b, BlobFrame):
                assert a.left is not None and b.left is not None
                assert a.left.uv.tobytes() == b.left.uv.tobytes()
                assert [a.hue_names[h] for h in a.left.hue] == [b.hue_names[h] for h in b.left.hue]


def test_the_file_is_complete(recorded: Path, tracked: Path) -> None:
    for path in (recorded, tracked):
        findings = verify(path)
        assert is_ok(findings) and not findings


def test_isaacs_record_and_the_verdict_have_both_hands(tracked: Path, tmp_path: Path) -> None:
    out = tmp_path / "both.mcap"
    assert main(["export", str(tracked), "--format", "isaac", "-o", str(out)]) == 0
    records: dict[str, list[int]] = {"left": [], "right": []}
    for side, record in read_records(out):
        records[side].append(record.stamps.sample)
    takes, _ = read_take(tracked)
    assert {take.side: take.sample.tolist() for take in takes} == records
    assert all(len(stamps) > 150 for stamps in records.values())
    order = [r.stamps.available for _, r in read_records(out)]
    assert order == sorted(order)


def test_both_hands_are_tracked_again_bit_for_bit(tracked: Path, tmp_path: Path) -> None:
    again = tmp_path / "again.mcap"
    track(tracked, again)
    found = compare(tracked, again)
    assert found["identical"] and set(found["hands"]) == {"left", "right"}
    assert all(hand["identical"] and hand["compared"] > 100 for hand in found["hands"].values())


def test_each_hand_is_at_its_true_position(recorded: Path, tracked: Path) -> None:
    """Not at that of the other, 18 cm away."""
    error = truth_error_mm(tracked, recorded)
    assert np.nanmean(list(error.values())) < 15
    with SessionReader(tracked, side="left") as reader, SessionReader(recorded, side="left") as was:
        last = [m for m in reader.messages((Estimate,)) if isinstance(m, Estimate)][-1]
        true = list(was.truth())[-1]
    assert np.linalg.norm(last.keypoints[0] - true.keypoints[0]) < 0.03


def test_a_format_of_one_hand_gives_a_file_for_each(tracked: Path, tmp_path: Path) -> None:
    out = tmp_path / "out.csv"
    assert main(["export", str(tracked), "--format", "csv", "-o", str(out)]) == 0
    assert not out.exists()
    rows = {}
    for side in ("left", "right"):
        path = tmp_path / f"out_{side}.csv"
        data = json.loads((tmp_path / f"out_{side}.csv.json").read_text())
        assert data["glove"].endswith("left") == (side == "left")
        with path.open() as file:
            rows[side] = sum(1 for _ in csv.reader(line for line in file if line[0] != "#"))
    assert rows["left"] > 100 and rows["right"] > 100


def test_a_report_contains_each_hand(tracked: Path) -> None:
    measures = measure_hands(tracked)
    assert [(one.side, one.name) for one in measures] == [
        ("left", "tracked left"),
        ("right", "tracked right"),
    ]
    bends = [one.row("index_mcp_flexion") for one in measures]
    assert bends[0] is not None and bends[1] is not None
    assert bends[0].measure.greatest != bends[1].measure.greatest


def test_a_session_is_copied_with_both_hands(tracked: Path, tmp_path: Path) -> None:
    out = tmp_path / "copy.mcap"
    assert main(["export", str(tracked), "--format", "mcap", "-o", str(out)]) == 0
    with SessionReader(out) as copy, SessionReader(tracked) as original:
        assert copy.sides == original.sides
        assert copy.topic_names == original.topic_names


def test_a_part_is_tracked_to_the_same_bits(tracked: Path, tmp_path: Path) -> None:
    part, again = tmp_path / "part.mcap", tmp_path / "part_again.mcap"
    assert main(["crop", str(tracked), "-o", str(part), "--start", "1.5"]) == 0
    track(part, again)
    assert compare(part, again)["identical"]


def test_images_show_both_hands_and_are_tracked(tmp_path: Path) -> None:
    path = tmp_path / "images.mcap"
    simulate(path, SimulateOptions(hands="both", seed=3, duration=1.5, fps=15.0))
    with SessionReader(path) as reader:
        frames = [m for m in reader.messages((StereoFrame,)) if isinstance(m, StereoFrame)]
    image = frames[len(frames) // 2].left
    assert image is not None
    # the hands are on different halves of the image at the start: saturated fabric on both
    strong = image.max(axis=2).astype(int) - image.min(axis=2) > 90
    assert strong[:, :640].sum() > 1000 and strong[:, 640:].sum() > 1000
    report = track(path, tmp_path / "tracked.mcap")
    assert all(hand.error_mm["mean"] < 15 for hand in report.hands.values())


def test_each_hand_is_compared(tracked: Path, recorded: Path, tmp_path: Path) -> None:
    found = compare(tracked, tracked, tmp_path / "o.png")
    assert found["identical"] and set(found["hands"]) == {"left", "right"}
    assert found["compared"] == sum(h["compared"] for h in found["hands"].values())
    other = tmp_path / "other.mcap"
    track(recorded, other, TrackOptions("vist"))
    apart = compare(tracked, other)
    assert not apart["identical"]
    assert all(0.1 < hand["mean_mm"] < 30 for hand in apart["hands"].values())
    assert apart["max_mm"] == max(h["max_mm"] for h in apart["hands"].values())


def test_a_part_is_as_accurate_as_the_whole_at_the_same_times(
    recorded: Path, tracked: Path, tmp_path: Path
) -> None:
    part = tmp_path / "part.mcap"
    crop(tracked, part, start=1.0)
    whole = truth_error_mm(tracked, recorded, also_in=part)
    assert whole == pytest.approx(truth_error_mm(part, recorded, also_in=tracked))
    assert whole != pytest.approx(truth_error_mm(tracked, recorded))
