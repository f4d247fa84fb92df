"""The software renderer, compared with the geometry of a pinhole camera."""

from __future__ import annotations

import numpy as np
import pytest

from app.panels.hand.bodies import HandBodies
from app.widgets.view3d.orbit import VIEW_ANGLE_DEG, Orbit
from app.widgets.view3d.raster.scene import RasterScene
from app.widgets.view3d.scene import BodyLook, Grid
from app.widgets.view3d.shapes import Block, CapsuleShape, Disc, Shape, ball, polyline
from tests.gui.gui_fakes import ScriptedEngine, scripted_setup

WIDTH, HEIGHT = 160, 120
FOCAL = 0.5 * HEIGHT / np.tan(np.deg2rad(VIEW_ANGLE_DEG / 2))
FLAT = BodyLook("#FFFFFF", ambient=2.0)
"""White wherever it is visible, so that a pixel shows its coverage."""


def rendered(scene: RasterScene, orbit: Orbit | None = None) -> np.ndarray:
    """(H, W, 3) red, green, blue as shares of one."""
    pixels = scene.render(orbit or Orbit(), WIDTH, HEIGHT)
    return pixels.view(np.uint8).reshape(HEIGHT, WIDTH, 4)[..., 2::-1] / 255.0


def cover_of(shape: Shape, R: np.ndarray | None = None, p: np.ndarray | None = None) -> np.ndarray:
    """(H, W) how much of each pixel a white body covers."""
    scene = RasterScene()
    scene.add(shape, FLAT).move(np.eye(3) if R is None else R, np.zeros(3) if p is None else p)
    return rendered(scene)[..., 0]


def facing(orbit: Orbit) -> np.ndarray:
    """(3, 3) R_GB whose x is the image's right, y its up, z towards the eye."""
    return np.stack([np.cross(orbit.up, orbit.direction), orbit.up, orbit.direction], axis=1)


def middle(cover: np.ndarray) -> tuple[float, float]:
    """Centre (u, v) px of what is covered."""
    v, u = np.mgrid[:HEIGHT, :WIDTH] + 0.5
    return float((u * cover).sum() / cover.sum()), float((v * cover).sum() / cover.sum())


@pytest.mark.parametrize("radius", [0.004, 0.02, 0.05])
def test_a_ball_covers_the_circle_of_its_tangent_cone(radius: float) -> None:
    sine = radius / Orbit().distance
    seen = FOCAL * sine / np.sqrt(1 - sine**2)
    cover = cover_of(ball(radius))
    half_a_ray = 0.125  # of the four through each pixel of the edge
    assert cover.sum() == pytest.approx(np.pi * seen**2, abs=half_a_ray * 2 * np.pi * seen)
    assert middle(cover) == pytest.approx((WIDTH / 2, HEIGHT / 2), abs=0.1)


