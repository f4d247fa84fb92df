"""The chain filter's state (docs/chain.md, eq. 2), and the addition of an error vector (eq. 3)."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np

from tracker.base.records import record
from tracker.fusion.chain.layout import Blocks, ChainLayout
from tracker.geometry.kernels import rotate_all
from tracker.kernels import kernel
from tracker.kernels.arrays import Matrix, Stack, Vector, Written
from tracker.messages import Array

SCALE_LIMITS = (0.6, 1.5)


class Dynamic(NamedTuple):
    """The dynamic part: p, v (3,) m, m/s of the root's IMU in G, R_GB (A, 3, 3)."""

    p: Vector
    v: Vector
    R_GB: Stack


class ImuErrors(NamedTuple):
    """For n IMUs: gyro bias bg (n, 3) rad/s, mounting R_IB (n, 3, 3), accel bias ba (n, 3) m/s²."""

    bg: Matrix
    R_IB: Stack
    ba: Matrix


class Body(NamedTuple):
    """Variables on which the position of a point relative to p depends: R_GB (A, 3, 3), scale
    (A, 2) length and girth, joint (B, 3) m."""

    R_GB: Stack
    scale: Matrix
    joint: Matrix


@record(
    "chain.state",
    shapes={
        "p": "3",
        "v": "3",
        "R_GB": "A 3 3",
        "bg": "I 3",
        "R_IB": "I 3 3",
        "ba": "I 3",
        "scale": "A 2",
        "joint": "B 3",
        "marker": "M 3",
        "P": "n n | 0 0",
        "axis": "K | 0",
    },
)
@dataclass(eq=False)
class ChainState:
    """Nominal state and covariance at time ``t``. Shapes: A active segments, n IMUs, M markers.

    p, v (3,) of the root's IMU in G; R_GB (A, 3, 3); bg, ba (n, 3); R_IB (n, 3, 3); scale (A, 2)
    length and girth; joint (B, 3) m in the root's B; marker (M, 3) m in each marker's B;
    axis (K,) values of `ChainLayout.fixed_axes`, whose joints are oblique in this wearer;
    P (N, N) in the order of `ChainLayout`, or (0, 0) where only a calibration is solved for;
    velocity_ratio is the variance of the velocity relative to that of P (eq. 77).
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
    axis: Array = field(default_factory=lambda: np.zeros(0))  # of recordings without it: empty
    velocity_ratio: float = 1.0

    @property
    def dynamic(self) -> Dynamic:
        return Dynamic(self.p, self.v, self.R_GB)

    @property
    def imus(self) -> ImuErrors:
        return ImuErrors(self.bg, self.R_IB, self.ba)

    @property
    def body(self) -> Body:
        return Body(self.R_GB, self.scale, self.joint)

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
        out = np.empty((len(self.scale), 3))
        out[:, :2], out[:, 2] = self.scale, self.scale[:, 1]
        return out


def initial_state(layout: ChainLayout) -> ChainState:
    """A flat hand at the origin with nominal geometry and zero covariance."""
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
        P=np.zeros((layout.blocks.size, layout.blocks.size)),
        axis=np.zeros(len(layout.fixed_axes)),
    )


def inject(state: ChainState, layout: ChainLayout, dx: Array) -> None:
    """Add an error vector (N,) to the nominal state in place; rotations by local perturbation."""
    fitting = Fitting(state.scale, state.joint, state.marker, state.axis)
    state.R_GB, state.R_IB, state.scale = _inject(
        layout.blocks, state.dynamic, state.imus, fitting, np.ascontiguousarray(dx)
    )


class Fitting(NamedTuple):
    """The wearer and the glove: scale (A, 2), joint (B, 3) m, marker (M, 3) m, axis (K,)."""

    scale: Matrix
    joint: Matrix
    marker: Matrix
    axis: Vector


@kernel(nogil=False)
def _inject(
    at: Blocks,
    dynamic: Written[Dynamic],
    imus: Written[ImuErrors],
    fitting: Written[Fitting],
    dx: Vector,
) -> tuple[Stack, Stack, Matrix]:
    """Adds to the vectors in place; R_GB, R_IB and scale are replaced, because other states share
    them."""
    p, v, bg, ba, joint, marker, axis = (
        dynamic.p, dynamic.v, imus.bg, imus.ba, fitting.joint, fitting.marker, fitting.axis
    )  # fmt: skip
    p += dx[0:3]
    v += dx[3:6]
    bg += dx[at.bg : at.phi].reshape(bg.shape)
    ba += dx[at.ba : at.scale].reshape(ba.shape)
    joint += dx[at.joint : at.marker].reshape(joint.shape)
    marker += dx[at.marker : at.axis].reshape(marker.shape)
    axis += dx[at.axis :]
    scale = fitting.scale + dx[at.scale : at.joint].reshape(fitting.scale.shape)
    low, high = SCALE_LIMITS
    for i in range(scale.shape[0]):
        for k in range(scale.shape[1]):
            scale[i, k] = min(max(scale[i, k], low), high)
    # eq. 3: rotations by perturbations on the right
    R_GB = rotate_all(dynamic.R_GB, dx[at.theta : at.bg].reshape(-1, 3))
    return R_GB, rotate_all(imus.R_IB, dx[at.phi : at.ba].reshape(-1, 3)), scale
