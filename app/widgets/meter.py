"""Table cells that hold a figure over a bar."""

from __future__ import annotations

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QRectF, Qt
from PySide6.QtGui import QColor, QPainter
from PySide6.QtWidgets import QStyledItemDelegate, QStyleOptionViewItem

SHARE_ROLE = Qt.ItemDataRole.UserRole + 1
FULL, PART = QColor("#009E73"), QColor("#E69F00")
ENOUGH = 0.9


class MeterDelegate(QStyledItemDelegate):
    """Paints `SHARE_ROLE` (0..1) as a thin bar under the text."""

    def paint(
        self,
        painter: QPainter,
        option: QStyleOptionViewItem,
        index: QModelIndex | QPersistentModelIndex,
    ) -> None:
        super().paint(painter, option, index)
        share = index.data(SHARE_ROLE)
        if share is None or share != share:  # NaN: there is no such parameter
            return
        box = QRectF(option.rect).adjusted(6, option.rect.height() - 5, -6, -2)
        painter.save()
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(128, 128, 128, 70))
        painter.drawRoundedRect(box, 1.5, 1.5)
        box.setWidth(max(3.0, box.width() * share))
        painter.setBrush(FULL if share >= ENOUGH else PART)
        painter.drawRoundedRect(box, 1.5, 1.5)
        painter.restore()
