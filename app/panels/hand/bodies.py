"""The bodies of a hand in the 3D scene: built once, then moved and recoloured."""

from __future__ import annotations

import numpy as np

from app.engines.engine import EngineSetup
from app.viewmodels.hand_scene import (
    AXIS,
    CELL,
    MARKER_NOW,
    MARKER_RECENT,
    TRAIL_POINTS,
    HandGround,
    HandScene,
    ShownParts,
    ribbon,
    ribbon_faces,
)
from app.viewmodels.hand_skin import Draped, HandSkin
from app.viewmodels.states import BLUISH_GREEN, GREY, ORANGE, PURPLE, SKY, VERMILION
from app.widgets.view3d.orbit import Orbit
from app.widgets.view3d.scene import (
    BodyLook,
    BodyScene,
    DrawnSurface,
    GroundLines,
    Label,
    rgb,
)
from app.widgets.view3d.shapes import Lines, Surface, polyline
from tracker.messages import Array, IntArray

WHITE = "#FFFFFF"
FRUSTUM_DEPTH = 0.05
AXIS_COLOURS = (ORANGE, BLUISH_GREEN, SKY)  # x, y, z, as in the sensor plots
AXIS_LENGTH = 2.2  # radii of the segment
TRAIL_PART, PATCH_PART = 1000, 2000  # part numbers beyond those of the segments


LIMIT = 0.015  # m; about half the distance to the next fingertip of a spread hand
SEGMENTS = 40
COLOUR = "#2F86BC"  # visible on both light and dark backgrounds
WHOLE = BodyLook(COLOUR, line_width=1.5)
CROSS_LENGTH = 0.012  # m
CROSS = BodyLook(VERMILION, line_width=2.0)
BROKEN = BodyLook(COLOUR, opacity=0.75, line_width=1.5)


class TipRings:
    """Two rings for each of ``tips`` fingertips, of which at most one is shown."""

    def __init__(self, scene: BodyScene, tips: int) -> None:
        self._whole = scene.add_group([ring(broken=False)] * tips, [WHOLE] * tips)
        self._broken = scene.add_group([ring(broken=True)] * tips, [BROKEN] * tips)

    def update(self, scene: HandScene, wanted: bool, orbit: Orbit) -> None:
        """Draw rings of two standard deviations around the fingertips of ``scene``."""
        if not wanted:
            self._whole.hide()
            self._broken.hide()
            return
        radius = 2 * scene.tip_sd
        known = np.isfinite(scene.tips).all(axis=1) & np.isfinite(radius)
        R = orbit.axes * np.minimum(np.maximum(radius, 1e-4), LIMIT)[:, None, None]
        self._whole.place(known & (radius <= LIMIT), R, scene.tips)
        self._broken.place(known & (radius > LIMIT), R, scene.tips)


def ring(broken: bool) -> Lines:
    """A ring of unit radius about z; ``broken``: dashed."""
    angle = 2 * np.pi * np.arange(SEGMENTS) / SEGMENTS
    points = np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    first = np.arange(0, SEGMENTS, 2 if broken else 1)
    return Lines(points, np.stack([first, (first + 1) % SEGMENTS], axis=1))


def facing(orbit: Orbit) -> Array:
    """(3, 3) rotation that turns z towards the viewer."""
    return orbit.axes


class PointCrosses:
    """A cross at each keypoint of a reference of which not the whole hand is known."""

    def __init__(self, scene: BodyScene, points: int) -> None:
        self._crosses = scene.add_group([_cross()] * points, [CROSS] * points)
        self._upright = np.tile(np.eye(3), (points, 1, 1))

    def update(self, points: Array, wanted: bool) -> None:
        """``points`` (K, 3) m, NaN where none is drawn."""
        known = np.asarray(np.isfinite(points).all(axis=1) & wanted)
        if known.any():
            self._crosses.place(known, self._upright, points)
        else:
            self._crosses.hide()


