"""Curves of signals: updated incrementally, interrupted in holes, of hands and recordings."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from app.engines.snapshot import Snapshot
from app.viewmodels.graphs import (
    Graph,
    from_setting,
    refusal,
    table,
    to_setting,
    units_of,
    value_at,
)
from app.viewmodels.signal_curves import LiveCurves
from app.viewmodels.signals import angle_signal, imu_signals, signals
from tests.gui.gui_fakes import ScriptedEngine, models, scripted_setup
from tracker import GRAVITY
from tracker.messages import Status, Tracking


@pytest.fixture
def setup():
    return scripted_setup(ScriptedEngine())


def imu_curves(imu: int, span: float):
    chosen = imu_signals("right", imu, models()[1].imu_names[imu])
    curves = LiveCurves(span)
    curves.choose(chosen)
    return {signal.name.split("/", 1)[1]: signal.key for signal in chosen}, curves


def test_curves_have_display_units(setup):
    samples = setup.tracked.recent_imu()
    keys, curves = imu_curves(2, 0.5)
    curves.take(Snapshot(setup, True, imu=samples))
    t, x = curves.curve(keys["gyro/x"])
    assert t[-1] == samples[-1].t and t[0] >= t[-1] - 0.5
    assert x[-1] == pytest.approx(np.rad2deg(samples[-1].gyro[2, 0]))
    assert curves.curve(keys["accel/z"])[1][-1] == pytest.approx(samples[-1].accel[2, 2] / GRAVITY)


def test_incremental_curves_equal_complete_ones(setup):
    """Live data are appended; a replay that seeks has other ones."""
    samples, span = setup.tracked.recent_imu(), 0.3
    keys, bits = imu_curves(1, span)
    for end in (1, 2, 30, 31, len(samples), 40, len(samples)):
        for begin in (0, end // 2, end - 1):
            shown = samples[begin:end]
            bits.take(Snapshot(setup, True, imu=shown))
            t, values = bits.curve(keys["accel/x"])
            # what is older than the first that is handed over may have come before
            own = [s for s in shown if s.t >= shown[-1].t - span]
            np.testing.assert_array_equal(t[-len(own) :], [s.t for s in own])
            assert values[-len(own) :] * GRAVITY == pytest.approx([s.accel[1, 0] for s in own])
            assert (np.diff(t) > 0).all() and t[0] >= t[-1] - span - 1e-9


def test_incremental_smoothed_curves_equal_complete_ones(setup):
    engine, column = setup.tracked, models()[0].angle_index["index_pip_flexion"]
    estimates = []
    for engine.frame in range(31, 90):
        estimates.append(engine.latest_estimate())
    speed = angle_signal("right", column, "index_pip_flexion", speed=True)
    bits, once = LiveCurves(10.0), LiveCurves(10.0)
    bits.choose([speed])
    once.choose([speed])
    for end in (1, 2, 3, 9, 10, 28, 45, 59):
        bits.take(Snapshot(setup, True, estimates=estimates[max(0, end - 20) : end]))
    once.take(Snapshot(setup, True, estimates=estimates))
    (t, values), (u, wanted) = bits.curve(speed.key), once.curve(speed.key)
    shared = np.isin(u, t)
    assert shared.sum() > 40 and np.isfinite(wanted[shared]).all()
    np.testing.assert_allclose(values[np.isin(t, u)], wanted[shared])


def test_a_hole_interrupts_and_seeking_back_restarts(setup):
    estimate = setup.tracked.latest_estimate()
    angle = angle_signal("right", 0, models()[0].joint_names[0])
    curves = LiveCurves(8.0)
    curves.choose([angle])
    taken = []
    for t in (1.0, 1.05, 3.0, 3.05):
        taken.append(dataclasses.replace(estimate, t=t))
        curves.take(Snapshot(setup, True, estimates=taken))
        curves.take(Snapshot(setup, True, estimates=taken))
    t, values = curves.curve(angle.key)
    assert t == pytest.approx([1.0, 1.05, 2.025, 3.0, 3.05])
    assert np.isnan(values).tolist() == [False, False, True, False, False]
    curves.take(Snapshot(setup, True, estimates=[dataclasses.replace(estimate, t=0.5)]))
    assert curves.curve(angle.key)[0].tolist() == [0.5]
    curves.take(Snapshot(setup, True, estimates=[dataclasses.replace(estimate, t=9.0)]))
    assert curves.curve(angle.key)[0][0] > 9.0 - 8.0


def test_status_gestures_and_images_are_curves_of_their_own(setup):
    engine = setup.tracked
    known = {s.key: s for s in signals(setup, {"battery_v", "rare_things"})}
    chosen = [
        known[f"right/{name}"]
        for name in (
            "status/battery_v",
            "status/rare_things",
            "gestures/open_palm",
            "images/blobs_left",
            "images/residual_left",
            "hand/tracking",
        )
    ]
    assert [s.unit for s in chosen] == ["V", "", "%", "", "px", ""]
    curves = LiveCurves(8.0)
    curves.choose(chosen)
    for engine.frame in (31, 33):
        status = Status(float(engine.frame), Tracking.TRACKING, {"battery_v": 3.7})
        view = Snapshot(
            setup,
            True,
            status=status,
            estimates=engine.recent_estimates(),
            images=engine.recent_images(),
        )
        curves.take(view)
    battery, rare, palm, blobs, residual, tracking = (curves.curve(s.key)[1] for s in chosen)
    assert battery.tolist() == [3.7, 3.7] and np.isnan(rare).all()
    assert len(palm) == 2 and ((palm >= 0) & (palm <= 100)).all()
    assert blobs[-1] == len(engine.latest_frame()[1].left) and np.isnan(residual).all()
    assert tracking.tolist() == [1.0, 1.0]


def test_keys_are_unique_and_both_hands_have_their_own(setup):
    left = dataclasses.replace(setup, glove=dataclasses.replace(setup.glove, side="left"))
    both = dataclasses.replace(setup, others=(left,))
    found = signals(both, {"battery_v"})
    keys = [s.key for s in found]
    assert len(set(keys)) == len(keys) == 2 * len(signals(setup, {"battery_v"}))
    assert {s.path[0] for s in found} == {"Left hand", "Right hand"}
    assert all(s.label.startswith(("left ", "right ")) for s in found)


def test_a_graph_has_at_most_two_units_and_gives_the_reason(setup):
    known = {s.name: s for s in signals(setup)}
    gyro, accel = known["dorsum/gyro/x"], known["dorsum/accel/x"]
    assert units_of([gyro, accel, gyro]) == ["°/s", "g"]
    assert refusal([gyro], accel) == "" == refusal([gyro, accel], gyro)
    why = refusal([gyro, accel], known["point/index_tip/x"])
    assert "°/s" in why and "mm" in why


def test_graph_settings_survive_and_invalid_ones_are_dropped():
    graphs = [Graph(("a", "b"), 30.0, 5.0), Graph()]
    assert from_setting(to_setting(graphs)) == graphs
    odd = [{"signals": ["a", 3], "span": "x"}, "no", {"signals": 5, "replay_span": -1}]
    assert from_setting(odd) == [Graph(("a",)), Graph()]
    assert from_setting(None) == []


def test_tables_join_signals_with_other_times(setup):
    known = {s.name: s for s in signals(setup)}
    gyro, angle = known["dorsum/gyro/x"], known["angle/index_pip_flexion"]
    curves = {
        gyro: (np.array([1.0, 1.1, 1.2]), np.array([1.0, np.nan, 3.0])),
        angle: (np.array([1.1, 1.2, 1.3]), np.array([10.0, 20.0, 30.0])),
    }
    assert table(curves, 1.0, 1.25, 1.2).splitlines()[1:] == [
        "-0.200000,1,",
        "-0.100000,,10",
        "0.000000,3,20",
    ]
    assert value_at(curves[angle], 1.16) == 20.0 and value_at(curves[angle], 0.0) == 10.0
    assert np.isnan(value_at((np.zeros(0), np.zeros(0)), 0.0))
