"""The chain filter's state: what changes, and how an error vector is added to it."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from tracker.fusion.chain.layout import ChainLayout
from tracker.geometry.kernels import rotate_all
from tracker.kernels import kernel
from tracker.messages import Array

SCALE_LIMITS = (0.6, 1.5)
LENGTH_GIRTH_GIRTH = np.array([0, 1, 1])


@dataclass(eq=False)
class ChainState:
    """Nominal state and covariance at time ``t``. Shapes: A active segments, n IMUs, M markers.

    p, v (3,) of the root's IMU in G; R_GB (A, 3, 3); bg, ba (n, 3); R_IB (n, 3, 3); scale (A, 2)
    length and girth; joint (B, 3) m in the root's B; marker (M, 3) m in each marker's B;
    P (N, N) in the order of `ChainLayout`.
    """

    t: float
    p: Array
    v: Array
    R_GB: Array
    bg: Array
    R_IB: Array
    ba: Array
    scale: Array
    joint: Array
    marker: Array
    P: Array

    def copy(self) -> ChainState:
        """An independent copy."""
        out = replace(self)
        for name, value in vars(self).items():
            if isinstance(value, np.ndarray):
                setattr(out, name, value.copy())
        return out

    def copy_nominal(self) -> ChainState:
        """A copy that shares every array: for trying other poses, whose arrays are replaced."""
        return replace(self)

    def scale3(self) -> Array:
        """(A, 3) factors along B: length, girth, girth."""
        return self.scale.take(LENGTH_GIRTH_GIRTH, axis=1)


def initial_state(layout: ChainLayout) -> ChainState:
    """A flat hand at the origin with nominal geometry and no certainty (P is zero)."""
    n, a = len(layout.glove.imus), len(layout.active)
    R = np.empty((a, 3, 3))
    for i in range(a):
        parent = layout.parent[i]
        R[i] = np.eye(3) if parent < 0 else R[parent] @ layout.R_rest[i]
    return ChainState(
        t=0.0,
        p=np.zeros(3),
        v=np.zeros(3),
        R_GB=R,
        bg=np.zeros((n, 3)),
        R_IB=layout.R_IB.copy(),
        ba=np.zeros((n, 3)),
        scale=np.ones((a, 2)),
        joint=np.zeros((int(np.sum(layout.base_of >= 0)), 3)),
        marker=np.zeros((len(layout.glove.markers), 3)),
        P=np.zeros((layout.size, layout.size)),
    )


def inject(state: ChainState, layout: ChainLayout, dx: Array) -> None:
    """Add an error vector (N,) to the nominal state in place; rotations by local perturbation."""
    state.R_GB, state.R_IB, state.scale = _inject(
        state.p, state.v, state.R_GB, state.bg, state.R_IB, state.ba, state.scale, state.joint,
        state.marker, np.ascontiguousarray(dx), layout.theta, layout.bg, layout.phi, layout.ba,
        layout.scale, layout.joint, layout.marker,
    )  # fmt: skip


@kernel
def _inject(  # type: ignore[no-untyped-def]
    p, v, R_GB, bg, R_IB, ba, scale, joint, marker, dx,
    theta_at, bg_at, phi_at, ba_at, scale_at, joint_at, marker_at,
):  # fmt: skip
    """Adds to the vectors in place; what other states share comes back anew."""
    p += dx[0:3]
    v += dx[3:6]
    bg += dx[bg_at:phi_at].reshape(bg.shape)
    ba += dx[ba_at:scale_at].reshape(ba.shape)
    joint += dx[joint_at:marker_at].reshape(joint.shape)
    marker += dx[marker_at:].reshape(marker.shape)
    scale = scale + dx[scale_at:joint_at].reshape(scale.shape)
    low, high = SCALE_LIMITS
    for i in range(scale.shape[0]):
        for k in range(scale.shape[1]):
            scale[i, k] = min(max(scale[i, k], low), high)
    turned = rotate_all(R_GB, dx[theta_at:bg_at].reshape(-1, 3))
    return turned, rotate_all(R_IB, dx[phi_at:ba_at].reshape(-1, 3)), scale
