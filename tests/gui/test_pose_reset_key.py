"""The pose reset in the window: by key and by double tap, of both hands, on the real engine."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import QDialog, QLineEdit

from app.engines.demo_camera import DemoChoice
from app.window.dialogs import KeysDialog
from app.window.message_bar import Countdown
from tests.gui.gui_fakes import ScriptedEngine, scripted_setup, with_live
from tests.notices import shows
from tracker.glove import library
from tracker.messages import Event, ImuSample
from tracker.offline.track import track
from tracker.session.compare import compare
from tracker.session.reader import SessionReader

TICK_MS = 150


class Resettable(ScriptedEngine):
    """A hand that adds its side to ``resets`` when its pose is reset."""

    def __init__(self, side: str, resets: list[str]) -> None:
        super().__init__()
        self._side, self._resets = side, resets

    def reset_pose(self) -> None:
        self._resets.append(self._side)


@pytest.fixture
def resets() -> list[str]:
    """Sides of the reset hands."""
    return []


@pytest.fixture
def both(window, engine, resets):
    """The window on both hands, with a countdown of three short seconds."""
    window.pose_reset._timer.setInterval(TICK_MS)
    hand, glove = library.load("vist-small-left", "reference-left")
    right = with_live(scripted_setup(engine), hand=Resettable("right", resets))
    left = replace(right, hand=hand, glove=glove)
    left = with_live(left, hand=Resettable("left", resets))
    window.host.adopt(replace(right, others=(left,)))
    window.counted = []
    window.pose_reset.counted.connect(window.counted.append)
    return window


def overlay(window) -> Countdown:
    return next(c for c in window.findChildren(Countdown) if c._key is window.pose_reset)


@pytest.mark.long
def test_the_key_counts_down_and_resets_both_hands(both, qtbot, resets):
    qtbot.keyClick(both, Qt.Key.Key_R)
    assert overlay(both).isVisible() and resets == []
    qtbot.waitUntil(lambda: len(resets) == 2)
    assert sorted(resets) == ["left", "right"] and both.counted == [3, 2, 1, 0]
    assert not overlay(both).isVisible()


@pytest.mark.long
@pytest.mark.parametrize("key", [Qt.Key.Key_Escape, Qt.Key.Key_R])
def test_escape_or_the_key_again_cancels_it(both, qtbot, resets, key):
    timer = both.pose_reset._timer
    timer.setInterval(60_000)  # it counts for the test, not during a stall
    qtbot.keyClick(both, Qt.Key.Key_R)
    timer.timeout.emit()
    assert both.counted == [3, 2]
    qtbot.keyClick(both, key)
    assert both.counted == [3, 2, 0] and not timer.isActive() and resets == []


def test_a_replay_has_no_reset(window, engine, qtbot):
    window.host.adopt(replace(scripted_setup(engine), live=None))
    assert not window.commands.actions["pose_reset"].isEnabled()


def settings(window) -> QDialog:
    window.run_command("pose_reset_setup")
    return window.set_up.dialogs["pose_reset"]


def test_another_key_is_set_shown_in_the_menu_and_stored(both, qtbot, store, resets):
    dialog = settings(both)
    dialog.key.setKeySequence(QKeySequence("N"))
    dialog.save.click()
    assert "N is already assigned to “Add a note…”" in dialog.problem.text()
    dialog.key.setKeySequence(QKeySequence("F7"))
    dialog.countdown.setValue(0)
    dialog.save.click()
    assert store.value.pose_reset_key == "F7" and store.value.pose_reset_countdown == 0
    action = both.commands.actions["pose_reset"]
    assert action.shortcut().toString() == "F7"
    table = KeysDialog(both.commands.menus(), both).table
    rows = [[table.item(r, c).text() for c in range(2)] for r in range(table.rowCount())]
    assert ["F7", "Reset pose"] in rows
    qtbot.keyClick(both, Qt.Key.Key_R)
    assert resets == []
    qtbot.keyClick(both, Qt.Key.Key_F7)
    assert sorted(resets) == ["left", "right"]


def test_a_letter_typed_into_a_field_resets_nothing(both, qtbot, resets):
    field = QLineEdit(both)
    field.show()
    field.setFocus()
    qtbot.waitUntil(field.hasFocus)
    qtbot.keyClick(field, Qt.Key.Key_R)
    assert field.text() == "r" and both.counted == []


class Tapped(ScriptedEngine):
    """A glove at rest whose back is tapped at times ``taps`` (s)."""

    def __init__(self, taps: tuple[float, ...]) -> None:
        super().__init__()
        self.packets = []
        for k in range(200):
            accel = np.tile([0.0, 0.0, 9.8], (7, 1))
            if any(0 <= k - round(100 * at) < 2 for at in taps):
                accel[0, 2] -= 20.0
            t = 0.01 * k
            gyro, valid = np.zeros((7, 3)), np.ones(7, bool)
            self.packets.append(ImuSample(t, t, t, k, accel, gyro, valid))

    def recent_imu(self):
        return self.packets


@pytest.mark.long
@pytest.mark.parametrize(
    ("on", "taps", "counts"),
    [(True, (1.0, 1.2), True), (True, (1.0,), False), (False, (1.0, 1.2), False)],
)
def test_a_double_tap_starts_it_if_enabled(window, qtbot, store, resets, on, taps, counts):
    assert not store.value.pose_reset_tap, "off by default"
    engine = Tapped(taps)
    window.pose_reset._timer.setInterval(TICK_MS)
    window.host.adopt(with_live(scripted_setup(engine), hand=Resettable("right", resets)))
    dialog = settings(window)
    dialog.tap.setChecked(on)
    dialog.save.click()
    if counts:
        qtbot.waitUntil(lambda: resets == ["right"])
    qtbot.wait(6 * TICK_MS)
    assert resets == (["right"] if counts else []), "and only once"


@pytest.mark.long
@pytest.mark.timeout(600)
def test_a_reset_of_the_demo_without_a_camera_is_recorded_and_tracked_again(
    window, qtbot, tmp_path
):
    window.pose_reset._timer.setInterval(TICK_MS)
    window.sources.open_demo(DemoChoice(lenses="none"))
    qtbot.waitUntil(lambda: window.host.running, timeout=100_000)
    qtbot.waitUntil(lambda: window.host.snapshot().estimate is not None)
    window.recording.set_folder(tmp_path)
    window.run_command("record")
    path = window.host.recording.request.path
    qtbot.keyClick(window, Qt.Key.Key_R)
    log_entries = lambda: window.log.model.entries("device", "Pose reset, right hand: joints")  # noqa: E731
    qtbot.waitUntil(lambda: log_entries() != [])
    assert shows(window.banner.text(), "pose_reset.done_heading")
    begun = window.host.snapshot().estimate.t
    qtbot.waitUntil(lambda: window.host.snapshot().estimate.t > begun + 1.0)
    window.run_command("record")
    window.host.recording.wait()
    track(path, tmp_path / "again.mcap")
    found = compare(path, tmp_path / "again.mcap")
    assert found["identical"] and found["compared"] > 100
    with SessionReader(path) as reader:
        kinds = [m.kind for m in reader.messages((Event,)) if isinstance(m, Event)]
    assert kinds.count("pose_reset") == 1
