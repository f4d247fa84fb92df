"""A robot in a session: read back bit for bit, and by another reader of ROS messages."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from mcap.reader import make_reader
from mcap_ros2.decoder import DecoderFactory

from tests.notices import raises
from tests.session.conftest import at
from tracker.base.errors import FileError
from tracker.messages import RobotMemory, RobotModel, RobotState
from tracker.session.decode_robot import read_robot, robot_model, robot_names
from tracker.session.export.mcap import copy_part
from tracker.session.export.options import ExportOptions
from tracker.session.reader import SessionReader

MODEL = RobotModel(at(0), "claw_left", ("a", "b"), ("cube",), "<robot/>", '{"side": "left"}')


def state(ms: float, seed: int) -> RobotState:
    rng = np.random.default_rng(seed)
    joints, poses = rng.normal(size=(2, 2)), rng.normal(size=(2, 7))
    return RobotState(
        at(ms), "claw_left", *joints, poses[0], poses[1:], rng.uniform(0, 9, 5), True, seed % 2 == 1
    )


def recorded(tmp_path: Path, record: Callable[..., Path]) -> Path:
    memory = RobotMemory(at(20), "claw_left", np.arange(9.0))
    written = [MODEL, *(state(10.0 * k, k) for k in range(1, 6)), memory, MODEL]
    return record(tmp_path / "s.mcap", written)


def test_a_robot_is_read_back_bit_for_bit(tmp_path: Path, record: Callable[..., Path]) -> None:
    with SessionReader(recorded(tmp_path, record)) as reader:
        assert robot_names(reader) == ("claw_left",)
        assert robot_model(reader, "claw_left") == MODEL
        found = list(read_robot(reader, "claw_left"))
    states = [m for m in found if isinstance(m, RobotState)]
    memories = [m for m in found if isinstance(m, RobotMemory)]
    assert len(states) == 5 and len(found) == 7  # the description is written once
    for k, got in enumerate(states, start=1):
        want = state(10.0 * k, k)
        assert (got.t, got.engaged, got.holding) == (want.t, want.engaged, want.holding)
        for name in ("command", "joints", "palm", "objects", "force"):
            assert (getattr(got, name) == getattr(want, name)).all()
    assert memories[0].t == at(20) and (memories[0].values == np.arange(9.0)).all()


def test_another_reader_finds_ros_joint_states(tmp_path: Path, record: Callable[..., Path]) -> None:
    path = recorded(tmp_path, record)
    topics = ["/robot/claw_left/joint_states", "/robot/claw_left/robot_description"]
    with path.open("rb") as file:
        found = make_reader(file, decoder_factories=[DecoderFactory()])
        content = {c.topic: m for _, c, _, m in found.iter_decoded_messages(topics=topics)}
    assert list(content[topics[0]].name) == ["a", "b"]
    assert list(content[topics[0]].position) == list(state(50, 5).joints)
    assert content[topics[1]].data == "<robot/>"


def test_a_state_before_the_robots_description_is_skipped(
    tmp_path: Path, record: Callable[..., Path]
) -> None:
    path = record(tmp_path / "s.mcap", [state(10, 1), MODEL, state(20, 2)])
    with SessionReader(path) as reader:
        found = list(read_robot(reader, "claw_left"))
    assert [m.t for m in found if isinstance(m, RobotState)] == [at(20)]


def test_a_part_of_a_session_contains_its_robots_description(
    tmp_path: Path, record: Callable[..., Path]
) -> None:
    out = tmp_path / "part.mcap"
    with SessionReader(recorded(tmp_path, record)) as reader:
        start = reader.anchor.wall(at(25))
        copy_part(reader, out, (start, start + 10**9), ExportOptions())
    with SessionReader(out) as part:
        assert robot_model(part, "claw_left").urdf == "<robot/>"
        found = [m.t for m in read_robot(part, "claw_left") if isinstance(m, RobotState)]
    assert found == [at(30), at(40), at(50)]


@pytest.mark.parametrize("content", ["[" * 100_000, "{", "[1]", '{"joints": 3}'])
def test_a_damaged_robot_description_is_reported(
    tmp_path: Path, record: Callable[..., Path], content: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("tracker.session.encode_robot.json.dumps", lambda _said: content)
    path = record(tmp_path / "s.mcap", [MODEL, state(10, 1)])
    with SessionReader(path) as reader, pytest.raises(FileError):
        robot_model(reader, "claw_left")


def test_a_session_without_robots_has_none(tmp_path: Path, record: Callable[..., Path]) -> None:
    with SessionReader(record(tmp_path / "s.mcap", [])) as reader:
        assert robot_names(reader) == ()
        with raises(FileError, "session.robot_unknown"):
            robot_model(reader, "claw_left")
