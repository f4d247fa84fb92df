"""How a tracker is fixed to the hand, from a movement that both sense.

The hand is turned in all directions while the wrist rests on a point. With R_GB by the glove's IMUs
and R_WT by the tracking system, R_GB R_BT = Rz(yaw) R_WT: relative rotations of both are the same
up to R_BT, and so are the directions of the vertical, whatever the heading of the glove has drifted
by (Park and Martin 1994, doi:10.1109/70.326576). The wrist w_B stays where it is, so
p_WT = c + R_WT d with d = R_BTᵀ (p_BT - w_B). Both are solved by reweighted least squares.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from tracker.base.errors import GlovetrackError
from tracker.base.notices import Notice, failure
from tracker.geometry import so3
from tracker.messages import Array

RATE = 100.0  # Hz, to which both are resampled
MOST_DELAY, LEAST_DELAY = 0.3, -0.1  # s
APART = (0.15, 0.3, 0.6)  # s between two instants of a relative rotation
LEAST_TURN = np.deg2rad(12.0)  # of a relative rotation that is used
HUBER_ROTATION, HUBER_POSITION = np.deg2rad(3.0), 0.004  # rad, m
PASSES = 15
LEAST_AXES = 0.06  # share of the second axis in all turns, below which they are about one axis
MOST_RMS, MOST_RMS_M = np.deg2rad(8.0), 0.02  # residuals of a movement that can be used
LEAST_SPAN = 4.0  # s
MEDIAN = 15  # speeds, of 5 ms each
WILD = 0.2  # rad
LONGEST_GAP = 0.1  # s between measurements that are interpolated
BoolArray = NDArray[np.bool_]


class AlignmentError(GlovetrackError):
    """The movement does not determine how the tracker is fixed."""


@dataclass(frozen=True, eq=False)
class Moved:
    """A movement as the glove and the tracking system sensed it.

    t_B (N,) s, R_GB (N, 3, 3) and angular speed (N,) rad/s of the root segment by its IMU; t_T
    (M,) s, R_WT (M, 3, 3) and p_WT (M, 3) m of the tracker; w_B (3,) m is the wrist in B. Instants
    increase.
    """

    t_B: Array
    R_GB: Array
    speed: Array
    t_T: Array
    R_WT: Array
    p_WT: Array
    w_B: Array


@dataclass(frozen=True, eq=False)
class Alignment:
    """p_BT (3,) m and q_BT (4,) xyzw of a tracker in the root segment's B; ``delay`` (s) by which
    its stamps are late; ``yaw`` (rad) about the vertical from the room to the frame of the IMUs
    during the movement. Residuals: rms of rotations (rad) and of positions (m)."""

    p_BT: Array
    q_BT: Array
    delay: float = 0.0
    yaw: float = 0.0
    rotation_rms: float = 0.0
    position_rms: float = 0.0

    @staticmethod
    def identity() -> Alignment:
        """For a tracker whose frame is the segment's."""
        return Alignment(np.zeros(3), np.array([0.0, 0.0, 0.0, 1.0]))


