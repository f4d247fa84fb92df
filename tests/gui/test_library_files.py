"""Order in the library: search, names, tags, the bin, columns; several formats and presets."""

from __future__ import annotations

import hashlib
import json
import shutil
import sys

import pytest
from PySide6.QtCore import QObject, Qt, QUrl, Slot
from PySide6.QtGui import QDesktopServices, QFontMetrics
from PySide6.QtWidgets import QApplication, QDialogButtonBox, QInputDialog

from app.jobs.export import DONE, ExportRequest, free_target
from app.panels.library.export_dialog import ExportChoice, ExportDialog, choice_from
from app.storage.session_tags import read_tags, tags_of_text, tags_path, write_tags
from app.storage.settings import SettingsStore
from app.window.main_window import MainWindow
from tests.notices import shows
from tracker.offline.options import TrackOptions
from tracker.offline.simulate import SimulateOptions, simulate
from tracker.offline.track import track
from tracker.session.export.formats import formats
from tracker.session.export.options import DatasetOptions
from tracker.session.reader import SessionReader

NAMES = ("P01_pinch", "P01_fist", "P02_pinch")


@pytest.fixture(scope="module")
def tracked(tmp_path_factory):
    folder = tmp_path_factory.mktemp("files")
    simulated, out = folder / "simulated.mcap", folder / "tracked.mcap"
    simulate(simulated, SimulateOptions(seed=3, duration=1.5, fps=30, images=False))
    track(simulated, out, TrackOptions("chain", with_sensors=True))
    return out


@pytest.fixture
def folder(tmp_path, tracked, store):
    folder = tmp_path / "sessions"
    folder.mkdir()
    for name in NAMES:
        shutil.copy(tracked, folder / f"{name}.mcap")
    return folder


@pytest.fixture
def library(folder, window, qtbot):
    window.show_panel("library")
    qtbot.waitUntil(lambda: window.library.table.rowCount() == len(NAMES))
    qtbot.waitUntil(lambda: not window.tasks.tasks)
    return window.library


def shown(library) -> set[str]:
    table = library.table
    rows = [i for i in range(table.rowCount()) if not table.isRowHidden(i)]
    return {table.item(i, 0).text() for i in rows}


def select(library, *names: str) -> None:
    table = library.table
    texts = [table.item(i, 0).text() for i in range(table.rowCount())]
    table._select([texts.index(name) for name in names])
    assert {row.name for row in library.table.selected()} == set(names)


def answer(window, text: str) -> None:
    dialog = QApplication.instance().activeModalWidget() or window.findChild(QInputDialog)
    assert isinstance(dialog, QInputDialog)
    dialog.setTextValue(text)
    dialog.accept()


@pytest.mark.long
def test_the_library_is_filled_when_it_is_first_shown(library):
    assert shown(library) == set(NAMES)
    assert all(library.table.columnWidth(i) >= 48 for i in range(library.table.columnCount()))


@pytest.mark.long
def test_a_search_lists_sessions_with_all_its_words(library, qtbot):
    library.page.search.setFocus()
    qtbot.keyClicks(library.page.search, "pinch p01")
    assert shown(library) == {"P01_pinch"}
    assert {row.name for row in library.table.selected()} <= {"P01_pinch"}
    library.page.search.clear()
    assert shown(library) == set(NAMES)


@pytest.mark.long
def test_a_report_of_the_selected_takes_is_shown(library, window, folder, qtbot):
    select(library, "P01_pinch", "P02_pinch")
    page, browser = folder / "report.html", FileManager()
    QDesktopServices.setUrlHandler("file", browser, "show")
    try:
        library.page.actions_of["report"].trigger()
        qtbot.waitUntil(lambda: len(browser.urls) == 1)
    finally:
        QDesktopServices.unsetUrlHandler("file")
    assert browser.urls[0].toLocalFile() == str(page)
    text = page.read_text("utf-8")
    assert "P01_pinch" in text and "P02_pinch" in text and "P01_fist" not in text
    assert (folder / "report.csv").exists()


