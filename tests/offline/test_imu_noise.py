"""``glovetrack imu-noise`` on recordings at rest, and the glove file with the noise."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from tests.notices import raises
from tracker.base.clock import ClockAnchor
from tracker.base.errors import FileError
from tracker.cli import main
from tracker.fusion.chain.params import ChainParams, with_measured_noise
from tracker.glove import library
from tracker.glove.files import parse_glove
from tracker.glove.imu_values import with_noise
from tracker.glove.model import ImuNoise
from tracker.messages import ImuSample
from tracker.offline.imu_noise import imu_noise
from tracker.session.description import describe
from tracker.session.raw_imu import RawImu
from tracker.session.writer import RecorderParams, SessionRecorder
from tracker.vision.rig import ideal_rig

RATE_HZ = 100.0
GYRO, ACCEL = 2e-4, 3e-3  # rad/s/√Hz, m/s²/√Hz: of IMU 0; IMU k has (1 + k) times that


def noise(n: int, imus: int, seed: int = 3) -> tuple[np.ndarray, np.ndarray]:
    """gyro and accel (n, imus, 3) of a glove on a table."""
    rng = np.random.default_rng(seed)
    worse = (1 + np.arange(imus))[:, None] * np.sqrt(RATE_HZ)
    gyro = 0.02 + GYRO * worse * rng.standard_normal((n, imus, 3))
    accel = [0, 0, 9.81] + ACCEL * worse * rng.standard_normal((n, imus, 3))
    return gyro, accel


def raw(gyro: np.ndarray, accel: np.ndarray) -> RawImu:
    n, imus = gyro.shape[:2]
    stamp = (np.arange(n) * 1e9 / RATE_HZ).astype(np.int64)
    names = tuple(f"imu{k}" for k in range(imus))
    valid = np.isfinite(gyro).all(axis=2)
    return RawImu(names, stamp, stamp, stamp * 1e-9, np.arange(n), accel, gyro, valid)


def test_each_imu_has_its_own_noise() -> None:
    report = imu_noise(raw(*noise(9000, 2)))
    assert report.rate_hz == pytest.approx(RATE_HZ)
    for k, imu in enumerate(report.imus):
        assert imu.noise.gyro == pytest.approx((1 + k) * GYRO, rel=0.1)
        assert imu.noise.accel == pytest.approx((1 + k) * ACCEL, rel=0.1)


def test_only_the_rest_of_a_recording_counts() -> None:
    gyro, accel = noise(12_000, 1)
    gyro[:2500] += np.sin(np.arange(2500) / 20)[:, None, None]  # while it is carried to the table
    gyro[-700:] += 0.5 * np.sin(np.arange(700) / 20)[:, None, None]
    report = imu_noise(raw(gyro, accel))
    assert report.start_s == pytest.approx(25, abs=1.01)
    assert report.duration_s == pytest.approx(88, abs=2.01)
    assert report.imus[0].noise.gyro == pytest.approx(GYRO, rel=0.1)


def test_a_few_lost_samples_do_not_matter_and_many_are_an_error() -> None:
    gyro, accel = noise(9000, 1)
    gyro[500:560] = accel[500:560] = np.nan
    assert imu_noise(raw(gyro, accel)).imus[0].noise.gyro == pytest.approx(GYRO, rel=0.1)
    gyro[::5] = accel[::5] = np.nan
    with raises(FileError, "noise.imu_missing", imu="imu0"):
        imu_noise(raw(gyro, accel))


def test_a_short_rest_is_rejected_with_instructions() -> None:
    with raises(FileError, "noise.short_rest"):
        imu_noise(raw(*noise(3000, 1)))


@pytest.fixture(scope="module")
def session(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A recording of a glove on a table, 65 s."""
    path = tmp_path_factory.mktemp("rest") / "rest.mcap"
    _hand, glove = library.load()
    texts = library.texts()
    info = describe(*texts, ClockAnchor(1_700_000_000 * 10**9, 0), rig=ideal_rig())
    gyro, accel = noise(6500, len(glove.imus))
    valid = np.ones(len(glove.imus), bool)
    with SessionRecorder(path, info, RecorderParams(images="none", sync=False)) as recorder:
        for k in range(len(gyro)):
            t = 10 + k / RATE_HZ
            recorder.write(ImuSample(t, t, t, k, accel[k], gyro[k], valid))
    return path


@pytest.mark.long
def test_the_command_writes_figures_curves_and_a_glove_file(
    session: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    glove_file, out, table = tmp_path / "mine.toml", tmp_path / "n.json", tmp_path / "n.csv"
    glove_file.write_text(library.text("gloves", library.DEFAULT_GLOVE))
    target = tmp_path / "measured.toml"
    words = [str(session), "--json", str(out), "-o", str(table)]
    assert main(["imu-noise", *words, "--glove", str(glove_file), "--set", str(target)]) == 0
    hand, glove = library.load()
    found = json.loads(out.read_text())
    names = [imu.name for imu in glove.imus]
    assert list(found["imus"]) == names
    assert found["imus"][names[2]]["gyro_rad_s"][0]["white"] == pytest.approx(3 * GYRO, rel=0.1)
    head, *rows = table.read_text().splitlines()
    assert len(head.split(",")) == 1 + 6 * len(names) and len(rows) > 20
    assert names[0] in capsys.readouterr().out
    with_it = parse_glove(target.read_text(), hand)
    assert with_it.imus[2].noise.gyro == pytest.approx(3 * GYRO, rel=0.15)
    for path in (out, table, target):  # none of them is overwritten
        before = {p: p.read_bytes() for p in (out, table, target)}
        for other in {out, table, target} - {path}:
            other.unlink()
        assert main(["imu-noise", *words, "--glove", str(glove_file), "--set", str(target)]) == 1
        assert path.read_bytes() == before[path]
        for other, data in before.items():
            other.write_bytes(data)


@pytest.mark.long
def test_a_glove_file_without_a_target_is_wrong_usage(session: Path, tmp_path: Path) -> None:
    with pytest.raises(SystemExit, match="2"):
        main(["imu-noise", str(session), "--glove", str(tmp_path / "x.toml")])


def test_the_noise_goes_into_the_glove_file_and_nothing_else_changes() -> None:
    hand, glove = library.load()
    text = library.text("gloves", library.DEFAULT_GLOVE)
    measured = {imu.name: ImuNoise(2e-4, 3e-3, 1e-6, 1e-5) for imu in glove.imus}
    changed = with_noise(text, measured)
    again = parse_glove(changed, hand)
    assert all(imu.noise == measured[imu.name] for imu in again.imus)
    without = [line for line in changed.splitlines() if not line.startswith("noise")]
    assert without == text.splitlines()
    assert with_noise(changed, measured) == changed
    with raises(FileError, "noise.unknown_imu", names=("toe",)):
        with_noise(text, {"toe": ImuNoise(1, 1, 0, 0)})


def test_only_worse_imus_than_expected_change_the_filter() -> None:
    hand, glove = library.load()
    text = library.text("gloves", library.DEFAULT_GLOVE)
    first = glove.imus[0].name
    good = parse_glove(with_noise(text, {first: ImuNoise(1e-4, 1e-3, 0, 0)}), hand)
    bad = parse_glove(with_noise(text, {first: ImuNoise(0.05, 1e-3, 0, 0.5)}), hand)
    params = ChainParams()
    assert with_measured_noise(params, glove) is params
    assert with_measured_noise(params, good) == params
    noisier = with_measured_noise(params, bad).noise
    assert (noisier.gyro, noisier.accel, noisier.accel_bias) == (0.05, params.noise.accel, 0.5)
