"""A recorded hand on the model of an arm: the files by an XML parser, and as OpenSim reads them."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree as ET

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from extensions.movement.tests.arm import BODY, MASS, WRIST
from extensions.movement.whole_body import AXES, LIGHT, MotionCourse
from tests.notices import raises
from tests.streaming.recorded_hand import OPENXR_JOINTS, RecordedHand, assert_parallel
from tracker.base.errors import ConfigError, FileError
from tracker.cli import main
from tracker.session.reader import SessionReader

OFFSET = 2.5  # s


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory, recorded: RecordedHand) -> Path:
    """The arm, its motion in degrees at some instants of the recording, and the outputs."""
    folder = tmp_path_factory.mktemp("arm")
    (folder / "arm.osim").write_text(BODY)
    t = recorded.recording.t[50:250:20] - recorded.recording.t[0] + OFFSET
    values = np.column_stack([20 + 5 * t, -10 + t])
    MotionCourse(t, ("elbow_flex_r", "wrist_flex_r"), values, True).write(folder / "arm.mot")
    given = [str(recorded.path), "--body", str(folder / "arm.osim"), "-o", str(folder / "o.osim")]
    moved = ["--motion", str(folder / "arm.mot"), "--offset", str(OFFSET)]
    assert main(["opensim-body", *given, *moved]) == 0
    return folder


def test_the_hand_is_welded_at_the_wrist_and_the_mass_stays(folder: Path) -> None:
    model = ET.parse(folder / "o.osim").getroot().find("Model")
    assert model is not None
    for kind in ("BodySet", "JointSet", "MarkerSet"):
        names = [e.get("name") for e in model.iterfind(f"{kind}/objects/*")]
        assert len(names) == len(set(names)) > 2
    (weld,) = model.iterfind("JointSet/objects/WeldJoint")
    assert weld.findtext("socket_child_frame") == "/bodyset/right_dorsum"
    assert weld.findtext("frames/*/socket_parent") == "/bodyset/hand_r"
    at = [float(v) for v in weld.findtext("frames/*/translation", "").split()]
    np.testing.assert_allclose(at, WRIST)
    mass = {b.get("name"): float(b.findtext("mass", "")) for b in model.iterfind("*/objects/Body")}
    assert mass["hand_r"] == pytest.approx(LIGHT)
    assert sum(mass.values()) == pytest.approx(1.2 + MASS)
    motion = MotionCourse.read(folder / "o.mot")
    coordinates = {c.get("name") for c in model.iter("Coordinate")}
    assert set(motion.names) == coordinates
    np.testing.assert_allclose(motion.values[:, 0], 20 + 5 * motion.t)


def test_opensim_has_the_recorded_hand_at_the_end_of_the_arm(
    folder: Path, recorded: RecordedHand
) -> None:
    """Within 0.1° of the recording; the wrist where the arm has its own."""
    opensim = pytest.importorskip("opensim")
    opensim.Logger.setLevelString("error")
    model = opensim.Model(str(folder / "o.osim"))
    state = model.initSystem()
    table = opensim.TimeSeriesTable(str(folder / "o.mot"))
    names, times = list(table.getColumnLabels()), np.array(table.getIndependentColumn())
    rows, hand = table.getMatrix().to_numpy(), recorded.recording.hand
    for k in range(0, len(times), 4):
        for name, value in zip(names, np.deg2rad(rows[k]), strict=True):
            coordinate = model.getCoordinateSet().get(name)
            coordinate.setLocked(state, False)
            coordinate.setValue(state, float(value), False)
        model.realizePosition(state)
        pose = {b.getName(): b.getTransformInGround(state) for b in model.getBodySet()}
        own = turn_of(pose["hand_r"])
        assert_parallel(turn_of(pose["right_dorsum"]), own * Rotation.from_matrix(AXES["right"]))
        at = pose["hand_r"].p().to_numpy() + own.apply(WRIST)
        np.testing.assert_allclose(pose["right_dorsum"].p().to_numpy(), at, atol=1e-9)
        row = int(np.abs(hand.t - hand.t[0] + OFFSET - times[k]).argmin())
        wrist = Rotation.from_quat(hand.orientations["wrist"][row])
        for segment, keypoint in list(OPENXR_JOINTS.items())[1:]:
            if f"right_{segment}" in pose:
                found = turn_of(pose["right_dorsum"]).inv() * turn_of(pose[f"right_{segment}"])
                bone = Rotation.from_quat(hand.orientations[keypoint][row])
                assert np.rad2deg((found.inv() * wrist.inv() * bone).magnitude()) < 0.1


def turn_of(transform) -> Rotation:
    R = transform.R()
    return Rotation.from_matrix([[R.get(i, j) for j in range(3)] for i in range(3)])


def test_without_a_motion_the_body_has_its_default_pose(
    folder: Path, recorded: RecordedHand, tmp_path: Path
) -> None:
    given = [str(recorded.path), "--body", str(folder / "arm.osim")]
    place = ["--place-right", "0", "0.1", "0", "0", "0", "90"]
    assert main(["opensim-body", *given, "-o", str(tmp_path / "o.osim"), *place]) == 0
    motion = MotionCourse.read(tmp_path / "o.mot")
    assert not motion.in_degrees
    np.testing.assert_allclose(motion.values[:, 0], 0.3)
    with SessionReader(recorded.path) as reader:
        column = motion.names.index(f"right_{reader.info.hand.joint_names[0]}")
    angle = next(iter(recorded.recording.hand.angles.values()))
    np.testing.assert_allclose(motion.values[:, column], angle, atol=1e-6)


def test_what_cannot_be_attached_is_refused(
    folder: Path, recorded: RecordedHand, tmp_path: Path
) -> None:
    from extensions.movement.whole_body import DorsumPlacement, WholeBody, combined

    (tmp_path / "old.osim").write_text(BODY.replace("40000", "30000"))
    with raises(FileError, "osim.old_model"):
        WholeBody(tmp_path / "old.osim")
    body = WholeBody(folder / "arm.osim")
    with SessionReader(recorded.path) as reader:
        with raises(ConfigError, "osim.no_segment", name="hand"):
            body.attach(reader, DorsumPlacement.of("right", "hand"))
        hands = {"right": body.attach(reader, DorsumPlacement.of("right"))}
    with raises(ConfigError, "osim.no_overlap"):
        combined(hands, MotionCourse.read(folder / "arm.mot"), {}, 90.0)