def test_tags_are_stored_next_to_the_session_and_found(library, window, folder, qtbot):
    path = folder / "P01_fist.mcap"
    before = hashlib.sha256(path.read_bytes()).hexdigest()
    select(library, "P01_fist")
    library.page.actions_of["tags"].trigger()
    answer(window, "good,  left hand , good")
    qtbot.waitUntil(lambda: not window.tasks.tasks)
    assert read_tags(path) == ("good", "left hand")
    assert hashlib.sha256(path.read_bytes()).hexdigest() == before
    library.page.search.setText("good")
    assert shown(library) == {"P01_fist"}
    library.page.search.clear()
    library.files.tag([path], "")
    assert not tags_path(path).exists()
    assert window.banner.text() == "Tags removed: good, left hand."
    window.banner.buttons[0].click()
    assert read_tags(path) == ("good", "left hand")


def test_a_session_is_renamed_with_its_tags(library, window, folder, qtbot):
    write_tags(folder / "P02_pinch.mcap", ["keep"])
    select(library, "P02_pinch")
    library.table.setFocus()
    library.page.actions_of["rename"].trigger()
    answer(window, "P02 grasp")
    qtbot.waitUntil(lambda: "P02-grasp" in shown(library))
    assert read_tags(folder / "P02-grasp.mcap") == ("keep",)
    assert not (folder / "P02_pinch.mcap").exists()
    library.files.rename(folder / "P01_fist.mcap", "P01_pinch")
    assert shows(window.banner.text(), "rename.exists")


def test_a_renamed_session_remains_selected_and_a_removed_one_moves_no_selection(
    library, folder, qtbot
):
    """Tags and the bin would apply to another session otherwise."""
    select(library, "P02_pinch")
    library.files.rename(folder / "P02_pinch.mcap", "Z9_last")
    qtbot.waitUntil(lambda: shown(library) == {"P01_fist", "P01_pinch", "Z9_last"})
    assert [row.name for row in library.table.selected()] == ["Z9_last"]
    (folder / "Z9_last.mcap").unlink()
    library.rescan()
    qtbot.waitUntil(lambda: shown(library) == {"P01_fist", "P01_pinch"})
    assert library.table.selected() == []


@pytest.mark.styled
def test_the_title_of_a_question_is_not_truncated(library, window, folder):
    """Frames write it in bold, between an icon and their buttons."""
    library.files.ask_name(folder / "P01_pinch.mcap")
    dialog = window.findChild(QInputDialog)
    font = dialog.font()
    font.setBold(True)
    room = dialog.width() - QFontMetrics(font).horizontalAdvance("Rename P01_pinch.mcap")
    dialog.reject()
    assert room >= 150


@pytest.fixture
def trash(tmp_path, monkeypatch):
    """A user whose bin is in the test's own folder."""
    (tmp_path / "data").mkdir()
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    return tmp_path / "data" / "Trash"


@pytest.mark.skipif(sys.platform != "linux", reason="where the bin is depends on the system")
def test_sessions_are_moved_to_the_bin_after_confirmation_and_restored_by_undo(
    library, window, folder, trash, qtbot
):
    write_tags(folder / "P01_fist.mcap", ["x"])
    select(library, "P01_fist", "P02_pinch")
    library.table.setFocus()
    qtbot.keyClick(library.table, Qt.Key.Key_Delete)
    qtbot.waitUntil(lambda: shown(library) == {"P01_pinch"})
    names = {"P01_fist.mcap", "P01_fist.tags.json", "P02_pinch.mcap"}
    assert {p.name for p in (trash / "files").iterdir()} == names
    assert window.banner.text() == "2 recordings moved to the trash."
    library.rescan()  # like the watched folder
    qtbot.wait(500)
    assert library.table.selected() == []
    qtbot.keyClick(library.table, Qt.Key.Key_Delete)
    assert (folder / "P01_pinch.mcap").exists(), "a second press takes nothing else"
    undo = window.banner.buttons[0]
    assert undo.text() == "Undo"
    qtbot.mouseClick(undo, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: shown(library) == set(NAMES))
    assert {row.name for row in library.table.selected()} == {"P01_fist", "P02_pinch"}
    assert read_tags(folder / "P01_fist.mcap") == ("x",)
    assert list((trash / "files").iterdir()) == [] and list((trash / "info").iterdir()) == []


def test_undo_does_not_replace_a_newer_file_of_that_name(library, window, folder, trash, tracked):
    select(library, "P01_fist")
    library.page.actions_of["bin"].trigger()
    assert window.banner.text() == "P01_fist moved to the trash."
    shutil.copy(tracked, folder / "P01_fist.mcap")
    window.banner.buttons[0].click()
    assert shows(window.banner.text(), "window.not_restored")


