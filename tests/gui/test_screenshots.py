"""The screenshot tool waits until a panel shows something."""

from __future__ import annotations

import numpy as np
from PySide6.QtWidgets import QTreeWidget, QTreeWidgetItem, QVBoxLayout, QWidget

from app.tools.screenshots import has_contents
from app.widgets.curve_plot import CurveLook, TwoAxisPlot


def test_a_panel_has_contents_when_its_curves_fill_the_plot_and_its_tree_has_items(qtbot) -> None:
    panel, plot, tree = QWidget(), TwoAxisPlot(), QTreeWidget()
    column = QVBoxLayout(panel)
    column.addWidget(plot)
    column.addWidget(tree)
    qtbot.addWidget(panel)
    tree.addTopLevelItem(QTreeWidgetItem(["IMUs"]))
    plot.set_looks([CurveLook("#ff0000")])
    plot.show_time(-10.0, 0.0)
    assert not has_contents(panel)  # it is not shown
    with qtbot.waitExposed(panel):
        panel.show()
    assert not has_contents(panel)
    for seconds, filled in ((5.0, False), (10.0, True)):
        t = np.linspace(-seconds, 0.0, 50)
        plot.draw([(t, np.sin(t))])
        assert has_contents(panel) is filled
    tree.clear()
    assert not has_contents(panel)
    tree.hide()
    assert has_contents(panel)
