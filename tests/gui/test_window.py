"""The real window on an engine whose every message is known."""

import gc
import threading
import time

import numpy as np
import pytest
from PySide6.QtCore import QPointF, Qt, QTimer
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication, QToolTip

from app.viewmodels.camera_overlay import project
from app.viewmodels.states import IDLE
from app.window.dialogs import CommandPalette, rank
from app.window.main_window import MainWindow
from tests.gui.gui_fakes import ScriptedEngine, SlowJob, frame_and_blobs, models, scripted_setup
from tests.gui.patience import settled
from tracker.messages import Event, Status, Tracking


def pixels(widget) -> np.ndarray:
    """(h, w, 3) RGB of what a widget shows."""
    image = widget.grab().toImage().convertToFormat(QImage.Format.Format_RGB888)
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    return rows[:, : 3 * image.width()].reshape(image.height(), image.width(), 3).copy()


def test_starts_on_the_start_page_with_nothing_to_stop(window):
    assert window.start_page.isVisible()
    assert not any(dock.isVisible() for dock in window.docks.values())
    assert not window.commands.actions["stop"].isEnabled()
    assert not window.commands.actions["record"].isEnabled()
    assert window.commands.actions["demo"].isEnabled()


def test_every_command_is_in_a_menu_and_no_shortcut_is_taken_twice(window):
    listed = {a for m in window.commands._menus.values() for a in m.actions()}
    assert set(window.commands.actions.values()) <= listed
    keys = [a.shortcut().toString() for a in window.commands.actions.values()]
    keys = [k for k in keys if k]
    assert len(keys) == len(set(keys))


def test_the_camera_panel_paints_the_image_it_is_given(live, engine):
    view = live.cameras.left
    live.cameras.follow.setChecked(False)
    for box in live.cameras._layer_boxes.values():
        box.setChecked(False)
    live.cameras._shown = None
    live.cameras.refresh(live.host.snapshot())
    shown, image = pixels(view), frame_and_blobs(engine.frame)[0].left
    for u, v in ((640, 360), (400, 500), (900, 200)):
        at = view.zoom.origin + QPointF(u + 0.5, v + 0.5) * view.zoom.scale
        colour = shown[int(at.y()), int(at.x())].astype(int)
        assert np.abs(colour - image[v, u, ::-1].astype(int)).max() < 60


def test_a_pixel_of_the_view_maps_back_to_itself_at_any_zoom(live, qtbot):
    view = live.cameras.left
    live.cameras.follow.setChecked(False)
    for zoom, centre in ((1.0, (0.5, 0.5)), (3.7, (0.3, 0.6))):
        view.zoom.zoom, view.zoom.centre = zoom, QPointF(*centre)
        at = view.zoom.origin + QPointF(200.5, 300.5) * view.zoom.scale
        assert view.zoom.to_image(at) == pytest.approx((200.0, 300.0), abs=1e-6)


def test_the_skeleton_is_projected_onto_the_hand(live):
    """Every true fingertip lands on a pixel of the dark glove or of a patch, not on the table."""
    view = live.host.snapshot()
    names = view.setup.glove.keypoint_names(view.setup.hand)
    uv = project(view, view.estimate.keypoints, right=False)
    wrist, middle = uv[names.index("wrist")], uv[names.index("middle_mcp")]
    table = view.frame.left[20, 20].astype(int)
    between = np.round((wrist + 2 * middle) / 3).astype(int)
    colour = view.frame.left[between[1], between[0]].astype(int)
    assert np.abs(colour - table).max() > 25


def test_the_hand_view_draws_the_hand(live, qtbot):
    qtbot.waitUntil(lambda: live.hand._hands[0].skin is not None)
    live.hand.refresh(live.host.snapshot())
    before = pixels(live.hand.view)
    greenish = (before[..., 1] > before[..., 0] + 25).mean()
    assert greenish > 0.005  # the colour of what is measured
    live.hand.view.orbit.turn(1.0, 0.3)
    live.hand.view.render_scene()
    assert (pixels(live.hand.view) != before).mean() > 0.005


def test_a_lost_position_is_reported_and_drawn_differently(live, engine, qtbot):
    engine.tracking = Tracking.LOST
    qtbot.waitUntil(lambda: "lost" in live.bar.tracking.text().lower())
    qtbot.waitUntil(lambda: "lost" in live.hand.view.caption)


