"""Hand tracking with a sensor glove and a stereo camera.

::

    import glovetrack

    rec = glovetrack.open("session.mcap")
    rec.t, rec.keypoints["index_tip"]             # (N,) s and (N, 3) m
    again = rec.track(engine="vist")              # a new recording
    again.export("c3d", "session.c3d")

    with glovetrack.LiveTracker.simulated() as live:
        for estimate in live:
            print(estimate.keypoints["index_tip"])

Conventions
-----------
Units are SI and radians; a name with another unit ends with it (``_deg``, ``_mm``). Rows are
samples: N points are (N, 3). Positions are in the global frame G (z up). Quaternions are Hamilton,
unit, x, y, z, w. Errors are `GlovetrackError`, whose text is for the user.

Each kind of plug-in has a module with what it needs: `glovetrack.applications`, `cameras`,
`checks`, `commands`, `engine`, `formats`, `listeners`, `panels`, `remote`, `scenes`, `sheets` and
`streams`; `glovetrack.notices` has what all report with. `tracker` and `app` are internal and
change without notice.
"""

from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from glovetrack.columns import Columns
    from glovetrack.hands import Hand, ImuSamples
    from glovetrack.live import Estimate, LiveTracker
    from glovetrack.recorded import Image, RecordedEvent
    from glovetrack.recording import Recording, open, simulate
    from tracker.base.errors import ConfigError, DeviceError, FileError, GlovetrackError
    from tracker.offline.options import TrackOptions
    from tracker.offline.simulate import SimulateOptions
    from tracker.session.export.options import ExportOptions
else:
    from tracker.base.errors import ConfigError, DeviceError, FileError, GlovetrackError

from tracker import __version__

__all__ = [
    "Columns",
    "ConfigError",
    "DeviceError",
    "Estimate",
    "ExportOptions",
    "FileError",
    "GlovetrackError",
    "Hand",
    "Image",
    "ImuSamples",
    "LiveTracker",
    "RecordedEvent",
    "Recording",
    "SimulateOptions",
    "TrackOptions",
    "__version__",
    "open",
    "simulate",
]

if not TYPE_CHECKING:
    # Loaded on first use: the engine takes a second to import, and `glovetrack --help` needs none
    # of it. Type checkers see the imports above instead, so no name is untyped.
    _MODULES = {
        "columns": ("Columns",),
        "hands": ("Hand", "ImuSamples"),
        "live": ("Estimate", "LiveTracker"),
        "recorded": ("Image", "RecordedEvent"),
        "recording": ("Recording", "open", "simulate"),
        "options": ("ExportOptions", "SimulateOptions", "TrackOptions"),
    }
    _HOME = {name: module for module, names in _MODULES.items() for name in names}

    def __getattr__(name):
        if name not in _HOME:
            raise AttributeError(f"module 'glovetrack' has no attribute {name!r}")
        value = getattr(import_module(f".{_HOME[name]}", __name__), name)
        globals()[name] = value
        return value

    def __dir__():
        return sorted(__all__)
