"""C3D files, read by ezc3d."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import ezc3d
import numpy as np
import pytest

from tracker.messages import Estimate, Event, ImuSample
from tracker.session.export.options import ExportOptions
from tracker.session.export.run import export


@pytest.fixture
def tracked(tmp_path: Path, record: Callable[..., Path], maker) -> tuple[Path, list[Estimate]]:
    """Thirty random poses at 100 Hz, the thumb's keypoint 3 and angle 2 lost in some."""
    estimates = [maker.estimate(10.0 * k, lost=k % 10 > 7) for k in range(30)]
    return record(tmp_path / "in.mcap", estimates), estimates


def test_c3d_distinguishes_measured_points(tracked, tmp_path: Path, session_info) -> None:
    path, estimates = tracked
    export(path, "c3d", tmp_path / "o.c3d")
    file = ezc3d.c3d(str(tmp_path / "o.c3d"))
    n = len(session_info.keypoint_names)
    labels = file["parameters"]["POINT"]["LABELS"]["value"]
    assert labels[:n] == list(session_info.keypoint_names)
    assert file["parameters"]["POINT"]["RATE"]["value"][0] == pytest.approx(100)
    assert file["parameters"]["GLOVETRACK"]["AXES"]["value"] == ["x forward, y left, z up"]
    points, residual = file["data"]["points"], file["data"]["meta_points"]["residuals"][0]
    assert np.allclose(points[:3, :n, 5].T, estimates[5].keypoints * 1000, atol=1e-3)
    assert np.isnan(points[:3, 3, 8]).all() and residual[3, 8] == -1
    sd_mm = 1000 * estimates[5].keypoint_sd  # random, up to 1000: a byte contains at most 127
    assert np.allclose(residual[:n, 5], np.clip(np.ceil(sd_mm), 1, 127))
    analog = file["data"]["analogs"][0, 4, 5]
    assert analog == pytest.approx(np.rad2deg(estimates[5].angles[4]), abs=1e-4)


def test_c3d_has_inferred_points_with_residual_zero(
    tmp_path: Path, record: Callable[..., Path], maker
) -> None:
    e = maker.estimate(0)
    state = np.array(e.keypoint_state)
    state[1::2] = 1
    path = record(tmp_path / "in.mcap", [replace(e, keypoint_state=state, t=e.t + k / 100)
                                         for k in range(10)])  # fmt: skip
    export(path, "c3d", tmp_path / "o.c3d", ExportOptions(units="m"))
    residual = ezc3d.c3d(str(tmp_path / "o.c3d"))["data"]["meta_points"]["residuals"][0]
    inferred = residual[: len(state), 4] == 0
    assert np.array_equal(inferred, state == 1) and (residual[: len(state)][~inferred] > 0).all()


def test_c3d_carries_markers_imus_and_notes(
    tmp_path: Path, record: Callable[..., Path], maker, session_info
) -> None:
    messages = list(maker.stream(600, images=False))
    note = Event(messages[0].t + 0.25, "note", "a mark")
    path = record(tmp_path / "in.mcap", [*messages, note])
    export(path, "c3d", tmp_path / "o.c3d")
    file = ezc3d.c3d(str(tmp_path / "o.c3d"))
    glove, hand = session_info.glove, session_info.hand
    labels = file["parameters"]["POINT"]["LABELS"]["value"]
    e = [m for m in messages if isinstance(m, Estimate)][3]
    for marker in (glove.markers[0], glove.markers[-1]):
        s = hand.index[marker.segment]
        wanted = e.segment_p[s] + e.segment_R[s] @ marker.position
        column = labels.index(f"M{marker.id:02d}_{marker.segment}")
        assert np.allclose(file["data"]["points"][:3, column, 3], wanted * 1000, atol=1e-3)
    names = file["parameters"]["ANALOG"]["LABELS"]["value"]
    packet = [m for m in messages if isinstance(m, ImuSample)][4]
    imu = 1  # the other one is missing in a neighbouring packet
    column = names.index(f"{glove.imu_names[imu]}_gyr_x")
    assert file["data"]["analogs"][0, column, 4] == pytest.approx(packet.gyro[imu, 0], abs=1e-5)
    assert file["parameters"]["ANALOG"]["UNITS"]["value"][column] == "rad/s"
    events = file["parameters"]["EVENT"]
    assert events["DESCRIPTIONS"]["value"] == [
        "a mark"
    ]  # the other one was written after the last estimate
    assert events["TIMES"]["value"][1, 0] == pytest.approx(0.25, abs=1e-4)