def solve(moved: Moved) -> Alignment:
    """Returns the alignment. Raises AlignmentError for a movement that does not determine it."""
    if min(_span(moved.t_B), _span(moved.t_T)) < LEAST_SPAN:
        raise AlignmentError(failure("room.too_short", least_s=LEAST_SPAN))
    moved = without_wild(moved)
    delay = delay_of(moved)
    t = np.arange(
        max(moved.t_B[0], moved.t_T[0] - delay), min(moved.t_B[-1], moved.t_T[-1] - delay), 1 / RATE
    )
    R_GB = rotations_at(moved.t_B, moved.R_GB, t)
    R_WT = rotations_at(moved.t_T - delay, moved.R_WT, t)
    measured = _is_near(moved.t_B, t) & _is_near(moved.t_T - delay, t)
    R_BT, rotation_rms = _rotation(R_GB, R_WT, measured)
    _check(
        rotation_rms < MOST_RMS, failure("room.rotations_differ", rms_deg=np.rad2deg(rotation_rms))
    )
    d, position_rms = _pivot(moved.R_WT, moved.p_WT)
    _check(position_rms < MOST_RMS_M, failure("room.wrist_moved", rms_mm=1e3 * position_rms))
    D = (R_GB @ R_BT @ np.swapaxes(R_WT, 1, 2))[measured]
    yaw = np.arctan2(D[:, 1, 0] - D[:, 0, 1], D[:, 0, 0] + D[:, 1, 1])
    mean = float(np.angle(np.mean(np.exp(1j * yaw))))
    p_BT = moved.w_B + R_BT @ d
    return Alignment(p_BT, so3.quat_from_matrix(R_BT), delay, mean, rotation_rms, position_rms)


def without_wild(moved: Moved) -> Moved:
    """The movement without poses that differ by more than `WILD` from both neighbours."""
    steps = np.linalg.norm(so3.log(np.swapaxes(moved.R_WT[:-1], 1, 2) @ moved.R_WT[1:]), axis=1)
    wild = np.zeros(len(moved.t_T), bool)
    wild[1:-1] = (steps[:-1] > WILD) & (steps[1:] > WILD)
    kept = ~wild
    return replace(moved, t_T=moved.t_T[kept], R_WT=moved.R_WT[kept], p_WT=moved.p_WT[kept])


def delay_of(moved: Moved) -> float:
    """s by which the tracker's stamps are late: where both angular speeds correlate most."""
    begin, end = max(moved.t_B[0], moved.t_T[0]) + 0.4, min(moved.t_B[-1], moved.t_T[-1]) - 0.4
    t = np.arange(begin, end, 1 / RATE)
    t = t[_is_near(moved.t_B, t)]
    at, speed = _speed(moved.t_T, moved.R_WT)
    near, most = _is_near(moved.t_T, at), float(moved.speed.max())
    tracker = at[near], np.minimum(speed, most)[near]
    shifts = np.arange(LEAST_DELAY, MOST_DELAY, 0.5 / RATE)
    fixed = np.interp(t, moved.t_B, moved.speed)
    found = [_correlation(t + s, fixed, moved.t_T, tracker) for s in shifts]
    k = int(np.argmax(found))
    if found[k] < 0.7 or not 0 < k < len(shifts) - 1:
        raise AlignmentError(failure("room.movements_differ", correlation=float(found[k])))
    a, b, c = found[k - 1 : k + 2]
    return float(shifts[k] + 0.5 * (a - c) / (a - 2 * b + c) * (shifts[1] - shifts[0]))


def _span(t: Array) -> float:
    return float(t[-1] - t[0]) if len(t) > 1 else 0.0


def _is_near(t: Array, at: Array) -> BoolArray:
    """(n,) whether there is a measurement on both sides, close to each of the instants ``at``."""
    k = np.clip(np.searchsorted(t, at, side="right") - 1, 0, len(t) - 2)
    return np.asarray(t[k + 1] - t[k] < LONGEST_GAP)


def rotations_at(t: Array, R: Array, at: Array) -> Array:
    """(n, 3, 3) rotations interpolated on great arcs at other instants."""
    k = np.clip(np.searchsorted(t, at, side="right") - 1, 0, len(t) - 2)
    share = np.clip((at - t[k]) / np.maximum(t[k + 1] - t[k], 1e-9), 0.0, 1.0)
    turn = so3.log(np.swapaxes(R[k], 1, 2) @ R[k + 1])
    out: Array = R[k] @ so3.exp(share[:, None] * turn)
    return out


def _correlation(at: Array, fixed: Array, t_T: Array, tracker: tuple[Array, Array]) -> float:
    """Between ``fixed`` (n,) and the tracker's speed at the instants ``at`` (n,), without gaps."""
    near = _is_near(t_T, at)
    return float(np.corrcoef(fixed[near], np.interp(at[near], *tracker))[0, 1])


