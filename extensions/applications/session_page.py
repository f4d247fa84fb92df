"""An application off-screen, shown on a page at the pace of its hand."""

from __future__ import annotations

import threading

from extensions.applications.page import PageServer
from extensions.applications.runner import Outcome
from tracker.base.clock import monotonic


class PacedPage:
    """Shows each sample when it is due; ``paced`` False: at once, since it comes live."""

    def __init__(self, port: int, paced: bool) -> None:
        self._server, self._paced = PageServer(port), paced
        self._began: float | None = None
        self.url = self._server.url

    def look(self, title: str, outcome: Outcome) -> None:
        """Waits for the sample's time, then shows it."""
        now = monotonic()
        if self._began is None:
            self._began = now - outcome.t
        if self._paced and self._began + outcome.t > now:
            threading.Event().wait(self._began + outcome.t - now)
        self._server.show(title, outcome.hand, outcome.drawing)

    def close(self) -> None:
        self._server.close()
