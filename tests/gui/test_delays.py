"""The measured delay of the hand on the screen contains the painting."""

from types import SimpleNamespace

import pytest
from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QWidget

from app.window.delays import DelayMeter

SAMPLE, REFRESH, PAINTING = 10.0, 0.012, 0.03  # s


class Host(QObject):
    opened = Signal(object)


class SlowWidget(QWidget):
    """Its painting takes time on ``clock``."""

    def __init__(self, clock):
        super().__init__()
        self.clock, self.painted = clock, 0

    def paintEvent(self, event):
        self.clock.now += PAINTING
        self.painted += 1


@pytest.fixture
def clock():
    return SimpleNamespace(now=SAMPLE + REFRESH)


@pytest.fixture
def seen():
    """What the engine received."""
    return []


def view_of(t, seen):
    live = SimpleNamespace(hand=SimpleNamespace(set_figures=seen.append))
    return SimpleNamespace(setup=SimpleNamespace(live=live), estimate=SimpleNamespace(t=t))


def test_until_the_panel_is_painted_and_once_for_each_estimate(qtbot, clock, seen):
    widget, host = SlowWidget(clock), Host()
    qtbot.addWidget(widget)
    widget.show()
    qtbot.waitUntil(lambda: widget.painted > 0)
    clock.now = SAMPLE + REFRESH
    meter = DelayMeter(host, lambda: [0.004, 0.006], clock=lambda: clock.now)
    for panels in (["hand"], ["cameras"], ["hand"]):  # the same estimate
        widget.painted = 0
        widget.update()
        meter.refreshed(view_of(SAMPLE, seen), panels)
        qtbot.waitUntil(lambda: widget.painted > 0 and not meter._painted.isActive())
    clock.now = SAMPLE + 5.0
    meter.refreshed(view_of(SAMPLE, seen), [])
    late_ms = 1e3 * (REFRESH + PAINTING)
    assert seen[-1] == pytest.approx(
        {
            "latency_screen_ms": late_ms,
            "latency_screen_p99_ms": late_ms,
            "latency_stream_ms": 5.0,
            "latency_stream_p99_ms": 5.98,
        }
    )


def test_without_a_panel_and_streams_there_are_no_figures(clock, seen):
    meter = DelayMeter(Host(), list, clock=lambda: clock.now)
    meter.refreshed(view_of(SAMPLE, seen), ["cameras"])
    assert seen == [{}]


def test_a_replay_is_not_measured(clock):
    meter = DelayMeter(Host(), list, clock=lambda: clock.now)
    view = view_of(SAMPLE, [])
    view.setup.live = None
    meter.refreshed(view, ["hand"])
    assert not meter._painted.isActive()
