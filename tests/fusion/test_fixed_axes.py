"""Oblique joint axes: rows of anatomy that repeat a constant error."""

import numpy as np

from tracker.fusion.chain.filter import ChainFilter
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import ChainParams
from tracker.fusion.time.imu_buffer import ImuBuffer
from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel

OBLIQUE = 0.08  # rad about each axis: 1.3 of the population's standard deviations


def test_rows_repeated_for_ten_seconds_are_no_surer_than_the_axes(
    hand: HandModel, glove: GloveModel
) -> None:
    """With rows that count as independent, 330 of 0.15 rad claim 8 mrad at an error of 80."""
    layout, params = ChainLayout(hand, glove), ChainParams()
    filter_ = ChainFilter(layout, params, ImuBuffer(len(glove.imus)))
    state = filter_.state
    child = layout.names.index("index_intermediate")
    state.R_GB = state.R_GB.copy()
    state.R_GB[child] = state.R_GB[child] @ so3.exp(np.array([OBLIQUE, 0.0, -OBLIQUE]))
    true, R_parent = state.R_GB[child].copy(), state.R_GB[layout.parent[child]].copy()
    for k in range(330):
        assert filter_.constrain(1.001 * k * params.constraint.period)
    now, theta = filter_.state, layout.blocks.theta
    turned = np.zeros((3, layout.blocks.size))
    R_ca = now.R_GB[child].T @ now.R_GB[layout.parent[child]]
    turned[:, theta + 3 * child : theta + 3 * child + 3] = np.eye(3)
    first = theta + 3 * layout.parent[child]
    turned[:, first : first + 3] = -R_ca
    error = so3.log(now.R_GB[child].T @ now.R_GB[layout.parent[child]] @ R_parent.T @ true)
    sd = np.sqrt(np.diag(turned @ now.P @ turned.T))
    for axis in (0, 2):  # twist and abduction, which the rows constrain
        assert 0.02 < abs(error[axis]) < 2 * sd[axis]
    values = now.axis[[k for k, a in enumerate(layout.fixed_axes) if a.child == child]]
    assert np.abs(values).max() > 0.1 * OBLIQUE, "by the axes' share of the initial variance"
