"""The icons: Lucide drawings in the colours of the palette."""

from __future__ import annotations

from functools import cache

from PySide6.QtCore import QByteArray, QSize, Qt
from PySide6.QtGui import QAction, QColor, QIcon, QPainter, QPalette, QPixmap, QPixmapCache
from PySide6.QtSvg import QSvgRenderer
from PySide6.QtWidgets import QAbstractButton, QApplication

from resources import folder

NAME = "icon_name"
"""The property of an action or a button that contains the name of its icon."""
SIZES = (16, 32, 48)  # px; up to 300 %
INK = "currentColor"
GAP = "\N{EN SPACE}"


def dress(item: QAction | QAbstractButton, name: str) -> None:
    """Set the icon ``name``, which `recolour` updates."""
    item.setProperty(NAME, name)
    item.setIcon(icon(name, QApplication.palette()))


def text_by_icon(text: str) -> str:
    """``text`` with more distance from its icon than the 4 px of Qt's styles."""
    return GAP + text


def recolour(app: QApplication) -> None:
    """Redraw all icons in the colours of the palette of ``app``."""
    palette = app.palette()
    for widget in app.allWidgets():
        items = [*widget.actions(), widget]
        for item in items:
            name = item.property(NAME)
            if name and isinstance(item, QAction | QAbstractButton):
                item.setIcon(icon(str(name), palette))


def icon(name: str, palette: QPalette) -> QIcon:
    """The icon in its normal, disabled and checked (on the accent colour) state."""
    normal, off = QPalette.ColorGroup.Active, QPalette.ColorGroup.Disabled
    text = palette.color(normal, QPalette.ColorRole.ButtonText)
    faint = palette.color(off, QPalette.ColorRole.ButtonText)
    on = palette.color(normal, QPalette.ColorRole.HighlightedText)
    found = QIcon()
    for size in SIZES:
        found.addPixmap(drawing(name, text, size), QIcon.Mode.Normal, QIcon.State.Off)
        found.addPixmap(drawing(name, faint, size), QIcon.Mode.Disabled)
        found.addPixmap(drawing(name, on, size), QIcon.Mode.Normal, QIcon.State.On)
    return found


def drawing(name: str, colour: QColor, size: int) -> QPixmap:
    """``size`` px square, cached. Raises FileNotFoundError for an unknown name."""
    pixmap, key = QPixmap(QSize(size, size)), f"lucide {name} {colour.name()} {size}"
    if QPixmapCache.find(key, pixmap):
        return pixmap
    pixmap.fill(Qt.GlobalColor.transparent)
    painter = QPainter(pixmap)
    QSvgRenderer(QByteArray(_svg(name).replace(INK, colour.name()).encode())).render(painter)
    painter.end()
    QPixmapCache.insert(key, pixmap)
    return pixmap


@cache
def _svg(name: str) -> str:
    return (folder("icons") / "lucide" / f"{name}.svg").read_text("utf-8")
