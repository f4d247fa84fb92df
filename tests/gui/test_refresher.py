"""The refresh rate of panels, on a simulated clock."""

from types import SimpleNamespace

import numpy as np
import pytest

from app.engines.engine_host import EngineHost
from app.engines.snapshot import Snapshot
from app.panels.panel import Panel
from app.platform.painting_pauses import PAINTING
from app.platform.tasks import TaskOwner
from app.widgets.image_shapes import Cross
from app.widgets.image_view import ImageView
from app.window.ticker import SPARING, Refresher
from tests.gui.gui_fakes import ScriptedEngine, scripted_setup
from tracker.base.notices import failure
from tracker.messages import Shed

TICK = 0.005


class Counting(Panel):
    period = 0.05

    def __init__(self, name: str, spared_at: Shed | None) -> None:
        self.name, self.spared_at = name, spared_at
        super().__init__()
        self.times = 0

    def refresh(self, view: Snapshot | None) -> None:
        self.times += 1


@pytest.fixture
def host(qapp):
    host = EngineHost(TaskOwner())
    yield host
    host.shut_down()


def refreshed(host: EngineHost, qtbot, shed: float) -> tuple[int, int]:
    """Refreshes in 10 s of a panel that is reduced from the first step on, and of one that never
    is."""
    engine = ScriptedEngine()
    engine.values["load_shed"] = shed
    host.adopt(scripted_setup(engine))
    panels = [Counting("spared", Shed.VIEW_RATE), Counting("other", None)]
    for panel in panels:
        qtbot.addWidget(panel)
        panel.resize(50, 50)
        panel.show()
    now = 0.0
    refresher = Refresher(panels, TICK, lambda text: None, lambda: now)
    view = host.snapshot()
    for _ in range(2000):
        now += TICK
        refresher.refresh(view)
    return panels[0].times, panels[1].times


def test_only_low_priority_panels_are_delayed_on_an_overloaded_computer(host, qtbot):
    both = refreshed(host, qtbot, 0.0)
    assert both[0] == both[1] == pytest.approx(10 / Counting.period, rel=0.1)
    spared, other = refreshed(host, qtbot, float(Shed.VIEW_RATE))
    assert other == both[1]
    assert spared == pytest.approx(other / SPARING, rel=0.1)


def test_panels_and_images_give_way_to_a_device_that_follows_the_hand(host, qtbot, monkeypatch):
    given: list[str] = []
    monkeypatch.setattr(PAINTING, "priority", SimpleNamespace(wait=lambda: given.append("way")))
    panel = Counting("one", None)
    qtbot.addWidget(panel)
    panel.show()
    host.adopt(scripted_setup(ScriptedEngine()))
    Refresher([panel], TICK, lambda text: None).refresh(host.snapshot())
    assert panel.times == 1 and len(given) == 1
    view = ImageView("left", "no image")
    qtbot.addWidget(view)
    view.show_image(np.zeros((90, 160), np.uint8), [Cross(1.0, 1.0, "#ffffff")] * 5)
    given.clear()
    view.grab()
    assert len(given) == 1


def test_a_failing_engine_is_stopped_and_reported(host, qtbot):
    engine, errors = ScriptedEngine(), []
    host.adopt(scripted_setup(engine))
    host.error.connect(errors.append)
    assert host.running
    engine.failure = failure("thread.failed", thread="camera", type="ValueError", why="empty")
    host.snapshot()
    assert not host.running and engine.stopped
    assert len(errors) == 1 and "Tracking has stopped" in errors[0] and "ValueError" in errors[0]
    host.snapshot()
    assert len(errors) == 1
