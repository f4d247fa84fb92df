"""Rates, axes, images, copies and omissions, checked with independent libraries."""

import csv
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pyarrow.parquet as pq
import pytest
from rosbags.highlevel import AnyReader
from rosbags.typesys import Stores, get_typestore
from scipy.spatial.transform import Rotation

from tests.notices import raises
from tracker.base.errors import ConfigError
from tracker.hand.openxr import JOINTS, joint_radii, to_openxr
from tracker.messages import Estimate, Event, ImuSample, Validity
from tracker.session.export.axes import AXES
from tracker.session.export.formats import FORMATS
from tracker.session.export.load import load_series
from tracker.session.export.options import AXES_NAMES, ExportOptions
from tracker.session.export.run import export
from tracker.session.reader import SessionReader
from tracker.session.verify import is_ok, verify
from tracker.session.writer import SessionRecorder

Record = Callable[..., Path]


@pytest.fixture
def tracked(tmp_path: Path, record: Record, maker) -> tuple[Path, list[Estimate]]:
    """Thirty random poses at 100 Hz; the last keypoint is lost in the last three."""
    estimates = [maker.estimate(10.0 * k) for k in range(30)]
    for k in (27, 28, 29):
        keypoints, state = estimates[k].keypoints.copy(), estimates[k].keypoint_state.copy()
        keypoints[-1], state[-1] = np.nan, 0
        estimates[k] = replace(estimates[k], keypoints=keypoints, keypoint_state=state)
    return record(tmp_path / "in.mcap", estimates), estimates


def test_every_convention_matches_its_description(tracked) -> None:
    assert tuple(AXES) == AXES_NAMES
    ways = {"forward": (1, 0, 0), "backward": (-1, 0, 0), "left": (0, 1, 0), "right": (0, -1, 0)}
    ways |= {"up": (0, 0, 1)}
    for axes in AXES.values():
        parts = axes.description.split(", ")
        for row, part in zip(axes.rows, parts[:3], strict=True):
            assert np.array_equal(row, ways[part.split()[1]])
        assert axes.left_handed == ("left-handed" in parts)


@pytest.mark.parametrize("name", AXES_NAMES)
def test_bones_point_the_same_way_in_all_axes(tracked, name: str) -> None:
    """x of a bone's own axes, turned by its orientation, points along it in any convention."""
    path, _ = tracked
    with SessionReader(path) as reader:
        m = load_series(reader, ExportOptions(axes=name))
    a, b = (m.keypoint_names.index(k) for k in ("index_pip", "index_dip"))
    bone = m.keypoints[:, b] - m.keypoints[:, a]
    along = Rotation.from_quat(m.q[:, a]).apply([1.0, 0, 0])
    assert np.allclose(bone / np.linalg.norm(bone, axis=1)[:, None], along, atol=1e-9)


def test_a_fast_oscillation_is_not_aliased(tmp_path: Path, record: Record, maker) -> None:
    """45 Hz at 20 rows a second would look like 5 Hz; the same applies to orientations."""
    base, t = maker.estimate(0), np.arange(300) * 10.0
    swing = 0.2 * np.sin(2 * np.pi * 45 * t / 1000)
    rows = [
        replace(
            base,
            t=maker.estimate(ms).t,
            keypoints=base.keypoints + 0.01 * s,
            keypoint_q=np.tile(Rotation.from_euler("z", s).as_quat(), (len(base.keypoint_q), 1)),
        )
        for ms, s in zip(t, swing, strict=True)
    ]
    with SessionReader(record(tmp_path / "in.mcap", rows)) as reader:
        m = load_series(reader, ExportOptions(rate=20.0))
    turn = Rotation.from_quat(m.q[5:-5, 0]).as_euler("zyx")[:, 0]
    assert np.abs(turn).max() < 0.02 * 0.2
    assert np.abs(m.keypoints[5:-5, 0, 0] - base.keypoints[0, 0]).max() < 0.02 * 0.01 * 0.2
    assert np.allclose(np.linalg.norm(m.q[:, 0], axis=1), 1)


def test_a_part_of_the_session_in_rosbags(tmp_path: Path, maker, session_info) -> None:
    source, out = tmp_path / "in.mcap", tmp_path / "part.mcap"
    with SessionRecorder(source, session_info) as recorder:
        for m in maker.stream(2000, images=False):
            recorder.write(m)
        recorder.write(Event(maker.imu(1000).t, "note", "Anna says hello"))
    options = ExportOptions(start=0.5, stop=1.0, anonymous=("participant", "notes"))
    export(source, "mcap", out, options)
    assert is_ok(verify(out))
    with SessionReader(out) as part, SessionReader(source) as whole:
        packets = [m for m in part.messages((ImuSample,)) if isinstance(m, ImuSample)]
        assert (packets[0].seq, packets[-1].seq) == (50, 99)
        assert part.rig().fx == whole.rig().fx, "what holds since before is there"
        assert part.metadata["participant"] == part.metadata["notes"] == ""
        assert part.attachments == whole.attachments
    assert b"Anna" not in out.read_bytes() and b"P 07" not in out.read_bytes()
    with AnyReader([out], default_typestore=get_typestore(Stores.ROS2_HUMBLE)) as bag:
        imu = [c for c in bag.connections if c.topic == "/glove/right/imu/dorsum"]
        assert sum(1 for _ in bag.messages(imu)) == 50
    for wrong in (ExportOptions(rate=50.0), ExportOptions(anonymous=("time",))):
        with pytest.raises(ConfigError):
            export(source, "mcap", tmp_path / "no.mcap", wrong)
    assert not (tmp_path / "no.mcap").exists()


