"""The calibration profile of each glove's wearer: selected, stored, compared with the fit."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Protocol

from app.engines.engine import EngineSetup
from app.storage.bound_gloves import GloveSettings, bound, with_bound
from app.storage.removed_file import RemovedFile
from app.storage.settings import SettingsFileOf, WearerSettings, wearer_of
from app.storage.wearers import WearerStore
from app.viewmodels.calibration import CalibrationView, calibration_view
from app.words import tr
from tracker.fusion.chain.calibration.measured import LONGEST, SHORTEST
from tracker.fusion.chain.calibration.profile_file import WearerFile, write_wearer
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.profile import WearerProfile
from tracker.messages import Calibration

HAND_MM = (1000 * SHORTEST, 1000 * LONGEST)
"""Plausible range of a measured hand length."""


FOLDER, DEMO = "wearers", "demo"


class WearerProfileModel:
    """``latest`` is the current calibration; the last fit is that at the last save, selection or
    reset.

    ``layout`` is of the hand and glove whose profiles are offered; None before there is one.
    """

    def __init__(self, store: WearerStore, layout: ChainLayout | None = None) -> None:
        self._store, self._layout = store, layout
        self._selected: WearerFile | None = None
        self._last_fit: Calibration | None = None
        self._saving = ""  # name under which the engine's next answer is to be saved
        self._exporting: Path | None = (
            None  # file to which the engine's next answer is to be exported
        )
        self.latest: Calibration | None = None

    def open(self) -> None:
        """Forget the wearer after the engine has changed."""
        self._selected = self._last_fit = self.latest = None

    def names(self) -> list[str]:
        """The stored profiles for this hand and glove."""
        return self._store.names(self._layout) if self._layout is not None else []

    @property
    def profile(self) -> WearerProfile | None:
        """The selected profile."""
        return self._selected.profile if self._selected is not None else None

    def apply_profile(self, name: str, layout: ChainLayout) -> None:
        """Select a profile. Raises FileError if it does not exist or is for another glove."""
        self._selected = self._store.load(name, layout)
        self._last_fit = self._selected.calibration

    def take_off(self) -> None:
        self._selected = None

    def ask_to_save(self, name: str) -> None:
        """Save the next `learned` under this name."""
        self._saving = name

    def ask_to_export(self, path: Path) -> None:
        """Export the next `learned` to this file."""
        self._exporting = path

    def take_in(self, path: Path, layout: ChainLayout) -> str:
        """Import a profile; returns its name here. Raises FileError."""
        return self._store.take_in(path, layout)

    def learned(self, wearer: WearerFile) -> str:
        """Save the calibration if that was requested; its new name, or "". Raises FileError."""
        name, self._saving = self._saving, ""
        path, self._exporting = self._exporting, None
        if path is not None:
            write_wearer(path, wearer)
        if not name:
            return ""
        kept = self._store.save(name, wearer)
        self._selected, self._last_fit = wearer, wearer.calibration
        return kept

    def remove(self, name: str) -> RemovedFile:
        """Raises FileError if it does not exist or cannot be removed."""
        return self._store.remove(name)

    def forgotten(self) -> None:
        """The engine was reset; the previous calibration can be compared."""
        self._last_fit = self.latest or self._last_fit

    def shown(
        self, comparing: bool, frozen: bool, one_camera: bool = False
    ) -> CalibrationView | None:
        """The table; None before the first calibration."""
        if self.latest is None:
            return None
        shown = calibration_view(self.latest, self._last_fit if comparing else None, one_camera)
        if comparing and self._last_fit is None:
            words = tr("There is nothing to compare with yet: save a profile, or reset.")
            return replace(shown, advice=words)
        if frozen:
            return replace(
                shown, advice=tr("Frozen: the calibration does not change until you unfreeze it.")
            )
        return shown


class HandWearerSettings(GloveSettings, WearerSettings, Protocol):
    """The settings that contain the wearer of each glove."""


class WearersOfHands:
    """``current`` is the calibration of the displayed hand, one of ``by_side``."""

    def __init__(self, store: SettingsFileOf[HandWearerSettings]) -> None:
        self._store = store
        folder = store.path.parent / FOLDER
        self._files, self._demo_files = WearerStore(folder), WearerStore(folder / DEMO)
        self.current = WearerProfileModel(self._files)
        self.by_side: dict[str, WearerProfileModel] = {}

    def open(self, setups: list[EngineSetup]) -> None:
        """Start with other gloves, without wearers."""
        self.by_side = {
            setup.side: WearerProfileModel(
                self._files_of(setup), ChainLayout(setup.hand, setup.glove)
            )
            for setup in setups
        }

    def _files_of(self, setup: EngineSetup) -> WearerStore:
        return self._demo_files if setup.simulated else self._files

    def show(self, setup: EngineSetup) -> str:
        """Select a hand; returns the name of its last wearer."""
        self.current = self.by_side[setup.side]
        settings = self._store.value
        own = bound(settings, setup.connection.number)  # for a glove that is recognized
        if own is not None:
            return own.wearer
        name = wearer_of(settings, setup.side, setup.simulated)
        # Earlier versions stored the name of a left glove's wearer as "right".
        earlier = wearer_of(settings, "right") if not setup.simulated else ""
        return name or (earlier if earlier in self.current.names() else "")

    def remember(self, name: str, setup: EngineSetup | None) -> None:
        """Store the wearer of this hand for the next start."""
        if setup is None:
            return
        settings = self._store.value
        own = bound(settings, setup.connection.number)
        if setup.connection.number is not None and own is not None:
            gloves = with_bound(settings, setup.connection.number, replace(own, wearer=name))
            self._store.update(gloves=gloves)
        if setup.simulated:
            self._store.update(demo_wearers={**settings.demo_wearers, setup.side: name})
            return
        names = dict(settings.wearers)
        if names.get("right") in self.current.names():
            names["right"] = ""  # stored by earlier versions for either hand
        self._store.update(wearers={**names, setup.side: name})
