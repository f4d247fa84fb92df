"""A recorded session: its hands, sensors, images and events, to be read, tracked and exported."""

from __future__ import annotations

import shutil
import tempfile
import weakref
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager
from pathlib import Path
from types import MappingProxyType, TracebackType
from typing import TYPE_CHECKING, Any

import numpy as np

from glovetrack.arguments import argument_errors, check_types
from glovetrack.recorded import RecordedData
from glovetrack.session_file import SessionFile, Window
from tracker.base.numeric_threads import one_numeric_thread
from tracker.offline.options import TrackOptions
from tracker.session.export.options import ExportOptions

if TYPE_CHECKING:
    from tracker.offline.simulate import SimulateOptions


class Recording(RecordedData):
    """A session file. `glovetrack.open` makes one; it may be used as a context manager.

    Times are in s since the recording began, the same for both hands, sensors and images. An image
    or a packet that was taken before and arrived later has a negative time.
    ``recording[2.0:5.0]`` is the part from 2 s to 5 s. Data are read from the file on
    first use and then cached.
    """

    def __init__(
        self,
        path: Path,
        window: Window | None = None,
        folder: Path | None = None,
        zero_ns: int | None = None,
    ) -> None:
        """``window``: only from one instant to the other (s). ``folder``: deleted with this object.
        ``zero_ns``: the instant of ``t = 0`` (ns since 1970), by default the file's beginning.

        Raises FileError where the file is not a session.
        """
        super().__init__(Path(path), window, zero_ns)
        self._end = weakref.finalize(self, _release, self._file, folder)

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
        """Seconds from the beginning to the end of the recording, or of this part of it."""
        return self._file.duration

    @property
    def engine(self) -> str:
        """The engine that tracked it; empty if it was not tracked."""
        return self._file.reader.info.engine

    @property
    def participant(self) -> str:
        """The participant that was entered before the recording."""
        return self._file.reader.info.participant

    @property
    def metadata(self) -> Mapping[str, str]:
        """The metadata of the file."""
        return MappingProxyType(self._file.reader.metadata)

    # ---- parts

    def __getitem__(self, times: slice) -> Recording:
        """``recording[2.0:5.0]``: the part from 2 s to 5 s. Raises TypeError for a step."""
        if not isinstance(times, slice) or times.step is not None:
            raise TypeError("a recording is sliced by seconds, as in recording[2.0:5.0]")
        stop = np.inf if times.stop is None else float(times.stop)
        return self.between(float(times.start or 0.0), stop)

    def between(self, start: float, stop: float) -> Recording:
        """The part with ``start <= t < stop`` (s). Its times count from the same beginning."""
        old_start, old_stop = self._file.window or (-np.inf, np.inf)
        window = max(start, old_start), min(stop, old_stop)
        return Recording(self.path, window, zero_ns=self._file.zero_ns)

    # ---- tracking and export

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
        """Tracks the sensor data again; returns the new recording, with sensors and estimates.

        Its times count from the same beginning, also those of a part.
        ``engine``: instead of the recording's; ``wearer``: path of a wearer's profile; ``out``: the
        new file, else one that is deleted with the returned object; ``options``: all options of
        ``glovetrack track``, instead of the other arguments. Raises GlovetrackError.
        """
        from tracker.offline.track import track  # deferred: loads every engine

        chosen = options or TrackOptions(
            engine=engine, wearer=str(wearer), smooth=smooth, with_sensors=True
        )
        check_types(chosen)
        with argument_errors(), _target(out, f"{self.path.stem}_tracked.mcap") as (target, folder):
            with one_numeric_thread(), self._file.as_file(to_track=True) as source:
                track(source, target, chosen, force=force)
            return Recording(target, folder=folder, zero_ns=self._file.zero_ns)

    def export(
        self,
        format: str,
        path: str | Path,
        options: ExportOptions | None = None,
        *,
        force: bool = False,
    ) -> Mapping[str, Any]:
        """Exports it as ``format`` (``csv``, ``c3d``, ``bvh``, …) to ``path``.

        Returns the content of the JSON file that describes the export. An existing file is replaced
        only with ``force``. Raises GlovetrackError.
        """
        from tracker.session.export.run import export  # deferred: loads every format

        chosen = options or ExportOptions()
        check_types(chosen)
        with (
            argument_errors(),
            one_numeric_thread(),
            self._file.as_file(to_track=False) as source,
        ):
            return MappingProxyType(export(source, format, Path(path), chosen, force=force))

    def compare(self, other: Recording) -> Mapping[str, Any]:
        """Compares it with another tracking of the same movement: ``identical``, distances of
        keypoints in mm, differences of angles in degrees. Raises FileError where the two have no
        instants in common."""
        from tracker.session.compare import compare  # deferred: most programs only read

        with self._file.as_file(False) as one, other._file.as_file(False) as two:
            return MappingProxyType(compare(one, two))


@contextmanager
def _target(out: str | Path | None, name: str) -> Iterator[tuple[Path, Path | None]]:
    """Yields the path to write to and, without ``out``, the new folder for it, which is deleted if
    the block fails."""
    if out is not None:
        yield Path(out), None
        return
    folder = Path(tempfile.mkdtemp(prefix="glovetrack-"))
    with ExitStack() as undo:
        undo.callback(shutil.rmtree, folder, ignore_errors=True)
        yield folder / name, folder
        undo.pop_all()


def _release(file: SessionFile, folder: Path | None) -> None:
    file.close()
    if folder is not None:
        shutil.rmtree(folder, ignore_errors=True)


def open(path: str | Path) -> Recording:
    """Open a recorded session.

    Raises FileError if the file does not exist or is not a session.
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
    """Simulates a session with known truth: a wearer, a glove and a camera.

    ``path``: the new file, else one that is deleted with the returned object. ``duration`` in s;
    ``hands``: ``right``, ``left`` or ``both``; without ``images`` the detected blobs are written,
    which is faster. ``options``: all options of ``glovetrack simulate``, instead of these.
    Raises ConfigError for invalid values, TypeError for another type.
    """
    from tracker.offline import simulate as simulation  # deferred: the simulator

    chosen = options or simulation.SimulateOptions(
        seed=seed, duration=duration, hands=hands, images=images
    )
    check_types(chosen)
    with argument_errors(), _target(path, "simulated.mcap") as (target, folder):
        with one_numeric_thread():
            simulation.simulate(target, chosen, force=force)
        return Recording(target, folder=folder)
