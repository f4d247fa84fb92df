"""Which panel is refreshed when; one that fails rests and does not take the others along."""

from __future__ import annotations

import logging
import time
from collections.abc import Callable, Sequence

from app.engines.snapshot import Snapshot
from app.panels.panel import Panel
from app.platform.courtesy import PAINTING
from app.words import tr

SPARE = 4.0
"""A panel rests this many times as long as its last refresh took: on a busy machine the image
slows down, not the tracking."""
SPARING = 4.0  # times its period that a panel waits which is spared
REST_S = 5.0  # after a failure
_log = logging.getLogger(__name__)


class Refresher:
    """Refreshes panels in sight or at work, each at its own pace.

    ``failed`` gets a sentence, once a panel.
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
        self._told: set[str] = set()

    def clear(self) -> None:
        """Let every panel show that there is no engine."""
        for panel in self._panels:
            self._refresh(panel, None)

    def refresh(self, view: Snapshot) -> None:
        """Those that are due. ``tick`` is the s between two calls."""
        now = self._clock()
        for panel in self._panels:
            unseen = panel.visibleRegion().isEmpty() and not panel.works_unseen
            if now < self._due.get(panel.name, 0.0) or unseen:
                continue
            began = self._clock()
            fine = self._refresh(panel, view)
            rest = self._period(panel, view) - self._tick / 2 if fine else REST_S
            self._due[panel.name] = now + max(rest, SPARE * (self._clock() - began))

    def _period(self, panel: Panel, view: Snapshot) -> float:
        """s; longer where the engine says that the computer is too slow for all panels."""
        spared = panel.spared_at is not None and view.shed >= panel.spared_at
        return panel.period * (SPARING if spared else 1.0)

    def _refresh(self, panel: Panel, view: Snapshot | None) -> bool:
        """Whether that went well."""
        PAINTING.give_way()
        try:
            panel.refresh(view)
        except Exception as error:  # noqa: BLE001  one panel's fault must not stop the others
            self._tell(panel, error)
            return False
        return True

    def _tell(self, panel: Panel, error: Exception) -> None:
        if panel.name not in self._told:
            self._told.add(panel.name)
            _log.exception("The panel %s failed.", panel.name)
            self._failed(
                tr("The panel {} failed and rests ({}: {}); the rest goes on.").format(
                    panel.windowTitle().replace("&&", "&"), type(error).__name__, error
                )
            )
