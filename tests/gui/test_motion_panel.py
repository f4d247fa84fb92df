"""The motion in the real window: numbers, bars, curves, the table."""

from __future__ import annotations

import csv

import numpy as np
import pytest
from PySide6.QtCore import QPointF
from PySide6.QtGui import QGuiApplication

from app.engines.replay.engine import open_replay
from app.panels.motion.panel import BAR, RANGE, SHARE, VALUE
from tests.gui.gui_fakes import ScriptedEngine
from tracker.session.motion import read_take
from tracker.session.reader import SessionReader


@pytest.fixture
def motion(live, qtbot):
    """The panel in front, with numbers."""
    live.show_panel("motion")
    panel = live.motion
    qtbot.waitUntil(panel.isVisible)
    panel.refresh(live.host.snapshot())
    return panel


def row_of(panel, name: str) -> int:
    return panel.model.names.index(name)


def test_each_angle_is_a_number_and_a_bar_in_its_range(motion, engine: ScriptedEngine):
    estimate = engine.latest_estimate()
    for name in ("index_pip_flexion", "thumb_ip_flexion"):
        row = row_of(motion, name)
        assert motion.table.item(row, 0).text() == name.replace("_", " ")
        shown = float(motion.table.item(row, VALUE).text().split()[0])
        assert shown == pytest.approx(np.rad2deg(estimate.angles[row]), abs=0.06)
        low, high = motion.model.limits[row]
        share = motion.table.item(row, BAR).data(SHARE)
        assert share == pytest.approx((estimate.angles[row] - low) / (high - low))


def test_removed_distances_are_restored_by_undo(motion, live):
    names = list(motion.model.names)
    motion.table.selectRow(row_of(motion, "thumb_tip - index_tip"))
    motion.controls.remove.click()
    assert "thumb_tip - index_tip" not in motion.model.names
    assert live.banner.text() == "Distances removed: 1."
    live.banner.buttons[0].click()
    assert motion.model.names == names


def test_the_aperture_is_there_and_any_distance_can_be_added(motion, engine: ScriptedEngine):
    names = list(motion.model.point_names)
    estimate = engine.latest_estimate()
    a, b = names.index("thumb_tip"), names.index("index_tip")
    row = row_of(motion, "thumb_tip - index_tip")
    true = 1000 * np.linalg.norm(estimate.keypoints[a] - estimate.keypoints[b])
    assert float(motion.table.item(row, VALUE).text().split()[0]) == pytest.approx(true, abs=0.06)
    many = motion.table.rowCount()
    motion.controls.ends[0].setCurrentText("wrist")
    motion.controls.ends[1].setCurrentText("middle tip")
    motion.controls.measure.click()
    motion.controls.measure.click()  # adding the same one again adds no row
    assert motion.table.rowCount() == many + 1
    motion.refresh(motion.host.snapshot())
    assert motion.table.item(many, VALUE).text().endswith("mm")
    motion.controls.remove.click()
    assert motion.table.rowCount() == many


def test_radians_are_stored_as_the_unit(motion, store):
    motion.controls.units.setCurrentIndex(motion.controls.units.findData("rad"))
    motion.refresh(motion.host.snapshot())
    assert store.value.angle_unit == "rad"
    assert motion.table.item(0, VALUE).text().endswith("rad")


def test_live_curves_are_of_the_last_seconds(motion, engine: ScriptedEngine):
    for frame in range(31, 36):
        engine.frame = frame
        motion.refresh(motion.host.snapshot())
    t, values = motion.plot.curves[0].getData()
    assert t[-1] == 0.0 and t[0] < 0.0 and len(values) == len(t)
    assert values[-1] == pytest.approx(np.rad2deg(engine.latest_estimate().angles[0]), abs=90)
    assert not motion.plot.at.isVisible()


def test_the_table_is_copied_to_the_clipboard(motion):
    motion.controls.copy.click()
    lines = QGuiApplication.clipboard().text().splitlines()
    assert len(lines) == 1 + motion.table.rowCount()
    assert len(lines[0].split("\t")) == len(lines[1].split("\t")) == 13


def test_a_replay_shows_the_whole_take_and_a_click_jumps(
    window, qtbot, tmp_path, simulated_sessions, no_leaks
):
    tracked = simulated_sessions.tracked()
    window.host.adopt(open_replay(tracked, lambda *_: None))
    window.show_panel("motion")
    motion = window.motion
    qtbot.waitUntil(lambda: motion.model is not None and motion.model.take is not None)
    with SessionReader(tracked) as reader:
        take = read_take(reader)
    row = motion.table.chosen[0]
    t, values = motion.plot.curves[0].getData()
    np.testing.assert_allclose(t, take.t)
    np.testing.assert_allclose(values, np.rad2deg(take.angles[:, row]))
    shown = float(motion.table.item(row, RANGE).text())
    swing = np.nanmax(take.angles[:, row]) - np.nanmin(take.angles[:, row])
    assert shown == pytest.approx(np.rad2deg(swing), abs=0.06)
    player = window.host.setup.player
    player.play(False)
    qtbot.waitUntil(lambda: motion.plot.at.isVisible())

    class Click:
        def __init__(self, x: float) -> None:
            box = motion.plot.plot.getPlotItem().vb
            self._at = box.mapViewToScene(QPointF(x, 0.0))

        def scenePos(self) -> QPointF:
            return self._at

    motion.plot._clicked(Click(2.0))
    qtbot.waitUntil(lambda: abs(player.position - 2.0) < 0.1)
    qtbot.waitUntil(lambda: abs(motion.plot.at.value() - 2.0) < 0.1)
    motion.save_table(tmp_path / "motion.csv")
    read = list(csv.DictReader((tmp_path / "motion.csv").open()))
    assert read[row]["name"] == motion.model.names[row]
    assert float(read[row]["range"]) == pytest.approx(shown, abs=0.06)
