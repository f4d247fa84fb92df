"""Writes measurements of a glove to its own file, which is used from then on."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Protocol

from app.engines.engine import EngineSetup
from app.storage.bound_gloves import BoundGlove, GloveSettings, bound, with_bound
from app.storage.own_gloves import own_path
from app.storage.settings import SettingsOf
from tracker.base.files import write_with_folder
from tracker.glove import library
from tracker.glove.files import parse_glove
from tracker.glove.model import GloveModel, ImuVibration


class OwnGloveSettings(GloveSettings, Protocol):
    """The settings that name the glove's file and its hand."""

    @property
    def glove(self) -> str: ...

    @property
    def hand(self) -> str: ...


def own_model(setup: EngineSetup) -> GloveModel:
    """The glove as its own file describes it now, which may be newer than the one in use."""
    glove = setup.connection
    name = glove.own_file if own_path(glove.own_file).is_file() else glove.file
    return parse_glove(library.text("gloves", name), setup.hand, name)


def own_vibration(setup: EngineSetup) -> dict[str, ImuVibration | None]:
    """The motors' values in the own file, by the names of the IMUs."""
    return {imu.name: imu.vibration for imu in own_model(setup).imus}


def save_own(
    store: SettingsOf[OwnGloveSettings], setup: EngineSetup, change: Callable[[str], str]
) -> Path:
    """Write the glove's own file with a change of its text; it is used when devices are opened
    next.

    Raises FileError if the result is not a glove file, or if it cannot be written.
    """
    glove = setup.connection
    path = own_path(glove.own_file)
    text = change(library.text("gloves", glove.own_file if path.is_file() else glove.file))
    parse_glove(text, setup.hand, path.name)
    write_with_folder(path, text)
    if not setup.simulated:  # the demo uses its own file whenever it exists
        _use(store, setup)
    return path


def _use(store: SettingsOf[OwnGloveSettings], setup: EngineSetup) -> None:
    settings, glove = store.value, setup.connection
    changes: dict[str, object] = {}
    if settings.glove == glove.file:
        changes["glove"] = glove.own_file
    if glove.number is not None:
        hand = settings.hand if settings.glove == glove.file else setup.hand.name
        known = bound(settings, glove.number) or BoundGlove(setup.side, glove.file, hand)
        own = replace(known, glove=glove.own_file)
        changes["gloves"] = with_bound(settings, glove.number, own)
    store.update(**changes)