class HandBodies:
    """Mesh and outline of the hand, patches of the glove, fingertips, axes, trail and camera."""

    def __init__(self, scene: BodyScene, setup: EngineSetup, hue_colours: dict[str, str]) -> None:
        self._scene = scene
        self._colours = [hue_colours.get(m.hue, WHITE) for m in setup.glove.markers]
        self._skin: HandSkin | None = None
        self._marker_state: IntArray | None = None  # of the patches drawn
        tips = sum(n.endswith("_tip") for n in setup.hand.keypoint_names)
        self._tips = TipRings(scene, tips)
        self._points = PointCrosses(scene, len(setup.glove.keypoint_names(setup.hand)))
        self._frustum = _frustum(setup)
        self._camera = scene.add(self._frustum, BodyLook(SKY, line_width=1.5))
        many = len(setup.hand.segments)
        self._axes = scene.add_group(
            [_axis(k, s.radius) for k in range(3) for s in setup.hand.segments],
            [BodyLook(colour, line_width=2.0) for colour in AXIS_COLOURS for _ in range(many)],
        )
        self._axes_shown = np.ones(3 * many, np.bool_)
        self._world = scene.add_group(
            [polyline(np.array([np.zeros(3), AXIS * np.eye(3)[k]])) for k in range(3)],
            [BodyLook(colour) for colour in AXIS_COLOURS],
        )
        self._ground_labels: list[Label] = []
        faces = ribbon_faces(TRAIL_POINTS)
        self._trail = scene.add_surface(
            Surface(faces, np.full(len(faces), TRAIL_PART), np.zeros(2 * TRAIL_POINTS))
        )
        self._ground = HandGround()
        self._has_place = setup.camera.calibrated
        self._camera.show(False)  # no position before the first estimate

    def apply_profile(self, skin: HandSkin) -> None:
        """Use this mesh from now on."""
        self._skin, self._marker_state = skin, None
        surface = Surface(skin.skin.faces, skin.part, skin.skin.along)
        self._hand = self._scene.add_surface(surface)
        self._reference = self._scene.add_outline(surface)
        patches = skin.patches
        self._markers = self._scene.add_surface(
            Surface(patches.faces, np.full(len(patches.faces), PATCH_PART), patches.along)
        )

    def update(self, scene: HandScene, show: ShownParts, orbit: Orbit) -> None:
        """Move all bodies to ``scene``."""
        if self._skin is not None:
            self._update_hand(self._skin, scene, show)
        self._tips.update(scene, show.uncertainty, orbit)
        self._points.update(scene.reference_points, show.reference)
        self._update_axes(scene, show.axes)
        self._update_trail(scene, show.trail, orbit)
        corners = scene.p_GC + self._frustum.points @ scene.R_GC.T
        self._camera.show(show.camera and self._has_place and orbit.sees(corners))
        self._camera.move(scene.R_GC, scene.p_GC)

    def update_ground(self, scene: HandScene) -> list[Label]:
        """Place the ground below the hand; returns its labels."""
        if not self._ground.follow(scene.segment_p):
            return self._ground_labels
        grid = self._ground.grid
        self._scene.set_ground(GroundLines(grid.ends, grid.strength))
        at = np.tile(grid.corner, (3, 1))
        self._world.place(np.ones(3, np.bool_), np.tile(np.eye(3), (3, 1, 1)), at)
        letters = [
            Label(name, grid.corner + 1.15 * AXIS * np.eye(3)[k], AXIS_COLOURS[k])
            for k, name in enumerate("xyz")
        ]
        scale = grid.corner + [0.5 * CELL, -0.2 * CELL, 0.0]
        self._ground_labels = [*letters, Label(f"{CELL * 100:.0f} cm", scale, GREY)]
        return self._ground_labels

    def _update_hand(self, skin: HandSkin, scene: HandScene, show: ShownParts) -> None:
        skin.fit(scene.scale)
        R, p = scene.segment_R, scene.segment_p
        drape(self._hand, skin.draped(R, p, scene.segment_state))
        self._hand.show(True)
        self._markers.show(show.markers)
        if show.markers:
            drape(self._markers, skin.draped_patches(R, p, self._colours))
            self._choose_patches(skin, scene.marker_state)
        self._reference.show(show.reference and scene.reference is not None)
        if show.reference and scene.reference is not None:
            drape(self._reference, skin.plain(*scene.reference))

    def _choose_patches(self, skin: HandSkin, state: IntArray) -> None:
        """Show the parts of the patches that ``state`` (M,) of the markers asks for."""
        if self._marker_state is None or (state != self._marker_state).any():
            self._marker_state = state.copy()
            self._markers.choose(skin.patch_faces(state == MARKER_NOW, state == MARKER_RECENT))

    def _update_axes(self, scene: HandScene, wanted: bool) -> None:
        """Show the frame B of each segment at its joint."""
        if not wanted:
            self._axes.hide()
            return
        R, p = scene.segment_R, scene.segment_p
        self._axes.place(self._axes_shown, np.concatenate([R, R, R]), np.concatenate([p, p, p]))

    def _update_trail(self, scene: HandScene, wanted: bool, orbit: Orbit) -> None:
        there = wanted and bool(np.isfinite(scene.trail).all())
        self._trail.show(there)
        if there:
            self._trail.drape(*ribbon(scene.trail, orbit.eye, rgb(PURPLE)))


def _cross() -> Lines:
    """Three lines through the origin."""
    ends = CROSS_LENGTH / 2 * np.concatenate([np.eye(3), -np.eye(3)])
    return Lines(ends, np.array([[0, 3], [1, 4], [2, 5]]))


def drape(surface: DrawnSurface, draped: Draped) -> None:
    """Update a surface with the vertices of ``draped``."""
    surface.drape(draped.points, draped.normals, draped.looks)


def _axis(k: int, radius: float) -> Lines:
    """A line along axis ``k`` of B that starts at the origin and extends beyond the segment."""
    ends = np.zeros((2, 3))
    ends[1, k] = AXIS_LENGTH * radius
    return polyline(ends)


def _frustum(setup: EngineSetup) -> Lines:
    """The field of view of the left camera up to `FRUSTUM_DEPTH`, in C."""
    rig, z = setup.camera.rig, FRUSTUM_DEPTH
    us, vs = (0, rig.left.width - 1), (0, rig.left.height - 1)
    corners = [(u, v) for u, v in ((us[0], vs[0]), (us[1], vs[0]), (us[1], vs[1]), (us[0], vs[1]))]
    points = [((u - rig.cx) / rig.fx * z, (v - rig.cy) / rig.fy * z, z) for u, v in corners]
    points.append((0.0, 0.0, 0.0))
    pairs = [(0, 1), (1, 2), (2, 3), (3, 0), *((4, i) for i in range(4))]
    return Lines(np.array(points, float), np.array(pairs))
