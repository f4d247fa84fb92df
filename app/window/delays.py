"""How long after its sample the hand is on the screen and in the streams."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Collection, Sequence

from PySide6.QtCore import QObject, QTimer

from app.engines.engine_host import EngineHost
from app.engines.snapshot import Snapshot
from tracker.base.clock import monotonic
from tracker.live.telemetry import latency_figures

HAND = "hand"
"""The panel whose painting is measured."""
KEPT = 100  # estimates; two to six seconds
REPORT_EVERY = 1.0  # s


class DelayMeter(QObject):
    """Measures until the window's widgets were painted and passed to the window system; the screen
    shows them with its next frame or the one after. The engine receives the figures once a second,
    so that its status and recordings contain them.

    ``streams`` returns the delays of the streams, s, and ``clock`` the time of the samples, s.
    """

    def __init__(
        self,
        host: EngineHost,
        streams: Callable[[], Sequence[float]],
        clock: Callable[[], float] = monotonic,
    ) -> None:
        super().__init__(host)
        self._host, self._streams, self._clock = host, streams, clock
        self._late: deque[float] = deque(maxlen=KEPT)
        self._last = self._drawn = float("-inf")  # s, instants of samples
        self._due = 0.0
        # Widgets are painted by an event that precedes all timers.
        self._painted = QTimer(self, singleShot=True, interval=0)
        self._painted.timeout.connect(self._measure)
        host.opened.connect(self._begin)

    def refreshed(self, view: Snapshot, panels: Collection[str]) -> None:
        """The panels of these names were refreshed with ``view`` and will be painted next."""
        if view.setup.live is None:
            return
        if HAND in panels and view.estimate is not None and view.estimate.t > self._last:
            self._last = self._drawn = view.estimate.t
            self._painted.start()
        now = self._clock()
        if now >= self._due:
            self._due = now + REPORT_EVERY
            view.setup.live.hand.set_figures(self._figures())

    def _begin(self) -> None:
        """Begin with another engine."""
        self._late.clear()
        self._last = float("-inf")

    def _measure(self) -> None:
        self._late.append(self._clock() - self._drawn)

    def _figures(self) -> dict[str, float]:
        screen, self._late = self._late, deque(maxlen=KEPT)
        found = {"screen": screen, "stream": self._streams()}
        return {k: v for name, s in found.items() if s for k, v in latency_figures(name, s).items()}
