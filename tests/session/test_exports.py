"""Every export, opened by an independent library."""

import csv
import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import h5py
import numpy as np
import pyarrow.parquet as pq
import pytest

from tests.notices import raises
from tracker.base.errors import ConfigError, FileError
from tracker.cli import main
from tracker.messages import Estimate, ImuSample
from tracker.session.export.axes import AXES
from tracker.session.export.formats import FORMATS
from tracker.session.export.load import load_series
from tracker.session.export.options import ExportOptions
from tracker.session.export.run import export
from tracker.session.reader import SessionReader

Y_UP = AXES["y-up"].rows


@pytest.fixture
def tracked(tmp_path: Path, record: Callable[..., Path], maker) -> tuple[Path, list[Estimate]]:
    """Thirty random poses at 100 Hz, the thumb's keypoint 3 and angle 2 lost in some."""
    estimates = [maker.estimate(10.0 * k, lost=k % 10 > 7) for k in range(30)]
    return record(tmp_path / "in.mcap", estimates), estimates


def test_csv_has_the_columns_and_empty_cells(tracked, tmp_path: Path, session_info) -> None:
    path, estimates = tracked
    export(path, "csv", tmp_path / "o.csv")
    with (tmp_path / "o.csv").open() as file:
        rows = list(csv.DictReader(file))
    wrist = [f"wrist_{c}" for c in ("x", "y", "z", "qx", "qy", "qz", "qw", "sd", "state")]
    assert list(rows[0])[:10] == ["t", *wrist]
    last = session_info.hand.joint_names[-1]
    assert list(rows[0])[-2:] == [last, f"{last}_state"]
    assert [float(rows[4][c]) for c in wrist[3:7]] == pytest.approx(estimates[4].keypoint_q[0])
    assert float(rows[4]["wrist_sd"]) == pytest.approx(estimates[4].keypoint_sd[0], rel=1e-8)
    name, angle = session_info.keypoint_names[3], session_info.hand.joint_names[2]
    assert rows[8][f"{name}_x"] == rows[8][angle] == ""
    assert rows[8][f"{name}_state"] == rows[8][f"{angle}_state"] == "lost"
    assert rows[8][f"{name}_sd"] == "" and rows[7][f"{angle}_state"] == "inferred"
    assert rows[0]["t"] == "1760000000.123457"
    assert float(rows[7]["wrist_y"]) == pytest.approx(estimates[7].keypoints[0, 1], rel=1e-8)
    assert float(rows[7][angle]) == pytest.approx(estimates[7].angles[2], rel=1e-8)


def test_parquet_in_pyarrow(tracked, tmp_path: Path, session_info) -> None:
    path, estimates = tracked
    export(path, "parquet", tmp_path / "o.parquet")
    table = pq.read_table(tmp_path / "o.parquet")
    name = session_info.keypoint_names[3]
    assert table[f"{name}_x"].null_count == 6
    assert table["wrist_z"][4].as_py() == estimates[4].keypoints[0, 2]
    assert table[f"{name}_state"][8].as_py() == "lost"
    assert table["wrist_qw"][4].as_py() == estimates[4].keypoint_q[0, 3]
    column_info = table.schema.metadata
    assert (
        column_info[b"axes"] == b"x forward, y left, z up" and column_info[b"length_unit"] == b"m"
    )


def test_hdf5_in_h5py(tracked, tmp_path: Path) -> None:
    path, estimates = tracked
    export(path, "h5", tmp_path / "o.h5", ExportOptions(units="mm"))
    with h5py.File(tmp_path / "o.h5") as file:
        position = file["keypoints/position"]
        assert position.attrs["unit"] == "mm"
        assert np.allclose(position[5], estimates[5].keypoints * 1000)
        assert np.isnan(position[8, 3]).all()
        assert np.array_equal(file["joints/angle"][5], estimates[5].angles)
        assert np.allclose(file["keypoints/sd"][5], estimates[5].keypoint_sd * 1000)
        assert file.attrs["axes"] == "x forward, y left, z up"


