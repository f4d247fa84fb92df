"""The tool that measures what a refresh of each panel costs, in the real window."""

from __future__ import annotations

import pytest

from app.tools.paint_profile import PaintProfile, PanelCost, _table, measure_panels, share_of
from app.widgets import image_canvas

MOST = 20.0
"""Python of a refresh of all panels, in fixed loops: 2.5 on an idle computer and up to 5 beside ten
busy processes; 9 while shapes were painted one by one."""


def test_each_visible_panel_has_a_row_and_python_holds_the_lock_for_few_loops(live, qtbot):
    live.store.update(job="all")
    live.resize(1440, 900)
    for name in ("hand", "cameras", "sensors"):
        live.show_panel(name)
    before = image_canvas.draw_strokes
    found = measure_panels(live, "right", 10)
    assert image_canvas.draw_strokes is before, "kernels are only counted meanwhile"
    costs = {cost.panel: cost for cost in found.panels}
    visible = {n for n, panel in live.panels.items() if not panel.visibleRegion().isEmpty()}
    assert {"hand", "cameras"} <= visible <= costs.keys()
    assert costs["hand"].unlocked_ms > 0, "drawn by compiled code"
    assert all(0 <= cost.unlocked_ms <= cost.refresh_ms + cost.paint_ms for cost in found.panels)
    assert 0 < found.ratio < MOST
    assert live.ticker._timer.isActive()


def test_the_ratio_is_time_with_the_lock_over_the_fixed_loop():
    share = share_of(1 / 20)  # s; the window is refreshed 30 times a second
    assert share == pytest.approx(2 / 3) and share_of(1 / 60) == 1.0
    panels = (PanelCost("hand", 5.0, 2.0, 4.0), PanelCost("sensors", 1.5, 3.0, 0.0, share))
    found = PaintProfile("right", 10, 4.0, panels)
    assert found.locked_ms == pytest.approx(6.0) and found.ratio == pytest.approx(1.5)
    assert "ratio 1.50" in _table(found) and "hand" in _table(found)
