"""Raw samples as tables, and data sets that the official BIDS validator accepts."""

import csv
import json
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pyarrow.parquet as pq
import pytest

from tests.notices import raises
from tracker.base.errors import ConfigError, FileError
from tracker.messages import Estimate, Event, ImuSample
from tracker.session.export.options import ExportOptions
from tracker.session.export.run import export

Session = tuple[Path, list[ImuSample], list[Estimate]]


@pytest.fixture
def session(tmp_path: Path, record: Callable[..., Path], maker) -> Session:
    """0.6 s with packets, some of which lack one IMU, estimates and two notes."""
    messages = list(maker.stream(600, images=False))
    messages.append(Event(messages[0].t + 0.25, "note", "grasp\tnow"))
    path = record(tmp_path / "in.mcap", messages)
    packets = [m for m in messages if isinstance(m, ImuSample)]
    return path, packets, [m for m in messages if isinstance(m, Estimate)]


def test_raw_samples_have_three_clocks_and_units_in_their_header(
    session: Session, tmp_path: Path, session_info
) -> None:
    path, packets, _ = session
    export(path, "imu.csv", tmp_path / "o.csv")
    with (tmp_path / "o.csv").open() as file:
        rows = list(csv.DictReader(file))
    assert list(rows[0])[:4] == ["sampled [ns]", "arrived [ns]", "device [s]", "packet"]
    assert len(rows) == len(packets) and len(rows[0]) == 4 + 6 * len(session_info.glove.imus)
    name, k = session_info.glove.imu_names[1], 5
    assert float(rows[k][f"{name}_acc_y [m/s^2]"]) == pytest.approx(packets[k].accel[1, 1])
    assert float(rows[k][f"{name}_gyr_z [rad/s]"]) == pytest.approx(packets[k].gyro[1, 2])
    assert int(rows[k]["sampled [ns]"]) == session_info.anchor.wall(packets[k].t)
    assert int(rows[k]["arrived [ns]"]) == session_info.anchor.wall(packets[k].t_arrival)
    assert float(rows[k]["device [s]"]) == pytest.approx(packets[k].t_device, abs=1e-9)
    missing = session_info.glove.imu_names[2]
    assert not packets[3].valid[2] and rows[3][f"{missing}_gyr_x [rad/s]"] == ""


def test_raw_samples_in_pyarrow_to_the_last_bit(session: Session, tmp_path: Path) -> None:
    path, packets, _ = session
    options = ExportOptions(start=0.1, stop=0.2, anonymous=("time",))
    export(path, "imu.parquet", tmp_path / "o.parquet", options)
    table = pq.read_table(tmp_path / "o.parquet")
    assert table["packet"].to_pylist() == list(range(10, 21))
    assert table["sampled [ns]"][0].as_py() == pytest.approx(100_000_000, abs=1)
    column = np.array(table.column(4), float)
    assert np.array_equal(column, [p.accel[0, 0] for p in packets[10:21]])


def test_raw_samples_are_not_rotated_and_are_required(
    session: Session, tmp_path: Path, record: Callable[..., Path], maker
) -> None:
    with raises(ConfigError, "export.not_supported"):
        export(session[0], "imu.csv", tmp_path / "o.csv", ExportOptions(axes="unity"))
    without = record(tmp_path / "none.mcap", [maker.estimate(0)])
    with raises(FileError, "session.no_imu"):
        export(without, "imu.csv", tmp_path / "o.csv")


def test_a_data_set_contains_and_describes_its_values(
    session: Session, tmp_path: Path, session_info
) -> None:
    path, packets, estimates = session
    export(path, "bids", tmp_path / "set")
    stem = tmp_path / "set" / "sub-P07" / "motion" / "sub-P07_task-movement_tracksys-"
    for system in ("hand", "imu"):
        lines = (Path(f"{stem}{system}_channels.tsv")).read_text().splitlines()
        rows = (Path(f"{stem}{system}_motion.tsv")).read_text().splitlines()
        names = [line.split("\t")[0] for line in lines[1:]]
        said = json.loads(Path(f"{stem}{system}_motion.json").read_text())
        assert said["SamplingFrequency"] == pytest.approx(100)
        assert {len(r.split("\t")) for r in rows} == {len(names)} == {said["MotionChannelCount"]}
        if system == "hand":
            k = names.index("index_tip_POS_z")
            column = session_info.keypoint_names.index("index_tip")
            found, wanted = float(rows[7].split("\t")[k]), estimates[7].keypoints[column, 2]
            assert rows[15].split("\t")[names.index(f"{session_info.keypoint_names[3]}_POS_x")] == (
                "n/a"
            )
        else:
            k = names.index(f"{session_info.glove.imu_names[0]}_gyr_x")
            found, wanted = float(rows[7].split("\t")[k]), packets[7].gyro[0, 0]
        assert found == pytest.approx(wanted, rel=1e-8)
    events = (stem.parent / "sub-P07_task-movement_events.tsv").read_text().splitlines()
    assert events[1] == "0.250000\t0\tgrasp now"
    scans = (tmp_path / "set" / "sub-P07" / "sub-P07_scans.tsv").read_text()
    assert "2025-10-09T" in scans


def test_a_hole_is_part_of_the_duration(tmp_path: Path, record: Callable[..., Path], maker) -> None:
    messages = list(maker.stream(2000, images=False))
    start = messages[0].t
    held = [m for m in messages if not 0.5 < m.t - start < 1.5]
    export(record(tmp_path / "in.mcap", held), "bids", tmp_path / "set")
    motion = tmp_path / "set" / "sub-P07" / "motion"
    said = {
        system: json.loads(
            (motion / f"sub-P07_task-movement_tracksys-{system}_motion.json").read_text()
        )
        for system in ("hand", "imu")
    }
    length = max(m.t for m in held if isinstance(m, ImuSample)) - start + 0.01
    for system, rate in (("hand", 100.0), ("imu", 50.0)):
        assert said[system]["RecordingDuration"] == pytest.approx(length, abs=0.03), system
        effective = said[system]["SamplingFrequencyEffective"]
        assert effective == pytest.approx(rate, rel=0.05), system
        assert said[system]["SamplingFrequency"] == pytest.approx(100.0, rel=0.01)


@pytest.mark.long
def test_the_official_validator_finds_no_error(session: Session, tmp_path: Path) -> None:
    validator = shutil.which("bids-validator-deno", path=str(Path(sys.executable).parent))
    if validator is None:
        pytest.skip("bids-validator-deno is not installed")
    for name, options in (
        ("named", ExportOptions()),
        ("nameless", ExportOptions(anonymous=("participant", "notes", "time"))),
    ):
        export(session[0], "bids", tmp_path / name, options)
        done = subprocess.run(
            [validator, str(tmp_path / name), "--format", "json"],
            capture_output=True, text=True, timeout=120, check=False,
        )  # fmt: skip
        found = json.loads(done.stdout)
        errors = [i for i in found["issues"]["issues"] if i["severity"] == "error"]
        assert errors == [] and done.returncode == 0, errors
        assert found["summary"]["modalities"] == ["motion"]
    assert not list((tmp_path / "nameless").rglob("*P07*"))
