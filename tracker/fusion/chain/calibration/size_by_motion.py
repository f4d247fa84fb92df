"""The size of a hand that one camera sees, by the accelerometer of its root (docs/chain.md).

Images show positions in multiples of the hand's size; the accelerometer measures them in metres. A
filter cannot use this: its corrections of biases and mountings are correlated with the motion.
Windows of raw readings, with one bias, gyroscope matrix and size for all of them, can.
"""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from tracker import GRAVITY
from tracker.base.records import record
from tracker.fusion.chain.calibration.size import size_index, size_index_gain
from tracker.fusion.chain.filter import Rows
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.profile import WearerProfile
from tracker.fusion.chain.start.mono_start import assumed_size_sd
from tracker.fusion.chain.state import SCALE_LIMITS, ChainState
from tracker.fusion.time.imu_buffer import ImuBuffer, Intervals
from tracker.geometry import so3
from tracker.messages import Array, CameraPose

# ---- acceleration and images of a few seconds, as linear equations of the scale of the images
#
# The accelerometer measures metres, the images of one camera multiples of the hand's size.
# Packets are integrated from readings alone: corrections of the filter's biases and mountings
# during a window would look like acceleration. Equation numbers are those of docs/chain.md.

GRAVITY_G = np.array([0.0, 0.0, -GRAVITY])
SCALE, ACCEL_BIAS, GYRO_BIAS, GYRO_AXES, TILT = 0, slice(1, 4), slice(4, 7), slice(7, 16), 16
COLUMNS = 19
"""κ; and κ times these: accelerometer bias (3) m/s², gyro bias (3) rad/s, errors of the gyroscope's
matrix (3 x 3, by column), both biases negative, and the orientation error (3) rad at the start."""


@record(
    "chain.motion_window",
    shapes={
        "times": "k",
        "seen": "k 3",
        "by_motion": "k 3 c",
        "R_GI": "3 3 | 0",
        "bg": "3 | 0",
        "velocity": "3 c | 0",
        "place": "3 c | 0",
        "turn": "3 c | 0",
    },
)
@dataclass(eq=False)
class MotionWindow:
    """Positions of the root's IMU, and those that the packets integrate to.

    times (k,) s; seen (k, 3) multiples of the hand's size, from the camera, along axes of G;
    by_motion (k, 3, 19) m the same per unit of each unknown. The rest is the integration up to
    ``t``: R_GI (3, 3), bg (3,) rad/s subtracted, velocity, place, turn (3, 19). ``moved``: the
    camera has moved since the start, at ``camera``.
    """

    start: float = np.nan
    t: float = np.nan
    camera: CameraPose | None = None
    times: Array = field(default_factory=lambda: np.zeros(0))
    seen: Array = field(default_factory=lambda: np.zeros((0, 3)))
    by_motion: Array = field(default_factory=lambda: np.zeros((0, 3, COLUMNS)))
    R_GI: Array = field(default_factory=lambda: np.zeros(0))
    bg: Array = field(default_factory=lambda: np.zeros(0))
    velocity: Array = field(default_factory=lambda: np.zeros(0))
    place: Array = field(default_factory=lambda: np.zeros(0))
    turn: Array = field(default_factory=lambda: np.zeros(0))
    moved: bool = False

    @property
    def is_open(self) -> bool:
        """Whether it has begun."""
        return bool(np.isfinite(self.start))

    def integrate(self, way: Intervals, imu: int) -> bool:
        """Continues through the packets of one IMU; False where some are missing (eq. 79)."""
        if not way.valid[:, imu].all():
            return False
        dt = (way.stop - way.start)[:, None]
        if not len(dt):
            return True
        turned = (way.gyro[:, imu] - self.bg) * dt
        # 1. orientations: R (k, 3, 3) in the middle of each interval
        R, half, whole = np.empty((len(dt), 3, 3)), so3.exp(turned / 2), so3.exp(turned)
        for k in range(len(dt)):
            R[k] = self.R_GI @ half[k]
            self.R_GI = self.R_GI @ whole[k]
        # 2. what each unknown adds to rotation, velocity and place
        force = np.einsum("kij,kj->ki", R, way.accel[:, imu] * dt)
        moved = force + GRAVITY_G * dt
        step, faster = np.zeros((2, len(dt), 3, COLUMNS))
        step[..., GYRO_BIAS] = R * dt[..., None]
        for axis in range(3):
            columns = slice(GYRO_AXES.start + 3 * axis, GYRO_AXES.start + 3 * axis + 3)
            step[..., columns] = R * (way.gyro[:, imu, axis, None] * dt)[..., None]
        turns = self.turn + np.cumsum(step, axis=0)
        faster[...] = -so3.skew(force) @ (turns - step / 2)
        faster[..., SCALE] = moved
        faster[..., ACCEL_BIAS] += R * dt[..., None]
        faster[..., TILT:] = -so3.skew(moved)
        velocities = self.velocity + np.cumsum(faster, axis=0)
        farther = (velocities - faster / 2) * dt[..., None]
        self.place = self.place + farther.sum(axis=0)
        self.velocity, self.turn, self.t = velocities[-1], turns[-1], float(way.stop[-1])
        return True

    def add(self, seen: Array, camera: CameraPose) -> None:
        """Adds an image at ``t``, with the position ``seen`` (3,) from the ``camera`` in multiples
        of the size."""
        assert self.camera is not None
        by_motion = self.place.copy()
        by_motion[:, SCALE] -= camera.p_GC - self.camera.p_GC
        by_motion[:, SCALE] += self.place[:, GYRO_BIAS] @ self.bg  # the whole bias is unknown
        self.times = np.append(self.times, self.t)
        self.seen = np.concatenate([self.seen, seen[None]])
        self.by_motion = np.concatenate([self.by_motion, by_motion[None]])


