"""Axis conventions of other programs."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial.transform import Rotation

from tracker.messages import Array
from tracker.session.export.series import EstimateSeries

_MIRROR = np.diag([1.0, -1.0, 1.0])


@dataclass(frozen=True, eq=False)
class Axes:
    """``rows`` (3, 3): the new axes in G (x forward, y left, z up)."""

    rows: Array
    description: str

    @property
    def left_handed(self) -> bool:
        return bool(np.linalg.det(self.rows) < 0)


_FORWARD, _LEFT, _UP = np.eye(3)
_Z_UP = Axes(np.array([_FORWARD, _LEFT, _UP]), "x forward, y left, z up")
_Y_UP = Axes(np.array([-_LEFT, _UP, -_FORWARD]), "x right, y up, z backward")
AXES = {
    "z-up": _Z_UP,
    "y-up": _Y_UP,
    "ros": _Z_UP,  # REP 103
    "opengl": _Y_UP,  # and OpenXR, glTF, Maya
    "opensim": Axes(np.array([_FORWARD, _UP, -_LEFT]), "x forward, y up, z right"),
    "blender": Axes(np.array([-_LEFT, _FORWARD, _UP]), "x right, y forward, z up"),
    "unity": Axes(np.array([-_LEFT, _UP, _FORWARD]), "x right, y up, z forward, left-handed"),
    "unreal": Axes(np.array([_FORWARD, -_LEFT, _UP]), "x forward, y right, z up, left-handed"),
}


def turned(m: EstimateSeries, name: str, own: str = "z-up") -> EstimateSeries:
    """Converts positions and orientations from the axes ``own`` to the axes ``name``.

    A bone's own axes do not change (x along it, z dorsal); in left-handed axes its y is reversed,
    so that an orientation remains a rotation.
    """
    axes = AXES[name]
    rows = axes.rows @ AXES[own].rows.T
    if np.array_equal(rows, np.eye(3)):
        return m
    return replace(
        m,
        keypoints=m.keypoints @ rows.T,
        q=_turned(m.q, rows, axes.left_handed),
        segment_p=m.segment_p @ rows.T,
        segment_q=_turned(m.segment_q, rows, axes.left_handed),
    )


def _turned(given: Array, rows: Array, left_handed: bool) -> Array:
    """Orientations (N, n, 4) in the axes ``rows`` (3, 3)."""
    q = np.full_like(given, np.nan)
    known = np.isfinite(given).all(axis=-1)
    if known.any():
        own = _MIRROR if left_handed else np.eye(3)
        R = rows @ Rotation.from_quat(given[known]).as_matrix() @ own
        q[known] = Rotation.from_matrix(R).as_quat()
    return q
