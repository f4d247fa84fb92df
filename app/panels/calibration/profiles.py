"""Commands on calibration profiles: select, save, import, export, remove, reset."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Protocol, TypeVar

from PySide6.QtCore import QObject, Signal

from app.engines.engine import EngineSetup
from app.engines.host_parts import EngineChoice, EngineCommands, ErrorSignal
from app.jobs.calibration_commands import CalibrationCommands
from app.panels.calibration.wearer_row import WearerRow
from app.storage.removed_file import RemovedFile
from app.storage.settings import SettingsFileOf
from app.storage.wearers import WearerFile
from app.viewmodels.wearer_profiles import (
    HandWearerSettings,
    WearerProfileModel,
    WearersOfHands,
)
from app.words import error_text
from tracker.base.errors import GlovetrackError
from tracker.engine.kinds import learns_wearer

R = TypeVar("R")


class WearerHost(EngineChoice, EngineCommands, ErrorSignal, Protocol):
    """What the profiles use of the engine host."""


class ProfileSettings(HandWearerSettings, Protocol):
    """The settings of the calibration profiles."""

    @property
    def engine(self) -> str: ...


class WearerProfiles(QObject):
    """Does what ``row`` requests and shows the wearer in it. ``kept``: the last fit has changed."""

    kept = Signal()
    removed = Signal(str, object)  # a message, and a function that undoes the removal

    def __init__(
        self, host: WearerHost, store: SettingsFileOf[ProfileSettings], row: WearerRow
    ) -> None:
        super().__init__(row)
        self._host, self._store, self._row = host, store, row
        self._first: Path | None = None
        self._hands = WearersOfHands(store)
        self.link = CalibrationCommands(host, self)
        self.link.learned.connect(self._learned)
        row.chosen.connect(self.wear)
        row.save.connect(self.save)
        row.remove.connect(self.remove)
        row.export.connect(self.export)
        row.take_in.connect(self.take_in)
        row.measured.connect(self.link.measured)
        row.reset.connect(self.reset)
        row.freeze.connect(self.link.freeze)
        host.engine_changed.connect(self._engine_changed)

    @property
    def current(self) -> WearerProfileModel:
        """The calibration of the hand that is shown."""
        return self._hands.current

    def begin_with(self, profile: Path) -> None:
        """Store a profile and select it for the next hand that is tracked."""
        self._first = profile

    def open(self, setup: EngineSetup) -> None:
        """Select the profile used last before the engine starts; select the displayed hand last."""
        self._row.frozen.setChecked(False)
        hands = [*setup.others, setup]
        self._hands.open(hands)
        first, self._first = self._first, None
        for hand in hands:
            self.show_hand(hand)
            if first is not None and hand is setup and setup.live is not None:
                self.take_in(first)
            elif self._row.name and hand.live is not None:
                self._load_wearer(self._row.name, hand)

    def show_hand(self, setup: EngineSetup) -> None:
        """Show the wearer of this glove."""
        self._show_names(self._hands.show(setup))

    def _show_names(self, chosen: str) -> None:
        self._row.set_names(self.current.names(), chosen)

    def _try(self, work: Callable[[], R]) -> R | None:
        """The result of ``work``; None after reporting an error."""
        try:
            return work()
        except GlovetrackError as error:
            self._host.error.emit(error_text(error))
            return None

    def _remember(self, name: str) -> None:
        self._hands.remember(name, self._host.setup)

    def _load_wearer(self, name: str, setup: EngineSetup) -> None:
        layout = self.link.layout_of(setup)
        try:
            self.current.apply_profile(name, layout)
        except GlovetrackError as error:
            self._host.error.emit(error_text(error))
            self._show_names("")
            return
        self._give_profile(self._store.value.engine, self.current, setup.side)

    def _give_profile(self, engine: str, model: WearerProfileModel, side: str) -> None:
        """Send the profile of the wearer to an engine that accepts profiles."""
        if learns_wearer(engine) and model.profile is not None:
            self.link.apply_profile(model.profile, side)

    def _engine_changed(self, name: str) -> None:
        """Apply the selected profile to a new engine."""
        self._row.frozen.setChecked(False)
        for side, model in self._hands.by_side.items():
            self._give_profile(name, model, side)

    def wear(self, name: str) -> None:
        """Select a stored profile; an empty name selects a new wearer."""
        self._remember(name)
        self.current.take_off()
        if name and self._host.setup is not None:
            self._load_wearer(name, self._host.setup)
        else:
            self.reset(None)
        self._show_names(self._row.name)

    def save(self, name: str) -> None:
        """Save the calibration under a name, after requesting it from the engine."""
        self.current.ask_to_save(name)
        self.link.ask()

    def keep_learned(self) -> bool:
        """Save the result of guided poses in the wearer's profile; False if no wearer is
        selected."""
        if self._row.name:
            self.save(self._row.name)
        return bool(self._row.name)

    def export(self, path: Path) -> None:
        """Write the calibration to a file, after requesting it from the engine."""
        self.current.ask_to_export(path)
        self.link.ask()

    def take_in(self, path: Path) -> None:
        """Import a profile and select it."""
        layout = self.link.layout()
        name = self._try(lambda: self.current.take_in(path, layout)) if layout is not None else None
        if name is not None:
            self._show_names(name)
            self.wear(name)

    def _learned(self, wearer: WearerFile) -> None:
        kept = self._try(lambda: self.current.learned(wearer))
        if kept:
            self._remember(kept)
            self._show_names(kept)
            self.kept.emit()

    def remove(self, name: str) -> None:
        """Remove a profile; the engine's calibration does not change."""
        file = self._try(lambda: self.current.remove(name))
        if file is None:
            return
        self._remember("")
        self._show_names("")
        text = self.tr("The profile {} was removed.").format(name)
        self.removed.emit(text, partial(self._put_back, name, file))

    def _put_back(self, name: str, file: RemovedFile) -> None:
        """Select the restored profile again, unless another one has been selected since."""
        try:
            file.put_back()
        except GlovetrackError as error:
            self._host.error.emit(error_text(error))
            return
        if not self._row.name:
            self._remember(name)
        self._show_names(self._row.name or name)

    def reset(self, segments: list[str] | None) -> None:
        """Reset the calibration; the previous one remains available for comparison."""
        if self.link.reset(segments):
            self.current.forgotten()
