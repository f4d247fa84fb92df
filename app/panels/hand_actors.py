"""The hand's bodies in a pyvista plotter: built once, then only moved and recoloured."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
import pyvista as pv

from app.engine import EngineSetup
from app.viewmodels.hand_scene import MARKER_LATELY, MARKER_NOW, HandScene
from app.viewmodels.states import SKY, VALIDITY
from tracker.hand.model import Segment
from tracker.messages import Array, Validity

RESOLUTION = 10
"""Sides of a capsule: at 24 the software renderer takes twice as long for no visible gain."""
OPACITY = {Validity.MEASURED: 1.0, Validity.INFERRED: 0.55, Validity.LOST: 0.25}
MARKER_SIZE = {MARKER_NOW: 1.0, MARKER_LATELY: 0.7}
FRUSTUM_DEPTH = 0.05


@dataclass(frozen=True)
class Show:
    """What the user wants to see beside the hand."""

    markers: bool = True
    uncertainty: bool = True
    camera: bool = True
    truth: bool = True


class HandActors:
    """One actor per segment, marker, fingertip and the camera."""

    def __init__(self, plotter: Any, setup: EngineSetup, hue_colours: dict[str, str]) -> None:
        self._plotter = plotter
        self._states: list[int] = [-1] * len(setup.hand.segments)
        meshes = [segment_mesh(s) for s in setup.hand.segments]
        self._segments = [self._add(m, "#888888", specular=0.2) for m in meshes]
        self._ghosts = [self._add(m, "#FFFFFF", opacity=0.22) for m in meshes]
        self._markers = [
            self._add(_disc(m.size / 2, m.normal), hue_colours.get(m.hue, "#FFFFFF"), ambient=0.5)
            for m in setup.glove.markers
        ]
        tips = sum(n.endswith("_tip") for n in setup.hand.keypoint_names)
        ball = pv.Sphere(radius=1.0, theta_resolution=12, phi_resolution=8)
        self._tips = [self._add(ball, SKY, opacity=0.3) for _ in range(tips)]
        self._camera = self._add(_frustum(setup), SKY, style="wireframe", line_width=1.5)
        self._marker_segment = setup.glove.marker_segment(setup.hand)

    def _add(self, mesh: Any, colour: str, **options: Any) -> Any:
        options = {"smooth_shading": "style" not in options, **options}
        return self._plotter.add_mesh(
            mesh, color=colour, render=False, reset_camera=False, **options
        )

    def update(self, scene: HandScene, show: Show) -> None:
        """Move every actor to ``scene``."""
        for i, actor in enumerate(self._segments):
            actor.user_matrix = _pose(scene.segment_R[i], scene.segment_p[i])
            self._dress(i, int(scene.segment_state[i]))
        self._update_ghosts(scene, show.truth)
        self._update_markers(scene, show.markers)
        self._update_tips(scene, show.uncertainty)
        self._camera.SetVisibility(show.camera)
        self._camera.user_matrix = _pose(scene.R_GC, scene.p_GC)

    def _dress(self, i: int, state: int) -> None:
        """Measured: solid. Inferred: see-through with its mesh drawn. Lost: a faint mesh."""
        if self._states[i] == state:
            return
        self._states[i] = state
        prop = self._segments[i].prop
        prop.color = VALIDITY[state].colour
        prop.opacity = OPACITY[Validity(state)]
        prop.show_edges = state == Validity.INFERRED
        prop.style = "wireframe" if state == Validity.LOST else "surface"

    def _update_ghosts(self, scene: HandScene, wanted: bool) -> None:
        for i, actor in enumerate(self._ghosts):
            actor.SetVisibility(wanted and scene.truth is not None)
            if wanted and scene.truth is not None:
                actor.user_matrix = _pose(scene.truth[0][i], scene.truth[1][i])

    def _update_markers(self, scene: HandScene, wanted: bool) -> None:
        for i, actor in enumerate(self._markers):
            state = int(scene.marker_state[i])
            actor.SetVisibility(wanted)
            actor.prop.opacity = 1.0 if state == MARKER_NOW else 0.55
            size = MARKER_SIZE.get(state, 0.45)
            R = scene.segment_R[self._marker_segment[i]]
            actor.user_matrix = _pose(R * size, scene.markers[i])

    def _update_tips(self, scene: HandScene, wanted: bool) -> None:
        """A ball of 2σ around each fingertip."""
        for i, actor in enumerate(self._tips):
            known = bool(np.isfinite(scene.tips[i]).all() and np.isfinite(scene.tip_sd[i]))
            actor.SetVisibility(wanted and known)
            if known:
                radius = max(2 * float(scene.tip_sd[i]), 1e-4)
                actor.user_matrix = _pose(np.eye(3) * radius, scene.tips[i])


def _pose(R: Array, p: Array) -> Array:
    """(4, 4) of a rotation (times a size) and a position."""
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, p
    return T


def segment_mesh(s: Segment) -> Any:
    """A capsule along x of B, or the dorsum's slab with rounded edges."""
    if s.width > 0:
        return _slab(s)
    body = pv.Cylinder(
        center=(s.length / 2, 0, 0),
        direction=(1, 0, 0),
        radius=s.radius,
        height=s.length,
        resolution=RESOLUTION,
        capping=False,
    )
    ends = [_ball(s.radius, (0, 0, 0)), _ball(s.radius, (s.length, 0, 0))]
    return (
        body.extract_surface(algorithm="dataset_surface")
        .merge(ends)
        .extract_surface(algorithm="dataset_surface")
    )


def _slab(s: Segment) -> Any:
    """A rounded block ``width`` across (y) and two radii thick (z), reaching over both ends (x)."""
    block = pv.Superquadric(
        phi_roundness=0.35, theta_roundness=0.45, theta_resolution=24, phi_resolution=16
    )
    half = np.array([s.length / 2 + 0.6 * s.radius, s.width / 2, s.radius])
    # Fitted by its bounds: VTK's scales refer to axes that turn with its axis of symmetry.
    largest = np.abs(block.points).max(axis=0)
    block.points = block.points / largest * half + [s.length / 2, 0, 0]
    return block.compute_normals()


def _ball(radius: float, centre: tuple[float, float, float]) -> Any:
    return pv.Sphere(
        radius=radius,
        center=centre,
        theta_resolution=RESOLUTION,
        phi_resolution=max(6, RESOLUTION // 2 + 2),
    )


def _disc(radius: float, normal: Array) -> Any:
    """A flat patch, a little proud of the surface so that it is not swallowed by the capsule."""
    return pv.Cylinder(
        center=normal * 0.0005, direction=normal, radius=radius, height=0.0015, resolution=12
    )


def _frustum(setup: EngineSetup) -> Any:
    """The left camera's field of view to `FRUSTUM_DEPTH`, as lines, in C."""
    rig, z = setup.rig, FRUSTUM_DEPTH
    us, vs = (0, rig.left.width - 1), (0, rig.left.height - 1)
    corners = [(u, v) for u, v in ((us[0], vs[0]), (us[1], vs[0]), (us[1], vs[1]), (us[0], vs[1]))]
    points = [((u - rig.cx) / rig.fx * z, (v - rig.cy) / rig.fy * z, z) for u, v in corners]
    points.append((0.0, 0.0, 0.0))
    pairs = [(0, 1), (1, 2), (2, 3), (3, 0), *((4, i) for i in range(4))]
    lines = np.array([[2, a, b] for a, b in pairs]).ravel()
    return pv.PolyData(np.array(points, float), lines=lines)
