"""What an export format is made of: a plug-in under ``glovetrack.formats``.

An `ExportFormat` describes the format and names its writer, which gets a `SessionReader`, the path
of the new file and `ExportOptions`. `load_series` reads the estimates of a hand with the range,
rate, axes and joints that the options ask for. See ``docs/guide/exporting.md``.
"""

from tracker.base.errors import ConfigError, FileError
from tracker.session.export.formats import (
    COMMON,
    FORMATS,
    DatasetWriter,
    ExportFormat,
    Writer,
    formats,
)
from tracker.session.export.load import load_series
from tracker.session.export.options import UNITS, ExportOptions
from tracker.session.export.series import EstimateSeries
from tracker.session.reader import SessionReader

__all__ = [
    "COMMON",
    "FORMATS",
    "UNITS",
    "ConfigError",
    "DatasetWriter",
    "EstimateSeries",
    "ExportFormat",
    "ExportOptions",
    "FileError",
    "SessionReader",
    "Writer",
    "formats",
    "load_series",
]
