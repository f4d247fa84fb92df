"""Controls in one line; those that do not fit move into a pop-up behind a button."""

from __future__ import annotations

from itertools import accumulate

from PySide6.QtCore import QEvent, QObject, QSize, Qt, QTimer
from PySide6.QtGui import QResizeEvent, QShowEvent
from PySide6.QtWidgets import QHBoxLayout, QLayout, QSizePolicy, QWidget

from app.widgets.measures import NEAR
from app.widgets.more_button import MoreButton

CHANGES = (
    QEvent.Type.FontChange,
    QEvent.Type.StyleChange,
    QEvent.Type.Polish,
    QEvent.Type.ShowToParent,
    QEvent.Type.HideToParent,
)


class OneLine(QWidget):
    """Widgets in order of `add`, which is also their priority."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self._widgets: list[QWidget] = []
        self._inside = 0  # number of widgets in the line
        self._due = False  # whether a layout update is scheduled
        self.more = MoreButton(self.tr("More"))
        self.more.hide()
        self._row = QHBoxLayout(self)
        self._row.setSizeConstraint(QLayout.SizeConstraint.SetNoConstraint)
        self._row.setContentsMargins(0, 0, 0, 0)
        self._row.setSpacing(NEAR)
        self._row.addWidget(self.more)
        self._row.addStretch(1)

    def add(self, widget: QWidget) -> None:
        """Append a widget. The available space is checked when the line is visible."""
        self._widgets.append(widget)
        widget.installEventFilter(self)
        self._lay_out(len(self._widgets))
        if self.isVisible():
            self._share()

    def take_out(self, widget: QWidget) -> None:
        """Remove a widget; the caller owns it again."""
        self._inside -= self._widgets.index(widget) < self._inside
        self._widgets.remove(widget)
        widget.removeEventFilter(self)
        widget.setParent(None)
        self._lay_out(len(self._widgets))
        self._share()

    @property
    def in_leaf(self) -> list[QWidget]:
        """Widgets that do not fit into the line."""
        return self._widgets[self._inside :]

    def sizeHint(self) -> QSize:
        return QSize(self._needed()[-1], self._height())

    def minimumSizeHint(self) -> QSize:
        return QSize(self.more.sizeHint().width(), self._height())

    def _height(self) -> int:
        return max((w.sizeHint().height() for w in (self.more, *self._widgets)), default=0)

    def _needed(self) -> list[int]:
        """Widths in px of the first 0, 1, … widgets, plus the button unless it is all of them."""
        each = [0 if is_hidden(w) else w.sizeHint().width() + NEAR for w in self._widgets]
        taken = list(accumulate(each, initial=0))
        more = self.more.sizeHint().width()
        return [*(px + more for px in taken[:-1]), max(0, taken[-1] - NEAR)]

    def _share(self) -> None:
        needed, width = self._needed(), self.width()
        self._lay_out(max((n for n, px in enumerate(needed) if px <= width), default=0))

    def _lay_out(self, count: int) -> None:
        """Place the first ``count`` widgets in the line, the others in the pop-up."""
        if count == self._inside and self._row.count() == count + 2:
            return
        stay, self._inside = min(count, self._inside), count
        for i, widget in enumerate(self._widgets[stay:], stay):
            hidden = is_hidden(widget)
            if i < count:
                self._row.insertWidget(i, widget)
            else:
                self.more.add(widget)
            widget.setHidden(hidden)
        self.more.setVisible(count < len(self._widgets))
        self.updateGeometry()

    def _fit_soon(self) -> None:
        """Schedule one update for all changes in this event loop iteration."""
        if not self._due:
            self._due = True
            QTimer.singleShot(0, self, self._fit)

    def _fit(self) -> None:
        """Sizes have changed, of which hidden layouts are not notified."""
        self._due = False
        for widget in (*self._widgets, self.more):
            widget.updateGeometry()
        self._share()
        self._row.activate()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._fit_soon()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._share()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in CHANGES:  # changes the required space
            self._fit_soon()
        return super().eventFilter(watched, event)


def is_hidden(widget: QWidget) -> bool:
    """Whether a widget was hidden explicitly; one that was never shown was not."""
    explicit = widget.testAttribute(Qt.WidgetAttribute.WA_WState_ExplicitShowHide)
    return widget.isHidden() and explicit
