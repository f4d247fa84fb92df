"""Files of motion-capture programs: written by independent libraries, or as their manuals show."""

from __future__ import annotations

from datetime import datetime
from pathlib import Path

import bvhio
import ezc3d
import numpy as np
import pytest
from numpy.testing import assert_allclose

from extensions.reference.formats.read import read_reference
from extensions.reference.mapping import PointMapping, as_keypoints, keypoint_of, read_mapping
from extensions.reference.recording import ReferenceRecording
from tracker.base.errors import FileError
from tracker.hand.names import KEYPOINTS


def code(path: Path, mapping: PointMapping | None = None) -> str:
    with pytest.raises(FileError) as error:
        read_reference(path, mapping)
    return error.value.notice.code


def test_c3d_of_ezc3d_with_gaps_events_and_a_late_first_frame(tmp_path: Path) -> None:
    file = ezc3d.c3d()
    file["parameters"]["POINT"]["UNITS"]["value"] = ["cm"]
    file["parameters"]["POINT"]["RATE"]["value"] = [50.0]
    file["parameters"]["POINT"]["LABELS"]["value"] = ["a", "b"]
    points = np.ones((4, 2, 6))
    points[:3] = np.arange(36).reshape(3, 2, 6)
    file["data"]["points"] = points
    residuals = np.zeros((1, 2, 6))
    residuals[0, 1, 3] = -1
    file["data"]["meta_points"]["residuals"] = residuals
    file["header"]["points"]["first_frame"] = 100
    file.add_event([1.0, 2.25], label="Sync", context="General")
    path = tmp_path / "x.c3d"
    file.write(str(path))
    found = read_reference(path)
    assert found.names == ("a", "b") and found.rate == pytest.approx(50)
    assert found.t[0] == pytest.approx(2.0)
    assert_allclose(found.points[2, 1], 0.01 * points[:3, 1, 2])
    assert np.isnan(found.points[3, 1]).all() and np.isfinite(found.points[3, 0]).all()
    assert [(p.t, p.name) for p in found.pulses] == [(62.25, "Sync")]


def test_a_c3d_file_that_is_cut_off_is_refused(tmp_path: Path) -> None:
    file = ezc3d.c3d()
    file["parameters"]["POINT"]["RATE"]["value"] = [50.0]
    file["parameters"]["POINT"]["LABELS"]["value"] = ["a"]
    file["data"]["points"] = np.ones((4, 1, 500))
    path = tmp_path / "x.c3d"
    file.write(str(path))
    whole = path.read_bytes()
    path.write_bytes(whole[:-3000])
    assert code(path) == "reference.cut_off"
    path.write_bytes(b"not a c3d file")
    assert code(path) == "reference.not_readable"
    assert code(tmp_path / "missing.c3d") == "file.not_readable"


def test_trc_of_opensim(tmp_path: Path) -> None:
    opensim = pytest.importorskip("opensim")
    table = opensim.TimeSeriesTableVec3()
    table.setColumnLabels(["index_tip", "wrist"])
    for i in range(5):
        row = opensim.RowVectorVec3(2)
        row[0] = opensim.Vec3(i, 2, 3)
        row[1] = opensim.Vec3(float("nan")) if i == 2 else opensim.Vec3(-i, 5, 6.5)
        table.appendRow(i / 50, row)
    table.addTableMetaDataString("DataRate", "50")
    table.addTableMetaDataString("Units", "mm")
    path = tmp_path / "x.trc"
    opensim.TRCFileAdapter.write(table, str(path))
    found = read_reference(path)
    assert found.names == ("index_tip", "wrist") and found.kind == "TRC"
    assert_allclose(found.t, np.arange(5) / 50)
    assert_allclose(found.points[:, 0], 1e-3 * np.array([[i, 2, 3] for i in range(5)]))
    assert np.isnan(found.points[2, 1]).all()
    assert_allclose(found.points[4, 1], [-0.004, 0.005, 0.0065])


