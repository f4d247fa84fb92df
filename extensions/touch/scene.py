"""The room of the touch test, for simulated cameras."""

from __future__ import annotations

from tracker.simulation.rooms import Room, SceneKind
from tracker.vision.rig import StereoRig


def _room(rig: StereoRig, seed: int) -> Room:
    from extensions.touch.simulated.images import sheet_room  # Matplotlib

    return sheet_room(rig, seed)


SCENE = SceneKind("touch_sheet", "the sheet of the touch test on a table", _room)
