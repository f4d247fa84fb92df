"""Every export, opened by a library that is not ours."""

import csv
import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import bvhio
import cv2
import ezc3d
import h5py
import numpy as np
import pyarrow.parquet as pq
import pytest
import yourdfpy
from pygltflib import GLTF2
from scipy.spatial.transform import Rotation

from extensions.conformance.isaac.reader import read_records
from tracker.base.errors import ConfigError, FileError
from tracker.cli import main
from tracker.messages import CameraPose, Estimate, Event, ImuSample
from tracker.session.export.axes import AXES
from tracker.session.export.load import load_series
from tracker.session.export.options import FORMATS, ExportOptions
from tracker.session.export.run import export
from tracker.session.reader import SessionReader
from tracker.session.writer import SessionRecorder

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
    told = table.schema.metadata
    assert told[b"axes"] == b"x forward, y left, z up" and told[b"length_unit"] == b"m"


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


def test_c3d_says_what_was_measured(tracked, tmp_path: Path, session_info) -> None:
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
    sd_mm = 1000 * estimates[5].keypoint_sd  # random, up to 1000: a byte holds no more than 127
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
    imu = 1  # the other is missing in this packet's neighbour
    column = names.index(f"{glove.imu_names[imu]}_gyr_x")
    assert file["data"]["analogs"][0, column, 4] == pytest.approx(packet.gyro[imu, 0], abs=1e-5)
    assert file["parameters"]["ANALOG"]["UNITS"]["value"][column] == "rad/s"
    events = file["parameters"]["EVENT"]
    assert events["DESCRIPTIONS"]["value"] == ["a mark"]  # the other came after the last estimate
    assert events["TIMES"]["value"][1, 0] == pytest.approx(0.25, abs=1e-4)


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


def test_bvh_joints_stand_where_ours_do(tracked, tmp_path: Path, session_info) -> None:
    path, estimates = tracked
    export(path, "bvh", tmp_path / "o.bvh", ExportOptions(units="m"))
    root = bvhio.readAsHierarchy(str(tmp_path / "o.bvh"))
    for k in (0, 7, 25):
        root.loadPose(k)
        found = {joint.Name: np.array(joint.PositionWorld) for joint, _, _ in root.layout()}
        for name, wanted in zip(session_info.keypoint_names, estimates[k].keypoints, strict=True):
            if name in found:
                assert np.linalg.norm(found[name] - Y_UP @ wanted) < 1e-4, name
        assert {"wrist", "index_pip", "thumb_ip"} <= found.keys()


def test_gltf_animation_in_pygltflib(tracked, tmp_path: Path, session_info) -> None:
    path, estimates = tracked
    export(path, "glb", tmp_path / "o.glb")
    gltf = GLTF2().load(str(tmp_path / "o.glb"))
    blob, k = gltf.binary_blob(), 7

    def values(accessor: int, width: int) -> np.ndarray:
        a = gltf.accessors[accessor]
        start = gltf.bufferViews[a.bufferView].byteOffset
        return np.frombuffer(blob, "<f4", a.count * width, start).reshape(-1, width)

    animation = gltf.animations[0]
    rotation, place = {}, np.zeros(3)
    for channel in animation.channels:
        output = animation.samplers[channel.sampler].output
        if channel.target.path == "rotation":
            rotation[channel.target.node] = values(output, 4)[k]
        else:
            place = values(output, 3)[k]
    found: dict[str, np.ndarray] = {}

    def walk(node: int, R: np.ndarray, p: np.ndarray) -> None:
        n = gltf.nodes[node]
        if node not in rotation:
            return
        p = p + R @ (place if node == 0 else np.array(n.translation))
        found[n.name] = p
        for child in n.children or []:
            walk(child, R @ Rotation.from_quat(rotation[node]).as_matrix(), p)

    walk(0, np.eye(3), np.zeros(3))
    assert len(found) > 10
    for name, p in found.items():
        wanted = estimates[k].keypoints[session_info.keypoint_names.index(name)]
        assert np.linalg.norm(p - Y_UP @ wanted) < 1e-4, name


def test_urdf_moves_like_the_hand(tracked, tmp_path: Path, session_info) -> None:
    path, estimates = tracked
    export(path, "urdf", tmp_path / "o.urdf")
    robot = yourdfpy.URDF.load(str(tmp_path / "o.urdf"), load_meshes=False)
    hand, e = session_info.hand, estimates[3]
    assert set(hand.joint_names) < set(robot.actuated_joint_names)
    robot.update_cfg(dict(zip(hand.joint_names, e.angles, strict=True)))
    R, p = hand.forward(e.angles, np.eye(3), np.zeros(3))
    for i, name in enumerate(hand.segment_names):
        T = robot.get_transform(name, hand.segment_names[0])
        assert np.allclose(T[:3, 3], p[i], atol=1e-6), name
        assert np.allclose(T[:3, :3], R[i], atol=1e-6), name


