"""Who wears which glove: remembered for the next start, and the kept profiles of each hand.

The demo has profiles and names of its own, so that a simulated wearer never gets a real one's
calibration, nor the other way round.
"""

from __future__ import annotations

from dataclasses import replace

from app.engines.engine import EngineSetup
from app.storage.bound_gloves import bound, with_bound
from app.storage.settings import SettingsStore, wearer_of
from app.storage.wearers import WearerStore
from app.viewmodels.worn_calibration import WornCalibration
from tracker.fusion.chain.layout import ChainLayout

FOLDER, DEMO = "wearers", "demo"


class WearersOfHands:
    """``worn`` is the calibration of the hand that is shown, one of ``by_side``."""

    def __init__(self, store: SettingsStore) -> None:
        self._store = store
        folder = store.path.parent / FOLDER
        self._files, self._demo_files = WearerStore(folder), WearerStore(folder / DEMO)
        self.worn = WornCalibration(self._files)
        self.by_side: dict[str, WornCalibration] = {}

    def open(self, setups: list[EngineSetup]) -> None:
        """Other gloves: nobody wears them yet."""
        self.by_side = {
            setup.side: WornCalibration(self._files_of(setup), ChainLayout(setup.hand, setup.glove))
            for setup in setups
        }

    def _files_of(self, setup: EngineSetup) -> WearerStore:
        return self._demo_files if setup.simulated else self._files

    def show(self, setup: EngineSetup) -> str:
        """Turn to this hand; the name of who wore its glove last."""
        self.worn = self.by_side[setup.side]
        settings = self._store.value
        own = bound(settings, setup.glove_id)  # of a glove that is known again
        if own is not None:
            return own.wearer
        name = wearer_of(settings, setup.side, setup.simulated)
        # Earlier versions stored the name for a left glove alone as they did for a right one.
        earlier = wearer_of(settings, "right") if not setup.simulated else ""
        return name or (earlier if earlier in self.worn.names() else "")

    def remember(self, name: str, setup: EngineSetup | None) -> None:
        """Whose calibration this hand has at the next start."""
        if setup is None:
            return
        settings = self._store.value
        own = bound(settings, setup.glove_id)
        if setup.glove_id is not None and own is not None:
            gloves = with_bound(settings, setup.glove_id, replace(own, wearer=name))
            self._store.update(gloves=gloves)
        if setup.simulated:
            self._store.update(demo_wearers={**settings.demo_wearers, setup.side: name})
            return
        names = dict(settings.wearers)
        if names.get("right") in self.worn.names():
            names["right"] = ""  # where earlier versions stored that of either hand
        self._store.update(wearers={**names, setup.side: name})
