"""Data sets for robot learning, opened by Rerun's reader and by Arrow."""

from __future__ import annotations

import json
import os
import stat
from collections.abc import Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from scipy.spatial.transform import Rotation

from extensions.lerobot import export as lerobot
from tests.fixtures import RESOURCES
from tests.notices import raises
from tests.session.conftest import ANCHOR, at
from tests.streaming.recorded_hand import NEAR_DEG, RecordedHand, assert_near, assert_parallel
from tracker.base.errors import ConfigError, FileError
from tracker.base.workers import WorkerRequest
from tracker.cli import main
from tracker.geometry import so3
from tracker.messages import Estimate, Event, Message, StereoFrame, Tracking
from tracker.session.encode import Out
from tracker.session.export.options import DatasetOptions, ExportOptions
from tracker.session.export.run import export, export_dataset
from tracker.session.images import encode_image
from tracker.session.ros import motion
from tracker.session.writer import RecorderParams, SessionRecorder

N = 26
HZ = 50


@pytest.fixture
def moving(session_info) -> Callable[..., list[Message]]:
    """``moving(n, lost)``: n estimates, 20 ms apart, of a hand that bends and moves; the
    index fingertip and one angle are lost in the rows ``lost``."""
    hand, glove = session_info.hand, session_info.glove

    def make(n: int, lost: Sequence[int] = (), start_ms: float = 0.0) -> list[Message]:
        out: list[Message] = []
        for k in range(n):
            t = k / HZ
            angles = 0.3 + 0.2 * np.sin(2 * t + np.arange(len(hand.joint_names)))
            R_GB, p_GB = hand.forward(angles, so3.rz(0.5 * t), np.array([0.1 * t, 0.2, 1.0]))
            points = glove.keypoint_positions(hand, R_GB, p_GB, np.ones((len(R_GB), 3)))
            q = so3.quat_from_matrix(R_GB[glove.keypoint_segments(hand)])
            state = np.full(len(points), 2)
            said = np.full(len(angles), 2)
            if k in lost:
                row = session_info.keypoint_names.index("index_tip")
                points[row], q[row], state[row] = np.nan, np.nan, 0
                angles[3], said[3] = np.nan, 0
            out.append(Estimate(
                at(start_ms + 1000 * t), Tracking.TRACKING, points, q, state,
                np.full(len(points), 1e-3), angles, said, R_GB, p_GB,
            ))  # fmt: skip
        return out

    return make


def rows_of(folder: Path) -> pa.Table:
    return pa.concat_tables([pq.read_table(p) for p in sorted(folder.glob("data/*/*.parquet"))])


def column(table: pa.Table, name: str) -> np.ndarray:
    return np.array(table[name].to_pylist(), float)


def names_of(folder: Path, feature: str) -> list[str]:
    info = json.loads((folder / "meta" / "info.json").read_text())
    return info["features"][feature]["names"]


def read_by_rerun(folder: Path, episode: int) -> dict[str, list[Any]]:
    """The values that Rerun's reader returns for each entity, row by row."""
    reader = pytest.importorskip("rerun.experimental").LeRobotReader(folder)
    assert reader.version == "v3"
    found: dict[str, list[Any]] = {}
    for chunk in reader.stream(episode).to_chunks():
        batch = chunk.to_record_batch()
        for name in batch.schema.names:
            if "frame_index" in batch.schema.names and name not in ("frame_index",):
                kind = name.rsplit(":", 1)[-1]
                if kind in ("scalars", "blob", "text"):
                    found.setdefault(chunk.entity_path, []).extend(batch[name].to_pylist())
    return found