def test_trc_with_an_empty_cell(tmp_path: Path) -> None:
    """As Cortex writes a missing marker."""
    lines = [
        "PathFileType\t4\t(X/Y/Z)\tx.trc",
        "DataRate\tCameraRate\tNumFrames\tNumMarkers\tUnits\tOrigDataRate\tOrigDataStartFrame"
        "\tOrigNumFrames",
        "100\t100\t3\t2\tm\t100\t1\t3",
        "Frame#\tTime\tA\t\t\tB\t\t\t",
        "\t\tX1\tY1\tZ1\tX2\tY2\tZ2",
        "",
        "1\t0.00\t1\t2\t3\t4\t5\t6",
        "2\t0.01\t\t\t\t4\t5\t7",
        "3\t0.02\t1\t2\t3\t\t\t",
    ]
    path = tmp_path / "x.trc"
    path.write_text("\r\n".join(lines) + "\r\n")
    found = read_reference(path)
    assert np.isnan(found.points[1, 0]).all() and np.isnan(found.points[2, 1]).all()
    assert_allclose(found.points[1, 1], [4, 5, 7])


BVH = """HIERARCHY
ROOT Hips
{
  OFFSET 0 0 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  JOINT RightHand
  {
    OFFSET 10 1 0
    CHANNELS 3 Yrotation Zrotation Xrotation
    JOINT RightHandIndex1
    {
      OFFSET 8 0 2
      CHANNELS 3 Zrotation Xrotation Yrotation
      End Site
      {
        OFFSET 4 0 0
      }
    }
  }
}
MOTION
Frames: 3
Frame Time: 0.01
0 0 0 0 0 0 0 0 0 0 0 0
1 2 3 10 20 30 -40 50 60 70 -80 15
-1 5 2 190 -20 130 40 -50 160 -70 80 -15
"""


def test_bvh_positions_are_bvhio_s(tmp_path: Path) -> None:
    """For a file written by this test, and one by bvhio (9 digits) with its own channel order."""
    path, again = tmp_path / "x.bvh", tmp_path / "y.bvh"
    path.write_text(BVH)
    root = bvhio.readAsHierarchy(str(path))
    bvhio.writeHierarchy(str(again), root, 0.01)
    for file in (path, again):
        found = read_reference(file)
        assert found.rate == pytest.approx(100) and found.kind == "BVH"
        for frame in range(3):
            root.loadPose(frame)
            for joint, _, _ in root.layout():
                k = found.names.index(joint.Name)
                wanted = 0.01 * np.array(joint.PositionWorld)
                assert_allclose(found.points[frame, k], wanted, atol=1e-6)
    found = read_reference(path)
    end, first = (found.points[:, found.names.index(f"RightHandIndex1{n}")] for n in (".end", ""))
    assert_allclose(np.linalg.norm(end - first, axis=1), 0.04)
    metres = read_reference(path, PointMapping(unit=1.0))
    assert_allclose(metres.points, 100 * found.points)


@pytest.mark.parametrize(
    "text", ["HIERARCHY\n", BVH.split("MOTION")[0], BVH.replace("Zrot", "Qrot")]
)
def test_a_damaged_bvh_file_is_refused(text: str, tmp_path: Path) -> None:
    path = tmp_path / "x.bvh"
    path.write_text(text)
    assert code(path) == "reference.not_readable"


QUALISYS = [
    "NO_OF_FRAMES\t3", "NO_OF_CAMERAS\t7", "NO_OF_MARKERS\t2", "FREQUENCY\t200",
    "NO_OF_ANALOG\t0", "ANALOG_FREQUENCY\t0", "DESCRIPTION\t--",
    "TIME_STAMP\t2021-08-26, 15:19:24.317\t1483034.68525310", "DATA_INCLUDED\t3D",
    "EVENT\tSync\t2\t0.00500", "MARKER_NAMES\tindex_tip\twrist",
    "TRAJECTORY_TYPES\tMeasured\tMixed",
]  # fmt: skip


