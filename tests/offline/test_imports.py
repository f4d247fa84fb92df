"""Raw IMU data of other programs become sessions with the files' contents, which can be tracked."""

import os
import time
import tracemalloc
from pathlib import Path

import numpy as np
import pytest
from scipy.io import loadmat, savemat
from scipy.spatial.transform import Rotation

from tests.notices import raises, shows
from tracker.base.errors import ConfigError, FileError
from tracker.cli import main
from tracker.messages import Estimate
from tracker.offline.imports.run import ImportOptions, at_instants, import_imus
from tracker.offline.simulate import SimulateOptions, simulate
from tracker.offline.track import track
from tracker.session.export.run import export
from tracker.session.raw_imu import RawImu, read_raw_imu
from tracker.session.reader import SessionReader
from tracker.session.verify import is_ok, verify

XIMU3 = (
    "Gyroscope X (deg/s),Gyroscope Y (deg/s),Gyroscope Z (deg/s),"
    "Accelerometer X (g),Accelerometer Y (g),Accelerometer Z (g)"
)
START_S = 37  # three seconds before the trial's movement begins
G, DEG = 9.80665, np.pi / 180


def raw(path: Path) -> RawImu:
    with SessionReader(path) as reader:
        return read_raw_imu(reader)


def x_imu3(folder: Path, name: str, t_us: np.ndarray, rows: np.ndarray) -> Path:
    """A device's folder as written by the x-IMU3 program."""
    path = folder / name / "Inertial.csv"
    path.parent.mkdir(parents=True)
    lines = [f"{t}," + ",".join(f"{v:.6f}" for v in row) for t, row in zip(t_us, rows, strict=True)]
    path.write_text(f"Timestamp (us),{XIMU3}\n" + "\n".join(lines) + "\n")
    return path


def test_folders_of_x_imu3_become_one_session(tmp_path: Path) -> None:
    """Two devices on one clock, not synchronised; units and time of day as in the files."""
    began = 1_700_000_000_000_000
    t = np.arange(0, 2_000_000, 10_000)
    wave = np.sin(t / 3e5)[:, None]
    one = np.hstack([90 * wave, 0 * wave, 0 * wave, 0 * wave, 0 * wave, 1 + 0 * wave])
    other = np.hstack([0 * wave, 45 * wave, 0 * wave, 0 * wave, 1 + 0 * wave, 0 * wave])
    folder = tmp_path / "log"
    x_imu3(folder, "hand", began + t, one)
    x_imu3(folder, "finger", began + 4_000 + t, other)
    imus = {"dorsum": "hand", "index_proximal": "finger"}
    report = import_imus([folder], tmp_path / "a.mcap", ImportOptions(imus=imus))
    found = raw(tmp_path / "a.mcap")
    assert is_ok(verify(tmp_path / "a.mcap"))
    assert report["doubts"] == [] and report["rate_hz"] == pytest.approx(100)
    elapsed = (found.stamp_ns - began * 1000) / 1e3  # us
    assert 3_999 < elapsed[0] < 10_001 and len(found) >= 198
    rows = [found.names.index(n) for n in imus]
    assert np.allclose(found.gyro[:, rows[0], 0], 90 * DEG * np.sin(elapsed / 3e5), atol=1e-3)
    late = np.sin((elapsed - 4_000) / 3e5)
    assert np.allclose(found.gyro[:, rows[1], 1], 45 * DEG * late, atol=1e-3)
    assert np.allclose(found.accel[:, rows], [[0, 0, G], [0, G, 0]], atol=1e-5)
    assert found.valid.sum(axis=0).tolist() == [len(found) if n in imus else 0 for n in found.names]


def test_seconds_of_newer_files_and_a_file_for_the_only_imu(tmp_path: Path) -> None:
    path = tmp_path / "wrist.csv"
    lines = [f"{k / 50:.3f},0,0,180,0,0,1" for k in range(60)]
    path.write_text(f"Time (s),{XIMU3}\n" + "\n".join(lines) + "\n")
    os.utime(path, ns=(0, 1_700_000_059 * 10**9))
    report = import_imus([path], tmp_path / "a.mcap")
    found = raw(tmp_path / "a.mcap")
    assert report["imus"] == {"dorsum": "wrist"} and len(found) == 60
    assert np.allclose(found.gyro[:, 0, 2], np.pi)
    # no time of day is given: the file's last modification was its end
    assert found.stamp_ns[-1] == pytest.approx(1_700_000_059 * 10**9, abs=10**6)


@pytest.mark.long
def test_our_exports_are_imported_without_loss(tmp_path: Path) -> None:
    """All sensors and all three clocks."""
    simulate(tmp_path / "in.mcap", SimulateOptions(images=False, duration=2.0))
    export(tmp_path / "in.mcap", "imu.csv", tmp_path / "a.csv")
    import_imus([tmp_path / "a.csv"], tmp_path / "back.mcap")
    export(tmp_path / "back.mcap", "imu.csv", tmp_path / "b.csv")
    assert (tmp_path / "a.csv").read_bytes() == (tmp_path / "b.csv").read_bytes()


