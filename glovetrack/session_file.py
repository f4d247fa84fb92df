"""The file of a recording, or a part of it: readers, one time axis, and temporary files."""

from __future__ import annotations

import shutil
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from functools import cached_property
from pathlib import Path

import numpy as np

from tracker.base.clock import NS
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.messages import Array
from tracker.session.raw_imu import RawImu, read_raw_imu
from tracker.session.reader import SessionReader

Window = tuple[float, float]
LATE = 1.0  # s that an image may arrive after it was exposed


class SessionFile:
    """An open session. Its times are s since the recording began; ``window``: only a part."""

    def __init__(
        self, path: Path, window: Window | None = None, zero_ns: int | None = None
    ) -> None:
        """``zero_ns``: the instant of ``t = 0`` (ns since 1970), by default the file's beginning.

        Raises FileError where the file is not a session.
        """
        self.path, self.window = path, window
        self.reader = SessionReader(path)
        self.zero_ns: int = self.reader.span_ns[0] if zero_ns is None else zero_ns
        self._of_side: dict[str, SessionReader] = {}

    def close(self) -> None:
        """May be called again."""
        for reader in (self.reader, *self._of_side.values()):
            reader.close()

    @property
    def sides(self) -> tuple[str, ...]:
        """``("left", "right")``, or the one hand that was recorded."""
        return self.reader.sides or (self.reader.info.side,)

    def side(self, requested: str) -> str:
        """The hand that is meant. Raises ConfigError where that is not clear, or it is missing."""
        if requested in self.sides:
            return requested
        if requested:
            raise ConfigError(notice("api.other_side", file=self.path.name, side=self.sides[0]))
        if len(self.sides) == 1:
            return self.sides[0]
        raise ConfigError(notice("api.both_recorded", file=self.path.name))

    def of_side(self, side: str) -> SessionReader:
        """A reader of one hand."""
        if side not in self._of_side:
            named = side if self.reader.sides else ""
            self._of_side[side] = SessionReader(self.path, side=named)
        return self._of_side[side]

    @cached_property
    def raw_imu(self) -> dict[str, RawImu]:
        """All packets of each glove."""
        return {side: read_raw_imu(self.of_side(side)) for side in self.sides}

    # ---- time

    @property
    def start(self) -> float:
        """Where the file begins (s): 0 except for a part that was tracked again."""
        return (self.reader.span_ns[0] - self.zero_ns) / NS

    @property
    def duration(self) -> float:
        """Seconds from the beginning to the end of the recording, or of this part of it."""
        if self.window is None:
            return self.reader.duration
        start, stop = self.window
        return max(min(stop, self.start + self.reader.duration) - max(start, self.start), 0.0)

    def seconds(self, t: float) -> float:
        """s since the beginning of ``t``, s of the monotonic clock."""
        return (self.reader.anchor.wall(t) - self.zero_ns) / NS

    def has(self, t: float) -> bool:
        """Whether an instant (s) is in this part."""
        return self.window is None or self.window[0] <= t < self.window[1]

    def rows(self, t: Array) -> slice:
        """Which of the rising instants ``t`` (N,) s are in this part."""
        if self.window is None:
            return slice(None)
        first, last = np.searchsorted(t, self.window)
        return slice(int(first), int(last))

    def arrivals(self) -> tuple[float | None, float | None]:
        """From when to when (s of the monotonic clock) messages of this part may have arrived."""
        if self.window is None:
            return None, None
        start, stop = self.window
        return self._monotonic(start), self._monotonic(stop + LATE)

    def _monotonic(self, t: float) -> float | None:
        if not np.isfinite(t):
            return None
        return self.reader.anchor.monotonic(self.zero_ns + round(t * NS))

    # ---- as a file of its own

    @contextmanager
    def as_file(self, to_track: bool) -> Iterator[Path]:
        """Yields the path of the file or, for a part, of a temporary copy.

        ``to_track``: the copy contains the state of the engine at its start, for which the session
        is tracked up to there.
        """
        if self.window is None:
            yield self.path
            return
        from tracker.offline.crop import crop  # deferred: loads SciPy

        start, stop = self.window
        end = stop - self.start if np.isfinite(stop) else None
        with temporary_folder() as folder:
            part = folder / self.path.name
            crop(self.path, part, max(start - self.start, 0.0), end, with_state=to_track)
            yield part


@contextmanager
def temporary_folder() -> Iterator[Path]:
    """Deleted at the end, with all that is in it."""
    folder = Path(tempfile.mkdtemp(prefix="glovetrack-"))
    try:
        yield folder
    finally:
        shutil.rmtree(folder, ignore_errors=True)
