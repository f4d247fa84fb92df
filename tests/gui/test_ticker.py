"""The window's timer: the share of a processor that drawing may take."""

import time
from types import SimpleNamespace

from app.platform.painting_pauses import PAINTING
from app.window.ticker import LOW_LATENCY_SHARE, Ticker
from tracker.live.work_priority import WorkPriority

WORK = 0.03  # s of processor time that a look at the engine takes here


class Busy(Ticker):
    """Painting, as the event loop does it between two ticks."""

    def _tick(self) -> None:
        before = self.ticks
        super()._tick()
        end = time.thread_time() + WORK * (self.ticks - before)
        while time.thread_time() < end:
            pass


def test_a_window_that_has_much_to_paint_leaves_the_processor_to_what_moves(window, qtbot):
    """Beside an application or a robot; where there is none it takes what it can get."""
    assert not window.ticker.is_waited_for()
    window.panels["robot"].link.on = True
    assert window.ticker.is_waited_for()
    bar = SimpleNamespace(show_status=lambda *_: None, show_recording=lambda *_: None)
    bar.show_hands = bar.show_rate = bar.show_status
    ticker = Busy(window.host, [], bar)
    ticker.is_waited_for = window.ticker.is_waited_for
    ticker.start()
    qtbot.waitUntil(lambda: ticker.ticks >= 2)
    began, spent, ticks = time.monotonic(), time.thread_time(), ticker.ticks
    qtbot.waitUntil(lambda: ticker.ticks >= ticks + 20)
    ticker.stop()
    share = (time.thread_time() - spent) / (time.monotonic() - began)
    assert share < LOW_LATENCY_SHARE + 0.15  # and the rest of the window


def test_painting_pauses_where_something_waits_for_the_hand_and_with_two_hands(window, qtbot):
    way = WorkPriority()
    host = SimpleNamespace(
        setup=SimpleNamespace(
            live=SimpleNamespace(engine=SimpleNamespace(work_priority=way)), others=()
        ),
        snapshot=lambda: None,
        opened=window.host.opened,
        closed=window.host.closed,
        error=window.host.error,
        running=True,
        recording=window.host.recording,
    )
    bar = SimpleNamespace(show_status=lambda *_: None, show_recording=lambda *_: None)
    bar.show_hands = bar.show_rate = bar.show_status
    window.ticker.stop()  # there is one thread that paints
    ticker = Ticker(host, [], bar)
    for waited_for in (True, False, True):
        ticker.is_waited_for = lambda on=waited_for: on
        ticker._tick()
        assert (PAINTING.priority is way) == waited_for
    ticker.is_waited_for = lambda: False
    host.setup.others = (object(),)
    ticker._tick()
    assert PAINTING.priority is way
    host.setup = None
    ticker._tick()
    assert PAINTING.priority is None
