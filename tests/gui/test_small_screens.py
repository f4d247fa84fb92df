"""Small screens and large scales: panels shrink, then scroll, and nothing is truncated."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QLabel, QTabBar, QToolButton, QVBoxLayout, QWidget

from app.panels.colours.panel import TWO_COLUMNS
from app.widgets.scrolled import Scrolled
from app.window.commands import ToolBar
from app.window.main_window import SMALLEST
from tests.gui.gui_fakes import ScriptedEngine, scripted_setup
from tests.gui.patience import settled

pytestmark = pytest.mark.styled

SIZES = [(800, 500), (960, 540), (1366, 768)]  # the middle one is Full HD at 200 %


@pytest.mark.long
@pytest.mark.parametrize("size", SIZES)
def test_every_panel_has_its_required_size_or_scrolls(window, qtbot, size):
    window.host.adopt(scripted_setup(ScriptedEngine()))
    window.resize(*size)
    settled(window, qtbot)
    assert (window.width(), window.height()) == size
    for name, dock in window.docks.items():
        dock.raise_()
        settled(window, qtbot)
        area = dock.widget()
        assert isinstance(area, Scrolled)
        panel, available = area.widget(), area.viewport().size()
        least = panel.layout().totalMinimumSize()
        assert panel.width() >= least.width(), name
        assert panel.width() <= available.width() or area.horizontalScrollBar().maximum() > 0, name
        assert panel.height() <= available.height() or area.verticalScrollBar().maximum() > 0, name


def test_at_1366_by_768_the_images_and_the_hand_need_no_scrolling(window, qtbot):
    window.host.adopt(scripted_setup(ScriptedEngine()))
    window.resize(1366, 768)
    settled(window, qtbot)
    for name in ("cameras", "hand", "colours", "calibration", "sensors"):
        window.run_command(f"show_{name}")
        settled(window, qtbot)
        area = window.docks[name].widget()
        assert area.verticalScrollBar().maximum() == 0, name
        assert area.horizontalScrollBar().maximum() == 0, name


def test_at_1366_by_768_sessions_are_above_the_transport_of_a_replay(window, qtbot):
    window.host.adopt(scripted_setup(ScriptedEngine()))
    window.resize(1366, 768)
    window.run_command("job_look")
    window.library.transport.show()
    area = window.docks["library"].widget()
    qtbot.waitUntil(lambda: window.library.transport.height() > 50)
    qtbot.waitUntil(lambda: area.verticalScrollBar().maximum() == 0)
    assert window.library.table.viewport().height() >= 44  # a session


def test_tabs_of_panels_show_their_full_names_and_arrows_lead_to_the_rest(window, qtbot):
    """At 150 % on a laptop's screen five names do not fit beside each other."""
    window.host.adopt(scripted_setup(ScriptedEngine()))
    window.resize(911, 464)
    window.run_command("job_all")
    settled(window, qtbot)
    direct = Qt.FindChildOption.FindDirectChildrenOnly
    bars = [b for b in window.findChildren(QTabBar, options=direct) if b.isVisible()]
    assert {bar.tabText(0) for bar in bars} == {"Hand", "Calibration", "Sensors"}
    with_arrows = 0
    for bar in bars:
        needed = [bar.fontMetrics().horizontalAdvance(bar.tabText(i)) for i in range(bar.count())]
        widths = [bar.tabRect(i).width() for i in range(bar.count())]
        assert bar.elideMode() == Qt.TextElideMode.ElideNone
        assert all(map(int.__ge__, widths, needed)), widths
        arrows = [b for b in bar.findChildren(QToolButton) if b.isVisible()]
        assert len(arrows) == (2 if sum(widths) > bar.width() else 0)
        with_arrows += bool(arrows)
    assert with_arrows


