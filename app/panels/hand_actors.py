"""The hand's bodies in the 3D scene: built once, then only moved and recoloured."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

import numpy as np

from app.engine import EngineSetup
from app.viewmodels.hand_scene import MARKER_LATELY, MARKER_NOW, TRAIL_POINTS, HandScene
from app.viewmodels.states import BLUISH_GREEN, ORANGE, SKY, VALIDITY, YELLOW
from app.widgets.meshes import Mesh, ball, capsule, disc, lines, rounded_block
from tracker.hand.model import Segment
from tracker.messages import Array, Validity

if TYPE_CHECKING:
    from app.widgets.vtk_scene import Bodies

RESOLUTION = 10
"""Sides of a capsule: at 24 the software renderer takes twice as long for no visible gain."""
GREY, WHITE = "#888888", "#FFFFFF"
OPACITY = {Validity.MEASURED: 1.0, Validity.INFERRED: 0.55, Validity.LOST: 0.25}
MARKER_SIZE = {MARKER_NOW: 1.0, MARKER_LATELY: 0.7}
FRUSTUM_DEPTH = 0.05
AXIS_COLOURS = (ORANGE, BLUISH_GREEN, SKY)  # x, y, z, as the curves of the sensors
AXIS_LENGTH = 2.2  # radii of the segment


@dataclass(frozen=True)
class Show:
    """What the user wants to see beside the hand."""

    markers: bool = True
    uncertainty: bool = True
    camera: bool = True
    truth: bool = True
    axes: bool = False
    trail: bool = False


class HandActors:
    """One body per segment, marker, fingertip and the camera."""

    def __init__(self, scene: Bodies, setup: EngineSetup, hue_colours: dict[str, str]) -> None:
        self._states: list[int] = [-1] * len(setup.hand.segments)
        meshes = [segment_mesh(s) for s in setup.hand.segments]
        self._segments = [scene.add(m, GREY, specular=0.2) for m in meshes]
        self._ghosts = [scene.add(m, WHITE, opacity=0.22) for m in meshes]
        self._markers = [
            scene.add(_patch(m.size / 2, m.normal), hue_colours.get(m.hue, WHITE), ambient=0.5)
            for m in setup.glove.markers
        ]
        tips = sum(n.endswith("_tip") for n in setup.hand.keypoint_names)
        self._tips = [scene.add(ball(1.0), SKY, opacity=0.3) for _ in range(tips)]
        self._camera = scene.add(_frustum(setup), SKY, line_width=1.5)
        self._trail = scene.add(_polyline(TRAIL_POINTS), YELLOW, line_width=2.5)
        self._axes = [
            scene.add(_axis(k, s.radius), colour, line_width=2.0)
            for s in setup.hand.segments
            for k, colour in enumerate(AXIS_COLOURS)
        ]
        self._marker_segment = setup.glove.marker_segment(setup.hand)
        # Nothing has its place before the first hand; a ball of unit size would fill the view.
        for body in (*self._segments, *self._ghosts, *self._markers, *self._tips, *self._axes):
            body.show(False)
        self._camera.show(False)
        self._trail.show(False)

    def update(self, scene: HandScene, show: Show) -> None:
        """Move every actor to ``scene``."""
        for i, body in enumerate(self._segments):
            body.show(True)
            body.move(scene.segment_R[i], scene.segment_p[i])
            self._dress(i, int(scene.segment_state[i]))
        self._update_ghosts(scene, show.truth)
        self._update_markers(scene, show.markers)
        self._update_tips(scene, show.uncertainty)
        self._update_axes(scene, show.axes)
        self._update_trail(scene, show.trail)
        self._camera.show(show.camera)
        self._camera.move(scene.R_GC, scene.p_GC)

    def _dress(self, i: int, state: int) -> None:
        """Measured: solid. Inferred: see-through with its mesh drawn. Lost: a faint mesh."""
        if self._states[i] == state:
            return
        self._states[i] = state
        self._segments[i].paint(VALIDITY[state].colour)
        look = self._segments[i].look
        look.SetOpacity(OPACITY[Validity(state)])
        look.SetEdgeVisibility(state == Validity.INFERRED)
        if state == Validity.LOST:
            look.SetRepresentationToWireframe()
        else:
            look.SetRepresentationToSurface()

    def _update_ghosts(self, scene: HandScene, wanted: bool) -> None:
        for i, body in enumerate(self._ghosts):
            body.show(wanted and scene.truth is not None)
            if wanted and scene.truth is not None:
                body.move(scene.truth[0][i], scene.truth[1][i])

    def _update_markers(self, scene: HandScene, wanted: bool) -> None:
        for i, body in enumerate(self._markers):
            state = int(scene.marker_state[i])
            body.show(wanted)
            body.look.SetOpacity(1.0 if state == MARKER_NOW else 0.55)
            size = MARKER_SIZE.get(state, 0.45)
            R = scene.segment_R[self._marker_segment[i]]
            body.move(R * size, scene.markers[i])

    def _update_axes(self, scene: HandScene, wanted: bool) -> None:
        """The frame B of each segment, at its joint."""
        for i, body in enumerate(self._axes):
            body.show(wanted)
            if wanted:
                segment = i // len(AXIS_COLOURS)
                body.move(scene.segment_R[segment], scene.segment_p[segment])

    def _update_trail(self, scene: HandScene, wanted: bool) -> None:
        there = wanted and bool(np.isfinite(scene.trail).all())
        self._trail.show(there)
        if there:
            self._trail.reshape(scene.trail)

    def _update_tips(self, scene: HandScene, wanted: bool) -> None:
        """A ball of 2σ around each fingertip."""
        for i, body in enumerate(self._tips):
            known = bool(np.isfinite(scene.tips[i]).all() and np.isfinite(scene.tip_sd[i]))
            body.show(wanted and known)
            if known:
                radius = max(2 * float(scene.tip_sd[i]), 1e-4)
                body.move(np.eye(3) * radius, scene.tips[i])


def segment_mesh(s: Segment) -> Mesh:
    """A capsule along x of B, or the dorsum's slab with rounded edges."""
    return _slab(s) if s.width > 0 else capsule(s.length, s.radius, RESOLUTION)


