"""The estimates of a session as arrays, cut, resampled and turned as an export asks."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from tracker.clock import NS
from tracker.errors import ConfigError, FileError
from tracker.messages import Array, Estimate, IntArray, Validity
from tracker.session.description import SessionInfo
from tracker.session.export.axes import AXES, turned
from tracker.session.export.resample import resample
from tracker.session.reader import SessionReader

UNITS = {"m": 1.0, "cm": 100.0, "mm": 1000.0}
RATES = (1.0, 2000.0)


@dataclass(frozen=True)
class ExportOptions:
    """None keeps what the session or the format has.

    ``rate`` Hz; ``start``, ``stop`` s from the first estimate; ``joints`` keypoints and angles to
    keep; ``anonymous`` what is left out, of `formats.HIDEABLE`; ``every`` n-th image is drawn.
    """

    rate: float | None = None
    axes: str | None = None
    units: str | None = None
    start: float | None = None
    stop: float | None = None
    joints: tuple[str, ...] = ()
    anonymous: tuple[str, ...] = ()
    every: int = 1

    def __post_init__(self) -> None:
        if self.rate is not None and not RATES[0] <= self.rate <= RATES[1]:
            raise ConfigError(f"A rate of {self.rate:g} Hz is not between 1 and 2000 Hz.")
        if self.every < 1:
            raise ConfigError(f"Every image or every n-th, not every {self.every}.")
        if self.axes is not None and self.axes not in AXES:
            raise ConfigError(f"Axes can be {', '.join(AXES)}, not {self.axes!r}.")
        if self.units is not None and self.units not in UNITS:
            raise ConfigError(f"Units can be {', '.join(UNITS)}, not {self.units!r}.")


@dataclass(frozen=True, eq=False)
class Motion:
    """N estimates: stamp_ns (N,), keypoints (N, K, 3) m, q (N, K, 4), state (N, K),
    angles (N, J) rad, angle_state (N, J); NaN where lost.
    """

    info: SessionInfo
    keypoint_names: tuple[str, ...]
    joint_names: tuple[str, ...]
    stamp_ns: IntArray
    keypoints: Array
    q: Array
    state: IntArray
    angles: Array
    angle_state: IntArray
    notes: dict[str, object] = field(default_factory=dict)

    def __len__(self) -> int:
        return len(self.stamp_ns)

    def rows(self, rows: IntArray) -> Motion:
        """Some of the estimates."""
        return replace(
            self,
            stamp_ns=self.stamp_ns[rows],
            keypoints=self.keypoints[rows],
            q=self.q[rows],
            state=self.state[rows],
            angles=self.angles[rows],
            angle_state=self.angle_state[rows],
        )

    @property
    def t(self) -> Array:
        """(N,) s since 1970, rounded to the microsecond."""
        return np.round(self.stamp_ns / 1000) / 1e6

    @property
    def elapsed(self) -> Array:
        """(N,) s from the first estimate."""
        return (self.stamp_ns - self.stamp_ns[0]) / NS

    @property
    def rate(self) -> float:
        """Estimates per second: the inverse of the median step."""
        return 100.0 if len(self) < 2 else NS / float(np.median(np.diff(self.stamp_ns)))


def load_motion(
    reader: SessionReader, options: ExportOptions, even: bool = False, axes: str = "z-up"
) -> Motion:
    """All estimates of a session, as ``options`` ask; ``even``: the format knows one rate only.

    Raises FileError if the session holds none.
    """
    motion = _gather(reader)
    motion = _cut(motion, options)
    rate = options.rate
    if rate is None and even and not _is_even(motion):
        rate = float(round(motion.rate))
    if rate is not None:
        motion = resample(motion, rate)
    named = options.axes or axes
    motion = turned(motion, named)
    if "time" in options.anonymous:
        motion = replace(motion, stamp_ns=motion.stamp_ns - motion.stamp_ns[0])
    notes: dict[str, object] = {
        "axes": named,
        "axes_are": AXES[named].words,
        "resampled_hz": rate,
    }
    return replace(_picked(motion, options.joints), notes=notes)


def _gather(reader: SessionReader) -> Motion:
    found = [m for m in reader.messages([Estimate]) if isinstance(m, Estimate)]
    if not found:
        raise FileError(f"{reader.path} holds no estimates; track it first.")
    found.sort(key=lambda m: m.t)
    info = reader.info
    return Motion(
        info,
        info.keypoint_names,
        info.hand.joint_names,
        np.array([info.anchor.wall(m.t) for m in found], np.int64),
        np.array([m.keypoints for m in found]),
        np.array([m.keypoint_q for m in found]),
        np.array([m.keypoint_state for m in found]),
        np.array([m.angles for m in found]),
        np.array([m.angle_state for m in found]),
    )


def _cut(m: Motion, options: ExportOptions) -> Motion:
    start = -np.inf if options.start is None else options.start
    stop = np.inf if options.stop is None else options.stop
    rows = np.flatnonzero((m.elapsed >= start) & (m.elapsed <= stop))
    if len(rows) == 0:
        raise FileError(f"There is no estimate between {start:g} s and {stop:g} s.")
    return m.rows(rows)


def _is_even(m: Motion) -> bool:
    steps = np.diff(m.stamp_ns)
    return len(steps) == 0 or bool(np.ptp(steps) < 1e-3 * np.median(steps))


def _picked(m: Motion, names: tuple[str, ...]) -> Motion:
    """The keypoints and angles of those names. Raises ConfigError for a name that is none."""
    if not names:
        return m
    for name in names:
        if name not in m.keypoint_names and name not in m.joint_names:
            raise ConfigError(f"There is no keypoint or joint {name!r} in this session.")
    points = [i for i, n in enumerate(m.keypoint_names) if n in names]
    joints = [i for i, n in enumerate(m.joint_names) if n in names]
    return replace(
        m,
        keypoint_names=tuple(m.keypoint_names[i] for i in points),
        joint_names=tuple(m.joint_names[i] for i in joints),
        keypoints=m.keypoints[:, points],
        q=m.q[:, points],
        state=m.state[:, points],
        angles=m.angles[:, joints],
        angle_state=m.angle_state[:, joints],
    )


def state_words(state: IntArray) -> list[str]:
    """measured, inferred, lost for each number."""
    return [Validity(int(s)).name.lower() for s in state]
