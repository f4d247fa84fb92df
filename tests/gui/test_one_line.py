"""One line of controls: those without space move behind a button, and return."""

import pytest
from PySide6.QtWidgets import QCheckBox, QPushButton

from app.widgets.one_line import OneLine

pytestmark = pytest.mark.styled


@pytest.fixture
def line(qtbot):
    line = OneLine()
    qtbot.addWidget(line)
    for word in ("Replay", "Export", "Compare", "Recover"):
        line.add(QPushButton(word))
    line.add(QCheckBox("Loop"))
    line.resize(line.sizeHint())
    line.show()
    return line


def test_all_are_in_the_line_if_there_is_space(line):
    assert line.in_leaf == [] and not line.more.isVisible()
    places = [w.x() for w in line.findChildren(QPushButton) if w.parent() is line]
    assert places == sorted(places) and len(set(places)) == 4


def test_the_last_ones_move_behind_the_button_first_and_nothing_is_truncated(line):
    width, height = line.width(), line.height()
    line.resize(width * 2 // 3, height)
    hidden = len(line.in_leaf)
    assert 0 < hidden < 5 and line.more.isVisible()
    inside = [w for w in (*line.findChildren(QPushButton), line.more) if w.parent() is line]
    assert max(w.geometry().right() for w in inside) <= line.width()
    assert line.height() == height
    line.resize(line.minimumSizeHint())
    assert len(line.in_leaf) == 5
    line.resize(width, height)
    assert line.in_leaf == []


def test_controls_behind_the_button_can_be_used(line, qtbot):
    box = line.findChild(QCheckBox)
    line.resize(line.minimumSizeHint())
    menu = line.more.menu()
    menu.popup(line.mapToGlobal(line.rect().bottomLeft()))
    qtbot.waitUntil(box.isVisible)
    assert box.window() is menu and menu.height() > 4 * box.height()
    box.click()
    assert box.isChecked()
    menu.hide()


def test_hidden_ones_need_no_space_and_remain_hidden(line):
    button = line.findChild(QPushButton)
    button.hide()
    line.resize(line.minimumSizeHint())
    line.resize(line.sizeHint())
    assert button.isHidden() and line.in_leaf == []


def test_after_a_change_of_style_every_text_fits(line, qtbot):
    line.resize(line.sizeHint() * 0.8)
    line.setStyleSheet("QPushButton { padding: 4px 24px; }")
    buttons = line.findChildren(QPushButton)
    qtbot.waitUntil(lambda: len(line.in_leaf) > 1)
    inside = [b for b in buttons if b.parent() is line]
    qtbot.waitUntil(lambda: all(b.width() >= b.sizeHint().width() for b in inside))
