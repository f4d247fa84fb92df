"""What a panel of the window is made of: a plug-in under ``glovetrack.panels``.

A `PanelKind` names the panel, where layouts show it, and makes it from `PanelServices`. The panel
is a Qt widget that receives `Snapshot`s. A `WindowCommand` under ``glovetrack.window_commands``
adds a command to a menu of the window or of the library; see ``docs/panels.md``. Importing this
module imports Qt.
"""

from app.engines.snapshot import Snapshot
from app.panels.command_kind import CommandContext, WindowCommand
from app.panels.kind import PanelKind, PanelServices, Spot
from app.panels.panel import Panel, PanelColours
from tracker.messages import Estimate, Event, ImuSample, Tracking

__all__ = [
    "CommandContext",
    "Estimate",
    "Event",
    "ImuSample",
    "Panel",
    "PanelColours",
    "PanelKind",
    "PanelServices",
    "Snapshot",
    "Spot",
    "Tracking",
    "WindowCommand",
]
