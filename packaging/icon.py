"""Draws resources/icons/glovetrack.png from the SVG next to it."""

from __future__ import annotations

import os
import sys
from pathlib import Path

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication, QImage, QPainter
from PySide6.QtSvg import QSvgRenderer

ICONS = Path(__file__).parents[1] / "resources" / "icons"
SIZE = 256  # px


def draw(source: Path, target: Path, size: int = SIZE) -> bool:
    """Render an SVG to a square PNG; returns whether it was written."""
    image = QImage(size, size, QImage.Format.Format_ARGB32)
    image.fill(Qt.GlobalColor.transparent)
    painter = QPainter(image)
    QSvgRenderer(str(source)).render(painter)
    painter.end()
    return image.save(str(target))


if __name__ == "__main__":
    application = QGuiApplication([])
    sys.exit(0 if draw(ICONS / "glovetrack.svg", ICONS / "glovetrack.png") else 1)