def window_at(state: ChainState, layout: ChainLayout, camera: CameraPose) -> MotionWindow:
    """A window that begins at ``state``."""
    imu = int(layout.imu_of[0])
    zero = np.zeros((3, COLUMNS))
    return MotionWindow(
        start=state.t,
        t=state.t,
        camera=camera,
        R_GI=state.R_GB[0] @ state.R_IB[imu].T,
        bg=state.bg[imu].copy(),
        velocity=zero,
        place=zero,
        turn=zero,
    )


# ---- the size of a hand that one camera sees, by the accelerometer of its root (docs/chain.md)
#
# Images show positions in multiples of the hand's size; the accelerometer measures them in
# metres. A filter cannot use this: its corrections of biases and mountings are correlated with
# the motion. Windows of raw readings, with one bias, gyroscope matrix and size for all of them,
# can.

WINDOW = 2.0  # s: shorter ones contain little, in longer ones errors of orientation dominate
SETTLED = 3.0  # s of tracking before the first window: postures at a start are less accurate
LONGEST_GAP = 0.2  # s between two images
LEAST_ROWS = 12  # coordinates of markers in an image
LEAST_IMAGES = 12  # in a window
SAME_PLACE, SAME_TURN = 0.001, 0.003  # m and rad: a camera that moves more is on a head
FAR, FAR_TURN = 0.15, 0.5  # m and rad: its view is another one

ACROSS_SD, DEPTH_SD = 0.001, 0.004  # m, of a position from an image
POSE_SD = 0.0025  # m, of such a position by the reported pose of a camera that moves
INDEPENDENT = 3.75  # positions per second with independent errors, whatever the image rate
MOST_MISFIT = 3.0  # of a window, its expectation is at most 1

ACCEL_BIAS_SD, GYRO_BIAS_SD, GYRO_AXES_SD, TILT_SD = 0.3, 0.03, 0.01, 0.09
LEAST_SD = 0.018  # relative, assumed of a size found in this way
BETTER = 0.9  # ratio of the standard deviations from which on a size is used


