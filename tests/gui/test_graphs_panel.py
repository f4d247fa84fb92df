"""Graphs of any signals in the real window: selected, drawn, read, copied, restored."""

from __future__ import annotations

import csv
import io
import itertools
import time

import numpy as np
import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QApplication

from app.engines.replay.engine import open_replay
from app.viewmodels.graphs import MOST_CURVES, Graph
from app.window.main_window import MainWindow
from tests.gui.gui_fakes import ScriptedEngine, models
from tracker import GRAVITY
from tracker.messages import BlobFrame, ImuSample
from tracker.session.motion import read_take
from tracker.session.reader import SessionReader

GYRO_X = "right/imu/dorsum/gyro/x"


@pytest.fixture
def graphs(live, qtbot):
    """The panel in front, with its signals listed."""
    live.run_command("show_graphs")
    qtbot.waitUntil(lambda: bool(live.panels["graphs"].data.signals))
    return live.panels["graphs"]


def advance(panel, engine: ScriptedEngine, frames) -> None:
    for frame in frames:
        engine.frame = frame
        panel.refresh(panel.host.snapshot())


def leaf(panel, key: str):
    return panel.tree._leaves[key][1]


def tick(panel, key: str, on: bool = True) -> None:
    leaf(panel, key).setCheckState(0, Qt.CheckState.Checked if on else Qt.CheckState.Unchecked)


def show(panel, *graphs: tuple[str, ...]):
    """Only these graphs, once they are visible."""
    window = panel.window()
    window.docks["graphs"].setFloating(True)
    window.docks["graphs"].resize(900, 700)
    panel.stack.show_graphs([Graph(keys) for keys in graphs])
    deadline = time.monotonic() + 60
    while not all(plot.is_in_sight for plot in panel.stack.plots):
        QApplication.processEvents()
        assert time.monotonic() < deadline
    return panel.stack.plots


def only(panel, *keys: str):
    """One graph, of these signals."""
    return show(panel, keys)[0]


def drawn(plot, k: int = 0):
    x, y = plot.plot.curves[k].getData()
    return x, y


def test_every_signal_of_the_hand_is_in_the_tree(graphs):
    hand, glove, _ = models()
    keys = graphs.data.signals.keys()
    for imu, kind, axis in itertools.product(
        glove.imu_names, ("gyro", "accel"), ("x", "y", "z", "norm")
    ):
        assert f"right/imu/{imu}/{kind}/{axis}" in keys
    for name in hand.joint_names:
        assert {f"right/hand/angle/{name}", f"right/hand/speed/{name}"} <= keys
    for name, own in itertools.product(glove.keypoint_names(hand), ("x", "y", "z", "speed", "sd")):
        assert f"right/hand/point/{name}/{own}" in keys
    assert {"right/gestures/fist", "right/images/blobs_left", "right/images/residual_left"} <= keys
    assert {"right/status/imu_rate_hz", "right/status/latency_total_ms"} <= keys


def test_the_first_start_shows_the_index_finger_and_what_it_measures(graphs, engine):
    first, second = graphs.stack.plots
    assert first.graph.keys == (
        "right/hand/angle/index_mcp_flexion",
        "right/hand/angle/index_pip_flexion",
    )
    assert all("/gyro/" in key for key in second.graph.keys) and len(second.graph.keys) == 3
    advance(graphs, engine, (31, 33, 35))
    _, y = drawn(first, 1)
    column = models()[0].angle_index["index_pip_flexion"]
    assert y[-1] == pytest.approx(np.rad2deg(engine.latest_estimate().angles[column]))


def test_a_signal_is_found_by_text_added_and_removed(graphs, engine):
    plot = only(graphs)
    graphs.tree.search.setText("dorsum RATE x")
    assert [k for k in graphs.data.signals if not leaf(graphs, k).isHidden()] == [GYRO_X]
    tick(graphs, GYRO_X)
    assert plot.graph.keys == (GYRO_X,)
    graphs.refresh(graphs.host.snapshot())
    samples = engine.recent_imu()
    imu = models()[1].imu_names.index("dorsum")
    x, y = drawn(plot)
    assert y == pytest.approx([np.rad2deg(s.gyro[imu, 0]) for s in samples][-len(y) :])
    assert len(y) > 50 and x[-1] == pytest.approx(samples[-1].t - plot.now)
    assert "dorsum&nbsp;angular&nbsp;rate&nbsp;x" in plot.legend.text()
    assert plot.plot.plot.getAxis("left").labelText.endswith("°/s")
    tick(graphs, GYRO_X, False)
    assert plot.graph.keys == () and plot.plot.curves == []


