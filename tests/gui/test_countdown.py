"""The countdown before a recording, by keys; remote requests do not wait."""

from __future__ import annotations

import json

import pytest
from PySide6.QtCore import Qt

from app.jobs import record_key
from app.storage.settings import SettingsStore
from app.window.message_bar import Countdown
from tests.gui.gui_fakes import scripted_setup

TICK_MS = 150


@pytest.fixture
def counting(window, engine, qtbot, monkeypatch):
    """A window with a countdown of three short seconds, and the counts shown."""
    window.record_key._timer.setInterval(TICK_MS)
    assert record_key.SECOND_MS == 1000
    window.host.adopt(scripted_setup(engine))
    panel = window.recording
    panel.countdown.setCurrentIndex(panel.countdown.findData(3))
    window.counted = []
    window.record_key.counted.connect(window.counted.append)
    return window


def test_a_recording_begins_after_the_countdown(counting, qtbot):
    overlay = counting.findChild(Countdown)
    qtbot.keyClick(counting, Qt.Key.Key_Space)
    assert counting.host.recording.request is None
    assert overlay.isVisible() and counting.recording.record_button.text() == "Not now (3)"
    middle = counting.rect().center()
    assert overlay.geometry().contains(middle)
    qtbot.waitUntil(lambda: counting.host.recording.request is not None)
    assert counting.counted == [3, 2, 1, 0]
    assert not overlay.isVisible() and counting.recording.record_button.text() == "Stop"
    qtbot.keyClick(counting, Qt.Key.Key_Space)
    assert counting.host.recording.request is None, "ending takes no countdown"


@pytest.mark.parametrize("key", [Qt.Key.Key_Escape, Qt.Key.Key_Space])
def test_escape_or_the_key_again_cancels_it(counting, qtbot, key):
    timer = counting.record_key._timer
    timer.setInterval(60_000)  # it counts for the test, not during a stall
    qtbot.keyClick(counting, Qt.Key.Key_Space)
    timer.timeout.emit()
    assert counting.counted == [3, 2]
    qtbot.keyClick(counting, key)
    assert counting.counted == [3, 2, 0] and not timer.isActive()
    assert counting.host.recording.request is None
    assert not counting.findChild(Countdown).isVisible()


def test_stopping_tracking_cancels_it(counting, qtbot):
    counting.run_command("record")
    counting.run_command("stop")
    assert counting.record_key.left == 0


def test_remote_requests_do_not_wait(counting, qtbot):
    counting.run_command("record")
    assert counting.record_key.left == 3
    assert json.loads(counting.remote.answers.answer_line('{"do": "start"}'))["ok"]
    assert counting.host.recording.request is not None and counting.record_key.left == 0
    qtbot.wait(5 * TICK_MS)
    assert counting.host.recording.request is not None, "the countdown must not end it"


def test_the_default_is_none_and_the_choice_is_stored(window, engine, store):
    window.host.adopt(scripted_setup(engine))
    window.run_command("record")
    assert window.host.recording.request is not None
    window.recording.countdown.setCurrentIndex(2)
    window.recording.countdown_sound.click()
    stored = SettingsStore(store.path).value
    assert (stored.countdown, stored.countdown_sound) == (5, True)
