"""What the calibration panel asks of the engine; answers come back into the window's thread."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from app.engines.engine import EngineSetup
from app.engines.engine_host import EngineHost
from app.words import tr
from tracker.base.errors import ConfigError
from tracker.fusion.chain.calibration.control import renewed
from tracker.fusion.chain.calibration.measured import measured_profile
from tracker.fusion.chain.calibration.profile_file import WearerFile
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.profile import WearerProfile
from tracker.fusion.engine import Engine

if TYPE_CHECKING:
    from tracker.fusion.chain.engine import ChainEngine


def chain_of(engine: Engine) -> ChainEngine:
    """The engine, if it is one whose calibration can be worked on. Raises ConfigError."""
    from tracker.fusion.chain.engine import ChainEngine  # by now it is loaded; a start does without

    if isinstance(engine, ChainEngine):
        return engine
    raise ConfigError(
        tr("Only the engine chain keeps a wearer's calibration: choose it in the Tracking menu.")
    )


class CalibrationCommands(QObject):
    """Commands to the engine of a `EngineHost`."""

    learned = Signal(object)  # WearerFile, after `ask`

    def __init__(self, host: EngineHost, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._host = host

    def layout(self) -> ChainLayout | None:
        """Of the glove and hand that are shown."""
        return self.layout_of(self._host.setup) if self._host.setup is not None else None

    @staticmethod
    def layout_of(setup: EngineSetup) -> ChainLayout:
        """Of a glove and hand."""
        return ChainLayout(setup.hand, setup.glove)

    @property
    def available(self) -> bool:
        """Whether there is an engine that takes commands: not in a replay, nor after a stop."""
        setup = self._host.setup
        return setup is not None and setup.command is not None and self._host.running

    def reset(self, segments: Sequence[str] | None) -> bool:
        """Forget some segments, or (None) all."""
        return self._command(lambda engine: engine.wearer.reset(segments))

    def freeze(self, on: bool) -> bool:
        return self._command(lambda engine: engine.wearer.freeze(on))

    def put_on(self, profile: WearerProfile, side: str) -> bool:
        """A profile of an earlier session, and of an earlier fit of the glove, on that hand."""

        def work(engine: Engine) -> None:
            chain = chain_of(engine)
            chain.put_on(renewed(profile, chain.layout))

        return self._host.command(work, side)

    def measured(self, length: float) -> bool:
        """Begin anew with a hand that is so long (m)."""
        return self._command(lambda e: e.put_on(measured_profile(e.layout, length)))

    def ask(self) -> bool:
        """Have what has been learned sent by `learned`."""
        setup = self._host.setup
        return setup is not None and self._command(lambda engine: self._answer(engine))

    def _answer(self, engine: ChainEngine) -> None:
        calibration = engine.calibration()
        wearer = WearerFile(engine.layout, engine.profile(), calibration)
        self.learned.emit(wearer)

    def _command(self, work: Callable[[ChainEngine], None]) -> bool:
        return self._host.command(lambda engine: work(chain_of(engine)))
