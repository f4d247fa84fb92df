"""A pose reset: the wearer holds the hand flat, which corrects drift.

Without a camera no sensor measures the rotation of the hand about the vertical, and that of each
finger is hardly observable: both drift with the gyroscopes' biases. A hand held level, the fingers
straight ahead, determines both. Tilt needs no reset: gravity measures it.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from tracker.base.notices import notice
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.state import ChainState
from tracker.geometry import so3
from tracker.messages import Array, Event

KIND = "pose_reset"
FINGER_SD, THUMB_SD = np.deg2rad(6.0), np.deg2rad(15.0)
"""rad per axis by which the joints of a hand held flat deviate from straight."""
DRIFT_SD = np.deg2rad(25.0)  # rad about the vertical that a finger may have drifted unnoticed
SLIP_SD = np.deg2rad(5.0)  # rad per axis that an IMU may have slipped with the glove's cloth
PASSES = 3  # the rows are applied this many times, each with the variance multiplied by it
MOST_BENT = np.deg2rad(60.0)  # rad: drift cannot bend a finger this far, a fist does
STEEPEST = np.sin(np.deg2rad(60.0))  # of the fingers: the heading is undefined beyond it


def reset_event(t: float) -> Event:
    """Event: the wearer holds the pose at ``t`` (s)."""
    return Event.of(t, KIND, notice("pose_reset.asked"))


def is_reset(event: Event) -> bool:
    """Whether the event requests an alignment with the pose."""
    return event.kind == KIND


def bends(state: ChainState, layout: ChainLayout) -> Array:
    """(A, 3) rad: rotation vectors of the deviation of segments from straight; zero for the
    root."""
    out = np.zeros((len(layout.active), 3))
    for c, a in enumerate(layout.parent):
        if a >= 0:
            out[c] = so3.log(layout.R_rest[c].T @ state.R_GB[a].T @ state.R_GB[c])
    return out


def is_flat(state: ChainState, layout: ChainLayout) -> bool:
    """Whether the fingers are as straight as those of a flat hand after drift."""
    flexion = np.abs(bends(state, layout)[:, 1])
    return bool(flexion[~_is_thumb(layout)].max(initial=0.0) < MOST_BENT)


def flat_rows(state: ChainState, layout: ChainLayout) -> tuple[Array, Array, Array]:
    """H (m, N), innovation r (m,) and variance (m,) rad²: every joint with an IMU is straight."""
    bent, thumb = bends(state, layout), _is_thumb(layout)
    children = [c for c, a in enumerate(layout.parent) if a >= 0 and layout.imu_of[c] >= 0]
    H = np.zeros((3 * len(children), layout.blocks.size))
    for k, c in enumerate(children):
        a = layout.parent[c]
        rows = slice(3 * k, 3 * k + 3)
        # log(R_rel Exp(u)) = log R_rel + J⁻¹ u, with u = θ_c - R_relᵀ R_restᵀ θ_a
        J = _inverse_right_jacobian(bent[c])
        at_c, at_a = (layout.blocks.theta + 3 * i for i in (c, a))
        H[rows, at_c : at_c + 3] = J
        H[rows, at_a : at_a + 3] = -J @ so3.exp(bent[c]).T @ layout.R_rest[c].T
    variance = np.array([(THUMB_SD if thumb[c] else FINGER_SD) ** 2 for c in children])
    return H, -bent[children].ravel(), np.repeat(variance, 3)


def doubt_drift(state: ChainState, layout: ChainLayout, frozen: bool) -> None:
    """Prepares the covariance for the rows where no image is available: segments may have drifted
    about the vertical, and IMUs slipped, by more than the covariance predicts. Gravity still
    determines tilt.

    ``frozen``: the calibration is frozen, so mountings are.
    """
    for c, a in enumerate(layout.parent):
        j = int(layout.imu_of[c])
        if a < 0 or j < 0:
            continue
        theta, phi = (slice(k, k + 3) for k in (layout.blocks.theta + 3 * c, _phi(layout, j)))
        up = state.R_GB[c][2]
        state.P[theta, theta] += DRIFT_SD**2 * np.outer(up, up)
        if not frozen:  # R_GB = R_GI R_IB with R_GI known: both errors are the same (eq. 3)
            for rows in (theta, phi):
                for columns in (theta, phi):
                    state.P[rows, columns] += SLIP_SD**2 * np.eye(3)


def _phi(layout: ChainLayout, imu: int) -> int:
    return layout.blocks.phi + 3 * imu


def heading(R_GB: Array) -> float | None:
    """rad about the vertical from straight ahead (x of G) to the fingers of a dorsum rotated by
    R_GB (3, 3), positive to the left; None where they point up or down."""
    x, y, z = R_GB[:, 0]
    return None if abs(z) > STEEPEST else float(np.arctan2(y, x))


def turn(state: ChainState, angle: float) -> None:
    """Rotates the whole hand about the vertical by ``angle`` rad; errors in G are rotated with
    it."""
    Rz = so3.rz(angle)
    state.p, state.v = Rz @ state.p, Rz @ state.v
    state.R_GB = np.einsum("ij,ajk->aik", Rz, state.R_GB)
    for first in (0, 3):  # p and v; rotations are perturbed in the segments' own axes (eq. 3)
        rows = slice(first, first + 3)
        state.P[rows] = Rz @ state.P[rows]
        state.P[:, rows] = state.P[:, rows] @ Rz.T


def _is_thumb(layout: ChainLayout) -> NDArray[np.bool_]:
    return np.array([name.startswith("thumb") for name in layout.names])


def _inverse_right_jacobian(v: Array) -> Array:
    """(3, 3) J_r⁻¹ of SO(3) at the rotation vector v (3,)."""
    angle = float(np.linalg.norm(v))
    K = so3.skew(v)
    if angle < 1e-6:
        return np.asarray(np.eye(3) + K / 2)
    factor = 1 / angle**2 - (1 + np.cos(angle)) / (2 * angle * np.sin(angle))
    return np.asarray(np.eye(3) + K / 2 + factor * K @ K)
