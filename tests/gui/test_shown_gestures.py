"""Gestures in the window: shown next to the hand, discarded when a replay seeks."""

from __future__ import annotations

from dataclasses import replace

from app.viewmodels.gestures import WORDS, ShownGestures
from extensions.applications.tests.hands import estimates
from tests.gui.gui_fakes import ScriptedEngine, scripted_setup
from tracker.gestures.values import GESTURES
from tracker.simulation.scripted import Key

HERE = (0.17, 0.0, 0.1)


def test_each_gesture_has_a_text():
    assert set(WORDS) == set(GESTURES)


def test_gestures_are_shown_at_the_windows_rate():
    shown = ShownGestures(scripted_setup(ScriptedEngine()))
    fists = estimates([Key(0.0, "fist", HERE), Key(1.0, "fist", HERE)], rate=30.0)
    lines = [shown.line(e) for e in fists]
    assert lines[0] == ""
    assert lines[3:] == ["fist 100 %"] * (len(lines) - 3)
    later = replace(estimates([Key(0.0, "relaxed", HERE), Key(0.1, "relaxed", HERE)])[0], t=60.0)
    assert shown.line(later) == ""
    assert shown.line(None) == ""


def test_the_hand_panel_shows_them(live):
    live.ticker.stop()
    live.hand._gestures.line = lambda estimate: "fist 97 %"
    live.hand.refresh(live.host.snapshot())
    assert live.hand.gesture.text() == "fist 97 %"