@record("chain.size_by_motion", shapes={"N": "0 | g g", "g": "0 | g"})
@dataclass(eq=False)
class SizeByMotionSavedState:
    """What changes. N (16, 16) and g (16,): information about the unknowns common to all windows,
    with their prior; empty before the first one. ``sd``: relative, of the size in use, infinite
    before it was measured."""

    N: Array = field(default_factory=lambda: np.zeros(0))
    g: Array = field(default_factory=lambda: np.zeros(0))
    window: MotionWindow = field(default_factory=MotionWindow)
    tracked_since: float = np.nan
    sd: float = np.inf
    before: WearerProfile | None = None  # the wearer as known without this

    def interrupt(self) -> None:
        """The hand is not tracked: no window continues across this."""
        self.window, self.tracked_since = MotionWindow(), np.nan


class SizeByMotion:
    """For one hand, itself immutable. Images must arrive in order."""

    def __init__(self, layout: ChainLayout) -> None:
        self._layout = layout

    def image(
        self,
        now: SizeByMotionSavedState,
        state: ChainState,
        camera: CameraPose,
        place: Array | None,
        buffer: ImuBuffer,
    ) -> bool:
        """Adds an image with the hand at ``place`` (`place_in_image`; None where it shows too
        little); returns whether a window was completed."""
        if np.isnan(now.tracked_since):
            now.tracked_since = state.t
        if self._layout.imu_of[0] < 0 or state.t - now.tracked_since < SETTLED:
            return False
        window = now.window
        if window.is_open and not self._continues(window, state, camera, buffer):
            now.window = window = MotionWindow()
        if place is None:
            return False
        if not window.is_open:
            now.window = window = window_at(state, self._layout, camera)
        window.add((place - camera.p_GC) / size_index(state.scale, self._layout), camera)
        return state.t - window.start >= WINDOW

    def _continues(
        self, window: MotionWindow, state: ChainState, camera: CameraPose, buffer: ImuBuffer
    ) -> bool:
        """Integrates a window up to ``state``; whether nothing interrupted it."""
        if state.t - window.times[-1] > LONGEST_GAP or window.camera is None:
            return False
        if not _is_near(window.camera, camera, FAR, FAR_TURN):
            return False
        window.moved |= not _is_near(window.camera, camera, SAME_PLACE, SAME_TURN)
        return window.integrate(buffer.intervals(window.t, state.t), int(self._layout.imu_of[0]))

    def complete(
        self, now: SizeByMotionSavedState, state: ChainState, known_sd: float
    ) -> float | None:
        """Adds the information of the completed window. Returns the factor by which the size of
        ``state`` is to change; None where it is not known better than before. ``known_sd``:
        relative, of the size without images."""
        window = now.window
        now.window = MotionWindow()
        if len(window.times) < LEAST_IMAGES or window.camera is None:
            return None
        index = size_index(state.scale, self._layout)
        known_sd = assumed_size_sd(known_sd)
        if not len(now.N):
            now.N, now.g = _prior(1.0 / index, known_sd / index)
        N, g, misfit = information(window, index)
        if misfit > MOST_MISFIT:
            return None
        now.N, now.g = now.N + N, now.g + g
        x, P = np.linalg.solve(now.N, now.g), np.linalg.inv(now.N)
        sd = float(np.sqrt(P[SCALE, SCALE]) / x[SCALE])
        low, high = SCALE_LIMITS
        if sd > BETTER * min(known_sd, now.sd) or not low < 1.0 / x[SCALE] < high:
            return None
        now.sd = sd
        return float(1.0 / (x[SCALE] * index))


def place_in_image(state: ChainState, seen: Rows, dx: Array) -> Array | None:
    """(3,) m: the root's position by an image alone, given the posture of the corrected ``state``;
    dx (N,) was its correction by the rows ``seen``. None where the image shows too little."""
    H, _, r, R = seen
    if len(r) < LEAST_ROWS:
        return None
    columns = np.column_stack([H[:, :3], r - H @ dx[: H.shape[1]]])
    weighted = np.linalg.solve(R, columns)
    A = H[:, :3].T @ weighted[:, :3]
    return np.asarray(state.p + np.linalg.solve(A, H[:, :3].T @ weighted[:, 3]))


