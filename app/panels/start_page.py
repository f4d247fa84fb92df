"""The start page, shown before an engine is opened."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QSize, Qt, Signal, SignalInstance
from PySide6.QtGui import QIcon
from PySide6.QtWidgets import (
    QFrame,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.panels.library.session_table import no_image, pixmap
from app.viewmodels.library import THUMBNAIL_WIDTH
from app.viewmodels.recent import MOST, Earlier, RecentSession
from app.widgets.measures import APART, WIDE
from app.widgets.scrolled import Scrolled

CARD = 250  # px, width of a card
NARROW = 190  # px, its minimum width
ROW = 44


class StartPage(QWidget):
    """Three ways to start, each with an explanation, and recent sessions."""

    demo = Signal()
    connect_devices = Signal()
    open_session = Signal()
    library_requested = Signal()
    recent_requested = Signal(object)  # Path
    recover = Signal(object)  # Path

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        inside = QWidget()
        column = QVBoxLayout(inside)
        column.setContentsMargins(WIDE, WIDE, WIDE, WIDE)
        column.addStretch(2)
        column.addWidget(self._heading(), 0, Qt.AlignmentFlag.AlignHCenter)
        column.addSpacing(APART)
        column.addLayout(_centred(self._unfinished()))
        column.addLayout(self._cards())
        column.addSpacing(APART)
        column.addLayout(_centred(self._recent()))
        column.addStretch(3)
        whole = QVBoxLayout(self)
        whole.setContentsMargins(0, 0, 0, 0)
        whole.addWidget(Scrolled(inside))

    def _heading(self) -> QLabel:
        label = QLabel(self.tr("Glovetrack"))
        label.setProperty("role", "heading")
        return label

    def _cards(self) -> QGridLayout:
        grid = QGridLayout()
        grid.setSpacing(WIDE)
        cards = (
            (
                self.tr("Demo"),
                self.tr("Try Glovetrack with a simulated glove and camera. No hardware needed."),
                self.demo,
            ),
            (
                self.tr("Glove and camera"),
                self.tr("Connect your devices and set them up step by step."),
                self.connect_devices,
            ),
            (
                self.tr("Recorded session"),
                self.tr("Replay a session file, review it frame by frame, and export it."),
                self.open_session,
            ),
        )
        grid.setColumnStretch(0, 1)
        for i, (title, text, signal) in enumerate(cards):
            grid.addWidget(_card(title, text, signal), 0, i + 1)
            grid.setColumnStretch(i + 1, CARD)  # uses all space up to its own width
        grid.setColumnStretch(len(cards) + 1, 1)
        return grid

    def _unfinished(self) -> QFrame:
        """The notice of an interrupted recording, with a button to recover it."""
        self.unfinished = QFrame()
        self.unfinished.setObjectName("card")
        self.unfinished_text = QLabel()
        self.unfinished_text.setWordWrap(True)
        self.recover_button = QPushButton(self.tr("Recover"))
        self.recover_button.setProperty("role", "primary")
        self.recover_button.clicked.connect(self._recover)
        row = QHBoxLayout(self.unfinished)
        row.addWidget(self.unfinished_text, 1)
        row.addWidget(self.recover_button)
        self.unfinished.hide()
        self._cut_off: Path | None = None
        return self.unfinished

    def _recent(self) -> QWidget:
        part = QWidget()
        self.recent = QListWidget()
        self.recent.setIconSize(QSize(THUMBNAIL_WIDTH, ROW - 4))
        self.recent.setFrameShape(QFrame.Shape.NoFrame)
        self.recent.setTextElideMode(
            Qt.TextElideMode.ElideMiddle
        )  # names often differ only at their ends
        self.recent.setAccessibleName(self.tr("Recent sessions"))
        self.recent.itemClicked.connect(self._chosen)
        self.recent.itemActivated.connect(self._chosen)
        self.recent_heading = QLabel(self.tr("Recent sessions"))
        self.recent_heading.setProperty("role", "faint")
        self.library_button = QPushButton(self.tr("Library"))
        self.library_button.setToolTip(self.tr("All recorded sessions"))
        self.library_button.clicked.connect(self.library_requested)
        top = QHBoxLayout()
        top.addWidget(self.recent_heading)
        top.addStretch(1)
        top.addWidget(self.library_button)
        column = QVBoxLayout(part)
        column.setContentsMargins(0, 0, 0, 0)
        column.addLayout(top)
        column.addWidget(self.recent)
        self.show_earlier(Earlier((), ()))
        return part

    # --- displayed data

    def show_earlier(self, earlier: Earlier) -> None:
        """Show recent sessions and interrupted recordings."""
        self.recent.clear()
        for session in earlier.recent:
            self.recent.addItem(_item(session))
        some = bool(earlier.recent)
        self.recent.setVisible(some)
        self.recent_heading.setVisible(some)
        self.recent.setFixedHeight(min(len(earlier.recent), MOST) * (ROW + 4) + 4)
        self._show_unfinished(earlier.unfinished)

    def _show_unfinished(self, paths: tuple[Path, ...]) -> None:
        self._cut_off = paths[0] if paths else None
        self.unfinished.setVisible(bool(paths))
        self.recover_button.setEnabled(bool(paths))
        if not paths:
            return
        text = self.tr("The recording {} was interrupted. Its contents can be recovered.")
        text = text.format(paths[0].name)
        if len(paths) > 1:
            text += " " + self.tr("{} more are in the library.").format(len(paths) - 1)
        self.unfinished_text.setText(text)

    # --- actions of the user

    def _chosen(self, item: QListWidgetItem) -> None:
        self.recent_requested.emit(item.data(Qt.ItemDataRole.UserRole))

    def _recover(self) -> None:
        if self._cut_off is not None:
            self.recover_button.setEnabled(False)  # until the folder has been read again
            self.recover.emit(self._cut_off)


def _item(session: RecentSession) -> QListWidgetItem:
    row = session.row
    item = QListWidgetItem(f"{row.name}\n{row.duration}, {session.age}")
    item.setToolTip(str(row.path))
    item.setData(Qt.ItemDataRole.UserRole, row.path)
    item.setSizeHint(QSize(0, ROW + 4))
    if session.details.image is not None:
        item.setIcon(QIcon(pixmap(session.details.image)))
    else:
        item.setIcon(QIcon(no_image()))
    return item


def _centred(widget: QWidget) -> QHBoxLayout:
    """A widget as wide as the cards, centred."""
    widget.setMaximumWidth(3 * CARD + 2 * 16)
    row = QHBoxLayout()
    row.addStretch(1)
    row.addWidget(widget, 3 * CARD)
    row.addStretch(1)
    return row


def _card(title: str, text: str, signal: SignalInstance) -> QFrame:
    card = QFrame()
    card.setObjectName("card")
    card.setMinimumWidth(NARROW)
    card.setMaximumWidth(CARD)
    column = QVBoxLayout(card)
    column.setContentsMargins(WIDE, WIDE, WIDE, WIDE)
    column.setSpacing(APART)
    about = QLabel(text)
    about.setWordWrap(True)
    about.setAlignment(Qt.AlignmentFlag.AlignTop)
    about.setMinimumHeight(64)
    button = QPushButton(title)
    button.setProperty("role", "primary")
    button.clicked.connect(signal)
    column.addWidget(about, 1)
    column.addWidget(button)
    return card
