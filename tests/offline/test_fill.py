"""Gaps of a session are listed, filled in a new file, and marked as interpolated everywhere."""

from __future__ import annotations

import csv
import json
import shlex
import shutil
from pathlib import Path

import ezc3d
import numpy as np
import pytest

from tests.notices import raises, shows
from tracker.base.errors import ConfigError, FileError
from tracker.base.files import sha256
from tracker.cli import main
from tracker.messages import Estimate, Tracking, Validity
from tracker.offline.fill import Signature, fill
from tracker.offline.options import TrackOptions
from tracker.offline.simulate import SimulateOptions, simulate
from tracker.offline.track import track
from tracker.session.edits import parse_edits
from tracker.session.export.mcap import copy_extras
from tracker.session.export.series import EstimateSeries, recorded_series
from tracker.session.gaps.fill import FillOptions
from tracker.session.gaps.find import HOLE, session_gaps
from tracker.session.mcap.container import Copier, McapOutput
from tracker.session.mcap.ordering import ordered
from tracker.session.motion import measures, read_take
from tracker.session.reader import SessionReader
from tracker.session.verify import is_ok, verify

pytestmark = pytest.mark.long

CUTS = ((2.0, 2.17), (3.0, 3.32), (4.0, 4.12))  # s without estimates
SIGNED = Signature("Ada", "2026-01-02T03:04:05+00:00")


def without_estimates(source: Path, out: Path, cuts: tuple[tuple[float, float], ...]) -> Path:
    """A copy without the hand's messages in some intervals."""
    with SessionReader(source) as reader:
        made = McapOutput(out, sync=False)
        copy_extras(reader, made)
        copier = Copier(reader.source, made)
        for raw in ordered(reader.source):
            t = (raw.publish_time - reader.span_ns[0]) / 1e9
            mine = raw.topic.startswith("/hand/") or raw.topic == "/tf"
            if not (mine and any(a < t < b for a, b in cuts)):
                copier.copy(raw)
        made.finish()
    return out


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("fill")
    simulated, out = folder / "simulated.mcap", folder / "whole.mcap"
    simulate(simulated, SimulateOptions(seed=5, duration=5.0, fps=30, images=False))
    track(simulated, out, TrackOptions("chain", with_sensors=True))
    return out


@pytest.fixture(scope="module")
def cut(whole: Path) -> Path:
    return without_estimates(whole, whole.with_name("cut.mcap"), CUTS)


@pytest.fixture(scope="module")
def filled(cut: Path) -> Path:
    """All three holes."""
    out = cut.with_name("filled.mcap")
    report = fill(cut, out, FillOptions("cubic", max_gap=0.5), SIGNED)
    assert len(report.filled) == len(CUTS)
    return out


def series(path: Path) -> EstimateSeries:
    with SessionReader(path) as reader:
        return recorded_series(reader)


def in_gaps(path: Path, filled: Path) -> np.ndarray:
    """(N,) which estimates of ``path`` are within filled gaps."""
    with SessionReader(filled) as reader:
        (edit,) = reader.edits
    stamps = series(path).stamp_ns
    inside = [(stamps > f.start_ns) & (stamps < f.stop_ns) for f in edit.filled]
    return np.any(inside, axis=0)


def test_holes_are_listed_with_their_limits(cut: Path) -> None:
    holes = [gap for gap in session_gaps(cut) if gap.kind == HOLE]
    assert [gap.part for gap in holes] == ["hand"] * len(CUTS)
    for gap, (start, stop) in zip(holes, CUTS, strict=True):
        assert gap.start == pytest.approx(start, abs=0.011)
        assert gap.stop == pytest.approx(stop, abs=0.021)
        assert gap.fillable
        assert gap.cause == "not computed"  # packets and images exist


def test_fingertips_without_a_sensor_are_listed_as_such(cut: Path) -> None:
    unsensed = [gap for gap in session_gaps(cut) if gap.cause == "no sensor"]
    assert {"index_tip", "ring_tip", "little_tip"} <= {k for gap in unsensed for k in gap.keypoints}
    assert not any(gap.fillable for gap in unsensed)


def test_the_new_file_is_complete_and_differs_only_in_the_gaps(cut: Path, filled: Path) -> None:
    assert is_ok(verify(filled))
    before, after = series(cut), series(filled)
    outside = after.rows(np.flatnonzero(~in_gaps(filled, filled)))
    for name in ("stamp_ns", "keypoints", "q", "state", "sd", "angles", "angle_state", "segment_p"):
        a, b = getattr(before, name), getattr(outside, name)
        assert np.array_equal(a, b, equal_nan=a.dtype.kind == "f"), name
    assert len(after) - len(before) == pytest.approx(100 * sum(b - a for a, b in CUTS), abs=4)
    assert not [gap for gap in session_gaps(filled) if gap.kind == HOLE]


