"""The guide and the keys in the Help menu, and a status bar that truncates no text."""

import re

import pytest
from PySide6.QtCore import QUrl
from PySide6.QtGui import QDesktopServices

from app.platform import guide as guide_pages
from app.platform.guide import guide_folder, matches, pages
from app.viewmodels.status import tracking_look
from app.widgets.chip import Chip
from app.window.dialogs import Dialogs, GuideDialog, KeysDialog, key_of, plain
from tests.gui.gui_fakes import ScriptedEngine, scripted_setup, with_camera
from tracker.messages import Status, Tracking


def opened(window, command: str, kind):
    window.run_command(command)
    return window.findChild(kind)


def test_the_guide_contains_every_page():
    assert set(pages()) == {path.name for path in guide_folder().glob("*.md")}


def test_the_guide_is_searchable_and_its_links_work(window, qtbot):
    guide = opened(window, "guide", GuideDialog)
    assert guide.list.count() == len(pages())
    guide.search.setText("exposure WIGGLE")
    found = [guide.list.item(i).text() for i in range(guide.list.count())]
    assert 0 < len(found) < len(pages())
    for name in matches(pages(), "exposure wiggle"):
        assert "exposure" in pages()[name].lower() and "wiggle" in pages()[name].lower()
    assert "exposure" in guide.view.toPlainText().lower()
    guide.view.anchorClicked.emit(QUrl("recording.md"))
    heading = re.search(r"^# (.+)$", pages()["recording.md"], re.MULTILINE)[1]
    assert guide.view.toPlainText().startswith(heading)
    guide.search.setText("zweihundertvierzig")
    assert guide.list.count() == 0 and not guide.view.toPlainText()


def test_the_documentation_opens_in_the_browser_where_it_is(tmp_path, monkeypatch, qtbot):
    page = tmp_path / "site" / "index.html"
    page.parent.mkdir()
    page.write_text("<h1>Glovetrack</h1>")
    monkeypatch.setattr(guide_pages, "folder", lambda name: tmp_path / name)
    opened_at = []
    monkeypatch.setattr(QDesktopServices, "openUrl", opened_at.append)
    Dialogs(None, None).documentation()
    assert [url.toLocalFile() for url in opened_at] == [str(page)]


def test_the_list_of_keys_has_every_command_that_has_one(window):
    table = opened(window, "keys", KeysDialog).table
    rows = {(table.item(i, 0).text(), table.item(i, 1).text()) for i in range(table.rowCount())}
    actions = [a for a in window.commands.actions.values() if not a.shortcut().isEmpty()]
    assert len(actions) > 40
    assert rows == {(key_of(a), plain(a.text())) for a in actions}
    assert ("Ctrl+1", "Cameras") in rows


@pytest.mark.styled
def test_a_chip_without_space_is_elided_at_a_letter(qtbot):
    chip = Chip()
    qtbot.addWidget(chip)
    chip.show_state("#009E73", "●", "Latency 12 ms (99 %: 1350)", "Of each stage")
    chip.resize(90, 20)
    chip.show()
    label = chip._text
    assert label.is_elided and label.shown().endswith("…")
    assert label.fontMetrics().horizontalAdvance(label.shown()) <= label.width()
    chip.resize(400, 20)
    qtbot.waitUntil(lambda: not label.is_elided)
    assert label.shown() == label.text()


@pytest.mark.long
@pytest.mark.parametrize(
    ("placed", "values", "words"),
    [
        (True, {}, "Position lost"),
        (False, {}, "Position unknown"),
        (False, {"heading_sd_deg": 6.0}, "Position unknown, heading within 12°"),
    ],
)
def test_a_glove_alone_has_not_lost_a_position(window, qtbot, placed, values, words):
    engine = ScriptedEngine()
    engine.status = lambda: Status(0.0, int(Tracking.LOST), values)
    window.host.adopt(with_camera(scripted_setup(engine), present=placed))
    qtbot.waitUntil(lambda: window.bar.tracking.text() == words)
    assert tracking_look(None, True, placed).word == "Stopped"


def test_the_status_bar_shows_the_refresh_rate(live, qtbot):
    qtbot.waitUntil(lambda: "times a second" in live.bar.tracking.toolTip())
    rate = int(re.search(r"\d+", live.bar.tracking.toolTip())[0])
    assert 0 < rate <= 63  # the timer's 16 ms allow no more