def _speed(t: Array, R: Array) -> tuple[Array, Array]:
    """Instants (n,) s and angular speeds (n,) rad/s over 50 ms there, without single wild poses."""
    at = np.arange(t[0] + 0.025, t[-1] - 0.025, 0.5 / RATE)
    before, after = rotations_at(t, R, at - 0.025), rotations_at(t, R, at + 0.025)
    speed = np.linalg.norm(so3.log(np.swapaxes(before, 1, 2) @ after), axis=1) / 0.05
    around = np.pad(speed, MEDIAN // 2, mode="edge")
    return at, np.median(np.lib.stride_tricks.sliding_window_view(around, MEDIAN), axis=1)


def _rotation(R_GB: Array, R_WT: Array, measured: BoolArray) -> tuple[Array, float]:
    """R_BT (3, 3), and the rms (rad) of what remains; from instants that both ``measured``."""
    a, b, pairs = [], [], 0
    for seconds in APART:
        n = round(seconds * RATE)
        turn_B = so3.log(np.swapaxes(R_GB[:-n], 1, 2) @ R_GB[n:])
        turn_T = so3.log(np.swapaxes(R_WT[:-n], 1, 2) @ R_WT[n:])
        large = np.linalg.norm(turn_B, axis=1) > LEAST_TURN
        large &= measured[:-n] & measured[n:]
        a.append(turn_B[large])
        b.append(turn_T[large])
        pairs += int(large.sum())
    turns = np.concatenate(b) if pairs else np.zeros((0, 3))
    axes = np.linalg.svd(turns, compute_uv=False) ** 2 if len(turns) >= 3 else np.zeros(3)
    share = float(axes[1] / max(axes.sum(), 1e-12))
    _check(share > LEAST_AXES, failure("room.one_axis"))
    a.append(R_GB[measured, 2])  # the vertical in B, and in T
    b.append(R_WT[measured, 2])
    of_B, of_T = np.concatenate(a), np.concatenate(b)
    weight = np.ones(len(of_B))
    for _ in range(PASSES):
        R_BT = _wahba(of_B, of_T, weight)
        away = np.linalg.norm(of_B - of_T @ R_BT.T, axis=1)
        weight = np.minimum(1.0, HUBER_ROTATION / np.maximum(away, 1e-12))
    rms = float(np.sqrt(np.average(away**2, weights=weight)))
    return R_BT, rms


def _wahba(a: Array, b: Array, weight: Array) -> Array:
    """The rotation R (3, 3) with a = R b (n, 3) in weighted least squares."""
    u, _, vt = np.linalg.svd((weight[:, None] * a).T @ b)
    out: Array = u @ np.diag([1.0, 1.0, np.linalg.det(u) * np.linalg.det(vt)]) @ vt
    return out


def _pivot(R_WT: Array, p_WT: Array) -> tuple[Array, float]:
    """d (3,) m in T from the wrist to the tracker, and the rms (m) of what remains."""
    n = len(R_WT)
    A = np.concatenate([np.tile(np.eye(3), (n, 1)), R_WT.reshape(3 * n, 3)], axis=1)
    y, weight = p_WT.ravel(), np.ones(n)
    for _ in range(PASSES):
        root = np.sqrt(np.repeat(weight, 3))
        solution = np.linalg.lstsq(root[:, None] * A, root * y, rcond=None)[0]
        away = np.linalg.norm((y - A @ solution).reshape(n, 3), axis=1)
        weight = np.minimum(1.0, HUBER_POSITION / np.maximum(away, 1e-12))
    return solution[3:], float(np.sqrt(np.average(away**2, weights=weight)))


def _check(good: bool, problem: Notice) -> None:
    if not good:
        raise AlignmentError(problem)