def information(window: MotionWindow, index: float) -> tuple[Array, Array, float]:
    """N (16, 16) and g (16,) of a window, whose start, velocity and constant acceleration are
    eliminated (eq. 80), and its misfit; ``index``: the hand's size."""
    assert window.camera is not None
    R_CG = window.camera.R_GC.T
    t = window.times - window.times.mean()
    basis, _ = np.linalg.qr(np.vander(t, 3))
    seen, motion = window.seen @ R_CG.T, np.einsum("ij,kjc->kic", R_CG, window.by_motion)
    seen = seen - basis @ (basis.T @ seen)
    flat = motion.reshape(len(t), -1)
    motion = (flat - basis @ (basis.T @ flat)).reshape(motion.shape)
    usual = len(t) / (INDEPENDENT * float(t[-1] - t[0])) / index**2
    variance = np.array([ACROSS_SD, ACROSS_SD, DEPTH_SD]) ** 2 + window.moved * POSE_SD**2
    weight = 1.0 / (usual * variance)
    N = np.einsum("kia,i,kib->ab", motion, weight, motion)
    g = np.einsum("kia,i,ki->a", motion, weight, seen)
    total = float(np.einsum("ki,i,ki->", seen, weight, seen))
    # the tilt at the start is the window's own
    own = N[TILT:, TILT:] + np.eye(3) * TILT_SD**-2
    gain = np.linalg.solve(own, np.column_stack([N[TILT:, :TILT], g[TILT:]]))
    total -= float(g[TILT:] @ gain[:, -1])
    N, g = (
        N[:TILT, :TILT] - N[:TILT, TILT:] @ gain[:, :-1],
        g[:TILT] - N[:TILT, TILT:] @ gain[:, -1],
    )
    loose, at = _prior(1.0, 0.2)
    total += float(at[SCALE])
    best = np.linalg.solve(N + loose, g + at)
    expected = 3 * INDEPENDENT * float(t[-1] - t[0])
    return N, g, (total - float((g + at) @ best)) / expected


def sized(known: WearerProfile, layout: ChainLayout, index: float, sd: float) -> WearerProfile:
    """A copy of a profile whose `size_index` is ``index`` with relative standard deviation ``sd``:
    the Kalman update with that one scalar."""
    h = size_index_gain(layout)
    variance = float(h @ known.P @ h)
    share = 1.0 - min((sd * index) ** 2 / variance, 1.0)
    K = known.P @ h / variance
    change = K * (index - size_index(known.scale, layout))
    first = layout.n_dynamic
    change = change[layout.blocks.scale - first : layout.blocks.joint - first]
    scale = known.scale + change.reshape(-1, 2)
    return replace(known, scale=scale, P=known.P - share * np.outer(K, h @ known.P))


def resize(state: ChainState, camera: CameraPose, scale: Array, factor: float) -> None:
    """Gives the hand the sizes ``scale`` (A, 2) in place: images show the same hand at ``factor``
    times the distance from the camera."""
    low, high = SCALE_LIMITS
    state.scale = np.clip(scale, low, high)
    state.p, state.v = camera.p_GC + factor * (state.p - camera.p_GC), factor * state.v


def _prior(scale: float, sd: float) -> tuple[Array, Array]:
    """N (16, 16) and g (16,) before any window."""
    deviation = np.empty(TILT)
    deviation[SCALE], deviation[ACCEL_BIAS], deviation[GYRO_BIAS] = sd, ACCEL_BIAS_SD, GYRO_BIAS_SD
    deviation[GYRO_AXES] = GYRO_AXES_SD
    N = np.diag(deviation**-2)
    g = np.zeros(TILT)
    g[SCALE] = scale / sd**2
    return N, g


def _is_near(before: CameraPose, now: CameraPose, far: float, turn: float) -> bool:
    """Whether the camera has moved and turned less than by ``far`` m and ``turn`` rad."""
    if np.linalg.norm(now.p_GC - before.p_GC) > far:
        return False
    return bool(np.linalg.norm(now.R_GC - before.R_GC) < turn)