def test_a_session_is_preserved_on_a_system_without_a_bin(library, window, folder, monkeypatch):
    monkeypatch.setattr("app.storage.system_bin.move_to_bin", lambda _path: (False, None))
    library.files.bin([folder / "P01_pinch.mcap"])
    assert shows(window.banner.text(), "window.no_trash")
    assert (folder / "P01_pinch.mcap").exists()


def test_open_sessions_are_neither_renamed_nor_deleted(library, window, folder, qtbot):
    window.sources.open_session(folder / "P01_fist.mcap")
    qtbot.waitUntil(lambda: window.host.running)
    for work in (
        lambda: library.files.bin([folder / "P01_fist.mcap"]),
        lambda: library.files.rename(folder / "P01_fist.mcap", "other"),
    ):
        work()
        assert shows(window.banner.text(), "window.is_open")
    assert (folder / "P01_fist.mcap").exists()


def test_columns_keep_the_width_set_by_the_user(library, window, store, qtbot):
    library.table.setColumnWidth(0, 333)
    window.close()
    again = MainWindow(SettingsStore(store.path))
    qtbot.addWidget(again)
    assert again.library.table.columnWidth(0) == 333
    again.close()


class FileManager(QObject):
    """Replaces the system's dialog."""

    def __init__(self) -> None:
        super().__init__()
        self.urls: list[QUrl] = []

    @Slot(QUrl)
    def show(self, url: QUrl) -> None:
        self.urls.append(url)


def ended(library) -> bool:
    items = library.exports.items
    return bool(items) and not any(i.open for i in items)


def export_dialog(window) -> ExportDialog:
    return window.findChild(ExportDialog)


def tick(dialog, *names: str) -> None:
    for item in dialog._items():
        on = item.data(Qt.ItemDataRole.UserRole) in names
        item.setCheckState(Qt.CheckState.Checked if on else Qt.CheckState.Unchecked)


def press_export(qtbot, dialog) -> None:
    button = dialog.start
    assert dialog.findChild(QDialogButtonBox).buttonRole(button).name == "AcceptRole"
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)


def test_an_open_session_from_any_folder_is_exported_in_several_formats(
    library, window, tracked, store, tmp_path, qtbot
):
    """It is outside the library's folder, and another one is selected there."""
    window.sources.open_session(tracked)
    qtbot.waitUntil(lambda: window.host.running)
    select(library, "P01_pinch")
    window.setFocus()
    window.run_command("export")
    dialog = export_dialog(window)
    assert dialog.windowTitle() == f"Export {tracked.name}"
    assert [i.text() for i in dialog._items()] == [kind.title for kind in formats()]
    tick(dialog)
    assert not dialog.start.isEnabled()
    tick(dialog, "csv", "trc")
    out = tmp_path / "out"
    out.mkdir()
    dialog.folder.setText(str(out))
    press_export(qtbot, dialog)
    qtbot.waitUntil(lambda: ended(library))
    assert [i.look for i in library.exports.items] == [DONE, DONE]
    assert (out / "tracked.csv").exists() and (out / "tracked.trc").exists()
    stored = SettingsStore(store.path).value
    assert stored.export_folder == str(out) and stored.export["formats"] == ["csv", "trc"]
    manager = FileManager()
    QDesktopServices.setUrlHandler("file", manager, "show")
    try:
        qtbot.mouseClick(library.pages.page(1).folder_button, Qt.MouseButton.LeftButton)
        assert [u.toLocalFile() for u in manager.urls] == [str(out)]
    finally:
        QDesktopServices.unsetUrlHandler("file")


