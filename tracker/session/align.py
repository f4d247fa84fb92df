"""Aligns two recordings in time, by the computers' clocks or by movement.

By movement: the angular speed of the hand is the same in both recordings, whatever the sensors. The
two are aligned at the greatest correlation of their speeds.
"""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from pathlib import Path

import numpy as np

from tracker.base.clock import NS
from tracker.base.errors import ConfigError, FileError
from tracker.base.files import whole_file, write_whole
from tracker.base.notices import notice
from tracker.base.toml_reader import read_text
from tracker.messages import Array, Estimate, ImuSample
from tracker.session.holes import LONGEST_FILLED
from tracker.session.reader import SessionReader

WAYS = ("clock", "movement")
RATE = 100.0  # Hz
MIN_OVERLAP = 3.0  # s, required overlap of both recordings
MIN_CORRELATION = 0.5  # minimum correlation of a match
MAX_OTHER_CORRELATION = 0.95  # maximum correlation at another offset, relative to the best
MIN_SEPARATION = 0.5  # s between two offsets that count as different
_SMOOTH = 0.05  # s


@dataclass(frozen=True, eq=False)
class SpeedCourse:
    """``speed`` (N,) rad/s at ``t`` (N,) s from ``start_ns`` since 1970; NaN where unknown."""

    start_ns: int
    t: Array
    speed: Array


@dataclass(frozen=True)
class Match:
    """``offset`` s: start of the second recording on the first one's time axis; ``correlation`` at
    that offset, and the greatest at a different one."""

    offset: float
    correlation: float
    elsewhere: float


@dataclass(frozen=True)
class SessionAlignment:
    """A stored alignment: ``offset_s`` is from the first measurement of the first recording to that
    of the second; ``clocks_differ_s`` must be added to the stamps of the second."""

    first: str
    second: str
    by: str
    offset_s: float
    clocks_differ_s: float
    correlation: float | None = None
    elsewhere: float | None = None


def align(first: Path, second: Path, by: str = "movement") -> SessionAlignment:
    """Raises ConfigError for an unknown method, FileError if the offset cannot be determined."""
    if by not in WAYS:
        raise ConfigError(notice("align.unknown_method", known=WAYS, method=by))
    a, b = read_courses(first, second)
    by_clock = (b.start_ns - a.start_ns) / NS
    if by == WAYS[0]:
        if by_clock > a.t[-1] or by_clock < -b.t[-1]:
            raise FileError(notice("align.no_overlap"))
        return SessionAlignment(first.name, second.name, by, by_clock, 0.0)
    found = best_match(a, b)
    return SessionAlignment(
        first.name,
        second.name,
        by,
        found.offset,
        found.offset - by_clock,
        found.correlation,
        found.elsewhere,
    )


def best_match(a: SpeedCourse, b: SpeedCourse) -> Match:
    """Raises FileError if no offset, or more than one, fits well."""
    x, y = (_log_speed(c)[:, None] for c in (a, b))
    return match_channels(x, y, float(a.t[0] - b.t[0]))


def match_channels(x: Array, y: Array, apart: float = 0.0, overlap: float = MIN_OVERLAP) -> Match:
    """For K channels x (N, K) and y (M, K) at even steps of 1/`RATE`, NaN where unknown. All
    channels share one offset; x begins ``apart`` s later than y; they overlap by at least
    ``overlap`` s.

    Raises FileError if no offset, or more than one, fits well.
    """
    r = _correlations(x, y, overlap)
    lags = np.arange(-(len(y) - 1), len(x)) / RATE
    if not np.isfinite(r).any():
        raise FileError(notice("align.too_short", needed_s=overlap))
    k = int(np.nanargmax(r))
    far = np.abs(lags - lags[k]) > MIN_SEPARATION
    elsewhere = float(np.nanmax(r[far])) if np.isfinite(r[far]).any() else -1.0
    if r[k] < MIN_CORRELATION:
        raise FileError(notice("align.no_fit", correlation=r[k]))
    if elsewhere > MAX_OTHER_CORRELATION * r[k]:
        raise FileError(notice("align.ambiguous", correlation=r[k], elsewhere=elsewhere))
    return Match(float(lags[k] + _peak(r, k) / RATE + apart), float(r[k]), elsewhere)


def _log_speed(course: SpeedCourse) -> Array:
    """Logarithm of the speed at even steps, minus its mean; 0 where unknown. The logarithm keeps
    the fastest instants from dominating."""
    known = np.isfinite(course.speed)
    if known.sum() < MIN_OVERLAP * RATE / 10:
        raise FileError(notice("align.no_movement"))
    t, speed = course.t[known], course.speed[known]
    at = np.arange(t[0], t[-1], 1 / RATE)
    width = max(int(_SMOOTH * RATE), 1)
    x = np.convolve(np.interp(at, t, speed), np.ones(width) / width, "same")
    x = np.log(x + 0.05)
    after = np.clip(np.searchsorted(t, at), 1, len(t) - 1)
    return np.where(t[after] - t[after - 1] > LONGEST_FILLED, np.nan, x)


