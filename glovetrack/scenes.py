"""What a scene of the simulated cameras is made of: a plug-in under ``glovetrack.scenes``.

A `SceneKind` makes a `Room` for the cameras of a rig: how images are rendered, and additional
objects (`Extra`), which consist of `Solids` in the global frame.
"""

from tracker.simulation.backgrounds import BackgroundParams
from tracker.simulation.desk.renderer import DeskParams
from tracker.simulation.render import RenderParams
from tracker.simulation.rooms import Room, SceneKind
from tracker.simulation.scene import Extra
from tracker.simulation.solids import UNOWNED, Solids, boxes, capsules
from tracker.vision.rig import StereoRig

__all__ = [
    "UNOWNED",
    "BackgroundParams",
    "DeskParams",
    "Extra",
    "RenderParams",
    "Room",
    "SceneKind",
    "Solids",
    "StereoRig",
    "boxes",
    "capsules",
]
