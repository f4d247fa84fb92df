"""The window's timer: it shows the latest data in the panels and the status bar.

Tracking and window share a computer and Python's lock. When the computer is too slow, images are
left out of tracking and lost, so the window is drawn less often first. Painting gives way to
messages while a consumer of the hand needs low latency, and with two hands: their messages take
twice as long, and the more of the painting is compiled code, the more often the window asks for the
lock again in the middle of one.
"""

from __future__ import annotations

import logging
import time
from collections.abc import Callable, Sequence
from typing import NamedTuple

from PySide6.QtCore import QObject, Qt, QTimer, Signal

from app.engines.engine_host import EngineHost
from app.engines.snapshot import Snapshot
from app.panels.panel import Panel
from app.platform.painting_pauses import PAINTING
from app.viewmodels.recording import duration_text
from app.viewmodels.states import BAD, WARN
from app.window.status_bar import StatusBar
from app.words import tr
from tracker.messages import Shed, Tracking

SPARE = 4.0
"""A panel pauses for this many times the duration of its last refresh: on a loaded machine the
image slows down, not the tracking."""
SPARING = 4.0  # times its period, for a panel that is refreshed less often under load
REST_S = 5.0  # after a failure
_log = logging.getLogger(__name__)
LOW_LATENCY_SHARE = 0.6
"""Largest share of a processor for the window, painting included, while a motor or a robot waits
for the hand: tracking shares Python's lock, and constant painting delays every packet. Without such
a consumer there is no limit."""
LESS, MORE = 0.8, 0.01
"""While images are left out the share shrinks by `LESS` at each update; else it grows by `MORE`: it
recovers within 20 s and does not oscillate."""


class Floor(NamedTuple):
    """What remains to the window of an overloaded computer: its share of a processor, and the
    longest time between two drawings, s, whatever the share."""

    share: float
    slowest: float


OVERLOADED = Floor(0.3, 1 / 20)  # the window must not look frozen
STARVED = Floor(0.1, 1 / 8)
"""While tracking searches fewer images than arrive, whatever else was given up before."""
TICK_MS = 16
STATUS_PERIOD = 0.25  # s
RATE_OVER_S = 1.0
NO_HAND_AFTER = 3.0  # s


class Refresher:
    """Refreshes panels that are visible or working, each at its own rate.

    ``failed`` receives a sentence, once per panel.
    """

    def __init__(
        self,
        panels: Sequence[Panel],
        tick: float,
        failed: Callable[[str], None],
        clock: Callable[[], float] = time.monotonic,
    ) -> None:
        self._panels, self._tick, self._failed, self._clock = panels, tick, failed, clock
        self._due: dict[str, float] = {}
        self._reported: set[str] = set()

    def clear(self) -> None:
        """Let every panel show that there is no engine."""
        for panel in self._panels:
            self._refresh(panel, None)

    def refresh(self, view: Snapshot) -> list[str]:
        """Refresh the panels that are due; returns their names. ``tick`` is the s between two
        calls."""
        now, refreshed = self._clock(), []
        for panel in self._panels:
            hidden = panel.visibleRegion().isEmpty() and not panel.works_unseen
            if now < self._due.get(panel.name, 0.0) or hidden:
                continue
            began = self._clock()
            fine = self._refresh(panel, view)
            rest = self._period(panel, view) - self._tick / 2 if fine else REST_S
            self._due[panel.name] = now + max(rest, SPARE * (self._clock() - began))
            refreshed += [panel.name] if fine else []
        return refreshed

    def _period(self, panel: Panel, view: Snapshot) -> float:
        """s; longer while the engine reports that the computer is too slow for all panels."""
        spared = panel.spared_at is not None and view.shed >= panel.spared_at
        return panel.period * (SPARING if spared else 1.0)

    def _refresh(self, panel: Panel, view: Snapshot | None) -> bool:
        """Returns whether it succeeded."""
        PAINTING.pause()
        try:
            panel.refresh(view)
        except Exception as error:  # noqa: BLE001  one panel's fault must not stop the others
            self._report(panel, error)
            return False
        return True

    def _report(self, panel: Panel, error: Exception) -> None:
        if panel.name not in self._reported:
            self._reported.add(panel.name)
            _log.exception("The panel %s failed.", panel.name)
            self._failed(
                tr("Panel {} failed and is paused ({}: {}). Everything else continues.").format(
                    panel.windowTitle().replace("&&", "&"), type(error).__name__, error
                )
            )