def test_two_units_have_two_axes_and_a_third_is_rejected(graphs):
    plot = only(graphs, GYRO_X, "right/imu/dorsum/accel/norm")
    graphs.refresh(graphs.host.snapshot())
    assert plot.plot.plot.getAxis("right").isVisible()
    assert plot.plot.plot.getAxis("right").labelText.endswith("g")
    assert plot.plot.right.addedItems == [plot.plot.curves[1]]
    _, norm = drawn(plot, 1)
    low, high = plot.plot.right.viewRange()[1]
    assert low < norm.min() and norm.max() < high
    point = "right/hand/point/index_tip/x"
    tick(graphs, point)
    assert point not in plot.graph.keys
    assert graphs.message.isVisible() and "mm" in graphs.message.text()
    assert leaf(graphs, point).checkState(0) == Qt.CheckState.Unchecked
    tick(graphs, GYRO_X, False)
    assert not plot.plot.plot.getAxis("right").isVisible()


@pytest.mark.long
def test_norms_and_speeds_are_those_of_the_messages(graphs, engine):
    tip = "right/hand/point/index_tip/"
    plot, other = show(graphs, ("right/imu/dorsum/accel/norm",), (tip + "speed",))
    advance(graphs, engine, range(31, 60))
    imu = models()[1].imu_names.index("dorsum")
    sample = engine.recent_imu()[-1]
    assert drawn(plot)[1][-1] == pytest.approx(np.linalg.norm(sample.accel[imu]) / GRAVITY)
    k = models()[1].keypoint_names(models()[0]).index("index_tip")
    estimates = engine.recent_estimates()
    t = np.array([e.t for e in estimates])
    p = np.array([e.keypoints[k] for e in estimates])
    true = 1000 * np.linalg.norm((p[2:] - p[:-2]) / (t[2:] - t[:-2])[:, None], axis=1)
    x, speed = drawn(other)
    inner = slice(5, 20)  # away from the ends
    at = np.searchsorted(x + other.now, t[1:-1][inner] - 1e-6)
    assert speed[at] == pytest.approx(true[inner], rel=1e-6)


@pytest.mark.long
def test_a_pause_freezes_one_graph_and_the_cursor_reads_all(graphs, engine):
    angle = "right/hand/angle/index_"
    plot, other = show(graphs, (angle + "pip_flexion",), (angle + "mcp_flexion",))
    advance(graphs, engine, range(31, 36))
    plot.controls.pause.click()
    before = drawn(plot)[1].copy()
    column = models()[0].angle_index["index_pip_flexion"]
    then = [e for e in engine.recent_estimates() if e.t < engine.latest_estimate().t][-1]
    at = then.t - plot.now
    advance(graphs, engine, range(40, 46))
    np.testing.assert_array_equal(drawn(plot)[1], before)
    assert drawn(other)[0].size > before.size
    box = plot.plot.plot.plotItem.vb
    middle = sum(box.viewRange()[1]) / 2
    plot.plot.plot.scene().sigMouseMoved.emit(box.mapViewToScene(QPointF(at, middle)))
    assert f"<b>{np.rad2deg(then.angles[column]):.4g}</b>" in plot.legend.text()
    same = models()[0].angle_index["index_mcp_flexion"]
    assert f"<b>{np.rad2deg(then.angles[same]):.4g}</b>" in other.legend.text()
    assert other.plot._cursor.isVisible()
    plot.plot.left.emit()
    assert "<b>" not in plot.legend.text() + other.legend.text()


def test_the_visible_part_is_copied_as_csv(graphs, engine):
    angle = "right/hand/angle/index_pip_flexion"
    plot = only(graphs, angle, GYRO_X)
    advance(graphs, engine, (31, 33, 35))
    plot.controls.copy.click()
    rows = list(csv.reader(io.StringIO(QGuiApplication.clipboard().text())))
    assert rows[0] == ["time (s)", "index pip flexion (°)", "dorsum angular rate x (°/s)"]
    angles = [row for row in rows[1:] if row[1]]
    column = models()[0].angle_index["index_pip_flexion"]
    assert len(angles) == len(engine.recent_estimates())
    for row, estimate in zip(angles, engine.recent_estimates(), strict=True):
        assert float(row[0]) == pytest.approx(estimate.t - plot.now, abs=1e-5)
        assert float(row[1]) == pytest.approx(np.rad2deg(estimate.angles[column]), rel=1e-5)
    assert sum(bool(row[2]) for row in rows[1:]) == len(engine.recent_imu())


def test_a_lost_joint_and_a_hole_interrupt_the_line(graphs, engine):
    plot = only(graphs, "right/hand/point/index_tip/x")
    k = models()[1].keypoint_names(models()[0]).index("index_tip")
    engine.lost = (k,)
    advance(graphs, engine, (31, 32))
    engine.lost = ()
    advance(graphs, engine, (33, 34, 44, 45))  # ten images without an estimate
    x, y = drawn(plot)
    t = [e.t for e in engine.recent_estimates()]
    gap = (t[-3] + t[-2]) / 2 - plot.now
    assert np.isnan(y[np.flatnonzero(np.isclose(x, gap))]).all() and np.isclose(x, gap).sum() == 1
    lost = [e.t - plot.now for e in engine.recent_estimates() if e.keypoint_state[k] == 0]
    assert len(lost) == 2
    assert np.isnan(y[[int(np.argmin(abs(x - at))) for at in lost]]).all()


