"""What the guided poses ask of the engine: what it knows of the wearer, and to forget it again."""

from __future__ import annotations

from PySide6.QtCore import QObject, Signal

from app.engines.engine_host import EngineHost
from app.jobs.calibration_commands import learning_part
from app.viewmodels.guided_result import WearerNow
from tracker.fusion.engine import Engine


class GuidedCommands(QObject):
    """Of the hand of one ``side``. Answers come back into the window's thread."""

    known = Signal(object)  # WearerNow, after `ask`

    def __init__(self, host: EngineHost, side: str, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._host, self._side = host, side

    def ask(self) -> bool:
        """Have what is known of the wearer sent by `known`; False where no engine takes commands.

        An engine that learns nothing of wearers says so in the log.
        """
        return self._host.command(self._answer, self._side)

    def _answer(self, engine: Engine) -> None:
        learner = learning_part(engine)
        wearer = learner.wearer
        gains, aside = wearer.synergies
        ends = {digit: P.copy() for digit, P in wearer.end_joints.items()}
        frozen, learning = wearer.calibration.is_frozen, wearer.is_learning
        known = wearer.remembered()
        self.known.emit(
            WearerNow(
                gains.copy(), aside.copy(), ends, learner.calibration(), known, frozen, learning
            )
        )

    def take_back(self, before: WearerNow) -> bool:
        """The wearer is known as he was ``before``."""
        known = before.remembered
        return self._host.command(
            lambda engine: learning_part(engine).wearer.take_back(known), self._side
        )
