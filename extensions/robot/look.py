"""Appearance of a robot and its scene: triangles and the poses of their bodies."""

from __future__ import annotations

from dataclasses import dataclass

from tracker.messages import Array, IntArray

NO_FINGER = -1


@dataclass(frozen=True, eq=False)
class RobotShape:
    """points, normals (V, 3) in the frame of each point's body; body (V,) the body's row in
    `Placed`; faces (F, 3); part (F,), one number per body; colour (V, 3) from 0 to 1; finger (V,)
    the finger whose tip a point belongs to, or `NO_FINGER`."""

    points: Array
    normals: Array
    body: IntArray
    faces: IntArray
    part: IntArray
    colour: Array
    finger: IntArray


@dataclass(frozen=True, eq=False)
class Placed:
    """Poses of the shape's bodies: R (B, 3, 3), p (B, 3) m in the robot's world."""

    R: Array
    p: Array
