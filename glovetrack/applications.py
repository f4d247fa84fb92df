"""The parts of an application of the hand: a plug-in under ``glovetrack.applications``.

An application has ``name``, ``title`` and ``between``, is built from its settings (a dataclass)
and returns from ``step(hand: HandSample) -> Step`` its drawing and its events; see
``extensions/applications/docs/applications.md``.
"""

from extensions.applications.drawing import Drawing, Line, Mesh, Points, Text
from extensions.applications.extension import ApplicationKind
from extensions.applications.hand import HandSample
from extensions.applications.interface import (
    Application,
    Happening,
    JointCommand,
    MotorCommand,
    PoseCommand,
    Step,
    VehicleCommand,
)

__all__ = [
    "Application",
    "ApplicationKind",
    "Drawing",
    "HandSample",
    "Happening",
    "JointCommand",
    "Line",
    "Mesh",
    "MotorCommand",
    "Points",
    "PoseCommand",
    "Step",
    "Text",
    "VehicleCommand",
]