def test_rerun_reads_two_sessions_as_two_episodes(
    tmp_path: Path, record: Callable[..., Path], maker, moving
) -> None:
    images = [maker.image(20.0 * k, k) for k in range(40)]
    paths = [
        record(tmp_path / "a.mcap", sorted([*moving(40), *images], key=lambda m: m.t)),
        record(tmp_path / "b.mcap", sorted([*moving(25), *images[:25]], key=lambda m: m.t)),
    ]
    out = tmp_path / "set"
    options = ExportOptions(dataset=DatasetOptions(task="Grasp the cup"))
    report = export_dataset(paths, "lerobot", out, options)
    assert report["frames"] == 65 and report["fps"] == HZ
    table = rows_of(out)
    for episode, (first, n) in enumerate([(0, 40), (40, 25)]):
        found = read_by_rerun(out, episode)
        for key in ("observation.state", "observation.state.valid", "action"):
            ours = column(table, key)[first : first + n]
            assert np.array_equal(np.array(found[f"/{key}"]), ours), key
        assert found["/task"] == [["Grasp the cup"]] * n
        for side in ("left", "right"):
            theirs = [bytes(row[0]) for row in found[f"/observation.images.{side}"]]
            wanted = [encode_image(getattr(images[k], side), "png", 0) for k in range(n)]
            assert theirs == wanted


def test_arrow_finds_what_lerobot_looks_for(
    tmp_path: Path, record: Callable[..., Path], moving
) -> None:
    path = record(tmp_path / "a.mcap", moving(40))
    out = tmp_path / "set"
    assert main(["export", str(path), str(path), "--format", "lerobot", "-o", str(out),
                 "--task", "Wave"]) == 0  # fmt: skip
    info = json.loads((out / "meta" / "info.json").read_text())
    assert (info["codebase_version"], info["fps"]) == ("v3.0", HZ)
    assert (info["total_episodes"], info["total_frames"], info["total_tasks"]) == (2, 80, 1)
    assert info["splits"] == {"train": "0:2"} and info["video_path"] is None
    file = pq.ParquetFile(out / info["data_path"].format(chunk_index=0, file_index=0))
    assert [file.metadata.row_group(k).num_rows for k in range(file.num_row_groups)] == [40, 40]
    table = file.read()
    assert set(table.column_names) == set(info["features"])
    for name, feature in info["features"].items():
        kind = table.schema.field(name).type
        if feature["shape"] == [1]:
            assert str(kind) == {"float32": "float"}.get(feature["dtype"], feature["dtype"])
        else:
            assert kind.list_size == feature["shape"][0] == len(feature["names"])
    assert table["index"].to_pylist() == list(range(80))
    assert table["frame_index"].to_pylist() == [*range(40), *range(40)]
    assert np.array_equal(column(table, "timestamp")[:40], np.float32(np.arange(40) / HZ))
    episodes = pq.read_table(out / "meta/episodes/chunk-000/file-000.parquet").to_pylist()
    spans = [(e["dataset_from_index"], e["dataset_to_index"], e["length"]) for e in episodes]
    assert spans == [(0, 40, 40), (40, 80, 40)] and episodes[1]["tasks"] == ["Wave"]
    tasks = pq.read_table(out / "meta" / "tasks.parquet")
    assert tasks.schema.pandas_metadata["index_columns"] == ["task"]
    assert tasks.to_pylist() == [{"task_index": 0, "task": "Wave"}]
    state = column(table, "observation.state")
    stats = json.loads((out / "meta" / "stats.json").read_text())["observation.state"]
    assert np.allclose(stats["mean"], state.mean(axis=0), atol=1e-6)
    assert np.allclose(stats["std"], state.std(axis=0), atol=1e-6)
    assert np.allclose(stats["max"], state.max(axis=0)) and stats["count"] == [80]
    assert np.allclose(episodes[0]["stats/action/min"], column(table, "action")[:40].min(axis=0))


def test_tasks_are_pandas_index(tmp_path: Path, record: Callable[..., Path], moving) -> None:
    pandas = pytest.importorskip("pandas")
    path = record(tmp_path / "a.mcap", moving(10))
    export(path, "lerobot", tmp_path / "set", ExportOptions(dataset=DatasetOptions("Wave")))
    tasks = pandas.read_parquet(tmp_path / "set/meta/tasks.parquet")
    assert tasks.iloc[0].name == "Wave" and tasks.loc["Wave"].task_index == 0


