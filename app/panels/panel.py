"""What every panel of the window is."""

from __future__ import annotations

from PySide6.QtWidgets import QWidget

from app.engines.engine_host import EngineHost
from app.engines.snapshot import Snapshot
from tracker.messages import Shed


class Panel(QWidget):
    """A dock's content. ``refresh`` is called at most every ``period`` seconds, when in sight."""

    name = ""  # stable, for layouts and tests
    period = 1 / 30
    spared_at: Shed | None = None  # from where on it is refreshed less often

    def __init__(self, host: EngineHost, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.host = host
        self.setObjectName(f"panel_{self.name}")

    def title(self) -> str:
        """The dock's title, translated."""
        raise NotImplementedError

    @property
    def works_unseen(self) -> bool:
        """Whether it is refreshed out of sight too, for work that it has to finish."""
        return False

    def refresh(self, view: Snapshot | None) -> None:
        """Show ``view``; None while no engine is open. Panels fed by signals need none."""

    def shut_down(self) -> None:
        """Free what Qt does not; called once, before the window goes."""
