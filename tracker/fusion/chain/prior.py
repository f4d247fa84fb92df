"""The initial covariance of a filter."""

from __future__ import annotations

import numpy as np

from tracker.fusion.chain.joint_axes import FixedAxis
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import PriorParams
from tracker.messages import Array


def initial_covariance(layout: ChainLayout, prior: PriorParams) -> Array:
    """(N, N). Hand size varies as a whole: lengths share a common factor, girths another."""
    P = np.zeros((layout.blocks.size, layout.blocks.size))
    d = np.zeros(layout.blocks.size)
    d[0:3] = prior.position**2
    d[3:6] = prior.first_velocity**2
    d[layout.blocks.theta : layout.n_dynamic] = prior.rotation**2
    d[layout.blocks.bg : layout.blocks.phi] = prior.gyro_bias**2
    d[layout.blocks.phi : layout.blocks.ba] = prior.mounting**2
    d[layout.blocks.ba : layout.blocks.scale] = prior.accel_bias**2
    length = slice(layout.blocks.scale, layout.blocks.joint, 2)
    girth = slice(layout.blocks.scale + 1, layout.blocks.joint, 2)
    d[length], d[girth] = prior.own_length**2, prior.own_girth**2
    d[layout.blocks.joint : layout.blocks.marker] = prior.joint**2
    d[layout.blocks.axis :] = [_axis_variance(layout, a, prior) for a in layout.fixed_axes]
    np.fill_diagonal(P, d)
    # eq. 19
    P[length, length] += prior.common_length**2
    P[girth, girth] += prior.common_girth**2
    P[length, girth] = P[girth, length] = prior.alike * prior.common_length * prior.common_girth
    _put_markers(P, layout, prior)
    return P


def _axis_variance(layout: ChainLayout, axis: FixedAxis, prior: PriorParams) -> float:
    of_thumb = layout.names[axis.child].startswith("thumb")
    return (prior.thumb_axis if of_thumb else prior.axis) ** 2


def _put_markers(P: Array, layout: ChainLayout, prior: PriorParams) -> None:
    """Patches are misplaced along the cloth, hardly normal to it (eq. 19)."""
    for k, normal in enumerate(layout.glove.marker_normal):
        rows = slice(layout.blocks.marker + 3 * k, layout.blocks.marker + 3 * k + 3)
        off = np.outer(normal, normal) / (normal @ normal)
        P[rows, rows] = prior.marker**2 * (np.eye(3) - off) + prior.marker_normal**2 * off


def reset_pose(P: Array, layout: ChainLayout, prior: PriorParams) -> None:
    """Resets the pose (p, v, theta) and its correlations; the calibration is unchanged."""
    n = layout.n_dynamic
    P[:n, :] = 0.0
    P[:, :n] = 0.0
    d = np.concatenate(
        [
            np.full(3, prior.position**2),
            np.full(3, prior.velocity**2),
            np.full(n - 6, prior.rotation**2),
        ]
    )
    P[np.arange(n), np.arange(n)] = d
