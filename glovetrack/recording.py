"""A recorded session: its hands, sensors, images and events, to be read, tracked and exported."""

from __future__ import annotations

import shutil
import tempfile
import weakref
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from types import MappingProxyType, TracebackType
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from glovetrack.columns import Columns
from glovetrack.hands import Hand, ImuSamples
from tracker.clock import NS
from tracker.errors import ConfigError
from tracker.messages import Array, Event, IntArray, StereoFrame
from tracker.numeric_threads import one_blas_thread
from tracker.offline.options import TrackOptions
from tracker.session.export.options import ExportOptions
from tracker.session.export.series import EstimateSeries, recorded_series, series_of
from tracker.session.notes import standing
from tracker.session.raw_imu import RawImu, read_raw_imu
from tracker.session.reader import SessionReader

if TYPE_CHECKING:
    from tracker.offline.simulate import SimulateOptions

CAMERA_SIDES = ("left", "right")


@dataclass(frozen=True)
class RecordedEvent:
    """Something that happened at ``t`` (s since the recording began). ``kind`` is ``note``,
    ``device``, ``tracking``, ``recording``, ``error``, ``pulse`` or ``gesture``."""

    t: float
    kind: str
    text: str
    data: Mapping[str, object] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class Image:
    """An image at ``t`` (s since the recording began): ``rgb`` (height, width, 3) uint8."""

    t: float
    rgb: NDArray[np.uint8]


