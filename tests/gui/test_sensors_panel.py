"""The sensors in the real window: curves, cursor readings, the glove's status."""

import dataclasses

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPointF
from PySide6.QtWidgets import QApplication

from app.viewmodels.sensors import glove_figures, link_tip
from tests.gui.gui_fakes import ScriptedEngine, models
from tracker import GRAVITY
from tracker.messages import Status, Tracking
from tracker.sensors.decoder import LinkCounters
from tracker.sensors.link_figures import LinkFigures


@pytest.fixture
def sensors(live, qtbot):
    live.run_command("show_sensors")
    qtbot.waitUntil(lambda: "gyro" in live.panels["sensors"]._shown)
    return live.panels["sensors"]


def point(plot, t: float) -> None:
    """Move the pointer over a time."""
    box = plot.plot.plotItem.vb
    plot.plot.scene().sigMouseMoved.emit(box.mapViewToScene(QPointF(t, 0.0)))


def test_the_imu_and_its_axes_are_selected(sensors, engine):
    sensors.choice.setCurrentIndex(3)
    sensors.refresh(sensors.host.snapshot())
    _, y = sensors.plots["gyro"].curves[1].getData()
    assert y[-1] == pytest.approx(np.rad2deg(engine.recent_imu()[-1].gyro[3, 1]))
    sensors.toggles[1].click()
    assert not sensors.plots["gyro"].curves[1].isVisible()
    assert not sensors.plots["accel"].curves[1].isVisible()
    assert sensors.plots["gyro"].curves[0].isVisible()


def test_the_cursor_reads_the_values_below_it(sensors, engine):
    samples = engine.recent_imu()
    then = samples[-51]
    at = then.t - samples[-1].t
    point(sensors.plots["gyro"], at)
    text = sensors.figures.text()
    assert text.startswith(f"{at:.2f} s: x {np.rad2deg(then.gyro[0, 0]):.3g}")
    assert f"z {then.accel[0, 2] / GRAVITY:.3g} g" in text
    sensors.toggles[0].click()
    point(sensors.plots["gyro"], at)
    assert "x " not in sensors.figures.text()
    QApplication.sendEvent(sensors.plots["gyro"], QEvent(QEvent.Type.Leave))
    assert "100.0 Hz" in sensors.figures.text()


def test_the_angles_of_a_finger_scroll(sensors, engine, qtbot):
    sensors.choice.setCurrentIndex(sensors.choice.findText("Angles: index"))
    assert sensors.plots["gyro"].isHidden() and not sensors.plots["angles"].isHidden()
    assert [box.text() for box in sensors.toggles] == [
        "mcp flexion",
        "mcp abduction",
        "pip flexion",
        "dip flexion",
    ]
    for frame in (31, 33, 35):
        engine.frame = frame
        sensors.refresh(sensors.host.snapshot())
    column = models()[0].angle_index["index_pip_flexion"]
    t, angle = sensors.plots["angles"].curves[2].getData()
    assert angle[-1] == pytest.approx(np.rad2deg(engine.latest_estimate().angles[column]))
    assert t[-1] == 0.0 and t[-3] == pytest.approx(-4 / 30, abs=1e-3)


def test_paused_curves_are_still_and_readable(sensors, engine):
    sensors.hold.click()
    before = sensors.plots["gyro"].curves[0].getData()[1].copy()
    engine.frame = 60
    sensors.refresh(sensors.host.snapshot())
    np.testing.assert_array_equal(sensors.plots["gyro"].curves[0].getData()[1], before)
    point(sensors.plots["accel"], -0.2)
    assert sensors.figures.text().startswith("-0.2")


def test_an_imu_without_data_is_named(sensors, engine, monkeypatch):
    samples = engine.recent_imu()
    valid = samples[0].valid.copy()
    valid[2] = False
    silent = [dataclasses.replace(s, valid=valid) for s in samples]
    monkeypatch.setattr(engine, "recent_imu", lambda: silent)
    sensors.refresh(sensors.host.snapshot())
    name = models()[1].imu_names[2].replace("_", " ")
    assert sensors.chips[2].text() == f"{name}: not responding"
    assert sensors.chips[1].text() == models()[1].imu_names[1].replace("_", " ")


def test_the_gloves_known_figures_are_shown():
    samples = ScriptedEngine().recent_imu()
    values = {"imu_rate_hz": 99.96, "imu_lost": 1.0, "battery_v": 3.7, "temperature_c": 29.0}
    shown = glove_figures(Status(0.0, Tracking.TRACKING, values), samples)
    assert shown[:2] == ["100.0 Hz", "1 packet lost"]
    assert shown[3:] == ["battery 3.70 V", "29.0 °C"]
    intervals = np.diff([s.t_arrival for s in samples[-100:]])
    assert shown[2] == f"jitter {1000 * intervals.std():.1f} ms"
    assert glove_figures(None, []) == []


def test_the_links_counters_are_shown_as_soon_as_there_is_something_to_show():
    quiet = LinkFigures(battery_mV=3700).values()
    assert glove_figures(Status(0.0, Tracking.TRACKING, quiet), []) == ["battery 3.70 V"]
    counters = LinkCounters(cobs_errors=1, crc_errors=2, length_errors=3, oversize=4)
    figures = LinkFigures(
        resets=1, opened=3, dropped=7, battery_mV=3499, skew_ppm=-61.4, latency_ms=16
    )
    figures.counters = counters
    status = Status(0.0, Tracking.TRACKING, figures.values())
    assert glove_figures(status, []) == [
        "⚠ battery low: 3.50 V",
        "10 frames damaged",
        "7 packets dropped by the glove",
        "1 restart",
        "2 reconnections",
        "clock -61 ppm",
        "⚠ adapter latency 16 ms",
    ]
    tip = link_tip(status).splitlines()
    assert "Frames with a wrong checksum (CRC): 2" in tip
    assert "Times the port was reopened: 2" in tip
    assert link_tip(None) == ""
