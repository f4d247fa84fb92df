"""What the robot hand adds to the window."""

from __future__ import annotations

from app.panels.kind import PanelKind, Spot
from app.words import mark
from extensions.robot.window.panel import RobotPanel

PANEL = PanelKind(
    "robot",
    mark("Robot hand"),
    lambda s: RobotPanel(s.host, s.store),
    {"all": Spot("right", 0, 2)},
    next_to="hand",
    number=13,
    private=False,
)