class Recording:
    """A session file. `glovetrack.open` makes one; it may be used as a context manager.

    Times are in s since the recording began, the same for both hands, sensors and images.
    ``recording[2.0:5.0]`` is the part from 2 s to 5 s. The file is read when something is first
    asked for; arrays are kept.
    """

    def __init__(
        self, path: Path, window: tuple[float, float] | None = None, folder: Path | None = None
    ) -> None:
        """``window``: only from one instant to the other (s). ``folder``: deleted with this object.

        Raises FileError where the file is not a session.
        """
        self.path = Path(path)
        self._reader = SessionReader(self.path)
        self._window = window
        self._parts: dict[str, SessionReader] = {}
        self._end = weakref.finalize(self, _release, self._reader, self._parts, folder)

    # ---- what it is about

    def __repr__(self) -> str:
        return f"<Recording {self.path.name}, {self.duration:.1f} s, {' and '.join(self.sides)}>"

    def __enter__(self) -> Recording:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    def close(self) -> None:
        """Close the file. Arrays that were taken stay usable. May be called again."""
        self._end()

    @property
    def duration(self) -> float:
        """Seconds from the beginning to the end; of a part its own."""
        if self._window is not None:
            start, stop = self._window
            return max(min(stop, self._reader.duration) - max(start, 0.0), 0.0)
        return self._reader.duration

    @property
    def sides(self) -> tuple[str, ...]:
        """``("left", "right")``, or the one hand that was recorded."""
        return self._reader.sides or (self._reader.info.side,)

    @property
    def engine(self) -> str:
        """Which engine tracked it; empty where it was not tracked."""
        return self._reader.info.engine

    @property
    def participant(self) -> str:
        """As it was entered before the recording."""
        return self._reader.info.participant

    @property
    def metadata(self) -> Mapping[str, str]:
        """Everything that the file says of itself."""
        return MappingProxyType(self._reader.metadata)

    # ---- parts

    def __getitem__(self, times: slice) -> Recording:
        """``recording[2.0:5.0]``: the part from 2 s to 5 s. Raises TypeError for a step."""
        if not isinstance(times, slice) or times.step is not None:
            raise TypeError("a recording is sliced by seconds, as in recording[2.0:5.0]")
        stop = np.inf if times.stop is None else float(times.stop)
        return self.between(float(times.start or 0.0), stop)

    def between(self, start: float, stop: float) -> Recording:
        """The part with ``start <= t < stop`` (s). Its times count from the same beginning."""
        old_start, old_stop = self._window or (-np.inf, np.inf)
        return Recording(self.path, (max(start, old_start), min(stop, old_stop)))

    # ---- hands

    @cached_property
    def hands(self) -> Mapping[str, Hand]:
        """Each recorded hand by its side. Raises FileError where there are no estimates."""
        return MappingProxyType({side: self._hand(side) for side in self.sides})

    @cached_property
    def truth(self) -> Mapping[str, Hand]:
        """Of a simulated session what each hand really did; empty of another."""
        found = {}
        for side in self.sides:
            part = self._part(side)
            true = sorted(part.truth(), key=lambda m: m.t)
            if true:
                found[side] = self._cut(Hand(side, series_of(part.info, true), self._zero_ns))
        return MappingProxyType(found)

    @property
    def hand(self) -> Hand:
        """The only hand. Raises ConfigError for a recording of both, whose hands are in `hands`."""
        if len(self.sides) != 1:
            raise ConfigError(
                f"{self.path.name} is a recording of both hands. "
                "Choose one: recording.hands['left'] or recording.hands['right']."
            )
        return self.hands[self.sides[0]]

    @property
    def t(self) -> Array:
        """(N,) s of the only hand's estimates."""
        return self.hand.t

    @property
    def t_unix_ns(self) -> IntArray:
        """(N,) ns since 1970 of the only hand's estimates."""
        return self.hand.t_unix_ns

    @property
    def keypoints(self) -> Columns:
        """See `Hand.keypoints`, of the only hand."""
        return self.hand.keypoints

    @property
    def angles(self) -> Columns:
        """See `Hand.angles`, of the only hand."""
        return self.hand.angles

    @property
    def sd(self) -> Columns:
        """See `Hand.sd`, of the only hand."""
        return self.hand.sd

    @property
    def valid(self) -> Columns:
        """See `Hand.valid`, of the only hand."""
        return self.hand.valid

    # ---- sensors and events

    def imu(self, name: str, side: str = "") -> ImuSamples:
        """Samples of one IMU. ``side`` is needed for a recording of both hands.

        Raises KeyError for an unknown name, FileError where nothing was recorded.
        """
        raw = self._raw_imu(self._side(side))
        if name not in raw.names:
            raise KeyError(f"no IMU {name!r}; available: {', '.join(raw.names)}")
        i = raw.names.index(name)
        t = (raw.stamp_ns - self._zero_ns) / NS
        rows = self._rows(t)
        return ImuSamples(name, t[rows], raw.accel[rows, i], raw.gyro[rows, i], raw.valid[rows, i])

    def imu_names(self, side: str = "") -> tuple[str, ...]:
        """The IMUs of the glove."""
        return self._part(self._side(side)).info.glove.imu_names

    @cached_property
    def events(self) -> tuple[RecordedEvent, ...]:
        """Notes in their last wording, and what happened to devices and tracking."""
        found = [m for m in self._reader.messages([Event]) if isinstance(m, Event)]
        out = (
            RecordedEvent(self._seconds(e.t), e.kind, e.text, MappingProxyType(dict(e.data)))
            for e in standing(found)
        )
        return tuple(e for e in out if self._within(e.t))

    def images(self, camera: str = "left") -> Iterator[Image]:
        """Images of the ``left`` or ``right`` camera, decoded one after the other.

        Raises ConfigError for another camera. A recording without images gives none.
        """
        if camera not in CAMERA_SIDES:
            raise ConfigError(f"The camera is 'left' or 'right', not {camera!r}.")
        with SessionReader(self.path) as reader:
            for m in reader.messages([StereoFrame], *self._arrivals()):
                assert isinstance(m, StereoFrame)
                image = m.left if camera == "left" else m.right
                t = self._seconds(m.t)
                if image is not None and self._within(t):
                    yield Image(t, np.ascontiguousarray(image[..., ::-1]))

    # ---- what is made of it

    def track(
        self,
        engine: str = "",
        wearer: str | Path = "",
        out: str | Path | None = None,
        *,
        smooth: bool = False,
        options: TrackOptions | None = None,
        force: bool = False,
    ) -> Recording:
        """Track the sensors again; the new recording, with sensors and estimates.

        ``engine``: another one than the recording's; ``wearer``: path of a wearer's profile;
        ``out``: the new file, else one that is deleted with the returned object; ``options``: all
        that ``glovetrack track`` takes, in place of the arguments before. Raises GlovetrackError
        in words.
        """
        from tracker.offline.track import track

        asked = options or TrackOptions(
            engine=engine, wearer=str(wearer), smooth=smooth, with_sensors=True
        )
        folder = None if out is not None else Path(tempfile.mkdtemp(prefix="glovetrack-"))
        target = Path(out) if out is not None else _in(folder, f"{self.path.stem}_tracked.mcap")
        try:
            with one_blas_thread(), self._as_file() as source:
                track(source, target, asked, force=force)
        except BaseException:
            if folder is not None:
                shutil.rmtree(folder, ignore_errors=True)
            raise
        return Recording(target, folder=folder)

    def export(
        self,
        format: str,
        path: str | Path,
        options: ExportOptions | None = None,
        *,
        force: bool = False,
    ) -> Mapping[str, Any]:
        """Write it as ``format`` (``csv``, ``c3d``, ``bvh``, …) to ``path``.

        Returns what the JSON file beside the export contains. An existing file is replaced only
        with ``force``. Raises GlovetrackError in words.
        """
        from tracker.session.export.run import export

        with one_blas_thread(), self._as_file() as source:
            return MappingProxyType(
                export(source, format, Path(path), options or ExportOptions(), force=force)
            )

    def compare(self, other: Recording) -> Mapping[str, Any]:
        """What differs from another tracking of the same movement: ``identical``, distances of
        keypoints in mm, differences of angles in degrees. Raises FileError where the two have no
        instants in common."""
        from tracker.session.compare import compare

        return MappingProxyType(compare(self.path, other.path))

    # ---- inside

    @cached_property
    def _zero_ns(self) -> int:
        return self._reader.span_ns[0]

    def _seconds(self, t: float) -> float:
        """s since the beginning of ``t``, s of the monotonic clock."""
        return (self._reader.anchor.wall(t) - self._zero_ns) / NS

    def _within(self, t: float) -> bool:
        return self._window is None or self._window[0] <= t < self._window[1]

    def _rows(self, t: Array) -> slice:
        if self._window is None:
            return slice(None)
        first, last = np.searchsorted(t, self._window)
        return slice(int(first), int(last))

    def _arrivals(self) -> tuple[float | None, float | None]:
        """From when on messages are read (s of the monotonic clock): images arrive later than they
        were taken, so the end is open."""
        if self._window is None or not np.isfinite(self._window[0]):
            return None, None
        return self._reader.anchor.monotonic(self._zero_ns + round(self._window[0] * NS)), None

    def _side(self, asked: str) -> str:
        if asked in self.sides:
            return asked
        if asked:
            raise ConfigError(f"{self.path.name} is a recording of the {self.sides[0]} hand.")
        if len(self.sides) == 1:
            return self.sides[0]
        raise ConfigError(f"{self.path.name} is a recording of both hands: say which side.")

    def _part(self, side: str) -> SessionReader:
        if side not in self._parts:
            self._parts[side] = SessionReader(self.path, side=side if self._reader.sides else "")
        return self._parts[side]

    def _hand(self, side: str) -> Hand:
        series: EstimateSeries = recorded_series(self._part(side))
        return self._cut(Hand(side, series, self._zero_ns))

    def _cut(self, hand: Hand) -> Hand:
        return hand if self._window is None else hand.between(*self._window)

    def _raw_imu(self, side: str) -> RawImu:
        return self._raw[side]

    @cached_property
    def _raw(self) -> dict[str, RawImu]:
        return {side: read_raw_imu(self._part(side)) for side in self.sides}

    def _as_file(self) -> _Source:
        return _Source(self.path, self._window)


