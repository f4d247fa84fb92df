"""Points fixed to segments: their position in G, and its derivatives by the errors.

A point at the nominal lever d from its segment's IMU (in B) is at  z = p_GI + R_GB (lambda∘d):

    dz/dp = I,  dz/dth = -R_GI [R_IB u]x,  dz/dphi = -R_GB [u]x,  dz/dlambda = R_GB D(d)

with u = lambda∘d. This is H of eq. 10 (Lee et al. 2021), derived independently; the paper's
derivation is its note S6.
"""

from __future__ import annotations

import numpy as np

from tracker.fusion.vist.layout import ERRORS, LAM, PHI, TH, P
from tracker.fusion.vist.state import VistState
from tracker.geometry import so3
from tracker.messages import Array, IntArray


def positions(state: VistState, segment: IntArray, lever: Array) -> Array:
    """(k, 3) m in G of points on the segments (k,) at nominal levers (k, 3)."""
    u = state.scale[segment] * lever
    return state.p_GI[segment] + np.einsum("kij,kj->ki", state.R_GB[segment], u)


def jacobians(state: VistState, segment: IntArray, lever: Array) -> Array:
    """J_point_error (k, 3, 21): each with respect to the errors of its own segment."""
    R_GB = state.R_GB[segment]
    R_skew = R_GB @ so3.skew(state.scale[segment] * lever)
    out = np.zeros((len(segment), 3, ERRORS))
    out[:, :, P : P + 3] = np.eye(3)
    out[:, :, TH : TH + 3] = -R_skew @ state.R_IB[segment].swapaxes(1, 2)
    out[:, :, LAM : LAM + 3] = R_GB * lever[:, None, :]
    out[:, :, PHI : PHI + 3] = -R_skew
    return out


def in_joint_rows(blocks: Array, segment: IntArray, size: int) -> Array:
    """Rows (k, 3, size) of the joint error vector from blocks (k, 3, 21)."""
    out = np.zeros((len(blocks), 3, size))
    for k, s in enumerate(segment):
        out[k, :, ERRORS * s : ERRORS * (s + 1)] = blocks[k]
    return out


def own_covariance(state: VistState, blocks: Array, segment: IntArray) -> Array:
    """(k, 3, 3) m² covariance of points, from the covariance of their own segments."""
    n = len(state.p_GI)
    diagonal = state.P.reshape(n, ERRORS, n, ERRORS)[segment, :, segment, :]
    return blocks @ diagonal @ blocks.swapaxes(1, 2)