@pytest.mark.long
def test_a_state_is_the_recorded_hand_in_openxrs_world(
    tmp_path: Path, recorded: RecordedHand
) -> None:
    """Read by Rerun, between whose rows the recording's instants are interpolated: the rows are
    0.5 ms apart. At an estimate where the hand's rotation changes
    its rate (an image corrects it), the straight line between two rows misses the corner by a
    quarter of a row's length times the change."""
    rate = 2000.0
    options = ExportOptions(rate=rate, dataset=DatasetOptions(images="none"))
    export(recorded.path, "lerobot", tmp_path / "set", options)
    names = names_of(tmp_path / "set", "observation.state")
    angles = recorded.names.angles
    assert len(set(names)) == 7 * N + 7 + len(angles)
    assert names[0] == "right_palm_x" and names[3 * N + 3] == "right_palm_qw"
    assert names[7 * N + 6] == "right_wrist_pose_qw"
    assert names[7 * N + 7 :] == [f"right_{n}" for n in angles]
    found = read_by_rerun(tmp_path / "set", 0)
    state, valid = (np.array(found[f"/observation.state{part}"]) for part in ("", ".valid"))
    fps = json.loads((tmp_path / "set/meta/info.json").read_text())["fps"]
    start = recorded.recording.t_unix_ns[0]
    rows = [fps * (recorded.unix_ns(e) - start) / 1e9 for e in recorded.estimates]
    inside = [k for k, at in enumerate(rows) if at < len(state) - 1]
    known = [k for k in inside if valid[int(rows[k]) : int(rows[k]) + 2].all()]
    assert len(known) > len(rows) / 2
    for k in known:
        e = recorded.estimates[k]
        row = np.array([np.interp(rows[k], np.arange(len(state)), c) for c in state.T])
        read = dict(zip(names, row, strict=True))
        for joint, (p, R) in recorded.openxr(e).items():
            assert_near([read[f"right_{joint}_{a}"] for a in "xyz"], p)
            q = [read[f"right_{joint}_q{a}"] for a in "xyzw"]
            corner = recorded.rate_change_deg(e, joint) / (4 * rate)
            assert_parallel(Rotation.from_quat(q), R, NEAR_DEG + corner)
        for name, angle in recorded.angles(e).items():
            assert np.rad2deg(abs(read[f"right_{name}"] - angle)) < 0.1
    steps = np.diff(state[:, 3 * N : 7 * N].reshape(-1, N, 4), axis=0)
    assert np.abs(steps).max() < 0.3, "a quaternion changes its sign"


def test_action_is_the_next_state(tmp_path: Path, record: Callable[..., Path], moving) -> None:
    export(record(tmp_path / "a.mcap", moving(30)), "lerobot", tmp_path / "set")
    table = rows_of(tmp_path / "set")
    state, action = column(table, "observation.state"), column(table, "action")
    assert np.array_equal(action[:-1], state[1:]) and np.array_equal(action[-1], state[-1])


def test_what_is_lost_keeps_its_last_value_under_a_mask(
    tmp_path: Path, record: Callable[..., Path], moving, session_info
) -> None:
    lost = range(12, 25)
    export(record(tmp_path / "a.mcap", moving(40, lost)), "lerobot", tmp_path / "set")
    table, names = rows_of(tmp_path / "set"), names_of(tmp_path / "set", "observation.state")
    state, valid = column(table, "observation.state"), column(table, "observation.state.valid")
    assert np.isfinite(state).all() and set(np.unique(valid)) == {0.0, 1.0}
    angle = f"right_{session_info.hand.joint_names[3]}"
    for name in ("right_index_tip_x", "right_index_tip_qw", angle):
        k = names.index(name)
        assert (valid[lost, k] == 0).all() and (valid[:11, k] == 1).all()
        known = np.flatnonzero(valid[:, k])
        before = known[known < 12][-1]
        assert (state[before : known[known > 12][0], k] == state[before, k]).all()
        assert (valid[26:, k] == 1).all() and state[30, k] != state[before, k]
    k = names.index("right_wrist_x")
    assert (valid[:, k] == 1).all()


