"""Commands of the guided poses to the engine: query the wearer's calibration, and restore it."""

from __future__ import annotations

from functools import partial

from PySide6.QtCore import QObject, Signal

from app.engines.engine_host import EngineHost
from app.jobs.calibration_commands import learning_part
from app.viewmodels.guided_result import WearerNow
from tracker.fusion.chain.known import WearerSnapshot
from tracker.fusion.engine import Engine


class GuidedCommands(QObject):
    """For the hand of one ``side``. Answers arrive in the window's thread."""

    known = Signal(object)  # WearerNow, after `ask`

    def __init__(self, host: EngineHost, side: str, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._host, self._side = host, side

    def ask(self) -> bool:
        """Request the state of the wearer's calibration, delivered by `known`; False if no engine
        accepts commands.

        An engine without a wearer's calibration reports that in the log.
        """
        return self._host.command(_wearer_now, self._side, self.known.emit)

    def restore_snapshot(self, before: WearerNow) -> bool:
        """Restore the calibration from ``before``."""
        return self._host.command(partial(_restore, known=before.remembered), self._side)


def _wearer_now(engine: Engine) -> WearerNow:
    learner = learning_part(engine)
    wearer = learner.wearer
    gains, abduction = wearer.synergies
    ends = {digit: P.copy() for digit, P in wearer.end_joints.items()}
    frozen, learning = wearer.calibration.is_frozen, wearer.is_learning
    known = wearer.remembered()
    return WearerNow(
        gains.copy(), abduction.copy(), ends, learner.calibration(), known, frozen, learning
    )


def _restore(engine: Engine, known: WearerSnapshot) -> None:
    learning_part(engine).wearer.restore_snapshot(known)
