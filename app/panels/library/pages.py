"""Pages behind tabs; what can be done with the page in front stands beside the tabs."""

from __future__ import annotations

from PySide6.QtWidgets import QHBoxLayout, QStackedWidget, QTabBar, QVBoxLayout, QWidget

from app.widgets.measures import APART


class Pages(QWidget):
    """Tabs and a page's controls share one line: the height is the page's own."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.bar = QTabBar()
        self.bar.setDocumentMode(True)
        self.bar.setExpanding(False)
        self.bar.setDrawBase(False)
        self._pages, self._heads = QStackedWidget(), QStackedWidget()
        line = QHBoxLayout()
        line.setSpacing(APART)
        line.addWidget(self.bar)
        line.addWidget(self._heads, 1)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        column.addLayout(line)
        column.addWidget(self._pages, 1)
        self.bar.currentChanged.connect(self._pages.setCurrentIndex)
        self.bar.currentChanged.connect(self._heads.setCurrentIndex)

    def add(self, page: QWidget, head: QWidget, title: str) -> None:
        """``head``: its controls."""
        self._pages.addWidget(page)
        self._heads.addWidget(head)
        self.bar.addTab(title)

    def page(self, index: int) -> QWidget:
        found = self._pages.widget(index)
        if found is None:
            raise IndexError(index)
        return found
