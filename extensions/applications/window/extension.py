"""What applications add to the window."""

from __future__ import annotations

from app.panels.kind import PanelKind, Spot
from app.words import mark
from extensions.applications.window.panel import ApplicationsPanel

PANEL = PanelKind(
    "applications",
    mark("Applications"),
    lambda s: ApplicationsPanel(s.host),
    {"all": Spot("right", 0, 1)},
    over="hand",
    number=12,
    private=False,
)
