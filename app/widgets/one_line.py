"""A panel's controls in one line; those that find no room stand in a leaf behind a button."""

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
    """Widgets in the order of `add`, which is that of their importance too."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Fixed)
        self._widgets: list[QWidget] = []
        self._inside = 0  # so many of them stand in the line
        self._due = False  # they are to be fitted in the next turn of the loop
        self.more = MoreButton(self.tr("More"))
        self.more.hide()
        self._row = QHBoxLayout(self)
        self._row.setSizeConstraint(QLayout.SizeConstraint.SetNoConstraint)
        self._row.setContentsMargins(0, 0, 0, 0)
        self._row.setSpacing(NEAR)
        self._row.addWidget(self.more)
        self._row.addStretch(1)

    def add(self, widget: QWidget) -> None:
        """The next one. What finds room is asked when the line is seen."""
        self._widgets.append(widget)
        widget.installEventFilter(self)
        self._lay_out(len(self._widgets))
        if self.isVisible():
            self._share()

    def take_out(self, widget: QWidget) -> None:
        """Forget one; it is the caller's again."""
        self._inside -= self._widgets.index(widget) < self._inside
        self._widgets.remove(widget)
        widget.removeEventFilter(self)
        widget.setParent(None)
        self._lay_out(len(self._widgets))
        self._share()

    @property
    def in_leaf(self) -> list[QWidget]:
        """Those for which the line has no room."""
        return self._widgets[self._inside :]

    def sizeHint(self) -> QSize:
        return QSize(self._needed()[-1], self._height())

    def minimumSizeHint(self) -> QSize:
        return QSize(self.more.sizeHint().width(), self._height())

    def _height(self) -> int:
        return max((w.sizeHint().height() for w in (self.more, *self._widgets)), default=0)

    def _needed(self) -> list[int]:
        """px that the first 0, 1, … all take, with the button where that is not all."""
        each = [0 if is_hidden(w) else w.sizeHint().width() + NEAR for w in self._widgets]
        taken = list(accumulate(each, initial=0))
        more = self.more.sizeHint().width()
        return [*(px + more for px in taken[:-1]), max(0, taken[-1] - NEAR)]

    def _share(self) -> None:
        needed, width = self._needed(), self.width()
        self._lay_out(max((n for n, px in enumerate(needed) if px <= width), default=0))

    def _lay_out(self, count: int) -> None:
        """The first ``count`` in the line, the others in the leaf."""
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
        """Once for all that changes until then, and not while it is being moved itself."""
        if not self._due:
            self._due = True
            QTimer.singleShot(0, self, self._fit)

    def _fit(self) -> None:
        """Their sizes have changed, which layouts out of sight are not told."""
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
        if event.type() in CHANGES:  # of how much room it needs
            self._fit_soon()
        return super().eventFilter(watched, event)


def is_hidden(widget: QWidget) -> bool:
    """Whether somebody has hidden it; one that was never shown is not."""
    explicit = widget.testAttribute(Qt.WidgetAttribute.WA_WState_ExplicitShowHide)
    return widget.isHidden() and explicit
