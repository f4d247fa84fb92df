"""The shared memory that the stream writes, read as its layout says."""

from __future__ import annotations

import dataclasses
import mmap
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from numpy.testing import assert_allclose, assert_array_equal
from scipy.spatial.transform import Rotation

from extensions.openxr.extension import STREAM, OpenXrOptions
from extensions.openxr.layout import (
    HEADER,
    JOINT,
    MAGIC,
    READER,
    READERS_AT,
    RING,
    RINGS_AT,
    SAMPLE,
    SIZE,
    VERSION,
    Space,
    Velocity,
)
from extensions.openxr.memory import ELSEWHERE
from extensions.openxr.publisher import (
    HOLD,
    LONGEST_SPAN,
    REPLAYED_NS,
    SPAN,
    JointSeries,
    OpenXrPublisher,
    WorldPlacement,
)
from extensions.openxr.readers import read_link
from tests.fixtures import RESOURCES
from tests.notices import raises
from tests.streaming.conftest import MakeEstimate
from tracker.glove.files import load_glove
from tracker.hand.files import load_hand
from tracker.hand.openxr import JOINTS, to_openxr
from tracker.messages import Estimate, Motion, Tracking, Validity
from tracker.streaming.publisher import Names, StreamError
from tracker.streaming.registry import StreamSettings, open_stream, open_streams

PLACED = WorldPlacement(Space.STAGE, (0.1, 0.8, -0.3), 90.0, 0.04)
ROOT = Path(__file__).parents[3]


