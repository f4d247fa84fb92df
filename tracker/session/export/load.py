"""Loads the estimates of a session, cut, resampled and in the axes of an export."""

from __future__ import annotations

from dataclasses import replace

from tracker.session.export.axes import AXES, turned
from tracker.session.export.openxr import WORLD, openxr_series
from tracker.session.export.options import OPENXR, ExportOptions
from tracker.session.export.resample import resample
from tracker.session.export.series import EstimateSeries, recorded_series
from tracker.session.reader import SessionReader


def load_series(
    reader: SessionReader,
    options: ExportOptions,
    even: bool = False,
    axes: str = "z-up",
    segments: bool = False,
) -> EstimateSeries:
    """Reads the estimates of a session with ``options``; ``even``: the format has one fixed rate;
    ``segments``: with the poses of all segments, which take most of the time to read.

    Raises FileError if the session contains none.
    """
    series = recorded_series(reader, segments).between(options.start, options.stop)
    rate = options.rate
    if rate is None and even and not series.even:
        rate = float(round(series.rate))
    if rate is not None:
        series = resample(series, rate)
    named = options.axes or axes
    if options.joints == (OPENXR,):
        named = options.axes or WORLD
        series = turned(openxr_series(series), named, WORLD)
    else:
        series = turned(series, named)
        series = series.only(options.joints) if options.joints else series
    if "time" in options.anonymous:
        zero = int(series.stamp_ns[0])
        series = replace(series, stamp_ns=series.stamp_ns - zero, zero_ns=zero)
    notes: dict[str, object] = {
        "axes": named,
        "axes_are": AXES[named].description,
        "resampled_hz": rate,
    }
    return replace(series, notes=notes)