@pytest.mark.long
@pytest.mark.parametrize("size", [(911, 464), (960, 500), (1280, 672), (1366, 720)])
@pytest.mark.parametrize("job", ["look", "all"])
def test_a_replay_shows_a_session_and_its_transport_on_every_screen(window, qtbot, size, job):
    """1366 x 768 at 150 %, 1920 x 1080 at 200 %, 1280 x 720, 1366 x 768, less bar and frame."""
    window.host.adopt(scripted_setup(ScriptedEngine()))
    window.resize(*size)
    QApplication.processEvents()
    window.run_command(f"job_{job}")
    window.layouts.reset()
    window.show_panel("library")
    library = window.library
    library.transport.show()
    area = window.docks["library"].widget()
    library.refresh(None)
    qtbot.waitUntil(lambda: area.verticalScrollBar().maximum() == 0)
    settled(window, qtbot)
    assert area.horizontalScrollBar().maximum() == 0
    assert library.table.height() >= 72  # a heading and a session
    for name in ("cameras", "hand"):
        bar = window.docks[name].widget().verticalScrollBar()
        qtbot.waitUntil(lambda bar=bar: bar.maximum() == 0)
    assert library.transport.timeline.width() >= 120


@pytest.mark.long
@pytest.mark.parametrize("size", [(911, 464), (960, 500), (1280, 672), (1366, 720)])
@pytest.mark.parametrize("job", ["record", "all"])
def test_record_is_visible_and_nothing_scrolls_sideways_on_every_screen(window, qtbot, size, job):
    window.host.adopt(scripted_setup(ScriptedEngine()))
    window.resize(*size)
    QApplication.processEvents()
    window.run_command(f"job_{job}")
    window.layouts.reset()
    window.show_panel("recording")
    area = window.docks["recording"].widget()
    button = window.recording.record_button
    qtbot.waitUntil(lambda: area.horizontalScrollBar().maximum() == 0)
    settled(window, qtbot)
    assert button.visibleRegion().boundingRect().size() == button.size()


def test_nothing_in_the_tool_bar_moves_when_a_recording_begins(window, qtbot):
    window.host.adopt(scripted_setup(ScriptedEngine()))
    window.resize(1366, 768)
    bar = window.findChild(ToolBar)
    buttons = bar.findChildren(QToolButton)
    qtbot.waitUntil(bar.isVisible)
    settled(window, qtbot)
    before = [button.geometry() for button in buttons]
    action = next(a for a in bar.actions() if a.iconText().endswith("Record"))
    action.setIconText(action.iconText().replace("Record", "Stop recording"))
    settled(window, qtbot)
    assert [button.geometry() for button in buttons] == before


def test_the_window_can_be_shrunk_to_its_minimum(window):
    window.host.adopt(scripted_setup(ScriptedEngine()))
    hint = window.minimumSizeHint()
    assert hint.width() <= SMALLEST[0] and hint.height() <= SMALLEST[1]


def test_colours_are_in_one_column_if_there_is_no_space_for_two(window, qtbot):
    window.host.adopt(scripted_setup(ScriptedEngine()))
    panel, dock = window.colours, window.docks["colours"]

    def are_beside() -> bool:
        return panel.image.x() > panel.ranges.geometry().right()

    dock.setFloating(True)
    for width, beside in ((TWO_COLUMNS + 60, True), (TWO_COLUMNS - 160, False)):
        dock.resize(width, 500)
        qtbot.waitUntil(lambda beside=beside: are_beside() == beside)
        assert panel.width() <= width


def test_a_wrapped_text_gets_its_height(qtbot):
    panel = QWidget()
    label = QLabel("many words " * 40)
    label.setWordWrap(True)
    label.setAlignment(Qt.AlignmentFlag.AlignTop)
    QVBoxLayout(panel).addWidget(label)
    area = Scrolled(panel)
    qtbot.addWidget(area)
    area.resize(300, 60)
    area.show()
    assert label.height() >= label.heightForWidth(label.width())
    assert area.verticalScrollBar().maximum() > 0
    area.resize(1200, 400)
    qtbot.waitUntil(lambda: area.verticalScrollBar().maximum() == 0)
    label.setText("word " * 4000)
    qtbot.waitUntil(lambda: area.verticalScrollBar().maximum() > 0)
