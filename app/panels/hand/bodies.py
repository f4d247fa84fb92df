"""The hand's bodies in the 3D scene: built once, then only moved and recoloured."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from app.engines.engine import EngineSetup
from app.viewmodels.hand_scene import (
    MARKER_LATELY,
    MARKER_NEVER,
    MARKER_NOW,
    TRAIL_POINTS,
    HandScene,
    ShownParts,
)
from app.viewmodels.states import BLUISH_GREEN, ORANGE, SKY, VALIDITY, YELLOW
from app.widgets.view3d.scene import BodyLook, BodyScene, Grid
from app.widgets.view3d.shapes import Block, Capsule, Disc, Lines, Shape, ball, polyline
from tracker.hand.model import Segment
from tracker.messages import Array, Validity

WHITE = "#FFFFFF"
HAND, REFERENCE = 1, 2  # groups of bodies that look like one where one sees through them
SEGMENT_LOOK = {
    Validity.MEASURED: BodyLook(VALIDITY[Validity.MEASURED].colour, specular=0.2),
    Validity.INFERRED: BodyLook(
        VALIDITY[Validity.INFERRED].colour, opacity=0.55, specular=0.2, grid=Grid.OVER, group=HAND
    ),
    Validity.LOST: BodyLook(VALIDITY[Validity.LOST].colour, opacity=0.5, grid=Grid.ALONE),
}
"""Measured: solid. Inferred: see-through with its grid drawn. Lost: a faint grid."""
REFERENCE_LOOK = BodyLook(WHITE, opacity=0.22, group=REFERENCE)
MARKER_SIZE = {MARKER_NOW: 1.0, MARKER_LATELY: 0.7}
FRUSTUM_DEPTH = 0.05
AXIS_COLOURS = (ORANGE, BLUISH_GREEN, SKY)  # x, y, z, as the curves of the sensors
AXIS_LENGTH = 2.2  # radii of the segment


class HandBodies:
    """One body per segment, marker, fingertip and the camera."""

    def __init__(self, scene: BodyScene, setup: EngineSetup, hue_colours: dict[str, str]) -> None:
        shapes = [segment_shape(s) for s in setup.hand.segments]
        self._segments = [scene.add(s, SEGMENT_LOOK[Validity.LOST]) for s in shapes]
        self._references = [scene.add(s, REFERENCE_LOOK) for s in shapes]
        self._marker_looks = [
            marker_looks(hue_colours.get(m.hue, WHITE)) for m in setup.glove.markers
        ]
        self._markers = [
            scene.add(_patch(m.size / 2, m.normal), looks[MARKER_NOW])
            for m, looks in zip(setup.glove.markers, self._marker_looks, strict=True)
        ]
        tips = sum(n.endswith("_tip") for n in setup.hand.keypoint_names)
        self._tips = [scene.add(ball(1.0), BodyLook(SKY, opacity=0.3)) for _ in range(tips)]
        self._camera = scene.add(_frustum(setup), BodyLook(SKY, line_width=1.5))
        self._trail = scene.add(
            polyline(np.zeros((TRAIL_POINTS, 3))), BodyLook(YELLOW, line_width=2.5)
        )
        self._axes = [
            scene.add(_axis(k, s.radius), BodyLook(colour, line_width=2.0))
            for s in setup.hand.segments
            for k, colour in enumerate(AXIS_COLOURS)
        ]
        self._marker_segment = setup.glove.marker_segment(setup.hand)
        self._has_place = setup.camera_calibrated
        # Nothing has its place before the first hand; a ball of unit size would fill the view.
        for body in (*self._segments, *self._references, *self._markers, *self._tips, *self._axes):
            body.show(False)
        self._camera.show(False)
        self._trail.show(False)

    def update(self, scene: HandScene, show: ShownParts) -> None:
        """Move every body to ``scene``."""
        for i, body in enumerate(self._segments):
            body.show(True)
            body.move(scene.segment_R[i], scene.segment_p[i])
            body.wear(SEGMENT_LOOK[Validity(int(scene.segment_state[i]))])
        self._update_references(scene, show.reference)
        self._update_markers(scene, show.markers)
        self._update_tips(scene, show.uncertainty)
        self._update_axes(scene, show.axes)
        self._update_trail(scene, show.trail)
        self._camera.show(show.camera and self._has_place)
        self._camera.move(scene.R_GC, scene.p_GC)

    def _update_references(self, scene: HandScene, wanted: bool) -> None:
        for i, body in enumerate(self._references):
            body.show(wanted and scene.reference is not None)
            if wanted and scene.reference is not None:
                body.move(scene.reference[0][i], scene.reference[1][i])

    def _update_markers(self, scene: HandScene, wanted: bool) -> None:
        for i, body in enumerate(self._markers):
            state = int(scene.marker_state[i])
            body.show(wanted)
            body.wear(self._marker_looks[i][state])
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


def marker_looks(colour: str) -> dict[int, BodyLook]:
    """Of a marker that is seen now, was seen lately, or never."""
    now = BodyLook(colour, ambient=0.5)
    faint = replace(now, opacity=0.55)
    return {MARKER_NOW: now, MARKER_LATELY: faint, MARKER_NEVER: faint}


def segment_shape(s: Segment) -> Shape:
    """A capsule along x of B, or the dorsum's slab: ``width`` across (y) and two radii thick (z),
    reaching over both ends (x)."""
    if s.width <= 0:
        return Capsule(s.length, s.radius)
    half = np.array([s.length / 2 + 0.6 * s.radius, s.width / 2, s.radius])
    return Block(half, np.array([s.length / 2, 0.0, 0.0]))


def _patch(radius: float, normal: Array) -> Disc:
    """A flat patch, a little proud of the surface so that it is not swallowed by the capsule."""
    return Disc(radius, 0.0015, normal, normal * 0.0005)


def _axis(k: int, radius: float) -> Lines:
    """From the origin along axis ``k`` of B, out of the segment's body."""
    ends = np.zeros((2, 3))
    ends[1, k] = AXIS_LENGTH * radius
    return polyline(ends)


def _frustum(setup: EngineSetup) -> Lines:
    """The left camera's field of view to `FRUSTUM_DEPTH`, in C."""
    rig, z = setup.rig, FRUSTUM_DEPTH
    us, vs = (0, rig.left.width - 1), (0, rig.left.height - 1)
    corners = [(u, v) for u, v in ((us[0], vs[0]), (us[1], vs[0]), (us[1], vs[1]), (us[0], vs[1]))]
    points = [((u - rig.cx) / rig.fx * z, (v - rig.cy) / rig.fy * z, z) for u, v in corners]
    points.append((0.0, 0.0, 0.0))
    pairs = [(0, 1), (1, 2), (2, 3), (3, 0), *((4, i) for i in range(4))]
    return Lines(np.array(points, float), np.array(pairs))
