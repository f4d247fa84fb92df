"""The glove set-up window: wiggle test, rest measurement, choice of a side."""

from __future__ import annotations

import threading
from dataclasses import replace

from app.storage.bound_gloves import BoundGlove, bound, with_bound
from app.viewmodels.glove_setup import SetUpPhase, StillRun, WiggleRun
from app.wizards.glove.feed import Wiggle, wiggling_wearer
from app.words import notice_text
from tests.gui.gui_fakes import ScriptedEngine, models, scripted_setup, simulation, with_glove
from tests.notices import shows
from tracker.base.notices import notice
from tracker.calibration.wiggle import WiggleTest
from tracker.simulation.imu import ImuSimulator


def samples(part: str, t: float, seconds: float):
    """For a simulated wearer, beginning at ``t``."""
    hand, glove, _ = models()
    wearer = wiggling_wearer(hand, glove, part, 2)
    simulator = ImuSimulator(wearer, Wiggle(hand, part), 2)
    return [replace(s, t=s.t + t) for s in simulator.samples(0.0, seconds)]


def test_a_wiggle_test_advances_through_all_steps_by_the_motion():
    hand, glove, _ = models()
    run, t, asked = WiggleRun(WiggleTest(hand, glove)), 0.0, []
    recent: list = []
    while run.phase != SetUpPhase.DONE and t < 60:
        part = run.part if run.phase != SetUpPhase.READY else "rest"
        asked.append(run.part)
        recent = (recent + samples(part, t, 1.0))[-1200:]
        t += 1.0
        run.look(recent)
    assert list(dict.fromkeys(asked)) == ["thumb", "index", "middle", "hand"]
    assert run.words == notice_text(notice("wiggle.all_right")) and run.part == "rest"


def test_a_wearer_who_does_nothing_is_asked_again():
    hand, glove, _ = models()
    run, t, recent = WiggleRun(WiggleTest(hand, glove)), 0.0, []
    while "Nothing moved" not in run.words and t < 30:
        recent = (recent + samples("rest", t, 1.0))[-1200:]
        t += 1.0
        run.look(recent)
    assert 10 < t < 20 and run.step == 0 and "thumb" in run.words


def test_a_rest_measurement_waits_for_rest_and_times_out():
    names = models()[1].imu_names
    run = StillRun(names)
    recent = samples("index", 0.0, 2.5)
    run.look(recent[:1])
    run.look(recent)
    assert not run.done and "Waiting for rest" in run.words
    recent += samples("rest", 2.5, 2.5)
    run.look(recent)
    assert run.done and run.pose is not None and run.pose.ok
    restless = StillRun(names)
    moved = samples("index", 0.0, 12.0)
    restless.look(moved[:1])
    restless.look(moved)
    assert restless.done and shows(restless.words, "still.moved")


def test_the_simulated_glove_is_measured_and_tested_by_clicks(window, qtbot):
    window.run_command("glove_setup")
    dialog = window.set_up.dialogs["glove"]
    assert dialog.choice.port() == "simulated"
    dialog.tabs.setCurrentWidget(dialog.still)
    qtbot.waitUntil(dialog.still.start.isEnabled)
    dialog.still.start.click()
    qtbot.waitUntil(lambda: dialog.still.table.rowCount() == 7)
    dialog.tabs.setCurrentWidget(dialog.wiggle)
    dialog.wiggle.start.click()
    qtbot.waitUntil(lambda: "thumb" in dialog.wiggle.now.text())
    dialog.close()
    qtbot.waitUntil(lambda: not window.tasks.tasks)


def test_a_side_starts_with_its_default_glove(window, qtbot):
    window.run_command("glove_setup")
    choice = window.set_up.dialogs["glove"].choice
    for side, usual in (("left", "vist-small-left"), ("right", "vist-small")):
        choice.side.setCurrentIndex(choice.side.findData(side))
        assert choice.gloves.currentText() == usual
    window.set_up.dialogs["glove"].close()
    qtbot.waitUntil(lambda: not window.tasks.tasks)


