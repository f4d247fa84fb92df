"""Who wears which glove: remembered for the next start, and the kept profiles of each hand."""

from __future__ import annotations

from dataclasses import replace

from app.engines.engine import EngineSetup
from app.storage.bound_gloves import bound, with_bound
from app.storage.settings import SettingsStore
from app.storage.wearers import WearerStore
from app.viewmodels.worn_calibration import WornCalibration


class WearersOfHands:
    """``worn`` is the calibration of the hand that is shown, one of ``by_side``."""

    def __init__(self, store: SettingsStore) -> None:
        self._store = store
        self._files = WearerStore(store.path.parent / "wearers")
        self.worn = WornCalibration(self._files)
        self.by_side: dict[str, WornCalibration] = {}

    def open(self, setups: list[EngineSetup]) -> None:
        """Other gloves: nobody wears them yet."""
        self.by_side = {setup.side: WornCalibration(self._files) for setup in setups}

    def show(self, setup: EngineSetup) -> str:
        """Turn to this hand; the name of who wore its glove last."""
        self.worn = self.by_side[setup.side]
        settings = self._store.value
        own = bound(settings, setup.glove_id)  # of a glove that is known again
        if own is not None:
            return own.wearer
        return settings.left_wearer if _is_left_of_two(setup) else settings.wearer

    def remember(self, name: str, setup: EngineSetup | None) -> None:
        """Whose calibration this hand has at the next start."""
        settings = self._store.value
        own = bound(settings, setup.glove_id) if setup is not None else None
        if setup is not None and setup.glove_id is not None and own is not None:
            gloves = with_bound(settings, setup.glove_id, replace(own, wearer=name))
            self._store.update(gloves=gloves)
        if setup is not None and _is_left_of_two(setup):
            self._store.update(left_wearer=name)
        else:
            self._store.update(wearer=name)


def _is_left_of_two(setup: EngineSetup) -> bool:
    return setup.other is not None and setup.side == "left"