def test_the_source_is_never_modified(cut: Path, filled: Path, tmp_path: Path) -> None:
    with SessionReader(filled) as reader:
        (edit,) = reader.edits
    assert edit.source_sha256 == sha256(cut)
    with raises(FileError, "file.is_input"):
        fill(cut, cut, FillOptions(max_gap=0.5), SIGNED, force=True)
    out = tmp_path / "there.mcap"
    out.write_bytes(b"mine")
    with raises(FileError, "file.exists_force"):
        fill(cut, out, FillOptions(max_gap=0.5), SIGNED)
    assert out.read_bytes() == b"mine"


def test_filled_estimates_are_inferred_and_close_to_the_removed_ones(
    whole: Path, filled: Path
) -> None:
    made, truth = series(filled), series(whole)
    rows = np.flatnonzero(in_gaps(filled, filled))
    assert (made.state[rows] == Validity.INFERRED).all()
    assert (made.angle_state[rows] == Validity.INFERRED).all()
    at = np.array([np.abs(truth.stamp_ns - s).argmin() for s in made.stamp_ns[rows]])
    away = np.linalg.norm(made.keypoints[rows] - truth.keypoints[at], axis=2)
    assert away.mean() < 0.01  # m; the hand moves by about 5 cm in the longest one
    z = away / np.sqrt(3) / made.sd[rows]
    assert np.sqrt((z**2).mean()) < 1.5