def test_the_status_bar_shows_rates_and_latency(live, qtbot):
    qtbot.waitUntil(lambda: "100 Hz" in live.bar.chips["imu_rate_hz"].text())
    assert "48 ms" in live.bar.chips["latency"].text()
    live.host.stop()
    qtbot.waitUntil(lambda: live.bar.tracking.text() == "Stopped")


def test_tuning_a_hue_reaches_the_engine_and_can_be_undone(live, engine):
    before = models()[2]
    live.colours.choose_hue(1)
    live.colours.ranges.rows["hue"].low.setValue(5)
    assert engine.profiles[-1].hues[1].hue == (5, before.hues[1].hue[1])
    live.colours.undo()
    assert engine.profiles[-1] == before
    live.colours.redo()
    assert engine.profiles[-1].hues[1].hue[0] == 5


def test_a_saved_profile_loads_as_the_same_and_a_broken_one_is_refused(live, tmp_path):
    live.colours.ranges.rows["saturation"].low.setValue(77)
    tuned = live.colours.tuning.profile
    live.colours.files.save(tmp_path / "mine.toml")
    live.colours.undo()
    live.colours.files.load(tmp_path / "mine.toml")
    assert live.colours.tuning.profile == tuned
    (tmp_path / "bad.toml").write_text("schema = 1\nname = 3\n")
    live.colours.files.load(tmp_path / "bad.toml")
    assert "bad.toml" in live.banner.text()
    assert live.colours.tuning.profile == tuned


def test_hidden_panels_cost_nothing(live, qtbot, monkeypatch):
    calls = []
    monkeypatch.setattr(live.panels["sensors"], "refresh", lambda view: calls.append(view))
    live.docks["log"].raise_()
    qtbot.waitUntil(lambda: live.docks["sensors"].visibleRegion().isEmpty())
    settled(live, qtbot)
    calls.clear()
    qtbot.wait(200)
    assert calls == []
    live.docks["sensors"].raise_()
    qtbot.waitUntil(lambda: len(calls) > 0)


def test_palette_finds_and_runs_a_command(live, qtbot):
    palette = CommandPalette(list(live.commands.actions.values()), live)
    qtbot.addWidget(palette)
    palette._query.setText("freeze")
    assert palette.names()[0] == "Freeze images"
    qtbot.keyClick(palette._query, Qt.Key.Key_Return)
    assert live.cameras.freeze.isChecked()


@pytest.mark.parametrize(
    ("query", "better", "worse"),
    [("rec", "Record", "Reset layout"), ("lay", "Reset layout", "Pause the replay")],
)
def test_palette_ranks_word_starts_first(query, better, worse):
    good, bad = rank(query, better), rank(query, worse)
    assert good is not None and (bad is None or good < bad)
    assert rank("xyz", better) is None


def test_events_reach_the_log_and_are_filtered(live, engine, qtbot):
    engine.events.append(Event(1.0, "error", "The glove does not answer."))
    qtbot.waitUntil(lambda: live.log.list.count() == 2)
    live.log.kind.setCurrentIndex(live.log.kind.findData("error"))
    assert live.log.list.count() == 1
    assert "does not answer" in live.log.list.item(0).text()
    live.log.copy()
    assert "does not answer" in QApplication.clipboard().text()


def test_checklist_follows_what_arrives(window, qtbot):
    assert window.checklist.summary.text().startswith("0 of")
    window.host.adopt(scripted_setup(ScriptedEngine()))
    window.run_command("show_checklist")
    qtbot.waitUntil(lambda: window.checklist.summary.text().startswith("9 of"), timeout=120_000)
    window.host.shut_down()
    assert window.checklist.summary.text().startswith("0 of")


def test_errors_stay_in_the_banner_until_dismissed(window):
    window.host.error.emit("The camera was unplugged.")
    assert window.banner.isVisible()
    window.host.error.emit("The glove was unplugged.")
    assert window.banner.text() == "The glove was unplugged."
    window.banner.dismissed.emit()
    assert not window.banner.isVisible()


def test_missing_devices_are_listed_in_the_window(window, qtbot, monkeypatch):
    monkeypatch.setattr("app.engines.found_gloves.serial_ports", list)
    window.sources.open_devices()
    qtbot.waitUntil(lambda: "No glove was found" in window.banner.text())
    assert window.start_page.isVisible()