class Pace:
    """Decides when to draw again; times in s, ``spent`` is the processor time of the drawing
    thread."""

    def __init__(self) -> None:
        self.share = 1.0
        self._floor = OVERLOADED
        self._last = (0.0, 0.0)  # the time of the last drawing, and ``spent`` then

    def look(self, overloaded: bool, starved: bool = False) -> None:
        """Adapt the share, a few times a second; ``overloaded``: images are left out; ``starved``:
        on purpose (`Shed.IMAGES`)."""
        self._floor = STARVED if starved else OVERLOADED
        if overloaded or starved:
            self.share = max(self._floor.share, LESS * self.share)
        else:
            self.share = min(1.0, self.share + MORE)

    def is_due(self, now: float, spent: float, hurried: bool) -> bool:
        """Whether to draw ``now``; if so, the share is counted from here. ``hurried``: a consumer
        of the hand needs low latency."""
        since, used = now - self._last[0], spent - self._last[1]
        held = self.share < 1.0 and used > self.share * since and since < self._floor.slowest
        if held or (hurried and used > LOW_LATENCY_SHARE * since):
            return False
        self._last = now, spent
        return True


class Ticker(QObject):
    """Runs from `start` to `stop`; ``ticks`` is counted for measuring the window's rate.

    ``colours_unfit``: patches were detected and no hand was found, or that has ended. ``no_hand``:
    `NO_HAND_AFTER` s of packets and images after the start without a hand; once per engine.
    ``is_waited_for``: whether a consumer of the hand needs low latency; then panels pause longer.
    ``refreshed`` is called with the data and the names of the panels that show them.
    """

    colours_unfit = Signal(bool)
    no_hand = Signal()

    def __init__(
        self,
        host: EngineHost,
        panels: Sequence[Panel],
        bar: StatusBar,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._host, self._bar = host, bar
        self._refresher = Refresher(panels, TICK_MS / 1000, host.error.emit)
        self._status_due = 0.0
        self.ticks = 0
        self._unfit = False
        self._handless_since: float | None = None
        self._hand_missed = False
        host.opened.connect(self._begin)
        host.closed.connect(self._clear)
        self.is_waited_for: Callable[[], bool] = lambda: False
        self.refreshed: Callable[[Snapshot, Sequence[str]], None] = lambda view, panels: None
        self._pace = Pace()
        self._counted = (0.0, 0)  # when, and how many ticks there had been
        self._timer = QTimer(self)
        self._timer.setTimerType(Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._tick)

    def start(self) -> None:
        self._timer.start(TICK_MS)

    def stop(self) -> None:
        self._timer.stop()

    def _begin(self) -> None:
        """Begin with another engine."""
        self._handless_since, self._hand_missed = None, False

    def _clear(self) -> None:
        """Show that there is no engine."""
        self._refresher.clear()
        self._bar.show_status(None, False)
        self._bar.show_hands({}, False)

    def _tick(self) -> None:
        now = time.monotonic()
        setup, hurried = self._host.setup, self.is_waited_for()
        live = setup.live if setup is not None else None
        should_pause = hurried or (setup is not None and bool(setup.others))
        PAINTING.priority = live.engine.work_priority if live is not None and should_pause else None
        if not self._pace.is_due(now, time.thread_time(), hurried):
            return
        self.ticks += 1
        view = self._host.snapshot()
        if view is not None:
            self.refreshed(view, self._refresher.refresh(view))
        if now >= self._status_due:
            self._status_due = now + STATUS_PERIOD
            self._refresh_status(view)
            self._miss_hand(view, now)
            self._show_rate(now)

    def _miss_hand(self, view: Snapshot | None, now: float) -> None:
        """Emit `no_hand` where the start finds none."""
        if self._hand_missed or view is None or view.status is None or not view.setup.whole:
            return
        if view.status.tracking != Tracking.SEARCHING:
            self._hand_missed = True  # it was found once and will be found again
        elif not (view.packets_arrive and view.images_arrive):
            self._handless_since = None
        elif self._handless_since is None:
            self._handless_since = now
        elif now - self._handless_since >= NO_HAND_AFTER:
            self._hand_missed = True
            self.no_hand.emit()

    def _show_rate(self, now: float) -> None:
        """Over at least 1 s: a quarter of a second is too coarse."""
        since, ticks = self._counted
        if now - since >= RATE_OVER_S:
            if since:
                self._bar.show_rate((self.ticks - ticks) / (now - since))
            self._counted = (now, self.ticks)

    def _refresh_status(self, view: Snapshot | None) -> None:
        placed = view is None or (view.setup.camera.present and view.setup.camera.calibrated)
        replayed = view is not None and view.setup.player is not None
        self._bar.show_status(view.status if view else None, self._host.running, placed, replayed)
        hands = (view, *view.others) if view is not None else ()
        statuses = {v.setup.side: v.status for v in hands}
        self._bar.show_hands(statuses, self._host.running, placed, replayed)
        values = view.status.values if view is not None and view.status is not None else {}
        starved = view is not None and view.is_overloaded and view.shed >= Shed.IMAGES
        self._pace.look(view is not None and view.is_overloaded, starved)
        unfit = bool(values.get("colours_unfit", 0.0))
        if unfit != self._unfit:
            self._unfit = unfit
            self.colours_unfit.emit(unfit)
        recording, text = self._host.recording, ""
        if recording.request is not None:
            word = self.tr("Paused") if recording.paused else self.tr("Recording")
            text = f"{word} {duration_text(recording.elapsed)}"
        self._bar.show_recording(text, WARN.colour if recording.paused else BAD.colour)