class _Source:
    """The file of a recording or, for the time of a ``with``, one of a part of it."""

    def __init__(self, path: Path, window: tuple[float, float] | None) -> None:
        self._path, self._window = path, window
        self._folder: Path | None = None

    def __enter__(self) -> Path:
        if self._window is None:
            return self._path
        from tracker.offline.crop import crop

        start, stop = self._window
        self._folder = Path(tempfile.mkdtemp(prefix="glovetrack-"))
        part = self._folder / self._path.name
        crop(self._path, part, max(start, 0.0), stop if np.isfinite(stop) else None)
        return part

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        if self._folder is not None:
            shutil.rmtree(self._folder, ignore_errors=True)


def _in(folder: Path | None, name: str) -> Path:
    assert folder is not None
    return folder / name


def _release(reader: SessionReader, parts: dict[str, SessionReader], folder: Path | None) -> None:
    for each in (reader, *parts.values()):
        each.close()
    if folder is not None:
        shutil.rmtree(folder, ignore_errors=True)


def open(path: str | Path) -> Recording:
    """Open a recorded session.

    Raises FileError in words where the file does not exist or is not a session.
    """
    return Recording(Path(path))


def simulate(
    path: str | Path | None = None,
    *,
    seed: int = 0,
    duration: float = 60.0,
    hands: str = "right",
    images: bool = True,
    options: SimulateOptions | None = None,
    force: bool = False,
) -> Recording:
    """Simulate a session with known truth: a wearer, a glove and a camera.

    ``path``: the new file, else one that is deleted with the returned object. ``duration`` in s;
    ``hands``: ``right``, ``left`` or ``both``; without ``images`` the detected blobs are written,
    which is faster. ``options``: all that ``glovetrack simulate`` takes, in place of these. Raises
    ConfigError for impossible ones.
    """
    from tracker.offline.simulate import SimulateOptions
    from tracker.offline.simulate import simulate as run

    asked = options or SimulateOptions(seed=seed, duration=duration, hands=hands, images=images)
    folder = None if path is not None else Path(tempfile.mkdtemp(prefix="glovetrack-"))
    target = Path(path) if path is not None else _in(folder, "simulated.mcap")
    with one_blas_thread():
        run(target, asked, force=force)
    return Recording(target, folder=folder)