def test_a_hole_is_not_filled(tmp_path: Path) -> None:
    path = tmp_path / "a.csv"
    lines = [f"{k * 10},{k},0,0,0,0,1" for k in range(200) if not 50 < k < 80]
    path.write_text(f"Time (ms),{XIMU3}\n" + "\n".join(lines) + "\n")
    import_imus([path], tmp_path / "a.mcap")
    assert len(raw(tmp_path / "a.mcap")) == 171
    old, values = np.array([0.0, 0.01, 0.2, 0.21]), np.arange(12.0).reshape(4, 3)
    found = at_instants(old, values, np.array([0.005, 0.1, 0.205]))
    assert np.allclose(found[[0, 2], 0], [1.5, 7.5]) and np.isnan(found[1]).all()


BROKEN = [
    ("import.not_number", f"Time (s),{XIMU3}\n0,1,2,3,4,5,6\n1,x,2,3,4,5,6\n"),
    ("import.cells", f"Time (s),{XIMU3}\n0,1,2,3,4,5,6\n1,2\n"),
    ("import.no_time_column", f"Packet number,{XIMU3}\n0,1,2,3,4,5,6\n1,1,2,3,4,5,6\n"),
    ("import.no_imu_column", "Time (s),Heart (bpm)\n0,1\n1,2\n"),
    ("import.unknown_unit", "Time (s),Gyroscope X (rpm)\n0,1\n1,2\n"),
    ("import.no_times", f"Time (s),{XIMU3}\n0,1,2,3,4,5,6\n"),
    ("import.no_times", f"Time (s),{XIMU3}\n1,1,2,3,4,5,6\n1,1,2,3,4,5,6\n"),
    ("import.no_time_column", ""),
    ("import.no_time_column", "\x00\x01\x02"),
    ("import.no_sample", f"Time (s),{XIMU3}\nnan,1,2,3,4,5,6\ninf,1,2,3,4,5,6\n"),
    ("import.long_line", "a" * 300_000),
    ("import.no_times", f"Time (s),{XIMU3}\n0,1,2,3,4,5,6\n1e300,1,2,3,4,5,6\n"),
    ("import.not_time", f"Time (s),{XIMU3}\n1e300,1,2,3,4,5,6\n2e300,1,2,3,4,5,6\n"),
]


@pytest.mark.parametrize(("code", "text"), BROKEN)
def test_other_files_are_rejected(tmp_path: Path, code: str, text: str) -> None:
    path = tmp_path / "a.csv"
    path.write_text(text)
    with raises(FileError, code):
        import_imus([path], tmp_path / "out.mcap")
    assert sorted(p.name for p in tmp_path.iterdir()) == ["a.csv"]


@pytest.mark.parametrize("damage", ["1e300", "-1e300", "1e9", "nan", ""])
def test_a_damaged_time_affects_only_its_sample(tmp_path: Path, damage: str) -> None:
    times = [f"{k / 100:.2f}" for k in range(50)]
    times[20] = damage
    path = tmp_path / "a.csv"
    path.write_text(f"Time (s),{XIMU3}\n" + "".join(f"{t},1,2,3,0,0,1\n" for t in times))
    report = import_imus([path], tmp_path / "out.mcap")
    assert (report["packets"], report["left_out"]) == (49, 1)
    assert report["duration_s"] == pytest.approx(0.49)


def test_a_time_of_another_clock_affects_only_its_sample(tmp_path: Path) -> None:
    """Integer nanoseconds, among them zero and more than 64 bits."""
    began = 1_700_000_000_000_000_000
    times = [began + 10_000_000 * k for k in range(40)]
    times[7], times[9], times[11] = 0, 2**63 - 1, 10**24
    path = tmp_path / "a.csv"
    path.write_text(f"Time (ns),{XIMU3}\n" + "".join(f"{t},1,2,3,0,0,1\n" for t in times))
    assert import_imus([path], tmp_path / "out.mcap")["left_out"] == 3
    assert raw(tmp_path / "out.mcap").stamp_ns[[0, -1]].tolist() == [began, began + 390_000_000]


@pytest.mark.long
def test_huge_and_endless_files_need_little_memory(tmp_path: Path) -> None:
    """Zeros without a line end, a device in place of a file, and a file that swells."""
    for name in ("huge.csv", "huge.mat"):
        with (tmp_path / name).open("wb") as file:
            file.truncate(3 * 10**9)
    (tmp_path / "log").mkdir()
    (tmp_path / "log" / "Inertial.csv").symlink_to("/dev/zero")
    savemat(tmp_path / "zeros.mat", {"imu_acc": np.zeros((20_000_000, 3))}, do_compression=True)
    started = time.process_time()
    tracemalloc.start()
    for source in ("huge.csv", "huge.mat", "log", "zeros.mat"):
        with raises(FileError, "file.unpacked_size", "import.long_line", "file.not_regular"):
            import_imus([tmp_path / source], tmp_path / "out.mcap")
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 50_000_000 and time.process_time() - started < 10.0