def test_the_port_of_the_glove_in_use_selects_that_glove(window, store, qtbot, tmp_path):
    """A glove bound to wrong files is set up again by its port, which the session has open."""
    port = str(tmp_path / "glove_left")
    known = BoundGlove("right", "vist-small", "reference-right", "", port)
    store.update(gloves=with_bound(store.value, 7, known), port=port)
    window.host.adopt(
        with_glove(replace(scripted_setup(ScriptedEngine()), simulated=False), number=7)
    )
    window.run_command("glove_setup")
    dialog = window.set_up.dialogs["glove"]
    dialog.choice.add_port(port)
    dialog.choice.side.setCurrentIndex(dialog.choice.side.findData("left"))
    dialog.use.click()
    found = bound(store.value, 7)
    assert (found.side, found.glove, found.port) == ("left", "vist-small-left", port)
    qtbot.waitUntil(lambda: not window.tasks.tasks)


def test_choosing_the_left_side_offers_left_files_and_is_stored(window, store, qtbot):
    window.run_command("glove_setup")
    choice = window.set_up.dialogs["glove"].choice
    choice.side.setCurrentIndex(choice.side.findData("left"))
    names = [choice.gloves.itemText(i) for i in range(choice.gloves.count())]
    assert names == ["vist-small-left"] and choice.hands.currentText() == "reference-left"
    window.set_up.dialogs["glove"].use.click()
    assert (store.value.glove, store.value.hand) == ("vist-small-left", "reference-left")
    assert simulation().glove.side == "right"
    qtbot.waitUntil(lambda: not window.tasks.tasks)


def test_gloves_found_after_closing_the_window_are_ignored(window, qtbot, monkeypatch):
    gone = threading.Event()

    def slow_ports():
        assert gone.wait(60)
        return []

    monkeypatch.setattr("app.wizards.glove.wizard.serial_ports", slow_ports)
    window.run_command("glove_setup")
    dialog = window.set_up.dialogs["glove"]
    destroyed = []
    dialog.destroyed.connect(lambda: destroyed.append(True))
    dialog.close()
    qtbot.waitUntil(lambda: bool(destroyed))
    gone.set()
    with qtbot.captureExceptions() as exceptions:
        qtbot.waitUntil(lambda: not window.tasks.tasks)
    assert exceptions == []


def test_the_port_is_free_when_the_window_reports_the_glove(window, qtbot):
    window.run_command("glove_setup")
    dialog = window.set_up.dialogs["glove"]
    reader, read_then = dialog._feed._thread, []
    dialog.chosen.connect(lambda: read_then.append(reader.is_alive()))
    dialog.use.click()
    qtbot.waitUntil(lambda: bool(read_then))
    assert read_then == [False]
    qtbot.waitUntil(lambda: not window.tasks.tasks)


def test_the_set_up_shows_which_glove_sends(window, store, qtbot, monkeypatch):
    """Without a glove "The glove answers" was the simulated one, beside "No USB serial port"."""
    monkeypatch.setattr("app.wizards.glove.wizard.serial_ports", list)
    window.run_command("glove_setup")
    dialog = window.set_up.dialogs["glove"]
    qtbot.waitUntil(lambda: "packets per second" in dialog.state.text())
    assert dialog.state.text().startswith("Simulated glove: ")
    qtbot.waitUntil(lambda: dialog.choice.again.isEnabled())
    assert dialog.choice.words.text().startswith("No glove was found on any USB port.")
    assert dialog.use.text() == "&Use these files"
    dialog.close()
    qtbot.waitUntil(lambda: not window.tasks.tasks)


def test_the_set_up_names_the_glove_in_use_and_one_at_a_port(window, qtbot, monkeypatch, tmp_path):
    monkeypatch.setattr("app.wizards.glove.wizard.serial_ports", list)
    window.host.adopt(
        with_glove(replace(scripted_setup(ScriptedEngine()), simulated=False), number=7)
    )
    window.run_command("glove_setup")
    dialog = window.set_up.dialogs["glove"]
    qtbot.waitUntil(lambda: dialog.state.text().startswith("Glove 7 in use: "))
    assert dialog.use.text() == "&Use this glove"
    qtbot.waitUntil(lambda: dialog.choice.again.isEnabled())
    assert dialog.choice.words.text() == "No other glove was found on any USB port."
    dialog.choice.add_port(str(tmp_path / "glove"))
    assert dialog.choice.glove_name(3) == f"Glove 3 at {tmp_path / 'glove'}"
    dialog.close()
    qtbot.waitUntil(lambda: not window.tasks.tasks)
