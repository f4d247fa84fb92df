"""Axes about which joints do not rotate (docs/chain.md, eqs. 32 to 34).

With R_rel = R_rest^T R_GBa^T R_GBc = Rz(abduction) Ry(flexion) Rx(twist), a joint without twist has
e_z^T R_rel e_y = 0 and a hinge e_x^T R_rel e_y = 0 as well. (A joint free to twist has no such
linear form and is not constrained.)
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from tracker.hand.model import HandModel
from tracker.messages import Array, IntArray

E_X, E_Y, E_Z = np.eye(3)


class FixedAxis(NamedTuple):
    """One row e^T R_rel f = 0 of the joint at active segment ``child``; ``stiff``: of a rotation
    that the joint hardly allows, rather than of one that it does not have."""

    child: int
    e: Array
    f: Array
    stiff: bool = False


def fixed_axes(hand: HandModel, names: Sequence[str], parent: IntArray) -> tuple[FixedAxis, ...]:
    """The rows of all joints between active segments ``names``, with ``parent`` (A,)."""
    out: list[FixedAxis] = []
    for child, name in enumerate(names):
        joint = hand.joint_of.get(name)
        if parent[child] < 0:
            continue
        free = () if joint is None else joint.axes
        if "twist" in free:
            continue
        out.append(FixedAxis(child, E_Z, E_Y))  # eq. 32
        if "abduction" not in free:
            out.append(FixedAxis(child, E_X, E_Y))  # eq. 33
        elif joint is not None and "abduction" in joint.stiff:
            out.append(FixedAxis(child, E_X, E_Y, stiff=True))
        if "flexion" not in free:
            out.append(FixedAxis(child, E_X, E_Z))  # eq. 34
    return tuple(out)
