"""Commands of the calibration panel to the engine; replies arrive in the window's thread."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial

from PySide6.QtCore import QObject, Signal

from app.engines.engine import EngineSetup
from app.engines.host_parts import EngineCommands
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.fusion.chain.calibration.control import renewed
from tracker.fusion.chain.calibration.measured import measured_profile
from tracker.fusion.chain.calibration.profile_file import WearerFile
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.profile import WearerProfile
from tracker.fusion.engine import Engine
from tracker.fusion.wearer_learning import LearnsWearer, learned, learner_of


def learning_part(engine: Engine) -> LearnsWearer:
    """The engine, if it estimates the wearer's calibration. Raises ConfigError otherwise."""
    if (learner := learner_of(engine)) is not None:
        return learner
    raise ConfigError(notice("engine.no_wearer"))


class CalibrationCommands(QObject):
    """Commands to the engine of a `EngineCommands`."""

    learned = Signal(object)  # WearerFile, after `ask`

    def __init__(self, host: EngineCommands, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._host = host

    def layout(self) -> ChainLayout | None:
        """Layout of the displayed glove and hand."""
        return self.layout_of(self._host.setup) if self._host.setup is not None else None

    @staticmethod
    def layout_of(setup: EngineSetup) -> ChainLayout:
        """Layout of a glove and hand."""
        return ChainLayout(setup.hand, setup.glove)

    @property
    def available(self) -> bool:
        """Whether an engine accepts commands: not in a replay, nor after a stop."""
        setup = self._host.setup
        return setup is not None and setup.live is not None and self._host.running

    def reset(self, segments: Sequence[str] | None) -> bool:
        """Reset the calibration of some segments, or (None) of all."""
        return self._host.command(partial(_reset, segments=segments))

    def freeze(self, on: bool) -> bool:
        return self._host.command(partial(_freeze, on=on))

    def apply_profile(self, profile: WearerProfile, side: str) -> bool:
        """Send a profile, and the calibration of the glove from an earlier fit, to that hand."""
        return self._host.command(partial(_load_wearer, profile=profile), side)

    def measured(self, length: float) -> bool:
        """Restart the calibration with this hand length (m)."""
        return self._host.command(partial(_put_on_measured, length=length))

    def ask(self) -> bool:
        """Request the calibration, which `learned` delivers."""
        return self._host.command(_learned, answer=self.learned.emit)


def _reset(engine: Engine, segments: Sequence[str] | None) -> None:
    learning_part(engine).wearer.reset(segments)


def _freeze(engine: Engine, on: bool) -> None:
    learning_part(engine).wearer.freeze(on)


def _load_wearer(engine: Engine, profile: WearerProfile) -> None:
    learner = learning_part(engine)
    learner.apply_profile(renewed(profile, learner.layout))


def _put_on_measured(engine: Engine, length: float) -> None:
    learner = learning_part(engine)
    learner.apply_profile(measured_profile(learner.layout, length))


def _learned(engine: Engine) -> WearerFile:
    return learned(learning_part(engine))