@pytest.fixture
def memory(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A memory of this test's own."""
    path = tmp_path / "memory"
    monkeypatch.setenv(ELSEWHERE, str(path))
    return path


@pytest.fixture
def openxr(names: Names) -> Names:
    return names.with_openxr()


def left() -> Names:
    hand = load_hand(RESOURCES / "hands" / "reference-left.toml")
    return Names.of(hand, load_glove(RESOURCES / "gloves" / "vist-small-left.toml", hand), "openxr")


def read(path: Path, dtype: np.dtype, at: int) -> np.void:
    with path.open("rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as memory:
        return np.frombuffer(memory, dtype, 1, at)[0].copy()


def sample(path: Path, number: int, side: int = 1) -> np.void:
    at = RINGS_AT + (side * RING + (number - 1) % RING) * SAMPLE.itemsize
    return read(path, SAMPLE, at)


def moved(e: Estimate, t: float, by: tuple[float, float, float]) -> Estimate:
    return dataclasses.replace(e, t=t, keypoints=e.keypoints + np.array(by))


def test_the_layout_is_that_of_the_documentation() -> None:
    assert (JOINT.itemsize, SAMPLE.itemsize, READER.itemsize) == (72, 1928, 128)
    assert HEADER.itemsize <= READERS_AT and READERS_AT + 8 * 128 <= RINGS_AT
    for dtype in (JOINT, SAMPLE, HEADER, READER):
        for name, (field, offset) in ((n, dtype.fields[n][:2]) for n in dtype.names or ()):
            assert offset % field.base.alignment == 0, name


def test_the_header_has_placement_and_hands(memory: Path, openxr: Names) -> None:
    publisher = OpenXrPublisher(openxr, PLACED)
    header = read(memory, HEADER, 0)
    assert header["magic"] == MAGIC and header["version"] == VERSION
    assert header["size"] == SIZE == memory.stat().st_size
    assert header["process"] == os.getpid() and header["running"] == 1
    assert header["ahead"] == 40_000_000 and header["space"] == Space.STAGE
    assert_allclose(header["position"], PLACED.position)
    turned = Rotation.from_quat(header["orientation"]).apply([0, 0, -1])
    assert_allclose(turned, [-1, 0, 0], atol=1e-6, err_msg="forward is turned to the left")
    assert header["hands"]["present"].tolist() == [0, 1]
    assert memory.stat().st_mode & 0o777 == 0o600
    publisher.close()
    assert not memory.exists()


def test_a_sample_has_the_joints_of_the_estimate(
    memory: Path, openxr: Names, make_estimate: MakeEstimate
) -> None:
    now = 5_000_000_000
    publisher = OpenXrPublisher(openxr, PLACED, now_ns=lambda: now)
    e = make_estimate(t=4.99, angles={"index_pip_flexion": 0.7})
    publisher.send(e)
    found, wanted = sample(memory, 1), to_openxr(e, openxr.keypoints, np.array(openxr.radii))
    assert read(memory, HEADER, 0)["hands"]["count"].tolist() == [0, 1]
    assert (found["sequence"], found["t"], found["written"]) == (1, 4_990_000_000, now)
    assert (found["active"], found["tracking"]) == (1, Tracking.TRACKING)
    joints = found["joints"]
    assert_allclose(joints["position"], wanted.position, atol=1e-6)
    assert_allclose(joints["radius"], wanted.radius, atol=1e-6)
    assert_array_equal(joints["state"], wanted.state)
    turn = Rotation.from_quat(joints["orientation"]) * Rotation.from_quat(wanted.orientation).inv()
    assert turn.magnitude().max() < 1e-5
    assert joints["sd"][JOINTS.index("index_tip")] == pytest.approx(0.002)
    assert np.isnan(joints["sd"][JOINTS.index("palm")])
    assert found["velocity"] == Velocity.UNKNOWN and np.isnan(joints["linear"]).all()
    publisher.close()


def test_velocities_are_those_of_the_motion(openxr: Names, make_estimate: MakeEstimate) -> None:
    """A hand that moves at a constant velocity and bends its index finger at 3 rad/s."""
    series, v = JointSeries(openxr), np.array([0.4, -0.2, 0.1])
    for k in range(4):
        t = 0.01 * k
        bent = make_estimate(t=t, angles={"index_pip_flexion": 3.0 * t})
        joints = series.add(moved(bent, t, tuple(v * t)))
    assert joints.velocity == Velocity.DIFFERENCE and joints.array is not None
    wrist, tip = JOINTS.index("wrist"), JOINTS.index("index_tip")
    assert_allclose(joints.array["linear"][wrist], [-v[1], v[2], -v[0]], atol=1e-5)
    assert_allclose(joints.array["angular"][wrist], 0, atol=1e-5)
    assert np.linalg.norm(joints.array["angular"][tip]) == pytest.approx(3.0, rel=1e-4)


def test_velocities_of_the_engine_are_preferred(openxr: Names, make_estimate: MakeEstimate) -> None:
    """They have no delay and a standard deviation; a finger's metacarpal moves with the wrist."""
    e, n, j = make_estimate(t=1.0), len(openxr.keypoints), len(openxr.angles)
    linear, angular = np.tile([1.0, 2.0, 3.0], (n, 1)), np.zeros((n, 3))
    sd, rate = np.full(n, 0.02), np.zeros(j)
    motion = Motion(linear, angular, sd, 2 * sd, rate, rate, rate)
    joints = JointSeries(openxr).add(dataclasses.replace(e, motion=motion))
    assert joints.velocity == Velocity.FILTER and joints.array is not None
    assert_allclose(joints.array["linear"], np.tile([-2, 3, -1], (26, 1)), atol=1e-4)
    assert_allclose(joints.array["angular"], 0, atol=1e-4)
    tip, base = JOINTS.index("index_tip"), JOINTS.index("index_metacarpal")
    assert joints.array["linear_sd"][tip] == pytest.approx(0.02)
    assert joints.array["angular_sd"][tip] == pytest.approx(0.04)
    assert joints.array["linear_sd"][base] > 0.02
    nothing = Motion(
        *(np.full_like(x, np.nan) for x in (linear, angular, sd, sd, rate, rate, rate))
    )
    without = JointSeries(openxr).add(dataclasses.replace(e, motion=nothing))
    assert without.velocity == Velocity.UNKNOWN


@pytest.mark.parametrize("dt", [SPAN / 2, 1.1 * LONGEST_SPAN])
def test_no_velocity_over_too_short_or_long_a_time(
    openxr: Names, make_estimate: MakeEstimate, dt: float
) -> None:
    series = JointSeries(openxr)
    series.add(make_estimate(t=1.0))
    assert series.add(make_estimate(t=1.0 + dt)).velocity == Velocity.UNKNOWN


def test_a_lost_finger_keeps_its_place_on_the_hand_for_a_while(
    openxr: Names, make_estimate: MakeEstimate
) -> None:
    series, gone = JointSeries(openxr), ("ring_tip",)
    tip = JOINTS.index("ring_tip")
    before = series.add(make_estimate(t=1.0)).array
    joints = series.add(moved(make_estimate(t=1.5, lost=gone), 1.5, (0.1, 0, 0))).array
    assert before is not None and joints is not None
    assert joints["state"][tip] == Validity.LOST
    assert joints["state"][tip - 1] == Validity.MEASURED
    assert_allclose(joints["position"][tip], before["position"][tip] + [0, 0, -0.1], atol=1e-6)
    assert np.isnan(joints["linear"][tip]).all() and np.isnan(joints["sd"][tip])
    assert joints["radius"][tip] == before["radius"][tip]
    assert series.add(make_estimate(t=1.01 + HOLD, lost=gone)).array is None
    assert series.add(make_estimate(t=1.02 + HOLD)).array is not None


def test_a_joint_that_was_never_seen_or_a_lost_wrist_is_no_hand(
    openxr: Names, make_estimate: MakeEstimate
) -> None:
    series = JointSeries(openxr)
    assert series.add(make_estimate(t=1.0, lost=("ring_tip",))).array is None
    assert series.add(make_estimate(t=1.1, lost=("wrist",))).array is None


def test_an_inactive_hand_is_a_sample_too(
    memory: Path, openxr: Names, make_estimate: MakeEstimate
) -> None:
    publisher = OpenXrPublisher(openxr, PLACED)
    publisher.send(make_estimate())
    publisher.send(make_estimate(lost=("wrist",), tracking=Tracking.LOST))
    assert (sample(memory, 1)["active"], sample(memory, 2)["active"]) == (1, 0)
    assert sample(memory, 2)["tracking"] == Tracking.LOST
    publisher.close()


def test_an_estimate_of_a_recording_is_stamped_when_it_is_sent(
    memory: Path, openxr: Names, make_estimate: MakeEstimate
) -> None:
    now = 100_000_000_000
    publisher = OpenXrPublisher(openxr, PLACED, now_ns=lambda: now)
    publisher.send(make_estimate(t=(now - REPLAYED_NS) / 1e9))
    assert sample(memory, 1)["t"] == now
    publisher.close()


def test_slots_are_used_in_turn(memory: Path, openxr: Names, make_estimate: MakeEstimate) -> None:
    publisher = OpenXrPublisher(openxr, PLACED)
    for k in range(RING + 2):
        publisher.send(make_estimate(t=0.01 * k))
    assert sample(memory, RING + 2)["sequence"] == RING + 2
    assert sample(memory, 3)["sequence"] == 3
    assert read(memory, HEADER, 0)["hands"]["count"][1] == RING + 2
    publisher.close()


def test_both_hands_share_the_memory(
    memory: Path, names: Names, make_estimate: MakeEstimate
) -> None:
    right, other = open_stream(STREAM, OpenXrOptions(), [names, left()])
    right.send(make_estimate())
    link = read_link()
    assert link is not None and link.running and link.hands == (0, 1) and link.readers == ()
    assert read(memory, HEADER, 0)["hands"]["present"].tolist() == [1, 1]
    other.close()
    right.close()
    right.close()
    assert read_link() is None
    with raises(StreamError, "stream.closed"):
        right.send(make_estimate())


def test_a_second_program_is_refused_and_the_first_goes_on(
    memory: Path, openxr: Names, make_estimate: MakeEstimate
) -> None:
    publisher = OpenXrPublisher(openxr, PLACED)
    with raises(StreamError, "openxr.occupied"):
        OpenXrPublisher(openxr, PLACED)
    publisher.send(make_estimate())
    assert sample(memory, 1)["sequence"] == 1
    publisher.close()


def test_a_program_that_was_killed_leaves_a_memory_that_is_used_again(
    memory: Path, openxr: Names
) -> None:
    code = (
        "import os; from extensions.openxr.memory import OpenXrMemory as M; "
        "m = M(); m.buffer[:8] = b'leftover'; os._exit(1)"
    )
    subprocess.run([sys.executable, "-c", code], cwd=ROOT, check=False)
    left_behind = memory.stat().st_ino
    publisher = OpenXrPublisher(openxr, PLACED)
    assert memory.stat().st_ino == left_behind, "layers that have it open read it"
    assert read(memory, HEADER, 0)["magic"] == MAGIC
    publisher.close()


def test_a_memory_elsewhere_is_refused(tmp_path: Path, openxr: Names) -> None:
    (tmp_path / "link").symlink_to(tmp_path / "somewhere")
    with raises(StreamError, "file.not_created"):
        OpenXrPublisher(openxr, PLACED, str(tmp_path / "link"))
    with raises(StreamError, "file.not_created"):
        OpenXrPublisher(openxr, PLACED, str(tmp_path / "nothing" / "memory"))


def test_readers_are_listed_and_count_as_clients(
    memory: Path, openxr: Names, make_estimate: MakeEstimate
) -> None:
    publisher = OpenXrPublisher(openxr, PLACED, now_ns=lambda: 9_000_000_000)
    assert publisher.clients == 0
    with memory.open("r+b") as file, mmap.mmap(file.fileno(), 0) as shared:
        entries = np.frombuffer(shared, READER, 2, READERS_AT)
        entries[1]["process"], entries[1]["name"] = 77, "Gärtner".encode()
        entries[1]["last"], entries[1]["readings"] = 8_500_000_000, 12
        del entries
    assert publisher.clients == 1
    link = read_link()
    assert link is not None
    (reader,) = link.readers
    assert (reader.process, reader.name, reader.readings) == (77, "Gärtner", 12)
    publisher.close()


@pytest.mark.parametrize(
    ("changed", "code", "option"),
    [
        ({"openxr_space": "view"}, "option.choice", "space"),
        ({"openxr_ahead_ms": 500}, "option.range", "ahead_ms"),
    ],
)
def test_wrong_options_are_named(
    memory: Path, names: Names, changed: dict[str, object], code: str, option: str
) -> None:
    with raises(StreamError, code, option=option):
        open_streams(StreamSettings({"openxr": True, **changed}), [names])
    assert not memory.exists()