@pytest.mark.parametrize("with_time", [True, False])
def test_qualisys_tsv(with_time: bool, tmp_path: Path) -> None:
    """With the columns Frame and Time, which the export may omit together with its header."""
    rows = [[10, 20, 30, 1, 2, 3], [0.0, 0.0, 0.0, 1, 2, 3], [10, 20, 31, "", "", ""]]
    lines = list(QUALISYS)
    if with_time:
        lines.append(
            "Frame\tTime\tindex_tip X\tindex_tip Y\tindex_tip Z\twrist X\twrist Y\twrist Z"
        )
        rows = [[i + 1, 0.005 * i, *row] for i, row in enumerate(rows)]
    lines += ["\t".join(map(str, row)) for row in rows]
    path = tmp_path / "x.tsv"
    path.write_text("\r\n".join(lines) + "\r\n")
    found = read_reference(path)
    assert_allclose(found.t, [0, 0.005, 0.01])
    assert_allclose(found.points[2, 0], [0.01, 0.02, 0.031])
    assert np.isnan(found.points[1, 0]).all() and np.isnan(found.points[2, 1]).all()
    assert found.start == datetime(2021, 8, 26, 15, 19, 24, 317000)
    assert [(p.t, p.name) for p in found.pulses] == [(0.005, "Sync")]


OPTITRACK = """Format Version,1.23,Take Name,Take 1,Capture Frame Rate,120.000000,\
Export Frame Rate,\
120.000000,Capture Start Time,2024-03-05 02.15.30.250 PM,Total Frames in Take,3,Total Exported \
Frames,3,Rotation Type,Quaternion,Length Units,{unit},Coordinate Space,Global

,Type,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Rigid Body,Marker,Marker,\
Marker,Marker,Marker,Marker
,Name,Wrist,Wrist,Wrist,Wrist,Wrist,Wrist,Wrist,P:IndexTip,P:IndexTip,P:IndexTip,Wrist,Wrist,Wrist
,ID,A,A,A,A,A,A,A,B,B,B,C,C,C
,,Rotation,Rotation,Rotation,Rotation,Position,Position,Position,Position,Position,Position,\
Position,Position,Position
Frame,Time (Seconds),X,Y,Z,W,X,Y,Z,X,Y,Z,X,Y,Z
0,0.000000,0,0,0,1,0.1,0.2,0.3,1,2,3,7,8,9
1,0.008333,0,0,0,1,0.1,0.2,0.3,,,,7,8,9
2,0.016667,0,0,0,1,0.1,0.2,0.3,1,2,4,7,8,9.5
"""


def test_optitrack_csv(tmp_path: Path) -> None:
    path = tmp_path / "x.csv"
    path.write_text(OPTITRACK.format(unit="Millimeters"))
    found = read_reference(path)
    assert set(found.names) == {"Wrist", "P:IndexTip"} and found.kind == "OptiTrack CSV"
    k = found.names.index("Wrist")
    assert_allclose(found.points[2, k], [0.007, 0.008, 0.0095])  # the marker, not the rigid body
    assert np.isnan(found.points[1, 1 - k]).all()
    assert found.start == datetime(2024, 3, 5, 14, 15, 30, 250000)
    path.write_text(OPTITRACK.format(unit="Furlongs"))
    assert code(path) == "reference.unknown_unit"


VICON = """Events
200
Subject,Context,Name,Time (s),Description
Ann,General,Sync,0.5,

Devices
1000
,,Force Plate,,
Frame,Sub Frame,Fx,Fy
,,N,N
1,0,5,5

Trajectories
200
,,Ann:RIFT,,,Ann:RWRA,,
Frame,Sub Frame,X,Y,Z,X,Y,Z
,,mm,mm,mm,mm,mm,mm
101,0,10,20,30,1,2,3
102,0,10,20,31,,,
103,0,10,20,32,1,2,5
"""


@pytest.mark.parametrize("delimiter", [",", "\t"])
def test_vicon_csv(delimiter: str, tmp_path: Path) -> None:
    path = tmp_path / "x.csv"
    path.write_text(VICON.replace(",", delimiter), encoding="cp1252")
    found = read_reference(path)
    assert found.names == ("Ann:RIFT", "Ann:RWRA")
    assert_allclose(found.t, [0.5, 0.505, 0.51])
    assert_allclose(found.points[2, 1], [0.001, 0.002, 0.005])
    assert np.isnan(found.points[1, 1]).all()
    assert [(p.t, p.name) for p in found.pulses] == [(0.5, "Sync")]