def test_a_finger_that_the_glove_lacks_is_unknown(
    tmp_path: Path, record: Callable[..., Path], moving, session_info
) -> None:
    """The identity instead of a quaternion, and never known."""
    estimates, row = [], session_info.keypoint_names.index("little_tip")
    for e in moving(20):
        points, q, state = e.keypoints.copy(), e.keypoint_q.copy(), e.keypoint_state.copy()
        points[row], q[row], state[row] = np.nan, np.nan, 0
        estimates.append(replace(e, keypoints=points, keypoint_q=q, keypoint_state=state))
    export(record(tmp_path / "a.mcap", estimates), "lerobot", tmp_path / "set")
    table, names = rows_of(tmp_path / "set"), names_of(tmp_path / "set", "observation.state")
    first = names.index("right_little_tip_qx")
    assert (column(table, "observation.state")[:, first : first + 4] == [0, 0, 0, 1]).all()
    assert (column(table, "observation.state.valid")[:, first : first + 4] == 0).all()


def test_a_robots_joints_are_the_action(tmp_path: Path, session_info, moving) -> None:
    path = tmp_path / "a.mcap"
    params = RecorderParams(images="none", sync=False)
    with SessionRecorder(path, session_info, params) as recorder:
        for k, estimate in enumerate(moving(30)):
            recorder.write(estimate)
            stamp = ANCHOR.wall(estimate.t) - 3_000_000
            if k % 2 == 0:
                recorded = motion.JointState(stamp, ["rh_FFJ1", "rh_FFJ2"], np.array([k, -k / 2]))
                data = motion.pack_joints(recorded)
                out = Out("/robot/shadow/joint_states", motion.JOINTS, stamp, stamp, data)
                recorder._guarded(lambda file, out=out: recorder._put(file, iter([out])))
    export(path, "lerobot", tmp_path / "set")
    assert names_of(tmp_path / "set", "action") == ["rh_FFJ1", "rh_FFJ2"]
    action = column(rows_of(tmp_path / "set"), "action")
    row = np.arange(30) // 2 * 2
    assert np.array_equal(action, np.stack([row, -row / 2], axis=1))


def test_parts_between_notes_are_episodes_with_the_notes_as_tasks(
    tmp_path: Path, record: Callable[..., Path], moving
) -> None:
    notes = [Event(at(395), "note", "pour"), Event(at(695), "note", "wipe the\ttable")]
    path = record(tmp_path / "a.mcap", [*moving(50), *notes])
    out = tmp_path / "set"
    assert main(["export", str(path), "--format", "lerobot", "-o", str(out), "--split"]) == 0
    episodes = pq.read_table(out / "meta/episodes/chunk-000/file-000.parquet").to_pylist()
    assert [e["length"] for e in episodes] == [20, 15, 15]
    assert [e["tasks"] for e in episodes] == [["ä note"], ["pour"], ["wipe the\ttable"]]
    table = rows_of(out)
    assert table["task_index"].to_pylist() == [0] * 20 + [1] * 15 + [2] * 15
    times = column(table, "timestamp")
    assert times[0] == times[20] == times[35] == 0
    named = export_dataset(
        [path], "lerobot", tmp_path / "named", ExportOptions(dataset=DatasetOptions("x", True))
    )
    assert named["tasks"] == ["x"]
    hidden = ExportOptions(dataset=DatasetOptions(split=True), anonymous=("notes",))
    assert export_dataset([path], "lerobot", tmp_path / "hidden", hidden)["tasks"] == [
        "Move the hand."
    ]


