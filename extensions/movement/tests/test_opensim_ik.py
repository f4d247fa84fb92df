"""OpenSim's own inverse kinematics on our model, markers and orientations finds our angles."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tracker.geometry import so3
from tracker.hand.model import HandModel
from tracker.messages import Array, Estimate
from tracker.session.export.options import ExportOptions
from tracker.session.export.run import export

opensim = pytest.importorskip("opensim")

RATE, COUNT = 50.0, 25
FINGERS = ("index", "middle", "ring", "little")
ACCURACY = 1e-7  # the hand is small: with OpenSim's 1e-5 its solver stops some degrees away


def moving(maker, scale: Array, is_fist: bool = False) -> list[Estimate]:
    """A hand of a calibrated size that turns, and all of whose angles swing within their limits; or
    whose fingers flex by 80 to 95° in their first joints, and are twisted by 6° there."""
    hand, glove = maker.info.hand, maker.info.glove
    low, high = hand.angle_limits.T
    flexions = [hand.joint_names.index(f"{f}_mcp_flexion") for f in FINGERS]
    out = []
    for k in range(COUNT):
        phase = np.sin(2 * np.pi * k / COUNT + np.arange(len(low)))
        angles = 0.5 * (low + high) + 0.3 * (high - low) * phase
        if is_fist:
            angles[flexions] = np.deg2rad(87.5 + 7.5 * np.sin(2 * np.pi * k / COUNT))
        R_GB, p = so3.exp(np.array([0.3, -0.4, 0.02 * k])), np.array([0.3, 0.1 + 0.002 * k, 1.0])
        R, p = hand.forward(angles, R_GB, p, scale)
        for finger in FINGERS if is_fist else ():
            i = hand.index[f"{finger}_proximal"]
            twist(hand, R, p, i, np.deg2rad(6.0))
            turn = hand.segments[i].R_rest.T @ R[hand.parent[i]].T @ R[i]
            nearest = so3.joint_angles(turn, twists=False)  # as the engines give them
            angles[list(hand.axis_columns[i][:2])] = nearest[:2]
        e = maker.estimate(1000.0 * k / RATE)
        out.append(
            replace(
                e,
                angles=angles,
                segment_R=R,
                segment_p=p,
                keypoints=glove.keypoint_positions(hand, R, p, scale),
                keypoint_q=so3.quat_from_matrix(R[glove.keypoint_segments(hand)]),
            )
        )
    return out


def twist(hand: HandModel, R: Array, p: Array, i: int, angle: float) -> None:
    """Rotate segment ``i`` and its descendants about its own axis, in place."""
    turn = R[i] @ so3.exp(np.array([angle, 0.0, 0.0])) @ R[i].T
    behind = [i]
    for s, parent in enumerate(hand.parent):
        if parent in behind:
            behind.append(s)
    p[behind] = p[i] + (p[behind] - p[i]) @ turn.T
    R[behind] = turn @ R[behind]


@pytest.fixture(params=[False, True], ids=["swinging", "fist"])
def files(
    tmp_path: Path, record: Callable[..., Path], maker, request: pytest.FixtureRequest
) -> tuple[Path, Array]:
    """A folder with o.osim, o.trc, o.mot and o.sto; (COUNT, J) true angles in degrees."""
    hand, glove = maker.info.hand, maker.info.glove
    scale = np.ones((len(hand.segments), 3))
    sensed = dict.fromkeys(hand.segments[i].name for i in glove.imu_segment(hand))
    calibration = maker.calibration(0)
    values = np.tile([1.06, 0.95, 0.95], (len(sensed), 1))
    for name in sensed:
        scale[hand.index[name]] = values[0]
    rows = {
        f: np.zeros_like(values)
        for f in ("scale_sd", "mounting_sd", "gyro_bias", "gyro_bias_sd", "accel_bias",
                  "accel_bias_sd")
    }  # fmt: skip
    mounting = np.tile([0.1, -0.05, 0.08], (len(sensed), 1))
    calibration = replace(
        calibration, segments=tuple(sensed), scale=values, mounting=mounting, **rows
    )
    estimates = moving(maker, scale, request.param)
    session = record(tmp_path / "in.mcap", [calibration, *estimates])
    for form in ("osim", "trc", "mot", "sto"):
        export(session, form, tmp_path / f"o.{form}", ExportOptions())
    opensim.Logger.setLevelString("error")
    return tmp_path, np.rad2deg([e.angles for e in estimates])


def columns(path: Path) -> tuple[list[str], Array]:
    table = opensim.TimeSeriesTable(str(path))
    return list(table.getColumnLabels()), table.getMatrix().to_numpy()


@pytest.mark.long
def test_markers_give_the_angles_within_a_degree(files: tuple[Path, Array], maker) -> None:
    folder, truth = files
    model = opensim.Model(str(folder / "o.osim"))
    model.initSystem()
    tool = opensim.InverseKinematicsTool()
    tool.setModel(model)
    tool.setMarkerDataFileName(str(folder / "o.trc"))
    tool.setOutputMotionFileName(str(folder / "found.mot"))
    tool.setResultsDir(str(folder))
    tool.set_report_errors(False)
    tool.set_accuracy(ACCURACY)
    assert tool.run()
    names, found = columns(folder / "found.mot")
    columns_read, mot = columns(folder / "o.mot")
    assert columns_read == list(maker.info.hand.joint_names) and len(found) == COUNT
    mine = found[:, [names.index(n) for n in columns_read]]
    assert np.abs(mine - truth).max() < 1.0
    assert np.abs(mine - mot).max() < 1.0


@pytest.mark.long
def test_imus_give_the_angles_between_them_within_two_degrees(
    files: tuple[Path, Array], maker
) -> None:
    folder, truth = files
    tool = opensim.IMUInverseKinematicsTool()
    tool.set_model_file(str(folder / "o.osim"))
    tool.set_orientations_file(str(folder / "o.sto"))
    tool.set_results_directory(str(folder))
    tool.set_output_motion_file("found.mot")
    tool.set_report_errors(False)
    assert tool.run(False)
    names, found = columns(folder / "found.mot")
    hand = maker.info.hand
    sensed = {i.segment for i in maker.info.glove.imus}
    between = [
        k
        for s in hand.segments
        if s.name in sensed and s.parent in sensed
        for k in hand.axis_columns[hand.index[s.name]]
        if k >= 0
    ]
    assert len(between) >= 10 and len(found) == COUNT
    mine = found[:, [names.index(hand.joint_names[k]) for k in between]]
    assert np.abs(mine - truth[:, between]).max() < 2.0
