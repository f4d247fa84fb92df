"""Keys, banner and initial size."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QApplication

from app.viewmodels.colour_picks import factory_colours
from app.window.commands import is_single
from app.window.docks import fit_to_screen
from tests.gui.gui_fakes import ScriptedEngine, scripted_setup
from tests.gui.patience import settled


@pytest.fixture
def active(window, qtbot):
    """The window on a scripted engine, with the keyboard."""
    window.host.adopt(scripted_setup(ScriptedEngine()))
    window.activateWindow()
    qtbot.waitUntil(window.isActiveWindow)
    return window


def press(qtbot, key):
    qtbot.keyClick(QApplication.focusWidget() or QApplication.activeWindow(), key)


def test_space_toggles_the_box_in_focus_and_records_elsewhere(active, qtbot):
    box = active.cameras.freeze
    box.setFocus()
    qtbot.waitUntil(box.hasFocus)
    press(qtbot, Qt.Key.Key_Space)
    assert box.isChecked() and active.host.recording.request is None
    box.clearFocus()
    qtbot.keyClick(active, Qt.Key.Key_Space)
    assert active.host.recording.request is not None


def test_letters_are_text_in_a_text_field(active, qtbot):
    active.show_panel("log")
    active.log.search.setFocus()
    qtbot.waitUntil(active.log.search.hasFocus)
    for key in (Qt.Key.Key_F, Qt.Key.Key_I, Qt.Key.Key_1):
        press(qtbot, key)
    assert active.log.search.text().lower() == "fi1"
    assert not active.cameras.freeze.isChecked()
    press(qtbot, Qt.Key.Key_Backspace)
    qtbot.keyClick(active.log.search, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert active.log.search.text().lower() == "fi1", "undo is the field's"


@pytest.mark.parametrize(
    ("keys", "single"),
    [("Space", True), ("N", True), (",", True), ("Ctrl+N", False), ("F5", False), ("", False)],
)
def test_only_printable_keys_give_way(qtbot, keys, single):
    action = QAction()
    action.setShortcut(keys)
    assert is_single(action) == single


def test_a_panels_key_shows_it_and_never_hides_it(active, qtbot):
    dock = active.docks["colours"]
    for _ in range(3):
        active.commands.actions["dock_colours"].trigger()
        assert not dock.isHidden() and not dock.visibleRegion().isEmpty()


def test_the_banner_shifts_nothing_is_logged_once_and_disappears_with_its_reason(active, qtbot):
    settled(active, qtbot)
    before = {name: dock.geometry() for name, dock in active.docks.items()}
    active.messages.show_message(
        "A sentence that is so long that it needs two lines. " * 5, about="devices"
    )
    settled(active, qtbot)
    assert active.banner.isVisible()
    assert {name: dock.geometry() for name, dock in active.docks.items()} == before
    lines = [active.log.list.item(i).text() for i in range(active.log.list.count())]
    assert sum("so long that it needs" in line for line in lines) == 1
    active.messages.no_longer("something else")
    assert active.banner.isVisible()
    active.set_up.changed.emit()
    assert not active.banner.isVisible()


def test_a_banner_about_missing_devices_leads_to_the_set_up(window, qtbot, monkeypatch):
    monkeypatch.setattr("app.engines.found_gloves.serial_ports", list)
    monkeypatch.setattr("app.engines.camera_choice.all_cameras", list)
    window.sources.open_devices()
    qtbot.waitUntil(lambda: "No glove was found" in window.banner.text())
    assert window.banner.buttons[0].isVisible()
    window.banner.buttons[0].click()
    assert window.docks["checklist"].isVisible() and not window.banner.isVisible()


@pytest.mark.styled
def test_the_first_window_fits_the_screen(window):
    room = window.screen().availableSize()
    fit_to_screen(window, (5 * room.width(), 5 * room.height()))
    assert window.width() < room.width() and window.height() < room.height()


def test_factory_colours_can_be_restored_and_that_can_be_undone(active, qtbot):
    panel = active.colours
    panel.tuning.move("hue", (84, 100), False)
    spoilt = panel.tuning.profile
    panel.tools.factory.emit()
    assert panel.tuning.profile == factory_colours()
    panel.undo()
    assert panel.tuning.profile == spoilt


def test_a_hue_is_applied_when_it_is_complete_and_undo_reverts_it(active, qtbot):
    active.show_panel("colours")
    panel = active.colours
    before = panel.tuning.profile
    box = panel.ranges.rows["hue"].low
    shown = box.value()
    box.setFocus()
    qtbot.waitUntil(box.hasFocus)
    box.selectAll()
    press(qtbot, Qt.Key.Key_7)
    assert panel.tuning.profile == before, "7 is not the hue that is typed"
    press(qtbot, Qt.Key.Key_0)
    press(qtbot, Qt.Key.Key_Return)
    assert panel.tuning.hue_range.hue[0] == 70
    qtbot.keyClick(box, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert panel.tuning.profile == before and box.value() == shown


def test_menus_tick_the_selected_entries(active):
    actions = active.commands.actions
    for menu in active.commands.menus():
        menu.aboutToShow.emit()
    ticked = {key for key, action in actions.items() if action.isCheckable() and action.isChecked()}
    assert {"engine_chain", "theme_light", "view_auto", "job_all"} <= ticked
    assert not ticked & {"theme_dark", "theme_system", "view_painted", "view_card"}
    actions["theme_dark"].trigger()
    actions["view_painted"].trigger()
    for menu in active.commands.menus():
        menu.aboutToShow.emit()
    assert actions["theme_dark"].isChecked() and not actions["theme_light"].isChecked()
    assert actions["view_painted"].isChecked() and not actions["view_auto"].isChecked()


def test_no_letter_is_assigned_to_two_entries_of_a_menu(window):
    for top in window.menuBar().actions():
        texts = [a.text().replace("&&", "") for a in top.menu().actions()]
        letters = [t[t.index("&") + 1].lower() for t in texts if "&" in t]
        assert len(letters) == len(set(letters)), top.text()