def test_resampling_keeps_a_sine(tmp_path: Path, record: Callable[..., Path], maker) -> None:
    base = maker.estimate(0)
    at = np.cumsum(np.r_[0, np.random.default_rng(5).uniform(9, 11, 199)])  # uneven ms
    rows = [
        replace(
            maker.estimate(float(ms)),
            keypoints=base.keypoints + 0.05 * np.sin(2 * np.pi * ms / 1000),
        )
        for ms in at
    ]
    path = record(tmp_path / "in.mcap", rows)
    with SessionReader(path) as reader:
        for rate, tolerance in ((240.0, 2e-5), (50.0, 5e-4)):
            m = load_series(reader, ExportOptions(rate=rate))
            assert np.allclose(np.diff(m.elapsed), 1 / rate, atol=1e-8)
            wanted = 0.05 * np.sin(2 * np.pi * m.elapsed)
            inner = slice(20, -20)  # the low-pass filter has fewer samples at the ends
            assert (
                np.abs(m.keypoints[inner, 0, 0] - base.keypoints[0, 0] - wanted[inner]).max()
                < tolerance
            )


def test_resampling_never_bridges_lost_rows(tracked) -> None:
    path, _ = tracked
    with SessionReader(path) as reader:
        m = load_series(reader, ExportOptions(rate=250.0))
    between = (m.elapsed > 0.0701) & (m.elapsed < 0.0999)
    assert np.isnan(m.keypoints[between, 3]).all()
    assert np.isfinite(m.keypoints[between, 4]).all()


def test_options_cut_pick_and_anonymise(tracked, tmp_path: Path) -> None:
    path, _ = tracked
    options = ExportOptions(
        start=0.1, stop=0.2, joints=("wrist", "index_mcp_flexion"), anonymous=("participant",)
    )
    report = export(path, "csv", tmp_path / "o.csv", options)
    beside = json.loads((tmp_path / "o.csv.json").read_text())
    assert beside == json.loads(json.dumps(report))
    assert (beside["rows"], beside["keypoints"]) == (11, ["wrist"])
    assert "participant" not in beside["metadata"]
    assert "P 07" not in (tmp_path / "o.csv.json").read_text()
    with raises(ConfigError, "session.no_joint"):
        export(path, "csv", tmp_path / "no.csv", ExportOptions(joints=("nose",)))


def test_a_session_without_estimates_is_reported(tmp_path: Path, record, maker) -> None:
    path = record(tmp_path / "in.mcap", [maker.imu(0)])
    with raises(FileError, "session.not_tracked"):
        export(path, "csv", tmp_path / "o.csv")
    assert not list(tmp_path.glob("*o.csv*"))
    assert not list(tmp_path.glob(".o*"))


def test_the_command_exports(tracked, tmp_path: Path) -> None:
    path, _ = tracked
    out = tmp_path / "o.mot"
    assert main(["export", str(path), "--format", "mot", "-o", str(out), "--rate", "50"]) == 0
    assert "nRows=15" in out.read_text()
    assert main(["export", str(path), "--format", "csv", "-o", str(tmp_path / "no" / "o.csv")]) == 1
    assert "mp4" in FORMATS.names()


def test_foreign_sessions_are_grouped_by_time(tmp_path: Path, session_info, maker) -> None:
    """Topics of another program: no packets, no metadata, timestamps that differ by IMU, late
    arrival."""
    from tracker.session.mcap.container import McapOutput
    from tracker.session.ros import sensors, topics

    out = McapOutput(tmp_path / "f.mcap", "zstd", sync=False)
    for name, text in session_info.attachments().items():
        out.attach(name, text, 0)
    samples = [maker.imu(10.0 * k, missing=3 if k == 20 else None) for k in range(50)]
    queue = []
    for k, s in enumerate(samples):
        for i, name in enumerate(session_info.glove.imu_names):
            stamp = session_info.anchor.wall(s.t) + i * 400_000
            if s.valid[i]:
                queue.append((stamp + 1_000_000 + (i == 5) * 24_000_000, k, i, name, stamp))
    for log, k, i, name, stamp in sorted(queue):
        data = sensors.pack_imu(
            sensors.ImuMessage(stamp, "x", samples[k].gyro[i], samples[k].accel[i])
        )
        out.write(out.channel(topics.imu("right", name), sensors.IMU), log, stamp, data, 0)
    out.finish()
    with SessionReader(tmp_path / "f.mcap") as reader:
        found = list(reader.messages([ImuSample]))
    assert len(found) == 50
    for a, b in zip(found, samples, strict=True):
        assert np.array_equal(a.accel, b.accel, equal_nan=True)
    assert not found[20].valid[3]
    steps = np.diff([m.t for m in found])
    assert np.all(steps > 0)