def _slab(s: Segment) -> Mesh:
    """A rounded block ``width`` across (y) and two radii thick (z), reaching over both ends (x)."""
    half = np.array([s.length / 2 + 0.6 * s.radius, s.width / 2, s.radius])
    block = rounded_block(half)
    return replace(block, points=block.points + [s.length / 2, 0, 0])


def _patch(radius: float, normal: Array) -> Mesh:
    """A flat patch, a little proud of the surface so that it is not swallowed by the capsule."""
    patch = disc(radius, 0.0015, normal)
    return replace(patch, points=patch.points + normal * 0.0005)


def _polyline(count: int) -> Mesh:
    """A line through ``count`` points, all at the origin yet."""
    return lines(np.zeros((count, 3)), [(i, i + 1) for i in range(count - 1)])


def _axis(k: int, radius: float) -> Mesh:
    """From the origin along axis ``k`` of B, out of the segment's body."""
    ends = np.zeros((2, 3))
    ends[1, k] = AXIS_LENGTH * radius
    return lines(ends, [(0, 1)])


def _frustum(setup: EngineSetup) -> Mesh:
    """The left camera's field of view to `FRUSTUM_DEPTH`, as lines, in C."""
    rig, z = setup.rig, FRUSTUM_DEPTH
    us, vs = (0, rig.left.width - 1), (0, rig.left.height - 1)
    corners = [(u, v) for u, v in ((us[0], vs[0]), (us[1], vs[0]), (us[1], vs[1]), (us[0], vs[1]))]
    points = [((u - rig.cx) / rig.fx * z, (v - rig.cy) / rig.fy * z, z) for u, v in corners]
    points.append((0.0, 0.0, 0.0))
    pairs = [(0, 1), (1, 2), (2, 3), (3, 0), *((4, i) for i in range(4))]
    return lines(np.array(points, float), pairs)
