"""The paper's states (eqs. 7 and 8) for all segments, and the joint covariance of their errors."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

import numpy as np

from tracker.base.records import record
from tracker.fusion.chain.kinematics import segment_positions
from tracker.fusion.chain.state import SCALE_LIMITS, ChainState, initial_state
from tracker.fusion.vist.layout import BA, BG, ERRORS, LAM, PHI, TH, P, V, VistLayout
from tracker.fusion.vist.params import VistPrior
from tracker.geometry.kernels import rotate_all
from tracker.messages import Array


@record(
    "vist.state",
    shapes={
        "p_GI": "n 3",
        "v_GI": "n 3",
        "R_GI": "n 3 3",
        "bg": "n 3",
        "ba": "n 3",
        "scale": "n 3",
        "R_IB": "n 3 3",
        "P": "21n 21n",
        "held_back": "2 3",
    },
)
@dataclass(eq=False)
class VistState:
    """Nominal state (eqs. 7 and 8 of Lee et al. 2021, doi:10.1126/scirobotics.abe1315) and
    covariance at time ``t``; n segments, rows as in `VistLayout`.

    p_GI, v_GI (n, 3) m, m/s of each IMU in G; R_GI (n, 3, 3); bg, ba (n, 3); scale (n, 3) lambda_B;
    R_IB (n, 3, 3); P (21 n, 21 n). held_back (2, 3) m, m/s: the difference in position and velocity
    between the damped motion of an unseen hand and the IMU integral, whose covariance P is.
    """

    t: float
    p_GI: Array
    v_GI: Array
    R_GI: Array
    bg: Array
    ba: Array
    scale: Array
    R_IB: Array
    P: Array
    held_back: Array = field(default_factory=lambda: np.zeros((2, 3)))

    def copy(self) -> VistState:
        """An independent copy."""
        arrays = {k: v.copy() for k, v in vars(self).items() if isinstance(v, np.ndarray)}
        return VistState(t=self.t, **arrays)

    def copy_nominal(self) -> VistState:
        """A copy that shares every array: propagation replaces them."""
        return replace(self)

    @property
    def R_GB(self) -> Array:
        """(n, 3, 3) orientation of each segment."""
        return self.R_GI @ self.R_IB

    def p_GB(self, layout: VistLayout) -> Array:
        """(n, 3) m, each segment's proximal joint: the IMU's position scales with the segment."""
        return self.p_GI - np.einsum("nij,nj->ni", self.R_GB, self.scale * layout.imu_position)


def inject(state: VistState, dx: Array) -> None:
    """Add an error vector (21 n,) to the nominal state; rotations by local perturbation."""
    e = dx.reshape(-1, ERRORS)
    state.p_GI = state.p_GI + e[:, P : P + 3]
    state.v_GI = state.v_GI + e[:, V : V + 3]
    state.R_GI = rotate_all(state.R_GI, np.ascontiguousarray(e[:, TH : TH + 3]))
    state.bg = state.bg + e[:, BG : BG + 3]
    state.ba = state.ba + e[:, BA : BA + 3]
    state.scale = np.clip(state.scale + e[:, LAM : LAM + 3], *SCALE_LIMITS)
    state.R_IB = rotate_all(state.R_IB, np.ascontiguousarray(e[:, PHI : PHI + 3]))


def initial_covariance(layout: VistLayout, prior: VistPrior) -> Array:
    """(21 n, 21 n). Hand size varies as a whole: lengths share a common factor, and so do
    girths."""
    sd = np.empty(ERRORS)
    sd[P : P + 3], sd[V : V + 3] = prior.position, prior.velocity
    sd[TH : TH + 3], sd[PHI : PHI + 3] = prior.rotation, prior.mounting
    sd[BG : BG + 3], sd[BA : BA + 3] = prior.gyro_bias, prior.accel_bias
    sd[LAM : LAM + 3] = prior.own_length, prior.own_girth, prior.own_girth
    out = np.diag(np.tile(sd**2, layout.n))
    length = np.arange(LAM, layout.size, ERRORS)
    girth = np.concatenate([length + 1, length + 2])
    out[np.ix_(length, length)] += prior.common_length**2
    out[np.ix_(girth, girth)] += prior.common_girth**2
    return out


def reset_motion(P_: Array, layout: VistLayout, prior: VistPrior) -> None:
    """Resets p, v and theta and their correlations; the calibration is unchanged."""
    rows = (ERRORS * np.arange(layout.n)[:, None] + np.arange(BG)).ravel()
    P_[rows, :] = 0.0
    P_[:, rows] = 0.0
    sd = np.repeat([prior.position, prior.velocity, prior.rotation], 3)
    P_[rows, rows] = np.tile(sd**2, layout.n)


def blank_state(layout: VistLayout) -> VistState:
    """A flat hand at the origin, with zero covariance."""
    return from_chain(layout, initial_state(layout.chain))


def from_chain(layout: VistLayout, chain: ChainState) -> VistState:
    """The state of free segments with the poses of a chain; P is left at zero."""
    j = layout.imu_of
    R_IB, scale = chain.R_IB[j], chain.scale3()
    p_GB = segment_positions(chain, layout.chain)
    p_GI = p_GB + np.einsum("nij,nj->ni", chain.R_GB, scale * layout.imu_position)
    return VistState(
        t=chain.t,
        p_GI=p_GI,
        v_GI=np.tile(chain.v, (layout.n, 1)),
        R_GI=np.ascontiguousarray(chain.R_GB @ R_IB.swapaxes(1, 2)),
        bg=chain.bg[j].copy(),
        ba=chain.ba[j].copy(),
        scale=scale.copy(),
        R_IB=R_IB.copy(),
        P=np.zeros((layout.size, layout.size)),
    )


def as_chain(layout: VistLayout, state: VistState) -> ChainState:
    """A chain with the same articulation, for the shared search; without covariance."""
    chain = initial_state(layout.chain)
    chain.t, chain.p, chain.R_GB = state.t, state.p_GI[0].copy(), state.R_GB
    chain.scale = np.column_stack([state.scale[:, 0], state.scale[:, 1:].mean(axis=1)])
    chain.R_IB[layout.imu_of] = state.R_IB
    return chain
