"""What OpenXR adds to the window."""

from __future__ import annotations

from app.panels.kind import PanelKind, Spot
from app.words import mark
from extensions.openxr.window.panel import OpenXrPanel

PANEL = PanelKind(
    "openxr",
    mark("OpenXR"),
    lambda s: OpenXrPanel(s.host, s.outputs),
    {"all": Spot("right", 1)},
    over="streams",
    private=False,
)
