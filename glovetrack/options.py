"""Options of tracking, simulating and exporting, as for the commands."""

from tracker.offline.options import TrackOptions
from tracker.offline.simulate import SimulateOptions
from tracker.session.export.options import ExportOptions

__all__ = ["ExportOptions", "SimulateOptions", "TrackOptions"]
