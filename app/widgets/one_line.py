"""A panel's controls in one line; those that find no room stand in a leaf behind a button."""

from __future__ import annotations

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
        self.more = MoreButton(self.tr("More"))
        self.more.hide()
        self._row = QHBoxLayout(self)
        self._row.setSizeConstraint(QLayout.SizeConstraint.SetNoConstraint)
        self._row.setContentsMargins(0, 0, 0, 0)
        self._row.setSpacing(NEAR)
        self._row.addWidget(self.more)
        self._row.addStretch(1)

    def add(self, widget: QWidget) -> None:
        """The next one."""
        self._widgets.append(widget)
        widget.installEventFilter(self)
        self._lay_out(len(self._widgets))
        self._share()

    def take_out(self, widget: QWidget) -> None:
        """Forget one; it is the caller's again."""
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
        return QSize(self._needed(len(self._widgets)), self._height())

    def minimumSizeHint(self) -> QSize:
        return QSize(self.more.sizeHint().width(), self._height())

    def _height(self) -> int:
        return max((w.sizeHint().height() for w in (self.more, *self._widgets)), default=0)

    def _needed(self, count: int) -> int:
        """px that the first ``count`` take, with the button where that is not all."""
        shown = [w for w in self._widgets[:count] if not is_hidden(w)]
        shown += [self.more] if count < len(self._widgets) else []
        return sum(w.sizeHint().width() for w in shown) + NEAR * max(0, len(shown) - 1)

    def _share(self) -> None:
        width, count = self.width(), len(self._widgets)
        while count > 0 and self._needed(count) > width:
            count -= 1
        self._lay_out(count)

    def _lay_out(self, count: int) -> None:
        """The first ``count`` in the line, the others in the leaf."""
        if count == self._inside and self._row.count() == count + 2:
            return
        self._inside = count
        for i, widget in enumerate(self._widgets):
            hidden = is_hidden(widget)
            if i < count:
                self._row.insertWidget(i, widget)
            else:
                self.more.add(widget)
            widget.setHidden(hidden)
        self.more.setVisible(count < len(self._widgets))
        self.updateGeometry()

    def _fit(self) -> None:
        """Their sizes have changed, which layouts out of sight are not told."""
        for widget in (*self._widgets, self.more):
            widget.updateGeometry()
        self._share()
        self._row.activate()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        QTimer.singleShot(0, self, self._fit)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._share()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in CHANGES:  # of how much room it needs
            QTimer.singleShot(0, self, self._fit)  # not while it is being moved itself
        return super().eventFilter(watched, event)


def is_hidden(widget: QWidget) -> bool:
    """Whether somebody has hidden it; one that was never shown is not."""
    explicit = widget.testAttribute(Qt.WidgetAttribute.WA_WState_ExplicitShowHide)
    return widget.isHidden() and explicit