def test_identity_and_time_are_anonymised(tmp_path: Path, maker, session_info) -> None:
    recorder = SessionRecorder(tmp_path, session_info)  # an automatic name: with the participant
    for k in range(10):
        recorder.write(maker.estimate(10.0 * k))
    recorder.close()
    assert "P-07" in recorder.path.name
    everyone = ("participant", "notes", "hand", "time")
    for form in sorted(set(FORMATS.names()) - {"mp4", "png", "mcap", "imu.csv", "imu.parquet"}):
        out = tmp_path / f"o.{form}"
        report = export(recorder.path, form, out, ExportOptions(anonymous=everyone))
        text = (tmp_path / f"o.{form}.json").read_text()
        for secret in ("P-07", "P 07", "ä note", session_info.hand.name, "17600000"):
            assert secret not in text.replace(report["source_sha256"], ""), (form, secret)
        for secret in ("P-07", "P 07", session_info.hand.name):
            files = [f for f in out.rglob("*") if f.is_file()] if out.is_dir() else [out]
            assert not any(secret.encode() in f.read_bytes() for f in files), (form, secret)
    assert (tmp_path / "o.csv").read_text().splitlines()[1].startswith("0.000000,")


def test_a_skeleton_cannot_omit_joints(tracked, tmp_path: Path) -> None:
    path, _ = tracked
    with raises(ConfigError, "export.not_supported"):
        export(path, "bvh", tmp_path / "o.bvh", ExportOptions(joints=("wrist",)))
    with raises(ConfigError, "export.every"):
        ExportOptions(every=0)


@pytest.mark.parametrize("format", ["csv", "parquet"])
def test_openxrs_joints_in_a_table(record, maker, session_info, tmp_path: Path, format) -> None:
    estimates = [maker.estimate(10.0 * k, lost=k == 2) for k in range(4)]
    path, out = record(tmp_path / "in.mcap", estimates), tmp_path / f"o.{format}"
    export(path, format, out, ExportOptions(joints=("openxr",)))
    if format == "csv":
        rows = list(csv.DictReader(out.read_text().splitlines()))
    else:
        rows = pq.read_table(out).drop_columns(["t"]).to_pylist()
    radii = joint_radii(session_info.hand)
    assert [n for n in rows[0] if n.startswith("palm")] == [
        *(f"palm_{c}" for c in ("x", "y", "z", "qx", "qy", "qz", "qw", "sd", "radius", "state"))
    ]
    for row, e in zip(rows, estimates, strict=True):
        wanted = to_openxr(e, session_info.keypoint_names, radii)
        for i, joint in enumerate(JOINTS):
            read = [row[f"{joint}_{c}"] for c in ("x", "y", "z", "qx", "qy", "qz", "qw", "radius")]
            if row[f"{joint}_state"] == "lost":
                assert set(read) <= {"", None} and wanted.state[i] == Validity.LOST
                continue
            pose = [*wanted.position[i], *wanted.orientation[i], wanted.radius[i]]
            same = 1.0 if np.dot(wanted.orientation[i], [float(v) for v in read[3:7]]) > 0 else -1.0
            pose[3:7] = [same * v for v in pose[3:7]]
            assert np.allclose([float(v) for v in read], pose, atol=1e-8), joint
    assert rows[2]["thumb_distal_state"] == "lost", "the keypoint that was lost is thumb_ip"


def test_openxrs_joints_are_rotated_like_all_others(record, maker, tmp_path: Path) -> None:
    path = record(tmp_path / "in.mcap", [maker.estimate(10.0 * k) for k in range(5)])
    with SessionReader(path) as reader:
        own = load_series(reader, ExportOptions(joints=("wrist",)))
        ros = load_series(reader, ExportOptions(joints=("openxr",), axes="ros"))
        up = load_series(reader, ExportOptions(joints=("openxr",)))
    wrist = JOINTS.index("wrist")
    assert np.allclose(ros.keypoints[:, wrist], own.keypoints[:, 0])
    assert np.allclose(up.keypoints[:, wrist], own.keypoints[:, 0] @ AXES["y-up"].rows.T)
    assert up.notes["axes"] == "y-up"


def test_openxrs_joints_and_our_names_cannot_be_combined() -> None:
    with raises(ConfigError, "export.joints"):
        ExportOptions(joints=("openxr", "wrist"))
