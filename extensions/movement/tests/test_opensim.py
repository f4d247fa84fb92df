"""OpenSim files, read by OpenSim itself."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from tracker.messages import Estimate
from tracker.session.export.axes import AXES
from tracker.session.export.options import ExportOptions
from tracker.session.export.run import export


@pytest.fixture
def tracked(tmp_path: Path, record: Callable[..., Path], maker) -> tuple[Path, list[Estimate]]:
    """Thirty random poses at 100 Hz, the thumb's keypoint 3 and angle 2 lost in some."""
    estimates = [maker.estimate(10.0 * k, lost=k % 10 > 7) for k in range(30)]
    return record(tmp_path / "in.mcap", estimates), estimates


def test_trc_and_mot_as_opensim_reads_them(tracked, tmp_path: Path) -> None:
    path, estimates = tracked
    export(path, "trc", tmp_path / "o.trc")
    lines = (tmp_path / "o.trc").read_text().split("\n")
    head = dict(zip(lines[1].split("\t"), lines[2].split("\t"), strict=True))
    assert (head["NumFrames"], head["Units"], head["DataRate"]) == ("30", "mm", "100")
    row = lines[5 + 1].split("\t")
    x, y, z = estimates[0].keypoints[0] * 1000
    assert np.allclose([float(v) for v in row[2:5]], [x, z, -y], atol=1e-5)
    assert lines[6 + 8].split("\t")[2 + 9 : 2 + 12] == ["", "", ""]
    export(path, "mot", tmp_path / "o.mot")
    text = (tmp_path / "o.mot").read_text()
    table = np.genfromtxt(text.split("endheader\n")[1].split("\n"), names=True)
    assert table["thumb_mcp_flexion"].shape == (30,)
    angle = table.dtype.names[3]
    assert np.isnan(table[angle][8])
    assert table[angle][4] == pytest.approx(np.rad2deg(estimates[4].angles[2]), rel=1e-6)


@pytest.fixture
def ended(tmp_path: Path, record: Callable[..., Path], maker) -> tuple[Path, list[Estimate]]:
    """Thirty random poses at 100 Hz; the last keypoint is lost in the last three."""
    estimates = [maker.estimate(10.0 * k) for k in range(30)]
    for k in (27, 28, 29):
        keypoints, state = estimates[k].keypoints.copy(), estimates[k].keypoint_state.copy()
        keypoints[-1], state[-1] = np.nan, 0
        estimates[k] = replace(estimates[k], keypoints=keypoints, keypoint_state=state)
    return record(tmp_path / "in.mcap", estimates), estimates


def test_opensim_itself_reads_trc_mot_and_sto(ended, tmp_path: Path, session_info) -> None:
    opensim = pytest.importorskip("opensim")
    path, estimates = ended
    for form in ("trc", "mot", "sto"):
        export(path, form, tmp_path / f"o.{form}")
    assert (tmp_path / "o.mot").read_text().startswith("o\n")
    assert "\to.trc\n" in (tmp_path / "o.trc").read_text()
    markers = opensim.TimeSeriesTableVec3(str(tmp_path / "o.trc"))
    names = list(markers.getColumnLabels())
    n = len(session_info.keypoint_names)
    assert names[:n] == list(session_info.keypoint_names)
    assert len(names) == n + len(session_info.glove.markers) + len(session_info.hand.segments)
    x, y, z = estimates[7].keypoints[0] * 1000
    found = markers.getRowAtIndex(7).getElt(0, 0)
    assert np.allclose([found[i] for i in range(3)], [x, z, -y], atol=1e-5)
    last = markers.getRowAtIndex(29)
    assert np.isnan(last.getElt(0, n - 1)[0]), "lost is NaN"
    table = opensim.TimeSeriesTable(str(tmp_path / "o.mot"))
    assert list(table.getColumnLabels()) == list(session_info.hand.joint_names)
    row = table.getRowAtIndex(4).to_numpy()
    assert np.allclose(row, np.rad2deg(estimates[4].angles), rtol=1e-6)
    turns = opensim.TimeSeriesTableQuaternion(str(tmp_path / "o.sto"))
    imu = session_info.glove.imus[2]
    assert turns.getColumnLabels()[2] == f"{imu.segment}_imu"
    q = turns.getRowAtIndex(4).getElt(0, 2)
    s = session_info.hand.index[imu.segment]
    wanted = AXES["opensim"].rows @ estimates[4].segment_R[s] @ imu.R_BI
    found = Rotation.from_quat([q.get(k) for k in (1, 2, 3, 0)]).as_matrix()
    assert np.allclose(found, wanted, atol=1e-6)


def test_trc_has_only_the_joints_that_are_asked_for_and_an_empty_last_cell_is_lost(
    ended, tmp_path: Path, session_info
) -> None:
    opensim = pytest.importorskip("opensim")
    asked = ("wrist", session_info.keypoint_names[-1])
    export(ended[0], "trc", tmp_path / "o.trc", ExportOptions(joints=asked))
    table = opensim.TimeSeriesTableVec3(str(tmp_path / "o.trc"))
    assert tuple(table.getColumnLabels()) == asked
    assert np.isnan(table.getRowAtIndex(29).getElt(0, 1)[0])