def test_an_invalid_calibration_is_refused_and_not_stored(window, store, tmp_path):
    (tmp_path / "mine.conf").write_text("[LEFT_CAM_HD]\nfx=700\n")
    window.set_up.set_calibration(tmp_path / "mine.conf")
    assert "mine.conf" in window.banner.text()
    assert store.value.calibration == ""


def test_an_error_of_a_panel_factory_is_shown(window, qtbot):
    def factory(progress):
        raise RuntimeError("no such thing")

    window.host.open("Trying", factory)
    qtbot.waitUntil(lambda: "no such thing" in window.banner.text())
    qtbot.waitUntil(lambda: not window.host.opening)
    assert window.host.setup is None


def test_a_long_job_shows_progress_and_ends_when_cancelled(window, qtbot):
    job = SlowJob()
    task = window.tasks.run("Working", job)
    qtbot.waitUntil(window.bar._bar.isVisible)
    assert job.started.wait(60)
    window.bar._cancel.click()
    qtbot.waitUntil(lambda: not window.tasks.tasks)
    assert not window.bar._bar.isVisible()
    assert not task.is_running


@pytest.mark.styled
def test_theme_and_layout_come_back(window, store, qtbot, no_leaks):
    window.set_theme("dark")
    window.host.adopt(scripted_setup(ScriptedEngine()))
    window.docks["sensors"].hide()
    window.close()
    again = MainWindow(store)
    qtbot.addWidget(again)
    again.show()
    again.host.adopt(scripted_setup(ScriptedEngine()))
    assert store.value.theme == "dark"
    assert not again.docks["sensors"].isVisible()
    again.layouts.reset()
    assert not again.docks["sensors"].isHidden()
    again.close()


def test_space_and_n_do_not_steal_letters_from_a_text_field(live, qtbot):
    live.run_command("show_recording")
    live.recording.participant.setFocus()
    qtbot.keyClicks(live.recording.participant, "no name")
    assert live.recording.participant.text().endswith("no name")
    assert live.host.recording.request is None


def test_the_window_never_blocks_long_on_a_live_engine(live, qtbot):
    gaps, last = [], [time.monotonic()]
    timer = QTimer()

    def tick():
        gaps.append(time.monotonic() - last[0])
        last[0] = time.monotonic()

    timer.timeout.connect(tick)
    timer.start(5)
    cpu = time.thread_time()
    qtbot.wait(800)
    cpu = time.thread_time() - cpu
    timer.stop()
    assert np.median(gaps) < 0.2
    assert cpu < 0.8  # of this thread alone: other programs' load does not count


def test_opening_and_closing_leaves_no_thread_timer_or_window(store, qtbot, no_leaks):
    threads = threading.active_count()
    for _ in range(2):
        window = MainWindow(store)
        window.show()
        window.host.adopt(scripted_setup(ScriptedEngine()))
        qtbot.wait(20)
        window.close()
        window.deleteLater()
        QApplication.processEvents()
        del window
    gc.collect()
    qtbot.waitUntil(lambda: threading.active_count() <= threads)
    left = [
        w for w in QApplication.topLevelWidgets() if isinstance(w, MainWindow) and w.isVisible()
    ]
    assert left == []


def test_another_engine_is_chosen_and_remembered(live, engine):
    live.run_command("engine_vist")
    assert engine.engines[-1] == "vist"
    assert live.store.value.engine == "vist"


def test_the_latency_of_each_stage_is_a_command(window):
    values = {"latency_total_ms": 7.8, "latency_detect_ms": 1.0}
    window.bar.show_status(Status(0.0, Tracking.TRACKING, values), running=True)
    window.commands.actions["latencies"].trigger()
    assert "Search of both images: 1.0 ms" in QToolTip.text()
    assert "7.8 ms" in window.bar.chips["latency"].accessibleDescription()