def test_graphs_and_named_layouts_survive_a_restart(graphs, live, store, qtbot):
    only(graphs, GYRO_X)
    graphs.stack.plots[0].controls.span.setCurrentIndex(2)
    graphs.stack.plots[0].controls.span.activated.emit(2)
    graphs.layouts.save("mine", graphs.stack.graphs)
    graphs.add.click()
    live.close()
    second = MainWindow(store)
    qtbot.addWidget(second)
    second.show()
    assert [g.keys for g in second.panels["graphs"].stack.graphs] == [(GYRO_X,), ()]
    assert second.panels["graphs"].stack.graphs[0].span == 30.0
    second.panels["graphs"].layouts.show_layout("mine")
    assert [g.keys for g in second.panels["graphs"].stack.graphs] == [(GYRO_X,)]
    second.panels["graphs"].layouts.delete("mine")
    assert second.panels["graphs"].layouts.names == []
    second.close()


def test_missing_signals_are_named_and_preserved(graphs):
    plot = only(graphs, "left/imu/dorsum/gyro/x", GYRO_X)
    assert "left/imu/dorsum/gyro/x" in plot.legend.text() and len(plot.plot.curves) == 1
    assert plot.graph.keys == ("left/imu/dorsum/gyro/x", GYRO_X)


def test_a_dragged_branch_fills_a_graph_up_to_its_limit(graphs, qtbot):
    plot = only(graphs)
    tree = graphs.tree.tree
    branch = leaf(graphs, "right/hand/angle/index_pip_flexion").parent()
    keys = bytes(tree.mimeData([branch.parent()]).data("application/x-glovetrack-signals").data())
    plot.dropped.emit(keys.decode().split("\n"))
    assert len(plot.graph.keys) == MOST_CURVES
    assert str(MOST_CURVES) in graphs.message.text()
    plot.controls.close_button.click()
    assert graphs.stack.plots == [] and graphs.stack.chosen is None
    tick(graphs, GYRO_X)
    assert [g.keys for g in graphs.stack.graphs] == [(GYRO_X,)]


def test_hidden_graphs_compute_nothing(graphs, live, engine, monkeypatch, qtbot):
    asked = []
    monkeypatch.setattr(graphs.data._live, "take", lambda view: asked.append(view))
    live.show_panel("library")
    live.docks["graphs"].hide()
    qtbot.wait(200)
    assert asked == []
    live.show_panel("graphs")
    qtbot.waitUntil(lambda: bool(asked))


@pytest.mark.long
def test_a_replay_shows_the_whole_recording_and_a_click_goes_there(
    window, qtbot, simulated_sessions
):
    tracked = simulated_sessions.tracked()
    window.host.adopt(open_replay(tracked, lambda *_: None))
    window.show_panel("graphs")
    graphs = window.panels["graphs"]
    angle, residual = "right/hand/angle/index_pip_flexion", "right/images/residual_left"
    show(graphs, (angle, residual), (GYRO_X,), ("right/gestures/fist", "right/images/blobs_left"))
    qtbot.waitUntil(lambda: graphs.data.recording is not None)
    player = window.host.setup.player
    player.play(False)
    graphs.refresh(window.host.snapshot())
    with SessionReader(tracked) as reader:
        take, start = read_take(reader), reader.anchor.monotonic(reader.span_ns[0])
        samples = [m for m in reader.messages([ImuSample]) if isinstance(m, ImuSample)]
        blobs = [m for m in reader.messages([BlobFrame]) if isinstance(m, BlobFrame)]
    first, second, third = graphs.stack.plots
    t, values = drawn(first)
    np.testing.assert_allclose(t, take.t)
    column = take.angle_names.index("index_pip_flexion")
    np.testing.assert_allclose(values, np.rad2deg(take.angles[:, column]))
    imu = models()[1].imu_names.index("dorsum")
    np.testing.assert_allclose(drawn(second)[0], [s.t - start for s in samples])
    assert drawn(second)[1] == pytest.approx([np.rad2deg(s.gyro[imu, 0]) for s in samples])
    np.testing.assert_array_equal(drawn(third, 1)[1], [len(b.left) for b in blobs])
    # px from the glove file's markers on the recorded hand: its wearer's own are 3 mm off
    assert 0.0 < np.nanmedian(drawn(first, 1)[1]) < 8.0
    begin, end = first.plot.plot.viewRange()[0]
    assert begin == 0.0 and end == pytest.approx(player.duration)
    first.plot.seek_requested.emit(2.0)
    qtbot.waitUntil(lambda: abs(first.plot.at.value() - 2.0) < 0.1)
    first.controls.span.setCurrentIndex(1)
    first.controls.span.activated.emit(1)
    graphs.refresh(window.host.snapshot())
    begin, end = first.plot.plot.viewRange()[0]
    assert end - begin == pytest.approx(5.0) and begin < 2.0 < end
    assert first.graph.span == 10.0 and first.graph.replay_span == 5.0
