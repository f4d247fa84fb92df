"""The estimates of a session as arrays, cut, resampled and turned as an export asks."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.spatial.transform import Rotation, Slerp

from tracker.clock import NS
from tracker.errors import ConfigError, FileError
from tracker.messages import Array, Estimate, IntArray, Validity
from tracker.session.description import SessionInfo
from tracker.session.reader import SessionReader

# Rows: the new axes in G (x forward, y left, z up).
AXES = {
    "z-up": np.eye(3),
    "y-up": np.array([[0.0, -1, 0], [0, 0, 1], [-1, 0, 0]]),  # x right, y up, z back (OpenXR, glTF)
    "opensim": np.array([[1.0, 0, 0], [0, 0, 1], [0, -1, 0]]),  # x forward, y up, z right
}
UNITS = {"m": 1.0, "cm": 100.0, "mm": 1000.0}
RATES = (1.0, 2000.0)


@dataclass(frozen=True)
class ExportOptions:
    """None keeps what the session or the format has.

    ``rate`` Hz; ``start``, ``stop`` s from the first estimate; ``joints`` keypoints and angles to
    keep; ``anonymous`` metadata fields that are left out.
    """

    rate: float | None = None
    axes: str | None = None
    units: str | None = None
    start: float | None = None
    stop: float | None = None
    joints: tuple[str, ...] = ()
    anonymous: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        if self.rate is not None and not RATES[0] <= self.rate <= RATES[1]:
            raise ConfigError(f"A rate of {self.rate:g} Hz is not between 1 and 2000 Hz.")
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
    motion = _turned(motion, AXES[options.axes or axes])
    notes: dict[str, object] = {"axes": options.axes or axes, "resampled_hz": rate}
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


def _rows(m: Motion, rows: IntArray) -> Motion:
    return replace(
        m,
        stamp_ns=m.stamp_ns[rows],
        keypoints=m.keypoints[rows],
        q=m.q[rows],
        state=m.state[rows],
        angles=m.angles[rows],
        angle_state=m.angle_state[rows],
    )


def _cut(m: Motion, options: ExportOptions) -> Motion:
    start = -np.inf if options.start is None else options.start
    stop = np.inf if options.stop is None else options.stop
    rows = np.flatnonzero((m.elapsed >= start) & (m.elapsed <= stop))
    if len(rows) == 0:
        raise FileError(f"There is no estimate between {start:g} s and {stop:g} s.")
    return _rows(m, rows)


def _is_even(m: Motion) -> bool:
    steps = np.diff(m.stamp_ns)
    return len(steps) == 0 or bool(np.ptp(steps) < 1e-3 * np.median(steps))


def resample(m: Motion, rate: float) -> Motion:
    """Estimates at ``rate`` Hz: cubic splines, slerp for orientations, a low-pass when slower.

    A number next to one that was lost stays lost; states are those of the nearest estimate.
    """
    if len(m) < 4:
        return m
    smooth = _low_pass(m, rate) if rate < 0.9 * m.rate else m
    n = int(np.floor(m.elapsed[-1] * rate + 1e-9)) + 1
    t = np.arange(n) / rate
    nearest = np.abs(np.searchsorted((m.elapsed[1:] + m.elapsed[:-1]) / 2, t))
    out = _rows(m, nearest)
    return replace(
        out,
        stamp_ns=m.stamp_ns[0] + np.round(t * NS).astype(np.int64),
        keypoints=_spline(m.elapsed, smooth.keypoints, t),
        angles=_spline(m.elapsed, smooth.angles, t),
        q=_slerp(m.elapsed, m.q, t),
    )


def _low_pass(m: Motion, rate: float) -> Motion:
    """A Gaussian that halves what lies at 0.4 of the new rate, so that little folds over."""
    sigma = np.sqrt(2 * np.log(2)) / (2 * np.pi * 0.4 * rate) * m.rate  # samples
    reach = max(int(np.ceil(3 * sigma)), 1)
    kernel = np.exp(-0.5 * (np.arange(-reach, reach + 1) / sigma) ** 2)
    return replace(m, keypoints=_smoothed(m.keypoints, kernel), angles=_smoothed(m.angles, kernel))


def _smoothed(values: Array, kernel: Array) -> Array:
    """Weighted means along time of what is known; what is lost stays lost."""
    flat = values.reshape(len(values), -1)
    out = np.empty_like(flat)
    for k, column in enumerate(flat.T):
        known = np.isfinite(column)
        total = np.convolve(np.where(known, column, 0.0), kernel, "same")[: len(column)]
        weight = np.convolve(known.astype(float), kernel, "same")[: len(column)]
        out[:, k] = np.where(known, total / np.where(known, weight, 1.0), np.nan)
    return out.reshape(values.shape)


def _spline(t_old: Array, values: Array, t: Array) -> Array:
    flat = values.reshape(len(values), -1)
    out = np.full((len(t), flat.shape[1]), np.nan)
    for k, column in enumerate(flat.T):
        known = np.isfinite(column)
        if known.sum() < 2:
            continue
        covered = _covered(t_old, known, t)
        out[covered, k] = CubicSpline(t_old[known], column[known])(t[covered])
    return out.reshape(len(t), *values.shape[1:])


def _slerp(t_old: Array, q: Array, t: Array) -> Array:
    out = np.full((len(t), *q.shape[1:]), np.nan)
    for k in range(q.shape[1]):
        known = np.asarray(np.isfinite(q[:, k]).all(axis=1))
        if known.sum() < 2:
            continue
        covered = _covered(t_old, known, t)
        turn = Slerp(t_old[known], Rotation.from_quat(q[known, k]))
        out[covered, k] = turn(t[covered]).as_quat()
    return out


def _covered(t_old: Array, known: np.ndarray, t: Array) -> np.ndarray:
    """Instants whose neighbours on both sides are known."""
    after = np.clip(np.searchsorted(t_old, t - 1e-9), 0, len(t_old) - 1)
    before = np.clip(np.searchsorted(t_old, t + 1e-9, side="right") - 1, 0, len(t_old) - 1)
    return known[after] & known[before]


def _turned(m: Motion, R: Array) -> Motion:
    """Positions and orientations in other axes: rows of ``R`` (3, 3) are those axes in G."""
    if np.array_equal(R, np.eye(3)):
        return m
    q = np.full_like(m.q, np.nan)
    known = np.isfinite(m.q).all(axis=-1)
    if known.any():
        q[known] = (Rotation.from_matrix(R) * Rotation.from_quat(m.q[known])).as_quat()
    return replace(m, keypoints=m.keypoints @ R.T, q=q)


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