@pytest.mark.styled
def test_without_space_a_field_is_omitted_instead_of_truncated(window, qtbot):
    """Two hands on a computer that leaves out all that it can, with a job running."""
    values = {"imu_rate_hz": 100.0, "frame_rate_hz": 30.0, "estimate_rate_hz": 100.0}
    values |= {"latency_total_ms": 9.0, "latency_total_p99_ms": 30.0, "imu_lost": 0.0}
    status = Status(0.0, Tracking.COASTING, values | {"load_shed": 4.0})
    bar = window.bar
    window.ticker.stop()  # it would show that nothing runs
    for width in (1366, 800):
        window.resize(width, 768)
        bar.show_status(status, running=True)
        bar.show_hands({"right": status, "left": status}, running=True)
        QApplication.processEvents()
        shown = [chip for chip in bar.chips.values() if chip.isVisible()]
        assert shown and bar.chips["shed"].isVisible(), "problems are reported"
        if width == 1366:
            read = (bar.tracking, bar.other_hand, *shown)
            qtbot.waitUntil(lambda read=read: not any(c._text.is_elided for c in read))
    assert not bar.chips["latency"].isVisible() and not bar.chips["losses"].isVisible()
    bad = Status(0.0, Tracking.COASTING, values | {"imu_lost": 7.0})
    bar.show_status(bad, running=True)
    assert bar.chips["losses"].isVisible(), "what is not fine stays"


@pytest.mark.styled
@pytest.mark.parametrize("width", [911, 1366])
def test_latency_and_losses_are_shown_on_a_small_screen_at_150_percent(window, qtbot, width):
    """1366 px are 911 then; there they are short, and a recording is shown too."""
    values = {"imu_rate_hz": 100.0, "frame_rate_hz": 30.0, "estimate_rate_hz": 100.0}
    values |= {"latency_total_ms": 9.0, "latency_total_p99_ms": 30.0}
    values |= {"imu_lost": 0.0, "frames_dropped": 36.0}
    bar = window.bar
    window.ticker.stop()  # it would show that nothing runs
    window.setMinimumSize(0, 0)
    window.resize(width, 512)
    bar.show_recording("Recording 12:34", "#000")
    bar.show_status(Status(0.0, Tracking.TRACKING, values), running=True)
    QApplication.processEvents()
    long = width == 1366
    assert bar.chips["latency"].text() == ("Latency 9 ms (99 %: 30)" if long else "Latency 9 ms")
    assert bar.chips["losses"].text() == ("Lost 0 packets, 36 images" if long else "Lost 0 + 36")
    chips = (bar.tracking, bar.recording, *(c for k, c in bar.chips.items() if k != "shed"))
    assert all(chip.isVisible() for chip in chips)
    qtbot.waitUntil(lambda: not any(chip._text.is_elided for chip in chips))


def test_the_status_of_a_replay_does_not_look_live(window):
    values = {"imu_rate_hz": 100.0, "frame_rate_hz": 0.0, "load_shed": 2.0}
    window.bar.show_status(Status(0.0, Tracking.TRACKING, values), True, replayed=True)
    assert window.bar.tracking.text() == "Replay: Tracking"
    assert {f.look for f in window.bar._fields.values()} == {IDLE}
    assert not window.bar.chips["shed"].isVisible()
    assert "recorded" in window.bar.chips["imu_rate_hz"].toolTip()


def test_after_closing_no_panel_shows_values_of_before(live, engine, qtbot):
    table = live.calibration.table
    live.show_panel("calibration")
    qtbot.waitUntil(lambda: table.rowCount() > 0)
    live.show_panel("sensors")
    qtbot.waitUntil(lambda: "Hz" in live.panels["sensors"].figures.text())
    live.run_command("record")
    live.recording.refresh(None)
    assert live.recording.file_label.text() != "–"
    live.run_command("record")
    live.run_command("close")
    assert table.rowCount() == 0 and live.calibration.length.text() == "–"
    assert live.calibration.overall.value() == 0
    assert live.panels["sensors"].figures.text() == ""
    assert all(chip._shown[0] == IDLE.colour for chip in live.panels["sensors"].chips)
    curves = [curve for plot in live.panels["sensors"].plots.values() for curve in plot.curves]
    assert curves
    assert all(not np.size(curve.xData) for curve in curves if curve.xData is not None)
    assert live.recording.file_label.text() == "–"
    assert live.hand.gesture.text() == ""


def test_the_wearer_is_saved_by_a_command_of_its_own(live, engine, monkeypatch):
    """Three menus deep in a narrow panel it is hard to find."""
    asked = []
    monkeypatch.setattr("app.panels.calibration.wearer_row.answer", lambda *a: asked.append(a))
    live.host.adopt(scripted_setup(engine))
    assert live.commands.actions["save_wearer"].isEnabled()
    live.run_command("save_wearer")
    assert len(asked) == 1
