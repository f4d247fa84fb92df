"""Engines by name: this program's own (`tracker.engine.builtin`) and those of other packages.

A package declares an engine as an entry point of the group ``glovetrack.engines`` that names an
`EngineKind`. Its settings travel in recordings as the table ``engines.NAME``, its state as a
`tracker.base.records.record`; both names must never change. Quick to import.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import asdict, dataclass, field, replace
from typing import Any

from tracker.base.config import from_dict, to_toml
from tracker.base.errors import ConfigError
from tracker.base.notices import Notice, notice
from tracker.base.registry import Registry
from tracker.engine.settings import Settings
from tracker.fusion.engine import Engine
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.vision.rig import StereoRig, ideal_rig

WITHOUT_CAMERA = "inertial"
"""The engine for a glove without a calibrated camera."""


@dataclass(frozen=True)
class Capabilities:
    """What an engine can do, known before one is made."""

    images: bool = True
    """Follows images; cannot be used without a calibrated camera."""
    one_lens: bool = True
    """Can follow the images of one lens alone."""
    wearer: bool = False
    """Learns the wearer from profiles and guided poses: a `wearer_learning.LearnsWearer`."""
    smoothing: bool = False
    """`tracker.offline.smooth` can smooth a recording with its settings."""


@dataclass(frozen=True)
class NoParams:
    """An engine without settings."""


@dataclass(frozen=True)
class EngineKind:
    """An engine that can be chosen; ``name`` is the entry point's.

    ``make(hand, glove, rig, params)`` returns an `Engine`; it raises ConfigError for a glove that
    the engine cannot use. Without a camera ``rig`` is an ideal one, for an engine without images.
    ``params`` is a frozen dataclass with a default for each field, as `tracker.base.config` reads
    it; if it is `Settings`, ``make`` receives all settings. ``state`` returns the class of
    `Engine.get_state`'s result, and imports all records in it. ``short`` is a short title. Menus
    sort engines by ``order``.
    """

    name: str
    title: str
    make: Callable[[HandModel, GloveModel, StereoRig, Any], Engine]
    state: Callable[[], type]
    params: type = NoParams
    capabilities: Capabilities = field(default_factory=Capabilities)
    short: str = ""
    order: int = 100


ENGINES = Registry("engines", "engine", EngineKind)


def engine_kinds() -> dict[str, EngineKind]:
    """All engines that can be loaded, in the order of menus."""
    found = ENGINES.all()
    return {name: found[name] for name in sorted(found, key=lambda n: (found[n].order, n))}


def capabilities_of(name: str) -> Capabilities:
    """For the named engine. Raises ConfigError for an unknown name."""
    return ENGINES.get(name).capabilities


def learns_wearer(name: str) -> bool:
    """Whether there is an engine of that name, and it learns the wearer."""
    return name in ENGINES.names() and capabilities_of(name).wearer


def build_engine(
    hand: HandModel, glove: GloveModel, rig: StereoRig | None, settings: Settings
) -> Engine:
    """Returns the engine that ``settings`` name.

    Raises ConfigError for an unknown name, for invalid settings, and if the engine needs a camera
    or a lens that is missing.
    """
    kind = ENGINES.get(settings.engine)
    can = kind.capabilities
    if can.images and rig is None:
        raise ConfigError(
            notice("engine.needs_camera", engine=settings.engine, other=WITHOUT_CAMERA)
        )
    if not can.one_lens and (settings.lenses != "both" or (rig is not None and rig.one_camera)):
        raise ConfigError(notice("engine.needs_both_lenses", engine=settings.engine))
    return kind.make(hand, glove, rig or ideal_rig(), params_of(kind, settings))


def params_of(kind: EngineKind, settings: Settings) -> Any:
    """Settings of one engine. Raises ConfigError for a wrong one."""
    if kind.params is Settings:
        return settings

    def on_problem(path: str, why: Notice) -> None:
        raise ConfigError(notice("config.invalid_setting", key=path, why=why))

    table = settings.engines.get(kind.name, {})
    return from_dict(kind.params, table, on_problem, f"engines.{kind.name}")


def settings_text(settings: Settings) -> str:
    """TOML for a recording, with every setting of each engine that can be loaded: any of them may
    be chosen while recording, and another version may have other defaults."""
    tables = dict(settings.engines)
    for name, kind in engine_kinds().items():
        if kind.params not in (Settings, NoParams):
            tables[name] = asdict(params_of(kind, settings))
    return to_toml(replace(settings, engines=tables))


def load_states() -> None:
    """Import what recorded states are made of, of every engine that can be loaded."""
    for kind in engine_kinds().values():
        kind.state()