def test_both_hands_are_stored_side_by_side(tmp_path: Path, moving, session_info) -> None:
    from tracker.session.description import describe

    hand = (RESOURCES / "hands" / "reference-left.toml").read_text()
    glove = (RESOURCES / "gloves" / "vist-small-left.toml").read_text()
    left = describe(hand, glove, ANCHOR)
    both = replace(session_info, others=(left,))
    path = tmp_path / "both.mcap"
    with SessionRecorder(path, both, RecorderParams(images="none", sync=False)) as recorder:
        for k, estimate in enumerate(moving(40)):
            recorder.write(estimate, side="right")
            if k >= 10:
                recorder.write(replace(estimate, t=estimate.t + 0.004), side="left")
    export(path, "lerobot", tmp_path / "set")
    names = names_of(tmp_path / "set", "observation.state")
    half = len(names) // 2
    assert {n.split("_")[0] for n in names[:half]} == {"left"}
    assert [n.replace("left", "right") for n in names[:half]] == names[half:]
    valid = column(rows_of(tmp_path / "set"), "observation.state.valid")
    wrist = names.index("left_wrist_x")
    assert (valid[:10, wrist] == 0).all() and (valid[11:, wrist] == 1).all()
    assert (valid[:, half + wrist] == 1).all()


@pytest.mark.long
def test_a_folder_in_processes_and_on_a_cluster_gives_the_same_files(
    tmp_path: Path, record: Callable[..., Path], moving, monkeypatch: pytest.MonkeyPatch
) -> None:
    distributed = pytest.importorskip("distributed")
    folder = tmp_path / "takes"
    (folder / "day2").mkdir(parents=True)
    for k, name in enumerate(("a.mcap", "b.mcap", "day2/a.mcap")):
        record(folder / name, moving(20 + 5 * k))
    monkeypatch.setattr(lerobot, "LARGEST_DATA_MB", 0)  # a file for each episode
    shares: list[float] = []
    export_dataset([folder], "lerobot", tmp_path / "local", ExportOptions(), shares.append,
                   WorkerRequest(2))  # fmt: skip
    with distributed.LocalCluster(1, processes=False, dashboard_address=None) as cluster:
        pool = WorkerRequest(dask=cluster.scheduler_address)
        export_dataset([folder], "lerobot", tmp_path / "dask", ExportOptions(), pool=pool)
    files = sorted(p.relative_to(tmp_path / "local") for p in (tmp_path / "local").rglob("*.*"))
    assert [str(p) for p in files if p.parts[0] == "data"] == [
        f"data/chunk-000/file-00{k}.parquet" for k in range(3)
    ]
    for path in files:
        assert (tmp_path / "local" / path).read_bytes() == (tmp_path / "dask" / path).read_bytes()
    assert rows_of(tmp_path / "local")["index"].to_pylist() == list(range(75))
    assert shares[-1] == pytest.approx(1.0)


def test_frames_without_an_image_of_their_own_take_the_nearest(
    tmp_path: Path, record: Callable[..., Path], maker, moving
) -> None:
    images = [maker.image(40.0 * k + 3, k) for k in range(15)]
    messages = sorted([*moving(30), *images], key=lambda m: m.t)
    path = record(tmp_path / "a.mcap", messages)
    export(path, "lerobot", tmp_path / "own")
    assert json.loads((tmp_path / "own/meta/info.json").read_text())["fps"] == 25
    export(path, "lerobot", tmp_path / "faster", ExportOptions(rate=100))
    found = rows_of(tmp_path / "faster")["observation.images.right"].to_pylist()
    centres = np.array([m.t for m in messages if isinstance(m, StereoFrame)])
    for k in (0, 3, 10, 11, 57):
        nearest = int(np.abs(centres - at(10.0 * k)).argmin())
        assert found[k]["bytes"] == encode_image(images[nearest].right, "png", 0)
    recorded = json.loads((tmp_path / "faster/meta/glovetrack.json").read_text())
    assert recorded["episodes"][0]["image_gap_s"] == pytest.approx(0.020, abs=0.004)


