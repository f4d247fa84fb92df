"""The mounting of a tracker on the hand is found from simulated movements with a known result."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from extensions.room import alignment_file
from extensions.room.alignment import Alignment, AlignmentError, Moved, solve
from extensions.room.movement import recorded_movement, root_movement
from extensions.room.tests.turning import Turning
from tests.notices import raises
from tests.room_tracker import RoomTracker, in_order
from tracker.base.config import to_toml
from tracker.base.errors import ConfigError, FileError
from tracker.cli import main
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.geometry import so3
from tracker.glove import library
from tracker.hand.model import HandModel
from tracker.messages import Array, ImuSample, Tracking
from tracker.offline.simulate import SimulateOptions, build
from tracker.session.writer import SessionRecorder
from tracker.simulation.motion import SimulatedMotion
from tracker.simulation.scenario import Simulation, SimulationParams
from tracker.simulation.wearer import WearerParams

YAW, DELAY = 1.2, 0.035
TRUE = RoomTracker()
IN_PLACE = SimulationParams(wearer=WearerParams(mounting_deg=0.0, wobble_deg=0.0))
"""IMUs mounted as in the glove file, so that the true alignment can be found."""
INERTIAL = Settings(engine="inertial")


def moved(motion: SimulatedMotion, tracker: RoomTracker = TRUE) -> Moved:
    hand, glove = library.load()
    sim = Simulation(hand, glove, motion, 3, IN_PLACE)
    Rz, poses = so3.rz(YAW), tracker.poses(sim)
    t_B, R_GB, speed = root_movement(list(sim.imu_samples()), hand, glove)
    return Moved(
        t_B=t_B,
        R_GB=R_GB,
        speed=speed,
        t_T=np.array([p.t + DELAY for p in poses]),
        R_WT=Rz @ so3.matrix_from_quat(np.array([p.q_GT for p in poses])),
        p_WT=np.array([p.p_GT for p in poses]) @ Rz.T,
        w_B=np.zeros(3),
    )


@pytest.fixture(scope="module")
def joints(hand: HandModel) -> int:
    return len(hand.joint_names)


@pytest.fixture(scope="module")
def movement(joints: int) -> Moved:
    return moved(Turning(joints))


def errors(found: Alignment) -> tuple[float, float]:
    """mm and degrees from the truth."""
    turned = so3.log(so3.matrix_from_quat(found.q_BT).T @ so3.exp(np.array(TRUE.turned)))
    away = np.linalg.norm(found.p_BT - np.array(TRUE.p_BT))
    return 1e3 * float(away), float(np.rad2deg(np.linalg.norm(turned)))


@pytest.mark.long
def test_offset_heading_and_delay_are_found(movement: Moved) -> None:
    """The tracker's noise is 1 mm and 0.6°; the wrist wanders by 1 mm, the gyro's bias is 1.5 °/s,
    its scale and the accelerometers' biases turn the glove by about a degree; a reading of the
    simulated gyroscope is the mean of the 10 ms before."""
    found = solve(movement)
    mm, degrees = errors(found)
    assert mm < 5.0 and degrees < 3.0
    assert found.delay == pytest.approx(DELAY, abs=0.006)
    assert abs(np.angle(np.exp(1j * (found.yaw + YAW)))) < np.deg2rad(8), "the glove drifts"
    assert found.rotation_rms < np.deg2rad(3) and found.position_rms < 0.004


@pytest.mark.long
def test_a_twentieth_of_wild_poses_and_a_gap_change_little(movement: Moved) -> None:
    rng = np.random.default_rng(4)
    wild = rng.random(len(movement.t_T)) < 0.05
    p = movement.p_WT + np.where(wild[:, None], rng.normal(0, 0.3, movement.p_WT.shape), 0)
    R = movement.R_WT @ so3.exp(np.where(wild[:, None], rng.normal(0, 0.5, p.shape), 0))
    seen = (movement.t_T < 6) | (movement.t_T > 8)
    hurt = replace(movement, t_T=movement.t_T[seen], R_WT=R[seen], p_WT=p[seen])
    mm, degrees = errors(solve(hurt))
    assert mm < 6.0 and degrees < 4.0


@pytest.mark.long
@pytest.mark.parametrize(
    ("change", "code"),
    [
        ({"about": (0.9, 0.0, 0.0)}, "room.one_axis"),
        ({"wander": 0.08}, "room.wrist_moved"),
        ({"duration": 3.0}, "room.too_short"),
    ],
)
def test_an_insufficient_movement_is_refused(
    joints: int, change: dict[str, object], code: str
) -> None:
    with raises(AlignmentError, code):
        solve(moved(Turning(joints, **change)))  # type: ignore[arg-type]


def test_a_tracker_on_something_else_is_refused(movement: Moved) -> None:
    with raises(AlignmentError, "room.movements_differ"):
        solve(replace(movement, R_WT=movement.R_WT[::-1].copy()))


def recorded(path: Path, motion: SimulatedMotion, tracker: RoomTracker | None) -> None:
    """What is recorded before an alignment: the tracker's frame counts as the hand's."""
    sim, info = build(SimulateOptions(seed=3, duration=motion.duration, fps=30, images=False))
    info = replace(info, rig=None, engine="inertial", settings_text=to_toml(INERTIAL))
    sim = Simulation(sim.hand, sim.glove, motion, 3, IN_PLACE)
    unaligned = [
        replace(p, p_BT=np.zeros(3), q_BT=np.array([0, 0, 0, 1.0]))
        for p in (tracker.poses(sim) if tracker is not None else [])
    ]
    with SessionRecorder(path, info) as recorder:
        for message in in_order(sim, unaligned):
            recorder.write(message)


@pytest.mark.long
def test_the_command_aligns_a_recording(
    joints: int, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    session, out = tmp_path / "turning.mcap", tmp_path / "alignment.toml"
    recorded(session, Turning(joints), TRUE)
    assert main(["room", "align", str(session), "-o", str(out)]) == 0
    assert "right hand: tracker at" in capsys.readouterr().out
    (found,) = alignment_file.read(out).values()
    mm, degrees = errors(found)
    assert mm < 5.0 and degrees < 3.0
    assert main(["room", "align", str(session), "-o", str(out)]) == 1, "that side is in the file"
    assert main(["room", "align", str(session), "-o", str(out), "--force"]) == 0


@pytest.mark.long
def test_an_aligned_glove_follows_the_tracker(joints: int) -> None:
    """The alignment of one movement, used on another one."""
    hand, glove = library.load()
    found = solve(moved(Turning(joints)))
    sim = Simulation(hand, glove, Turning(joints, 6.0, (0.5, 0.9, 0.8), 0.05), 3, IN_PLACE)
    pipeline, error = Pipeline(hand, glove, None, INERTIAL), []
    poses = [replace(p, p_BT=found.p_BT, q_BT=found.q_BT) for p in TRUE.poses(sim)]
    for message in in_order(sim, poses):
        if not isinstance(message, ImuSample):
            pipeline.feed_wrist(message)
            continue
        e = pipeline.feed_imu(message)
        if e.t > 1.0 and e.t < 5.8:
            assert e.tracking == Tracking.TRACKING
            error.append(distance(e.keypoints[0], sim.truth(e.t).keypoints[0]))
    assert np.mean(error) < 0.004 and np.max(error) < 0.01


def distance(a: Array, b: Array) -> float:
    return float(np.linalg.norm(a - b))


@pytest.mark.long
def test_a_session_without_poses_is_refused(tmp_path: Path, hand: HandModel) -> None:
    path = tmp_path / "plain.mcap"
    recorded(path, Turning(len(hand.joint_names), 5.0), None)
    with raises(FileError, "room.no_poses"):
        recorded_movement(path)
    recorded(
        tmp_path / "points.mcap",
        Turning(len(hand.joint_names), 5.0),
        replace(TRUE, with_rotation=False),
    )
    with raises(FileError, "room.no_rotations"):
        recorded_movement(tmp_path / "points.mcap")


def test_alignments_are_written_and_read(tmp_path: Path) -> None:
    path, both = tmp_path / "both.toml", {}
    for k, side in enumerate(("right", "left")):
        q = so3.quat_from_matrix(so3.exp(np.array([0.1, 0.2, k])))
        both[side] = Alignment(np.array([0.01, 0.02, k / 100]), q, 0.02 * k)
    alignment_file.write(path, both)
    for side, found in alignment_file.read(path).items():
        np.testing.assert_allclose(found.p_BT, both[side].p_BT, atol=1e-9)
        np.testing.assert_allclose(found.q_BT, both[side].q_BT, atol=1e-8)
        assert found.delay == pytest.approx(both[side].delay)


@pytest.mark.parametrize(
    "text",
    [
        "[middle]\nposition_m = [0, 0, 0]\n",
        "[right]\nposition_m = [0, 0]\nrotation_xyzw = [0, 0, 0, 1]\n",
        "[right]\nposition_m = [0, 0, 0]\nrotation_xyzw = [0, 0, 0, 2]\n",
        '[right]\nposition_m = [0, 0, "a"]\nrotation_xyzw = [0, 0, 0, 1]\n',
        "[right]\nposition_m = [0, 0, 0]\nrotation_xyzw = [0, 0, 0, 1]\nscale = 2\n",
        "right = 3\n",
    ],
)
def test_other_files_are_refused(tmp_path: Path, text: str) -> None:
    path = tmp_path / "alignment.toml"
    path.write_text(text)
    with raises(ConfigError, "room.bad_alignment"):
        alignment_file.read(path)
