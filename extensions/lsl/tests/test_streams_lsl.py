"""LSL: the sample's form, and an inlet that finds the outlet on this machine."""

from __future__ import annotations

import math
import time
from dataclasses import replace

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.spatial.transform import Rotation

try:
    import pylsl
except (ImportError, RuntimeError) as error:  # RuntimeError: no liblsl beside it
    pytest.skip(f"pylsl is not usable: {error}", allow_module_level=True)

from extensions.lsl.outlet import LslPublisher, channels, sample
from tests.streaming.moving_hand import turning
from tests.streaming.recorded_hand import RecordedHand, assert_near, assert_parallel
from tracker.base.clock import ClockAnchor
from tracker.gestures.values import GESTURES
from tracker.hand.openxr import JOINTS, joint_radii, to_openxr
from tracker.messages import Estimate
from tracker.streaming.publisher import Names

ANCHOR = ClockAnchor(1_732_538_096_123_456_789, 0)


def test_channels_name_every_value_of_a_sample(make_estimate, names: Names) -> None:
    e = make_estimate(lost=("thumb_tip", "thumb_ip_flexion"), angles={"ring_pip_flexion": 0.5})
    read = dict(zip([label for label, _ in channels(names)], sample(e, names), strict=True))
    i = names.keypoints.index("ring_tip")
    assert_allclose([read[f"ring_tip_{a}"] for a in "xyz"], e.keypoints[i])
    assert read["ring_tip_state"] == 2 and read["tracking"] == 1
    assert math.isnan(read["thumb_tip_x"]) and read["thumb_tip_state"] == 0
    assert math.isnan(read["thumb_ip_flexion"]) and read["thumb_ip_flexion_state"] == 0
    assert read["ring_pip_flexion"] == 0.5


def test_numbers_of_a_lost_row_are_not_sent(make_estimate, names: Names) -> None:
    e = make_estimate()
    nothing = replace(e, keypoint_state=0 * e.keypoint_state, angle_state=0 * e.angle_state)
    read = dict(
        zip([n for n, _ in channels(names, 1)], sample(nothing, names, None, 1), strict=True)
    )
    values = {k: v for k, v in read.items() if not k.endswith("_state") and k != "tracking"}
    shown = [values.pop(f"gesture_{n}_shown") for n in GESTURES]
    assert not any(shown)
    assert np.isnan([values.pop(f"gesture_{n}") for n in GESTURES]).all()
    assert len(values) == 3 * len(names.keypoints) + len(names.angles)
    assert all(math.isnan(v) for v in values.values())


def test_an_inlet_reads_a_recording_with_its_stamps(recorded: RecordedHand, wait_for) -> None:
    """Instants are moved to the present, as LSL's clock is that of this computer."""
    names = replace(recorded.names.with_openxr(), anchor=ANCHOR)
    out = LslPublisher(names)
    try:
        found = pylsl.resolve_byprop("source_id", "glovetrack-right", timeout=8)
        if not found:
            pytest.skip("LSL finds nothing here: this machine passes no multicast")
        assert out.probe().code == "stream.test_no_client"
        inlet = pylsl.StreamInlet(found[0])
        inlet.open_stream(timeout=60)
        wait_for(lambda: out.probe().code == "stream.test_read")
        info = inlet.info(5)  # owns what its description returns
        labels, clock = info.get_channel_labels(), info.desc().child("clock")
        for e in recorded.estimates:
            t = time.monotonic()
            out.send(replace(e, t=t))
            values, stamp = inlet.pull_sample(timeout=60)
            before, clock_s, after = time.monotonic(), pylsl.local_clock(), time.monotonic()
            assert t - after - 0.01 < stamp - clock_s < t - before + 0.01
            check(dict(zip(labels, values, strict=True)), recorded, e)
            since = 1e9 * (stamp - float(clock.child_value("lsl")))
            assert int(clock.child_value("unix_ns")) + since == pytest.approx(
                ANCHOR.wall(t), abs=1e5
            )
        inlet.close_stream()
    finally:
        out.close()
    out.send(recorded.estimates[0])  # ignored after closing


def check(read: dict[str, float], recorded: RecordedHand, e: Estimate) -> None:
    for joint, (p, R) in recorded.openxr(e).items():
        assert_near([read[f"{joint}_{a}"] for a in "xyz"], p)
        assert_parallel(Rotation.from_quat([read[f"{joint}_q{a}"] for a in "xyzw"]), R)
    for name, angle in recorded.angles(e).items():
        assert read[name] == pytest.approx(angle, abs=1e-6)


def test_the_second_schema_appends_numbers_and_velocities(make_estimate, names: Names) -> None:
    e = turning(make_estimate(lost=("thumb_tip",)), names)
    first, second = channels(names, 1), channels(names, 2)
    assert second[: len(first)] == first
    assert_allclose(sample(e, names, None, 2)[: len(first)], sample(e, names, None, 1))
    read = dict(zip([label for label, _ in second], sample(e, names), strict=True))
    i, j = names.keypoints.index("ring_tip"), names.angles.index("ring_pip_flexion")
    assert read["seq"] == 7 and e.motion is not None
    assert_allclose([read[f"ring_tip_v{a}"] for a in "xyz"], e.motion.linear[i])
    assert_allclose([read[f"ring_tip_w{a}"] for a in "xyz"], [0, 0, 2])
    assert (read["ring_tip_v_sd"], read["ring_tip_w_sd"]) == (0.02, 0.03)
    assert read["ring_pip_flexion_rate"] == e.motion.angle_rate[j]
    assert (read["ring_pip_flexion_rate_sd"], read["ring_pip_flexion_sd"]) == (0.05, 0.01)
    assert math.isnan(read["thumb_tip_vx"]) and math.isnan(read["thumb_tip_w_sd"])


def test_lsl_labels_pose_radius_and_state(make_estimate, names: Names, hand) -> None:
    openxr = names.with_openxr()
    e = make_estimate(lost=("middle_mcp",))
    labels = [label for label, _ in channels(openxr)]
    read = dict(zip(labels, sample(e, openxr), strict=True))
    wanted = to_openxr(e, openxr.keypoints, joint_radii(hand))
    i = JOINTS.index("ring_tip")
    pose = [read[f"ring_tip_{c}"] for c in ("x", "y", "z", "qx", "qy", "qz", "qw", "radius")]
    assert_allclose(pose, [*wanted.position[i], *wanted.orientation[i], wanted.radius[i]])
    assert read["ring_tip_state"] == 2 and read["palm_state"] == 0
    assert np.isnan([read["palm_x"], read["palm_qw"], read["palm_radius"]]).all()