def test_uncertainty_grows_towards_the_middle(filled: Path) -> None:
    made = series(filled)
    with SessionReader(filled) as reader:
        (edit,) = reader.edits
        tracking = {m.t: m.tracking for m in reader.messages((Estimate,))}  # type: ignore[union-attr]
        starts = [reader.anchor.monotonic(f.start_ns) for f in edit.filled]
        stops = [reader.anchor.monotonic(f.stop_ns) for f in edit.filled]
    longest = max(edit.filled, key=lambda one: one.length)
    sensed = [not n.startswith(("ring", "little")) for n in made.keypoint_names]  # eq. 62
    sd = made.sd[(made.stamp_ns > longest.start_ns) & (made.stamp_ns < longest.stop_ns)][:, sensed]
    assert (sd[len(sd) // 2] > sd[0]).all()
    assert (sd[len(sd) // 2] > sd[-1]).all()
    inside = [
        value
        for t, value in tracking.items()
        if any(a < t < b for a, b in zip(starts, stops, strict=True))
    ]
    assert set(inside) == {Tracking.COASTING}, "an interpolated hand does not count as tracked"


def test_each_export_marks_it_as_interpolated(filled: Path, tmp_path: Path) -> None:
    count = int(in_gaps(filled, filled).sum())
    for name in ("csv", "c3d"):
        assert (
            main(["export", str(filled), "--format", name, "-o", str(tmp_path / f"a.{name}")]) == 0
        )
    with (tmp_path / "a.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    for column in ("index_pip_state", "index_tip_state", "index_mcp_flexion_state"):
        assert sum(row[column] == "interpolated" for row in rows) == count, column
    data = json.loads((tmp_path / "a.csv.json").read_text())
    assert data["edits"][0]["who"] == "Ada"
    share = data["certainty"]["index_pip"]["interpolated"]
    assert share == pytest.approx(count / len(rows), abs=1e-5)
    points = ezc3d.c3d(str(tmp_path / "a.c3d"))
    column = points["parameters"]["POINT"]["LABELS"]["value"].index("index_pip")
    residual = points["data"]["meta_points"]["residuals"][0, column]
    made = series(filled)
    states = made.state[:, made.keypoint_names.index("index_pip")]
    inferred = (states == Validity.INFERRED).sum()
    assert inferred >= count
    assert (residual == 0).sum() == pytest.approx(inferred, abs=2)


def test_measures_count_it_as_inferred(filled: Path) -> None:
    with SessionReader(filled) as reader:
        found = measures(read_take(reader), [])[0]
    assert 0.05 < found.interpolated <= found.inferred


def test_info_verify_and_report_name_the_edit(
    filled: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["info", str(filled)]) == 0
    assert main(["verify", str(filled)]) == 0
    assert capsys.readouterr().out.count("3 gaps interpolated (cubic") == 2
    assert main(["report", str(filled), "-o", str(tmp_path / "r.html"), "--anonymous"]) == 0
    page = (tmp_path / "r.html").read_text()
    assert "3 gaps interpolated" in page
    assert "Ada" not in page


def test_tracking_again_drops_the_edit_and_reports_it(
    filled: Path, whole: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    out = tmp_path / "again.mcap"
    assert main(["track", str(filled), "-o", str(out)]) == 0
    assert shows(capsys.readouterr().out, "track.gaps_dropped", count=3, file="filled.mcap")
    again, first = series(out), series(whole)
    assert np.array_equal(again.keypoints, first.keypoints, equal_nan=True)
    with SessionReader(out) as reader:
        assert reader.edits == ()


def test_sensors_fill_a_gap_more_accurately_than_a_line(
    whole: Path, cut: Path, tmp_path: Path
) -> None:
    truth, errors = series(whole), {}
    for method in ("linear", "smooth"):
        out = tmp_path / f"{method}.mcap"
        fill(cut, out, FillOptions(method, max_gap=0.5), SIGNED)
        made = series(out)
        rows = np.flatnonzero(in_gaps(out, out))
        at = np.array([np.abs(truth.stamp_ns - s).argmin() for s in made.stamp_ns[rows]])
        away = np.linalg.norm(made.keypoints[rows] - truth.keypoints[at], axis=2)
        errors[method] = np.nanmean(away)
    assert errors["smooth"] < errors["linear"]


def test_a_second_edit_is_added_to_the_first(cut: Path, tmp_path: Path) -> None:
    short, both = tmp_path / "short.mcap", tmp_path / "both.mcap"
    assert len(fill(cut, short, FillOptions(max_gap=0.2), SIGNED).filled) == 2
    fill(short, both, FillOptions("cubic", max_gap=0.5), SIGNED)
    with SessionReader(both) as reader:
        assert [(e.method, len(e.filled)) for e in reader.edits] == [("linear", 2), ("cubic", 1)]


def test_only_listed_gaps_are_filled(cut: Path, tmp_path: Path) -> None:
    listed, out = tmp_path / "gaps.json", tmp_path / "one.mcap"
    assert main(["gaps", str(cut), "--json", str(listed)]) == 0
    data = json.loads(listed.read_text())["gaps"]
    one = [gap for gap in data if gap["kind"] == "hole"][:1]
    listed.write_text(json.dumps({"gaps": one}))
    words = ["fill", str(cut), "-o", str(out), "--gaps", str(listed), "--max-gap", "1"]
    assert main([*words, "--by", "Ada"]) == 0
    with SessionReader(out) as reader:
        ((only,),) = [edit.filled for edit in reader.edits]
    assert only.start_ns == one[0]["start_ns"]
    one[0]["start_ns"] += 1
    listed.write_text(json.dumps({"gaps": one}))
    assert main([*words, "--force"]) == 1, "not a gap of the session"


def test_commands_of_the_guide_fill_gaps(
    cut: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    shutil.copy(cut, tmp_path / "tracked.mcap")
    monkeypatch.chdir(tmp_path)
    assert main(shlex.split("gaps tracked.mcap --json gaps.json")) == 0
    lines = (
        "fill tracked.mcap -o filled.mcap --max-gap 0.2 --method cubic",
        'fill tracked.mcap -o some.mcap --gaps gaps.json --by "A. Miller"',
    )
    for line in lines:
        out = shlex.split(line)[3]
        assert main(shlex.split(line)) == 0
        with SessionReader(tmp_path / out) as reader:
            ((first, second),) = [edit.filled for edit in reader.edits]
        assert first.stop_ns < second.start_ns


def test_impossible_fills_are_rejected(cut: Path, whole: Path, tmp_path: Path) -> None:
    out = tmp_path / "none.mcap"
    with raises(FileError, "gaps.all_longer", max_gap_s=0.05):
        fill(cut, out, FillOptions(max_gap=0.05), SIGNED)
    with raises(FileError, "gaps.none_of_kind"):
        fill(whole, out, FillOptions(kinds=(HOLE,)), SIGNED)
    for wrong in (FillOptions("magic"), FillOptions(max_gap=0.0), FillOptions(kinds=("x",))):
        with pytest.raises(ConfigError):
            fill(cut, out, wrong, SIGNED)
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    "text", ["", "[]", '{"schema": 2, "edits": []}', '{"schema": 1}', "[" * 9999]
)
def test_an_invalid_record_of_edits_is_rejected(text: str) -> None:
    with raises(FileError, "edits.invalid", "edits.schema"):
        parse_edits(text, "edits.json")