def test_a_capsule_across_covers_its_tangents_and_caps() -> None:
    length, radius = 0.06, 0.01
    orbit = Orbit()
    seen = FOCAL * radius / np.sqrt(orbit.distance**2 - radius**2)
    straight = 2 * seen * FOCAL * length / orbit.distance
    R = facing(orbit)
    cover = cover_of(CapsuleShape(length, radius), R, -R[:, 0] * length / 2)
    assert cover.sum() == pytest.approx(straight + np.pi * seen**2, rel=0.015)
    column = cover[:, WIDTH // 2]
    assert column.sum() == pytest.approx(2 * seen, abs=0.15)


def test_a_disc_is_an_ellipse() -> None:
    orbit = Orbit()
    tilt = np.cos(1.0) * orbit.direction + np.sin(1.0) * orbit.up
    cover = cover_of(Disc(0.02, 1e-5, tilt))
    area = np.pi * (FOCAL * 0.02 / orbit.distance) ** 2 * np.cos(1.0)
    assert cover.sum() == pytest.approx(area, rel=0.02)


def test_a_block_seen_along_its_thickness_is_a_rectangle_with_round_corners() -> None:
    shape = Block(np.array([0.04, 0.03, 0.001]))
    cover = cover_of(shape, facing(Orbit()))
    rounded = 4 * 0.04 * 0.03 - (4 - np.pi) * shape.corner**2
    px_per_m = FOCAL / Orbit().distance
    assert cover.sum() == pytest.approx(px_per_m**2 * rounded, rel=0.01)


def test_bodies_are_where_a_pinhole_camera_sees_them() -> None:
    orbit = Orbit()
    orbit.turn(0.4, -0.3)
    orbit.target = np.array([0.1, -0.2, 0.05])
    R_CG = np.stack([np.cross(orbit.up, orbit.direction), -orbit.up, -orbit.direction])
    for sideways in ([0.05, 0.02, 0.03], [-0.03, 0.06, -0.05]):
        p_G = orbit.target + sideways
        p_C = R_CG @ (p_G - orbit.eye)
        scene = RasterScene()
        scene.add(ball(0.003), FLAT).move(np.eye(3), p_G)
        expected = FOCAL * p_C[:2] / p_C[2] + [WIDTH / 2, HEIGHT / 2]
        assert middle(rendered(scene, orbit)[..., 0]) == pytest.approx(tuple(expected), abs=0.2)


def test_a_size_in_the_pose_scales_the_body() -> None:
    unit, doubled = cover_of(ball(0.01)), cover_of(ball(0.01), 2 * np.eye(3))
    assert doubled.sum() == pytest.approx(cover_of(ball(0.02)).sum(), rel=1e-9)
    assert doubled.sum() > 3.9 * unit.sum()


@pytest.mark.parametrize("swapped", [False, True])
def test_the_nearer_body_is_visible_in_any_drawing_order(swapped: bool) -> None:
    scene, orbit = RasterScene(), Orbit()
    near, far = 0.05 * orbit.direction, np.zeros(3)
    for colour, p in [("#FF0000", near), ("#00FF00", far)][:: -1 if swapped else 1]:
        scene.add(ball(0.01), BodyLook(colour, ambient=2.0)).move(np.eye(3), p)
    red, green, _ = rendered(scene)[HEIGHT // 2, WIDTH // 2]
    assert (red, green) == (1.0, 0.0)


def test_transparent_bodies_are_blended_by_their_opacity() -> None:
    scene, orbit = RasterScene(), Orbit()
    scene.set_background("#0000FF")
    for colour, opacity, near in (("#00FF00", 0.5, 0.0), ("#FF0000", 0.4, 0.1)):
        look = BodyLook(colour, opacity=opacity, ambient=2.0)
        scene.add(ball(0.01), look).move(np.eye(3), near * orbit.direction)
    mixed = rendered(scene)[HEIGHT // 2, WIDTH // 2]
    np.testing.assert_allclose(mixed, [0.4, 0.6 * 0.5, 0.6 * 0.5], atol=1 / 255)


def test_of_a_group_only_the_nearest_transparent_body_is_visible() -> None:
    scene, orbit = RasterScene(), Orbit()
    for near in (0.0, 0.1):
        look = BodyLook("#FFFFFF", opacity=0.5, ambient=2.0, group=1)
        scene.add(ball(0.01), look).move(np.eye(3), near * orbit.direction)
    assert rendered(scene)[HEIGHT // 2, WIDTH // 2, 0] == pytest.approx(0.5, abs=1 / 255)


@pytest.mark.parametrize("width_px", [0.6, 1.0, 2.5])
def test_a_line_covers_its_length_times_its_width(width_px: float) -> None:
    orbit = Orbit()
    ends = np.array([[-0.04, -0.02, 0.0], [0.05, 0.03, 0.0]]) @ facing(orbit).T
    scene = RasterScene()
    scene.add(polyline(ends), BodyLook("#FFFFFF", line_width=width_px))
    length = FOCAL / orbit.distance * np.linalg.norm(ends[1] - ends[0])
    cover = rendered(scene)[..., 0]
    assert cover.sum() == pytest.approx(length * width_px, rel=0.06)


def test_a_line_is_occluded_by_a_body() -> None:
    orbit = Orbit()
    R = facing(orbit)
    scene = RasterScene()
    scene.add(polyline(np.array([[-0.05, 0, 0], [0.05, 0, 0]]) @ R.T), BodyLook("#FF0000"))
    scene.add(ball(0.01), BodyLook("#00FF00", ambient=2.0)).move(np.eye(3), 0.05 * orbit.direction)
    row = rendered(scene)[HEIGHT // 2 - 1 : HEIGHT // 2 + 1].max(axis=0)
    assert tuple(row[WIDTH // 2, :2]) == (0.0, 1.0)
    assert row[WIDTH // 2 - 15, 0] > 0.4


def test_a_grid_alone_lets_the_background_through_between_its_lines() -> None:
    scene = RasterScene()
    look = BodyLook("#FFFFFF", ambient=2.0, grid=Grid.ALONE)
    scene.add(Block(np.array([0.04, 0.03, 0.005])), look).move(facing(Orbit()), np.zeros(3))
    inner = rendered(scene)[50:70, 60:100, 0]
    assert inner.min() < 0.6 < 0.7 < inner.max()


@pytest.mark.parametrize(
    "p",
    [np.full(3, np.nan), 2 * Orbit().eye, np.array([np.inf, 0.0, 0.0])],
    ids=["nowhere", "behind", "endless"],
)
def test_bodies_behind_the_eye_are_not_drawn(p: np.ndarray) -> None:
    scene = RasterScene()
    for shape in (
        ball(0.02),
        Block(np.full(3, 0.01)),
        polyline(np.array([[0, 0, 0], [0.1, 0, 0]])),
    ):
        scene.add(shape, FLAT).move(np.eye(3), p)
    assert not rendered(scene).any()


def test_a_body_around_the_eye_occludes_nothing() -> None:
    assert not cover_of(ball(1.0)).any()


def test_a_line_that_passes_the_eye_is_clipped() -> None:
    orbit = Orbit()
    scene = RasterScene()
    scene.add(polyline(np.stack([0.01 * orbit.up, 2 * orbit.eye])), FLAT)
    assert rendered(scene).any()


def test_the_same_scene_gives_the_same_image() -> None:
    def image() -> np.ndarray:
        scene = RasterScene()
        for k in range(5):
            look = BodyLook("#4080C0", opacity=0.3 + 0.15 * k, specular=0.2, grid=Grid.OVER)
            scene.add(CapsuleShape(0.05, 0.008), look).move(np.eye(3), np.full(3, 0.005 * k))
        return rendered(scene).copy()

    np.testing.assert_array_equal(image(), image())


@pytest.mark.parametrize("size", [(1, 1), (2, 3), (17, 15)])
def test_a_image_may_be_tiny_and_the_scene_empty(size: tuple[int, int]) -> None:
    scene = RasterScene()
    scene.set_background("#102030")
    assert (scene.render(Orbit(), *size) == 0xFF102030).all()
    scene.add(ball(0.2), FLAT)
    assert (scene.render(Orbit(), *size) == 0xFFFFFFFF).any()
    scene.clear()
    assert (scene.render(Orbit(), *size) == 0xFF102030).all()


def test_more_pieces_than_the_initial_list_holds() -> None:
    """Thousands of lines over the whole image, whose last one is still drawn."""
    scene, R = RasterScene(), facing(Orbit())
    across = np.array([[-0.2, 0.0, 0.0], [0.2, 0.0, 0.0]]) @ R.T
    for k in range(400):
        scene.add(polyline(across - (k < 399) * 0.02 * R[:, 1]), FLAT)
    assert rendered(scene)[HEIGHT // 2 - 1 : HEIGHT // 2 + 1, 3, 0].max() > 0.4


def test_nothing_is_drawn_before_there_is_a_hand() -> None:
    """A ring has unit size until it is placed, and would fill the view."""
    scene = RasterScene()
    scene.set_background("#102030")
    HandBodies(scene, scripted_setup(ScriptedEngine()), {})
    assert (scene.render(Orbit(), WIDTH, HEIGHT) == 0xFF102030).all()