def test_urdf_has_the_calibrated_size(tmp_path: Path, session_info, maker) -> None:
    calibration = maker.calibration(0)
    scale = np.array([[1.2, 1.0, 1.0], [0.9, 1, 1]])
    with SessionRecorder(tmp_path / "in.mcap", session_info) as recorder:
        recorder.write(replace(calibration, scale=scale))
    export(tmp_path / "in.mcap", "urdf", tmp_path / "o.urdf")
    robot = yourdfpy.URDF.load(str(tmp_path / "o.urdf"), load_meshes=False)
    hand = session_info.hand
    T = robot.get_transform("index_proximal", "dorsum")
    origin = hand.segments[hand.index["index_proximal"]].origin
    assert np.allclose(T[:3, 3], origin * [1.2, 1, 1], atol=1e-9)


def test_mp4_in_opencv(tmp_path: Path, record: Callable[..., Path], maker, session_info) -> None:
    pose = CameraPose(np.diag([1.0, -1, -1]), np.array([0.0, 0, 0.5]))
    info = replace(session_info, rig=replace(session_info.rig, pose=pose))
    hand = info.hand
    angles = np.zeros(len(hand.joint_names))
    R, p = hand.forward(angles, np.eye(3), np.zeros(3))
    keypoints = info.glove.keypoint_positions(hand, R, p)
    with SessionRecorder(tmp_path / "in.mcap", info) as recorder:
        for k in range(10):
            frame = maker.image(20.0 * k, k)
            recorder.write(replace(frame, left=np.zeros((48, 64, 3), np.uint8)))
            recorder.write(replace(maker.estimate(20.0 * k), keypoints=keypoints))
    export(tmp_path / "in.mcap", "mp4", tmp_path / "o.mp4")
    video = cv2.VideoCapture(str(tmp_path / "o.mp4"))
    assert video.get(cv2.CAP_PROP_FRAME_COUNT) == 10
    assert video.get(cv2.CAP_PROP_FPS) == pytest.approx(50, rel=0.02)
    _, image = video.read()
    u, v = np.round(info.rig.project((keypoints[0] - pose.p_GC) @ pose.R_GC)).astype(int)
    assert image[v, u, 1] > 100


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
            inner = slice(20, -20)  # the low-pass has less to go by at the ends
            assert (
                np.abs(m.keypoints[inner, 0, 0] - base.keypoints[0, 0] - wanted[inner]).max()
                < tolerance
            )


def test_resampling_never_bridges_what_was_lost(tracked) -> None:
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
    with pytest.raises(ConfigError, match="no keypoint or joint 'nose'"):
        export(path, "csv", tmp_path / "no.csv", ExportOptions(joints=("nose",)))


def test_a_session_without_estimates_is_told(tmp_path: Path, record, maker) -> None:
    path = record(tmp_path / "in.mcap", [maker.imu(0)])
    with pytest.raises(FileError, match="holds no estimates; track it first"):
        export(path, "csv", tmp_path / "o.csv")
    assert not list(tmp_path.glob("*o.csv*"))
    assert not list(tmp_path.glob(".o*"))


def test_the_command_exports(tracked, tmp_path: Path) -> None:
    path, _ = tracked
    out = tmp_path / "o.mot"
    assert main(["export", str(path), "--format", "mot", "-o", str(out), "--rate", "50"]) == 0
    assert "nRows=15" in out.read_text()
    assert main(["export", str(path), "--format", "csv", "-o", str(tmp_path / "no" / "o.csv")]) == 1
    assert "mp4" in FORMATS


def test_foreign_sessions_are_grouped_by_instant(tmp_path: Path, session_info, maker) -> None:
    """Topics of a stranger: no packets, no metadata, stamps that differ by IMU, late arrival."""
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


def test_isaacs_record_has_every_estimate_with_its_stamps(tracked, tmp_path: Path) -> None:
    """That NVIDIA's replay opens such files is tested in extensions/conformance/tests."""
    path, estimates = tracked
    export(path, "isaac", tmp_path / "take.mcap")
    found = list(read_records(tmp_path / "take.mcap"))
    assert [side for side, _ in found] == ["right"] * len(estimates)
    for e, (_, record) in zip(estimates, found, strict=True):
        assert record.stamps.sample == round(e.t * 1e9)
        assert record.stamps.available >= record.stamps.sample
        assert record.joints["is_valid"].all() == (e.keypoint_state[3] != 0)
        wrist = record.joints[1]["position"]
        assert np.allclose(wrist, Y_UP @ e.keypoints[0], atol=1e-6)
    with pytest.raises(ConfigError, match="its own axes"):
        export(path, "isaac", tmp_path / "o.mcap", ExportOptions(axes="ros"))
