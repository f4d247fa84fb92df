"""The panels of the core, and where layouts show them."""

from __future__ import annotations

from app.panels.calibration.panel import CalibrationPanel
from app.panels.cameras import CamerasPanel
from app.panels.checklist import ChecklistPanel
from app.panels.colours.panel import ColoursPanel
from app.panels.devices.panel import DevicesPanel
from app.panels.graphs.panel import GraphsPanel
from app.panels.hand.panel import HandPanel
from app.panels.kind import PanelKind, Spot
from app.panels.library.panel import LibraryPanel
from app.panels.log import LogPanel
from app.panels.motion.panel import MotionPanel
from app.panels.recording import RecordingPanel
from app.panels.sensors import SensorsPanel
from app.panels.streams import StreamsPanel
from app.words import mark

CAMERAS = PanelKind(
    "cameras",
    mark("Cameras"),
    lambda s: CamerasPanel(s.host),
    {
        "set_up": Spot("left", 0, 0),
        "watch": Spot("left", 0, 0),
        "record": Spot("left", 0, 0),
        "look": Spot("left", 0, 0),
        "all": Spot("left", 0, 0),
    },
    number=1,
    private=False,
)
HAND = PanelKind(
    "hand",
    mark("Hand"),
    lambda s: HandPanel(s.host, s.store, s.tasks),
    {
        "watch": Spot("right", 0, 0),
        "record": Spot("left", 1, 0),
        "look": Spot("right", 0, 0),
        "all": Spot("right", 0, 0),
    },
    number=2,
    private=False,
)
SENSORS = PanelKind(
    "sensors",
    mark("Sensors"),
    lambda s: SensorsPanel(s.host, s.store),
    {"set_up": Spot("left", 1, 0), "all": Spot("left", 1, 0)},
    number=3,
    private=False,
)
MOTION = PanelKind(
    "motion",
    mark("Motion"),
    lambda s: MotionPanel(s.host, s.store),
    {"look": Spot("below", 0, 1), "all": Spot("left", 1, 1)},
    number=4,
    private=False,
)
LIBRARY = PanelKind(
    "library",
    mark("Library"),
    lambda s: LibraryPanel(s.host, s.store, s.tasks, s.recording_actions),
    {"look": Spot("below", 0, 0), "all": Spot("left", 1, 3)},
    number=5,
)
LOG = PanelKind(
    "log",
    mark("Log"),
    lambda s: LogPanel(s.host),
    {"record": Spot("right", 0, 1), "look": Spot("below", 0, 3), "all": Spot("left", 1, 4)},
    number=6,
)
CHECKLIST = PanelKind(
    "checklist",
    mark("Set-up"),
    lambda s: ChecklistPanel(s.host, s.store),
    {"set_up": Spot("right", 0, 0), "all": Spot("right", 1, 1)},
    number=7,
    private=False,
)
CALIBRATION = PanelKind(
    "calibration",
    mark("Calibration"),
    lambda s: CalibrationPanel(s.host, s.store),
    {"set_up": Spot("right", 0, 1), "all": Spot("right", 1, 0)},
    number=8,
    private=False,
)
COLOURS = PanelKind(
    "colours",
    mark("Colours"),
    lambda s: ColoursPanel(s.host, s.store.path.parent, s.tasks),
    {"set_up": Spot("right", 0, 2), "all": Spot("right", 1, 2)},
    number=9,
    private=False,
)
RECORDING = PanelKind(
    "recording",
    mark("Recording"),
    lambda s: RecordingPanel(s.host, s.plan, s.record_key),
    {"record": Spot("right", 0, 0), "all": Spot("right", 1, 3)},
    number=10,
)
STREAMS = PanelKind(
    "streams",
    mark("Streams && haptics"),
    lambda s: StreamsPanel(s.host, s.outputs, s.remote),
    {"all": Spot("right", 1, 4)},
    number=11,
    private=False,
)
GRAPHS = PanelKind(
    "graphs",
    mark("Graphs"),
    lambda s: GraphsPanel(s.host, s.store),
    {"look": Spot("below", 0, 2), "all": Spot("left", 1, 2)},
    over="hand",
    number=14,
    private=False,
)
DEVICES = PanelKind(
    "devices",
    mark("Device settings"),
    lambda s: DevicesPanel(s.host, s.store),
    {"all": Spot("right", 1, 5)},
    over="hand",
    number=15,
    private=False,
)
