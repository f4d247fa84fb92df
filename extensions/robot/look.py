"""What a robot and its scene look like: triangles, and where they are moved to."""

from __future__ import annotations

from dataclasses import dataclass

from tracker.messages import Array, IntArray

NO_FINGER = -1


@dataclass(frozen=True, eq=False)
class RobotShape:
    """points, normals (V, 3) in the frame of each point's body; body (V,) its row among those that
    `poses` gives; faces (F, 3); part (F,), one for each body; colour (V, 3) shares of one; finger
    (V,) whose tip a point is of, or `NO_FINGER`."""

    points: Array
    normals: Array
    body: IntArray
    faces: IntArray
    part: IntArray
    colour: Array
    finger: IntArray


@dataclass(frozen=True, eq=False)
class Placed:
    """Where the shape's bodies are: R (B, 3, 3), p (B, 3) m in the robot's world."""

    R: Array
    p: Array
