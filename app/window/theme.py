"""Light and dark: Qt's Fusion style with a palette of ours and a few lines of style sheet."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QPalette
from PySide6.QtWidgets import QApplication

from app.widgets.icons import recolour
from app.widgets.measures import APART, FAR, FIGURE, HEADING, NEAR, TIGHT, WIDE
from resources import folder


@dataclass(frozen=True)
class Colours:
    """The colours of one theme; text on window and on base has a contrast of 7 or more."""

    window: str
    base: str
    raised: str
    border: str
    text: str
    faint: str  # secondary text, contrast 4.5 or more
    accent: str
    on_accent: str
    scene: str  # background of the 3D view
    danger: str  # of recording, and of errors: contrast 4.5 or more
    tick: str  # a drawing in the colour of `on_accent`
    notice: tuple[str, str] = ("#6B2A00", "#FFE9DC")  # background and text of errors
    good: tuple[str, str] = ("#0B4F3C", "#FFE9DC")
    warning: tuple[str, str] = ("#5A3A00", "#FFE3B0")


LIGHT = Colours(
    "#F3F4F6",
    "#FFFFFF",
    "#E7E9ED",
    "#CBD0D7",
    "#1C2127",
    "#59626D",
    "#0B63B0",
    "#FFFFFF",
    "#E9EDF2",
    "#B3261E",
    "tick-light.svg",
)
DARK = Colours(
    "#1E2227",
    "#16191D",
    "#2A2F36",
    "#3D444D",
    "#E8EBEE",
    "#A3ACB7",
    "#4FA3E3",
    "#0B1116",
    "#181C21",
    "#FF8A80",
    "tick-dark.svg",
)


def is_dark(theme: str) -> bool:
    """Whether ``theme`` means dark now; "system" asks the desktop."""
    if theme == "system":
        app = QApplication.instance()
        assert isinstance(app, QApplication)
        return app.styleHints().colorScheme() == Qt.ColorScheme.Dark
    return theme == "dark"


def colours(theme: str) -> Colours:
    return DARK if is_dark(theme) else LIGHT


def apply(app: QApplication, theme: str) -> Colours:
    """Apply the theme to the whole application; returns its colours."""
    c = colours(theme)
    sheet = style_sheet(c)
    if app.styleSheet() != sheet:  # not applied yet; applying it takes half a second
        with _nothing_collected():
            app.setStyle("Fusion")
            app.setPalette(_palette(c))
            app.setStyleSheet(sheet)
            recolour(app)
    return c


@contextmanager
def _nothing_collected() -> Iterator[None]:
    """Qt notifies a list of widgets made at the beginning, each in Python. If that started a
    garbage collection, Qt would reach deleted widgets."""
    before = gc.isenabled()
    gc.disable()
    try:
        yield
    finally:
        if before:
            gc.enable()


def _palette(c: Colours) -> QPalette:
    palette = QPalette()
    roles = {
        QPalette.ColorRole.Window: c.window,
        QPalette.ColorRole.WindowText: c.text,
        QPalette.ColorRole.Base: c.base,
        QPalette.ColorRole.AlternateBase: c.window,
        QPalette.ColorRole.Text: c.text,
        QPalette.ColorRole.Button: c.raised,
        QPalette.ColorRole.ButtonText: c.text,
        QPalette.ColorRole.ToolTipBase: c.raised,
        QPalette.ColorRole.ToolTipText: c.text,
        QPalette.ColorRole.PlaceholderText: c.faint,
        QPalette.ColorRole.Highlight: c.accent,
        QPalette.ColorRole.HighlightedText: c.on_accent,
        QPalette.ColorRole.Link: c.accent,
        QPalette.ColorRole.Accent: c.accent,
        QPalette.ColorRole.Mid: c.border,
    }
    for role, colour in roles.items():
        palette.setColor(role, QColor(colour))
    for role in (QPalette.ColorRole.Text, QPalette.ColorRole.ButtonText):
        palette.setColor(QPalette.ColorGroup.Disabled, role, QColor(c.faint))
    palette.setColor(QPalette.ColorGroup.Disabled, QPalette.ColorRole.WindowText, QColor(c.faint))
    return palette


def style_sheet(c: Colours) -> str:
    return _frame(c) + _buttons(c) + _words(c) + _fields(c)


def _frame(c: Colours) -> str:
    """Bars, docks and tabs: low contrast, so that images and hand are prominent."""
    return f"""
    QMainWindow::separator {{ background: {c.window}; width: {TIGHT}px; height: {TIGHT}px; }}
    QMainWindow::separator:hover {{ background: {c.accent}; }}
    QMainWindow > QTabBar {{ qproperty-elideMode: ElideNone; }}
    QTabBar QToolButton {{ padding: 0px; background: {c.raised}; }}
    QTabBar::tab {{ color: {c.faint}; padding: {TIGHT}px {APART}px; border: none;
        border-bottom: 2px solid transparent; }}
    QMainWindow > QTabBar::tab {{ padding: {TIGHT}px {NEAR}px; }}
    QTabBar::tab:selected {{ color: {c.text}; border-bottom-color: {c.accent}; }}
    QTabBar::tab:hover {{ color: {c.text}; }}
    QTabBar::tab:selected:focus {{ background: {c.raised}; }}
    QMenuBar {{ background: {c.window}; }}
    QDockWidget {{ font-weight: 600; border: 1px solid {c.accent}; }}
    QDockWidget::title {{ background: {c.window}; padding: {TIGHT}px {NEAR}px;
        border-bottom: 1px solid {c.border}; text-align: left; }}
    QToolBar {{ background: {c.raised}; border: none; border-bottom: 1px solid {c.border};
        padding: {TIGHT}px {NEAR}px; spacing: {TIGHT}px; }}
    QToolBar::separator {{ background: {c.border}; width: 1px; margin: {TIGHT}px {NEAR}px; }}
    QStatusBar {{ border-top: 1px solid {c.border}; }}
    QStatusBar::item {{ border: none; }}
    QFrame#banner {{ background: {c.notice[0]}; border-radius: 4px; }}
    QFrame#banner[good="true"] {{ background: {c.good[0]}; }}
    QFrame#banner QLabel {{ color: {c.notice[1]}; }}
    QFrame#banner[good="true"] QLabel {{ color: {c.good[1]}; }}
    QFrame#card {{ background: {c.base}; border: 1px solid {c.border}; border-radius: 8px; }}
    """


def _buttons(c: Colours) -> str:
    return f"""
    QToolButton {{ padding: {TIGHT}px {NEAR}px; border: 1px solid transparent;
        border-radius: 4px; }}
    QToolButton:hover {{ border-color: {c.border}; background: {c.base}; }}
    QToolButton:checked {{ background: {c.accent}; color: {c.on_accent}; }}
    QToolButton[segment] {{ border: 1px solid {c.border}; border-radius: 0; background: {c.base};
        padding: {TIGHT}px {APART}px; }}
    QToolButton[segment="middle"], QToolButton[segment="last"] {{ border-left: none; }}
    QToolButton[segment="first"] {{ border-top-left-radius: 6px; border-bottom-left-radius: 6px; }}
    QToolButton[segment="last"] {{ border-top-right-radius: 6px;
        border-bottom-right-radius: 6px; }}
    QToolButton[segment]:hover {{ color: {c.accent}; }}
    QToolButton[segment]:checked {{ background: {c.accent}; color: {c.on_accent}; }}
    QToolButton#record_button:enabled {{ color: {c.danger}; font-weight: 600; }}
    QDockWidget QToolButton {{ background: {c.raised}; }}
    QDockWidget QToolButton:hover {{ border-color: {c.accent}; }}
    QDockWidget QToolButton:checked {{ background: {c.accent}; }}
    QToolButton[popupMode="2"] {{ padding-right: {FAR}px; }}
    QToolButton::menu-indicator {{ subcontrol-position: right center; right: {TIGHT}px; }}
    QPushButton {{ padding: {TIGHT}px {APART}px; }}
    QPushButton[role="primary"] {{ background: {c.accent}; color: {c.on_accent}; border: none;
        border-radius: 4px; font-weight: 600; padding: {NEAR}px {WIDE}px; }}
    QPushButton[role="primary"]:disabled {{ background: {c.border}; color: {c.text}; }}
    """


def _words(c: Colours) -> str:
    return f"""
    QLabel[role="faint"] {{ color: {c.faint}; }}
    QLabel[role="heading"] {{ font-size: {HEADING}pt; font-weight: 600; }}
    QLabel[role="figure"] {{ font-size: {FIGURE}pt; font-weight: 600; }}
    QLabel[role="warning"] {{ background: {c.warning[0]}; color: {c.warning[1]};
        padding: {TIGHT}px {NEAR}px; border-radius: 4px; }}
    """


def _tick(c: Colours) -> str:
    """The path of its file for a style sheet."""
    return Path(str(folder("icons")), c.tick).as_posix()


def _fields(c: Colours) -> str:
    return f"""
    QLineEdit[readOnly="true"] {{ background: transparent; border: none; color: {c.faint}; }}
    QTableView {{ gridline-color: {c.border}; selection-background-color: {c.accent};
        selection-color: {c.on_accent}; border: 1px solid {c.border}; }}
    QHeaderView::section {{ background: {c.raised}; padding: {TIGHT}px {NEAR}px; border: none;
        border-right: 1px solid {c.border}; border-bottom: 1px solid {c.border}; }}
    QCheckBox::indicator:checked, QListView::indicator:checked {{ width: 12px; height: 12px;
        background: {c.accent}; border: 1px solid {c.accent}; border-radius: 2px;
        image: url("{_tick(c)}"); }}
    QCheckBox::indicator:checked:disabled, QListView::indicator:checked:disabled {{
        background: {c.faint}; border-color: {c.faint}; }}
    QCheckBox::indicator:unchecked, QListView::indicator:unchecked,
    QRadioButton::indicator:unchecked {{ width: 12px; height: 12px;
        background: {c.base}; border: 1px solid {c.faint}; }}
    QCheckBox::indicator:unchecked, QListView::indicator:unchecked {{ border-radius: 2px; }}
    QRadioButton::indicator:unchecked {{ border-radius: 6px; }}
    QRadioButton::indicator:checked {{ width: 5px; height: 5px; border-radius: 6px;
        background: {c.base}; border: 4px solid {c.accent}; }}
    """
