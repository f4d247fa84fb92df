"""What the guided poses ask of the engine: what it knows of the wearer, and to forget it again."""

from __future__ import annotations

from PySide6.QtCore import QObject, Signal

from app.engines.engine_host import EngineHost
from app.jobs.calibration_commands import chain_of
from app.viewmodels.guided_result import WearerNow
from tracker.fusion.engine import Engine


class GuidedCommands(QObject):
    """Answers come back into the window's thread."""

    known = Signal(object)  # WearerNow, after `ask`

    def __init__(self, host: EngineHost, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._host = host

    def ask(self) -> bool:
        """Have what is known of the wearer sent by `known`; False where no engine takes commands.

        An engine that learns nothing of wearers says so in the log.
        """
        return self._host.command(self._answer)

    def _answer(self, engine: Engine) -> None:
        chain = chain_of(engine)
        gains, aside = chain.wearer.synergies
        remembered = chain.wearer.remembered()
        self.known.emit(WearerNow(gains.copy(), aside.copy(), chain.calibration(), remembered))

    def take_back(self, before: WearerNow) -> bool:
        """The wearer is known as he was ``before``."""
        known = before.remembered
        return self._host.command(lambda engine: chain_of(engine).wearer.take_back(known))