def test_sessions_that_differ_are_refused(
    tmp_path: Path, record: Callable[..., Path], maker, moving
) -> None:
    plain = record(tmp_path / "a.mcap", moving(20))
    seen = sorted([*moving(20), *(maker.image(20.0 * k, k) for k in range(20))], key=lambda m: m.t)
    images = record(tmp_path / "b.mcap", seen)
    with raises(ConfigError, "lerobot.layouts_differ", what="cameras"):
        export_dataset([plain, images], "lerobot", tmp_path / "set", ExportOptions())
    without = ExportOptions(dataset=DatasetOptions(images="none"))
    assert export_dataset([plain, images], "lerobot", tmp_path / "set", without)["sources"] == 2
    with raises(FileError, "file.occupied"):
        export_dataset([plain], "lerobot", tmp_path / "set", without)
    with raises(ConfigError, "export.not_supported"):
        export(plain, "lerobot", tmp_path / "x", ExportOptions(axes="unity", joints=("openxr",)))
    with raises(ConfigError, "lerobot.rate"):
        export(plain, "lerobot", tmp_path / "x", ExportOptions(rate=29.97))
    with raises(ConfigError, "export.one_session"):
        export_dataset([plain, images], "csv", tmp_path / "x", ExportOptions())
    with raises(FileError, "session.not_tracked"):
        export(record(tmp_path / "raw.mcap", [maker.imu(0.0)]), "lerobot", tmp_path / "x")
    assert not (tmp_path / "x").exists() and not list(tmp_path.glob(".*part"))


FAKE = """#!/bin/sh
for last; do :; done
echo "$@" > "$last.arguments"
exec cat > "$last"
"""


def test_films_are_made_by_the_systems_ffmpeg(
    tmp_path: Path,
    record: Callable[..., Path],
    maker,
    moving,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A substitute stores its input: each frame's image once, in order, of both episodes."""
    programs = tmp_path / "bin"
    programs.mkdir()
    monkeypatch.setenv("PATH", str(programs))
    images = [maker.image(20.0 * k, k) for k in range(20)]
    path = record(tmp_path / "a.mcap", sorted([*moving(20), *images], key=lambda m: m.t))
    options = ExportOptions(dataset=DatasetOptions(images="video"))
    with raises(ConfigError, "lerobot.needs_program"):
        export(path, "lerobot", tmp_path / "set", options)
    program = programs / "ffmpeg"
    program.write_text(FAKE)
    program.chmod(program.stat().st_mode | stat.S_IXUSR)
    monkeypatch.setenv("PATH", f"{programs}{os.pathsep}{os.defpath}")
    export_dataset([path, path], "lerobot", tmp_path / "set", options)
    film = tmp_path / "set/videos/observation.images.left/chunk-000/file-000.mp4"
    wanted = b"".join(encode_image(m.left, "png", 0) for m in images)
    assert film.read_bytes() == 2 * wanted
    recorded = film.with_name(f"{film.name}.arguments").read_text()
    assert "-force_key_frames 0.000000,0.390000" in recorded
    assert f"-framerate {HZ}" in recorded and "libx264" in recorded and "-c:v png" in recorded
    info = json.loads((tmp_path / "set/meta/info.json").read_text())
    assert info["features"]["observation.images.left"]["dtype"] == "video"
    table = rows_of(tmp_path / "set")
    assert "observation.images.left" not in table.column_names
    episodes = pq.read_table(tmp_path / "set/meta/episodes/chunk-000/file-000.parquet").to_pylist()
    key = "videos/observation.images.left"
    spans = [(e[f"{key}/from_timestamp"], e[f"{key}/to_timestamp"]) for e in episodes]
    assert spans == [(0.0, 0.4), (0.4, 0.8)] and episodes[0][f"{key}/file_index"] == 0


def test_the_message_of_a_failing_ffmpeg_is_reported(
    tmp_path: Path,
    record: Callable[..., Path],
    maker,
    moving,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    program = tmp_path / "ffmpeg"
    program.write_text("#!/bin/sh\necho Unknown encoder 'libx264' >&2\nexit 1\n")
    program.chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}{os.pathsep}{os.defpath}")
    images = [maker.image(20.0 * k, k) for k in range(20)]
    path = record(tmp_path / "a.mcap", sorted([*moving(20), *images], key=lambda m: m.t))
    options = ExportOptions(dataset=DatasetOptions(images="video"))
    with raises(FileError, "lerobot.film_failed"):
        export(path, "lerobot", tmp_path / "set", options)
    assert not (tmp_path / "set").exists()