def _correlations(x: Array, y: Array, overlap: float) -> Array:
    """Pearson's correlation of x (N, K) and y (M, K) where both are known, at each lag from -(M -
    1) on, pooled over the channels; NaN for an overlap below ``overlap`` s."""
    from scipy.signal import fftconvolve  # deferred: takes 0.25 s

    known_x, known_y = np.isfinite(x).astype(float), np.isfinite(y).astype(float)
    x, y = (np.where(np.isfinite(v), v - _mean(v), 0.0) for v in (x, y))

    def over(p: Array, q: Array) -> Array:
        return np.asarray(fftconvolve(p, q[::-1], axes=0))

    n = np.maximum(over(known_x, known_y), 1e-9)
    sum_x, sum_y = over(x, known_y), over(known_x, y)
    variance_x = (over(x**2, known_y) - sum_x**2 / n).sum(axis=1)
    variance_y = (over(known_x, y**2) - sum_y**2 / n).sum(axis=1)
    scale = np.sqrt(np.maximum(variance_x, 1e-12) * np.maximum(variance_y, 1e-12))
    r = (over(x, y) - sum_x * sum_y / n).sum(axis=1) / scale
    n = n.max(axis=1)
    return np.where((n >= overlap * RATE) & (scale > 1e-6 * n), r, np.nan)


def _mean(x: Array) -> Array:
    """(K,) of the known values of each channel; 0 without any."""
    known = np.isfinite(x)
    return np.asarray(np.where(known, x, 0.0).sum(axis=0) / np.maximum(known.sum(axis=0), 1))


def _peak(r: Array, k: int) -> float:
    """Steps from ``k`` to the top of the parabola through it and its neighbours."""
    if not 0 < k < len(r) - 1 or not np.isfinite(r[k - 1 : k + 2]).all():
        return 0.0
    bend = r[k - 1] - 2 * r[k] + r[k + 1]
    return 0.0 if bend >= 0 else float(np.clip(0.5 * (r[k - 1] - r[k + 1]) / bend, -0.5, 0.5))


def read_courses(first: Path, second: Path) -> tuple[SpeedCourse, SpeedCourse]:
    """From the IMUs if both recordings have them, otherwise from the tracked angles. Raises
    FileError if they have neither in common."""
    found = [(_of_imus(path), path) for path in (first, second)]
    if all(course is not None for course, _ in found):
        a, b = (course for course, _ in found)
    else:
        a, b = (_of_angles(path) for path in (first, second))
    if a is None or b is None:
        raise FileError(notice("align.nothing_common"))
    return a, b


def _of_imus(path: Path) -> SpeedCourse | None:
    """The angular speed of the root's IMU, or of the IMU with the most samples; None without
    IMUs."""
    with SessionReader(path) as reader:
        start = reader.span_ns[0]
        began = reader.anchor.monotonic(start)
        found = [m for m in reader.messages([ImuSample]) if isinstance(m, ImuSample)]
    if len(found) < 2:
        return None
    found.sort(key=lambda m: m.t)
    gyro = np.linalg.norm(np.array([m.gyro for m in found]), axis=2)
    known = np.isfinite(gyro)
    most = int(np.argmax(known.sum(axis=0)))  # the first of those with the most samples: the root
    return SpeedCourse(start, np.array([m.t for m in found]) - began, gyro[:, most])


def _of_angles(path: Path) -> SpeedCourse | None:
    """Root of the summed squares of all joints' speeds."""
    with SessionReader(path) as reader:
        start = reader.span_ns[0]
        began = reader.anchor.monotonic(start)
        found = [m for m in reader.messages([Estimate]) if isinstance(m, Estimate)]
    if len(found) < 2:
        return None
    found.sort(key=lambda m: m.t)
    return course_of_angles(start, np.array([m.t for m in found]) - began,
                            np.array([m.angles for m in found]))  # fmt: skip


def course_of_angles(start_ns: int, t: Array, angles: Array) -> SpeedCourse:
    """For joint angles (N, J) rad at ``t`` (N,) s; unknown where all are lost."""
    rate = np.gradient(angles, np.maximum(t, np.arange(len(t)) * 1e-9), axis=0)
    known = np.isfinite(rate).any(axis=1)
    return SpeedCourse(start_ns, t, np.where(known, np.sqrt(np.nansum(rate**2, axis=1)), np.nan))


def alignment_path(second: Path) -> Path:
    """Returns the path where the window stores the alignment of a recording."""
    return second.with_name(f"{second.stem}.aligned.json")


def keep(alignment: SessionAlignment, path: Path, force: bool = False) -> None:
    """Write an alignment as JSON. Raises FileError."""
    write_whole(path, json.dumps(asdict(alignment), indent=2) + "\n", force)


def read_alignment(path: Path) -> SessionAlignment:
    """Reads a stored alignment. Raises FileError if the file is not one."""
    try:
        stored = json.loads(read_text(path))
        numbers = [float(stored[k]) for k in ("offset_s", "clocks_differ_s")]
        names = [str(stored[k]) for k in ("first", "second", "by")]
    except (OSError, ValueError, KeyError, TypeError, RecursionError) as error:
        raise FileError(notice("align.not_alignment", path=path)) from error
    if not np.isfinite(numbers).all():
        raise FileError(notice("align.not_alignment", path=path))
    return SessionAlignment(names[0], names[1], names[2], numbers[0], numbers[1])


def draw(
    path: Path, a: SpeedCourse, b: SpeedCourse, alignment: SessionAlignment, force: bool = False
) -> None:
    """Plot both speeds on the first recording's time axis, as PNG."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg  # deferred: slow to load
    from matplotlib.figure import Figure

    figure = Figure(figsize=(9, 3.2), layout="constrained")
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    axes.plot(a.t, a.speed, lw=0.8, label=alignment.first)
    axes.plot(b.t + alignment.offset_s, b.speed, lw=0.8, label=alignment.second)
    axes.set_xlabel(f"s from the start of {alignment.first}")
    axes.set_ylabel("rad/s")
    axes.legend(loc="upper right")
    axes.grid(alpha=0.3)
    with whole_file(path, force) as part:
        figure.savefig(part, format="png", dpi=120)