def test_a_preset_restores_formats_and_options(library, window, store, qtbot):
    select(library, "P01_pinch")
    library.ask_export()
    dialog = export_dialog(window)
    tick(dialog, "trc", "mot")
    dialog.units.setCurrentIndex(dialog.units.findData("mm"))
    dialog.rate.setValue(60.0)
    dialog.presets.save_preset(" OpenSim  at 60 ")
    tick(dialog, "csv")
    dialog.rate.setValue(0.0)
    dialog.presets.box.setCurrentIndex(0)
    dialog.presets.box.setCurrentText("OpenSim at 60")
    assert dialog.choice() == ExportChoice(("trc", "mot"), 60.0, "", "mm")
    dialog.rate.setValue(25.0)
    dialog.presets.box.showPopup()  # the same one, chosen again
    qtbot.keyClick(dialog.presets.box.view(), Qt.Key.Key_Return)
    assert dialog.choice() == ExportChoice(("trc", "mot"), 60.0, "", "mm")
    dialog.close()
    library.ask_export()
    again = [d for d in window.findChildren(ExportDialog) if d is not dialog][-1]
    assert again.presets.box.findText("OpenSim at 60") > 0
    again.presets.box.setCurrentText("OpenSim at 60")
    qtbot.mouseClick(again.presets.remove_button, Qt.MouseButton.LeftButton)
    assert SettingsStore(store.path).value.export_presets == {}
    qtbot.mouseClick(again.presets.undo_button, Qt.MouseButton.LeftButton)
    assert list(SettingsStore(store.path).value.export_presets) == ["OpenSim at 60"]
    assert again.presets.box.currentText() == "OpenSim at 60"
    assert again.presets.undo_button.isHidden()
    again.close()


def test_several_sessions_become_one_data_set_with_its_task(qtbot, store, tmp_path):
    """Other formats have a file for each session."""
    sources = [tmp_path / "a.mcap", tmp_path / "b.mcap"]
    dialog = ExportDialog(sources, None, store)
    qtbot.addWidget(dialog)
    tick(dialog, "csv")
    assert not dialog.task.isEnabled()
    tick(dialog, "csv", "lerobot")
    dialog.axes.setCurrentIndex(dialog.axes.findData("unity"))
    dialog.task.setText(" Grasp the cup ")
    dialog.split.setChecked(True)
    asked: list[ExportRequest] = []
    dialog.wanted.connect(asked.append)
    press_export(qtbot, dialog)
    assert [(r.form, r.source.name, [p.name for p in r.also]) for r in asked] == [
        ("csv", "a.mcap", []),
        ("csv", "b.mcap", []),
        ("lerobot", "a.mcap", ["b.mcap"]),
    ]
    assert asked[2].options.dataset == DatasetOptions("Grasp the cup", True)
    assert asked[2].options.axes is None and asked[0].options.axes == "unity"


def test_invalid_stored_choices_are_ignored():
    for data in (None, 3, {"formats": "csv"}, {"formats": ["exe"], "rate": "fast", "axes": 1}):
        assert choice_from(data) == ExportChoice()
    choice = ExportChoice(("csv", "bvh"), 30.0, "unity", "cm", True, "Wave", True)
    assert choice_from(json.loads(json.dumps(choice.as_dict()))) == choice


def test_two_exports_in_the_queue_never_have_the_same_name(tmp_path):
    first = free_target(tmp_path, tmp_path / "a" / "x.mcap", "csv")
    second = free_target(tmp_path, tmp_path / "b" / "x.mcap", "csv", {first})
    assert (first.name, second.name) == ("x.csv", "x_2.csv")
    second.touch()
    third = free_target(tmp_path, tmp_path / "x.mcap", "csv", {first})
    assert third.name == "x_3.csv"


def test_unreadable_tags_are_ignored(tmp_path):
    session = tmp_path / "a.mcap"
    for text in ("", "[]", '{"tags": 3}', '{"tags": [1, "b"]}', "{" * 70000):
        tags_path(session).write_text(text)
        assert read_tags(session) == (("b",) if '"b"' in text else ())
    assert tags_of_text(" a b ,, c,a b") == ("a b", "c")


def test_the_selected_part_becomes_a_session(library, window, folder, qtbot):
    window.sources.open_session(folder / "P01_fist.mcap")
    qtbot.waitUntil(lambda: window.host.running)
    window.run_command("crop")
    assert "Mark a range first" in window.banner.text()
    window.host.setup.player.set_range(0.4, 1.1)
    window.run_command("crop")
    made = folder / "P01_fist_crop.mcap"
    qtbot.waitUntil(lambda: made.name in window.banner.text())
    qtbot.waitUntil(lambda: made.stem in shown(library))
    with SessionReader(made) as reader:
        assert reader.duration == pytest.approx(0.7, abs=0.04)
        assert len(reader.engine_states()) == 1
