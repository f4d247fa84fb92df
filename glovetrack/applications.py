"""What an application of the hand is made of: a plug-in under ``glovetrack.applications``.

An application has ``name``, ``title`` and ``between``, is made of its settings (a dataclass) and
answers ``step(hand: HandSample) -> Step`` with what is drawn and what has happened; see
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
