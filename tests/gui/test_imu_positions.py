"""The guided measurement of the IMUs' axes in the real window, with the demo's glove and wearer."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from PySide6.QtCore import Qt

from app.engines.demo_camera import DemoChoice, demo_spec
from app.storage.own_gloves import own_path
from app.wizards.positions import rest_request
from tests.gui.gui_fakes import ScriptedEngine, scripted_setup, with_glove, with_live
from tracker.calibration.imu_positions import POSITION_NAMES
from tracker.glove.files import parse_glove
from tracker.simulation.demo import build
from tracker.simulation.scenario import Simulation

IMUS = 2  # of the seven: the others take seconds to simulate and to evaluate
LATER = 0.6  # s between two ticks


class DemoGlove(ScriptedEngine):
    """The glove and the wearer of the demo on a clock that the test advances."""

    def __init__(self) -> None:
        super().__init__()
        spec = demo_spec(choice=DemoChoice(scene="plain"))
        demo = build(spec)
        glove = replace(demo.glove, imus=demo.glove.imus[:IMUS])
        self.demo = Simulation(demo.hand, glove, demo.motion, spec.seed)
        self.now, self.packets, self.shown = 1.0, [], []

    def recent_imu(self):
        return list(self.packets)

    def follow(self, plan, name: str = "") -> None:
        self.shown.append(name)
        for asked in plan(self.demo, self.now):
            self.demo.motion.ask(asked)

    def show(self, pose: str) -> None:
        self.shown.append(pose)

    def pass_time(self, seconds: float) -> None:
        self.packets = list(self.demo.imus.samples(self.now, self.now + seconds))
        self.now += seconds


@pytest.fixture
def engine(tmp_path, monkeypatch) -> DemoGlove:
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    return DemoGlove()


@pytest.fixture
def dialog(window, engine, qtbot, monkeypatch):
    """The dialog, opened by its command; the test is its clock."""
    setup = scripted_setup(engine)
    setup = replace(with_live(setup, wearer=engine), glove=engine.demo.glove)
    window.host.adopt(with_glove(setup, file="vist-small", own_file="vist-small-simulated"))
    window.run_command("imu_positions")
    dialog = window.set_up.dialogs["imu_positions"]
    dialog._timer.stop()
    monkeypatch.setattr(dialog.lead.stage.view, "render_scene", lambda: None)
    return dialog


def measured(dialog, engine, count: int = len(POSITION_NAMES)) -> list[str]:
    """The positions held after ``count`` of them."""
    while dialog.leads and len(dialog.run.guide.held) < count:
        engine.pass_time(LATER)
        dialog.tick()
        assert engine.now < 90.0, dialog.run.guide.held
    return dialog.run.guide.held


@pytest.mark.long
def test_the_positions_give_the_errors_of_the_simulated_imus(dialog, engine, window, qtbot):
    reopened = []
    window.set_up.reopen.connect(lambda: reopened.append(True))
    qtbot.mouseClick(dialog.lead.start, Qt.MouseButton.LeftButton)
    assert measured(dialog, engine) == list(POSITION_NAMES)
    assert engine.shown == [*POSITION_NAMES, ""] and engine.now < 60.0
    qtbot.waitUntil(dialog.outcome.save.isEnabled)
    assert dialog.outcome.table.rowCount() == IMUS
    qtbot.mouseClick(dialog.outcome.save, Qt.MouseButton.LeftButton)
    assert reopened and engine.shown[-1] == "" and "imu_positions" not in window.set_up.dialogs
    known = engine.demo.imus.errors
    glove = parse_glove(demo_spec().glove_text, engine.demo.hand)  # the demo uses it from now on
    for j, imu in enumerate(glove.imus[:IMUS]):
        left = imu.axes.accel @ known.accel_matrix[j]
        assert np.abs(left.T @ left - np.eye(3)).max() < 0.006
        assert np.abs(imu.axes.gyro @ known.gyro_matrix[j] - left).max() < 0.012


@pytest.mark.long
def test_positions_are_recognized_in_any_order_and_closing_changes_nothing(
    dialog, engine, window, qtbot
):
    before = window.store.value
    qtbot.mouseClick(dialog.lead.start, Qt.MouseButton.LeftButton)
    dialog._followed = POSITION_NAMES[0]  # the wearer takes another one first
    engine.follow(partial(rest_request, "thumb_up"))
    assert measured(dialog, engine, 1) == ["thumb_up"]
    assert dialog.run.guide.asked == POSITION_NAMES[0]
    assert not dialog.lead.finish.isEnabled()
    dialog.close()
    assert window.store.value == before and not own_path("vist-small-simulated").exists()
    assert engine.shown[-1] == ""