def test_a_row_of_many_imus_is_limited_by_its_decoded_size(tmp_path: Path, monkeypatch) -> None:
    """A header may name a thousand IMUs of one axis each."""
    monkeypatch.setattr("tracker.offline.imports.table._MOST_NUMBERS", 6_000_000)
    header = ",".join(f"imu{k} acc x (g)" for k in range(1000))
    path = tmp_path / "a.csv"
    path.write_text(f"Time (s),{header}\n" + f"0{',0' * 1000}\n" * 1000)
    with raises(FileError, "import.many_lines", most=999):
        import_imus([path], tmp_path / "out.mcap")


def test_a_damaged_matlab_file_is_rejected(tmp_path: Path) -> None:
    path, rng = tmp_path / "a.mat", np.random.default_rng(2)
    one = {"imu_acc": np.ones((50, 3)), "imu_gyr": np.ones((50, 3)), "sampling_rate": 100.0}
    savemat(path, one, do_compression=True)
    good = path.read_bytes()
    for _ in range(150):
        data = bytearray(good)
        at = int(rng.integers(len(data)))
        data[at : at + 4] = rng.bytes(4)
        path.write_bytes(bytes(data[: int(rng.integers(20, len(data)))]))
        try:
            import_imus([path], tmp_path / "out.mcap", force=True)
        except (FileError, ConfigError):
            continue


def test_implausible_units_are_reported(tmp_path: Path) -> None:
    path = tmp_path / "a.csv"
    header = XIMU3.replace("(g)", "(m/s^2)")  # wrong: they are g
    path.write_text(f"Time (s),{header}\n" + "".join(f"{k},0,0,0,0,0,1\n" for k in range(9)))
    report = import_imus([path], tmp_path / "out.mcap")
    assert report["doubts"][0].startswith("a feels 1 m/s²")


def test_the_assignment_of_imus_is_required(tmp_path: Path, capsys: pytest.CaptureFixture) -> None:
    for name in ("left", "right"):
        x_imu3(tmp_path, name, np.arange(0, 50) * 10_000, np.ones((50, 6)))
    words = ["import", str(tmp_path), "-o", str(tmp_path / "a.mcap")]
    assert main(words) == 1
    assert shows(capsys.readouterr().err, "import.imus_unassigned", found="left, right")
    assert main([*words, "--imu", "wrist=left"]) == 1
    assert main([*words, "--imu", "dorsum=left"]) == 0


@pytest.fixture
def data() -> Path:
    folder = Path(os.environ.get("GLOVETRACK_DATA", "/nonexistent"))
    if not (folder / "broad_imu").is_dir():
        pytest.skip("no recorded data")
    return folder


@pytest.mark.long
def test_a_recording_of_a_real_imu_agrees_with_its_cameras(data: Path, tmp_path: Path) -> None:
    """BROAD's 286 Hz, averaged to 100: inclination within 2° of the optical reference."""
    whole = loadmat(data / "broad_imu" / "02_undisturbed_slow_rotation_B.mat", squeeze_me=True)
    rate, first = float(whole["sampling_rate"]), 285 * START_S
    chosen = slice(first, first + 285 * 20)
    part = {k: whole[k][chosen] for k in ("imu_acc", "imu_gyr")} | {"sampling_rate": rate}
    savemat(tmp_path / "broad.mat", part)
    report = import_imus([tmp_path / "broad.mat"], tmp_path / "in.mcap")
    assert report["rate_hz"] == pytest.approx(100) and report["recorded_hz"][0] > 280
    track(tmp_path / "in.mcap", tmp_path / "out.mcap")
    with SessionReader(tmp_path / "out.mcap") as reader:
        found = [m for m in reader.messages((Estimate,)) if isinstance(m, Estimate)]
        up = np.array([m.segment_R[0][2] for m in found])  # G's z in the IMU's axes
        t = np.array([m.t for m in found])
    rows = first + np.round(t * rate).astype(int)
    true = whole["opt_quat"][rows][:, [1, 2, 3, 0]]
    seen = np.isfinite(true).all(axis=1) & (whole["movement"][rows] == 1)
    assert seen.sum() > 1000
    true_up = Rotation.from_quat(true[seen]).inv().apply([0, 0, 1])
    off = np.arccos(np.clip(np.sum(up[seen] * true_up, axis=1), -1, 1))
    assert np.degrees(np.sqrt(np.mean(off**2))) < 2.0


@pytest.mark.long
def test_imus_of_a_whole_body_are_selected_by_name(data: Path, tmp_path: Path) -> None:
    path = data / "qmt_fullbody_imu" / "full_body_example_data.mat"
    with pytest.raises(ConfigError, match="hand_right"):
        import_imus([path], tmp_path / "a.mcap")
    imus = {"dorsum": "hand_right"}
    report = import_imus([path], tmp_path / "a.mcap", ImportOptions(imus=imus))
    whole = loadmat(path, squeeze_me=True, struct_as_record=False)
    found = raw(tmp_path / "a.mcap")
    assert report["packets"] == 10_000
    assert np.allclose(found.accel[:, 0], whole["hand_right"].acc, atol=1e-12)
    assert np.allclose(found.gyro[:, 0], whole["hand_right"].gyr, atol=1e-12)
