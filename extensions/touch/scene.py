"""The room of the touch test, for simulated cameras."""

from __future__ import annotations

from tracker.base.registry import deferred
from tracker.simulation.rooms import SceneKind

SCENE = SceneKind(
    "touch_sheet",
    "the sheet of the touch test on a table",
    deferred("extensions.touch.simulated.images:sheet_room"),
)