def test_any_csv_with_a_mapping_file(tmp_path: Path) -> None:
    mapping, path = tmp_path / "m.toml", tmp_path / "x.csv"
    mapping.write_text(
        'units = "cm"\n[keypoints]\nwrist = ["a", "b"]\nindex_tip = "a"\nthumb_tip = "b"\n'
        '[columns]\ntime = "ms"\ntime_unit = "ms"\ndelimiter = ";"\n'
        '[columns.points]\na = ["ax", "ay", "az"]\nb = ["bx", "by", "bz"]\n'
    )
    path.write_text("made by x\nbx;by;bz;ms;ax;ay;az\n1;2;3;0;3;4;5\n1;2;3;20;3;;5\n")
    read = read_mapping(mapping)
    found = read_reference(path, read)
    assert_allclose(found.t, [0.0, 0.02])
    hand = as_keypoints(found, tuple(KEYPOINTS), "right", read, path)
    assert hand.names == ("wrist", "thumb_tip", "index_tip")
    assert_allclose(hand.points[0, 0], [0.02, 0.03, 0.04])
    assert np.isnan(hand.points[1, 0]).all()  # one of two markers is missing
    path.write_text("ms;ax\n1;2\n")
    assert code(path, read) == "reference.no_column"


@pytest.mark.parametrize(
    "text",
    [
        "[keypoints]\nwrist = 3\n",
        "[keypoints]\nwrist = []\n",
        'units = "furlong"\n',
        '[columns]\ntime = "t"\nrate = 5\n[columns.points]\n',
        '[columns]\nrate = 5\n[columns.points]\na = ["x", "y"]\n',
        'colour = "red"\n',
    ],
)
def test_a_wrong_mapping_file_is_refused(text: str, tmp_path: Path) -> None:
    path = tmp_path / "m.toml"
    path.write_text(text)
    with pytest.raises(FileError) as error:
        read_mapping(path)
    assert "m.toml" in str(error.value)


@pytest.mark.parametrize("text", ["", "a,b\n1,2\n", "Trajectories\n100\n"])
def test_other_files_are_refused(text: str, tmp_path: Path) -> None:
    path = tmp_path / "x.csv"
    path.write_text(text)
    assert code(path) in ("reference.unknown_format", "reference.empty")


@pytest.mark.parametrize(
    ("name", "keypoint", "side"),
    [
        ("index_tip", "index_tip", ""),
        ("Ann:R_IndexTip", "index_tip", "right"),
        ("RightHandIndex4", "index_tip", "right"),
        ("LeftHandThumb1", "thumb_cmc", "left"),
        ("RightHandPinky2.end", "little_tip", "right"),
        ("pinky_finger_mcp", "little_mcp", ""),
        ("RThumbIP", "thumb_ip", "right"),
        ("LeftHand", "wrist", "left"),
        ("right wrist", "wrist", "right"),
        ("hand_top", "", ""),
        ("right_elbow", "", "right"),
        ("M12_index_distal", "", ""),
        ("thumb_pip", "", ""),
        ("RightForeArm", "", "right"),
    ],
)
def test_points_are_found_by_their_names(name: str, keypoint: str, side: str) -> None:
    assert keypoint_of(name) == (keypoint, side)


def test_the_other_hand_s_points_are_not_used(tmp_path: Path) -> None:
    names = ("LeftHand", "LeftHandIndex1", "LeftHandIndex4", "RightHand", "RightHandThumb4")
    points = np.arange(30.0).reshape(2, 5, 3)
    both = ReferenceRecording("BVH", names, np.arange(2.0), points)
    left = as_keypoints(both, tuple(KEYPOINTS), "left", PointMapping(), tmp_path)
    assert left.names == ("wrist", "index_mcp", "index_tip")
    assert_allclose(left.points, points[:, :3])
    with pytest.raises(FileError) as error:
        as_keypoints(both, tuple(KEYPOINTS), "right", PointMapping(), tmp_path)
    assert error.value.notice.code == "reference.few_points"
    for keypoints, wanted in (
        ({"wrist": ("elbow",)}, "reference.no_point"),
        ({"elbow": ("LeftHand",)}, "reference.no_keypoint"),
    ):
        with pytest.raises(FileError) as error:
            as_keypoints(both, tuple(KEYPOINTS), "left", PointMapping(keypoints), tmp_path)
        assert error.value.notice.code == wanted
