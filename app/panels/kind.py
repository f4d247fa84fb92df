"""Descriptor with which a package adds a panel: a `PanelKind` as an entry point of
``glovetrack.panels``."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import TYPE_CHECKING, Literal

if TYPE_CHECKING:
    from app.engines.engine_host import EngineHost
    from app.jobs.outputs import Outputs
    from app.jobs.record_key import RecordKey
    from app.jobs.remote import RemoteControl
    from app.panels.command_kind import RecordingAction
    from app.panels.panel import Panel
    from app.platform.tasks import TaskOwner
    from app.storage.settings import SettingsStore
    from app.viewmodels.recording import RecordingPlan

LAST = 100
"""Tab position of panels that are added by other packages: after all of this program's."""


@dataclass(frozen=True, eq=False)
class PanelServices:
    """What a panel can use.

    ``host`` opens and runs engines and has signals for what happens. ``store``: the user's
    settings. ``tasks`` runs jobs in the background. ``plan`` and ``record_key``: the next
    recording. ``outputs`` and ``remote``: streams and remote control. ``recording_actions``:
    commands of other packages on recordings, by name.
    """

    host: EngineHost
    store: SettingsStore
    tasks: TaskOwner
    plan: RecordingPlan
    record_key: RecordKey
    outputs: Outputs
    remote: RemoteControl
    recording_actions: Mapping[str, RecordingAction]


@dataclass(frozen=True)
class Spot:
    """The position of a panel in a layout: in the left or right column, or below both.

    ``group``: the tab group in the column, 0 at the top. ``tab``: order in the group; the first tab
    is in front.
    """

    area: Literal["left", "right", "below"]
    group: int = 0
    tab: int = LAST


@dataclass(frozen=True, eq=False)
class PanelKind:
    """A kind of panel; the window creates one panel of each kind.

    ``name`` is the name of its entry point, and part of the names under which layouts are stored.
    ``title``: in English, translated if the catalogue contains it; ``&&`` shows ``&``. ``shown``:
    its position in each layout that shows it, by the layout's name: ``set_up``, ``watch``,
    ``record``, ``look`` (review) and ``all``. In the other layouts it is hidden until it is opened:
    then next to the panel ``next_to`` or as a tab of the panel ``over``, if that is visible.
    ``number``: its position in the View menu and its key, Ctrl+1 to Ctrl+9 and then Ctrl+Alt+1 to
    Ctrl+Alt+9; 0: at the end and without a key. ``private`` panels may show names of people and are
    omitted from the screenshot in a bug report. ``extra``: what to install with pip if ``make``
    raises ImportError.
    """

    name: str
    title: str
    make: Callable[[PanelServices], Panel]
    shown: Mapping[str, Spot] = field(
        default_factory=lambda: MappingProxyType({"all": Spot("right", 1)})
    )
    next_to: str = ""
    over: str = ""
    number: int = 0
    private: bool = True
    extra: str = ""
