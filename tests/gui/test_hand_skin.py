"""The skin in the 3D view: positions, and states that are distinguishable without colour."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

from app.viewmodels.hand_scene import HandGround, ribbon, ribbon_faces
from app.viewmodels.hand_skin import HandSkin, scales
from app.viewmodels.made_skins import MADE
from app.widgets.view3d.orbit import VIEW_ANGLE_DEG, Orbit
from app.widgets.view3d.raster.scene import RasterScene
from app.widgets.view3d.scene import GroundLines
from app.widgets.view3d.shapes import Surface
from tests.gui.gui_fakes import models
from tracker.messages import Calibration, Validity

WIDTH, HEIGHT = 160, 120
FOCAL = 0.5 * HEIGHT / np.tan(np.deg2rad(VIEW_ANGLE_DEG / 2))
FLAT = np.array([1.0, 1.0, 1.0, 1.0, 3.0, 0.0, 0.0])
"""White wherever it is seen."""


def facing(orbit: Orbit) -> np.ndarray:
    return np.stack([np.cross(orbit.up, orbit.direction), orbit.up, orbit.direction], axis=1)


def square(half: float, sideways: tuple[float, float, float] = (0.0, 0.0, 0.0)) -> np.ndarray:
    """(4, 3) corners before the orbit's eye, counter-clockwise."""
    corners = half * np.array([[-1, -1, 0], [1, -1, 0], [1, 1, 0], [-1, 1, 0]], float)
    return (corners + sideways) @ facing(Orbit()).T


def add_square(scene, points, look=FLAT, part=0, along=None, outline=False):
    faces = np.array([[0, 1, 2], [0, 2, 3]])
    surface = Surface(faces, np.full(2, part), np.zeros(4) if along is None else along)
    drawn = scene.add_outline(surface) if outline else scene.add_surface(surface)
    normals = np.tile(facing(Orbit())[:, 2], (4, 1))
    drawn.drape(points, normals, np.tile(look, (4, 1)))
    drawn.show(True)
    return drawn


def rendered(scene: RasterScene) -> np.ndarray:
    """(H, W, 3) red, green, blue as shares of one."""
    pixels = scene.render(Orbit(), WIDTH, HEIGHT)
    return pixels.view(np.uint8).reshape(HEIGHT, WIDTH, 4)[..., 2::-1] / 255.0


@pytest.mark.parametrize("half", [0.01, 0.0243, 0.05])
def test_a_surface_covers_its_area_to_a_part_of_a_pixel(half: float) -> None:
    scene = RasterScene()
    add_square(scene, square(half))
    side = 2 * half * FOCAL / Orbit().distance
    cover = rendered(scene)[..., 0]
    assert cover.sum() == pytest.approx(side**2, abs=0.15 * 4 * side)
    v, u = np.mgrid[:HEIGHT, :WIDTH] + 0.5
    middle = (u * cover).sum() / cover.sum(), (v * cover).sum() / cover.sum()
    assert middle == pytest.approx((WIDTH / 2, HEIGHT / 2), abs=0.15)


def test_a_surface_is_invisible_from_behind_and_occludes_if_set() -> None:
    scene = RasterScene()
    drawn = add_square(scene, square(0.03)[::-1])
    assert not rendered(scene).any()
    drawn.drape(square(0.03), np.zeros((4, 3)) + [0, 0, 1], np.tile(FLAT, (4, 1)))
    assert rendered(scene).any()
    drawn.choose(np.array([True, False]))
    half = rendered(scene)[..., 0].sum()
    drawn.choose(np.array([True, True]))
    assert rendered(scene)[..., 0].sum() == pytest.approx(2 * half, rel=0.02)
    drawn.show(False)
    assert not rendered(scene).any()


@pytest.mark.parametrize("swapped", [False, True])
def test_the_nearer_surface_is_seen(swapped: bool) -> None:
    scene = RasterScene()
    red, green = np.array([1, 0, 0, 1, 3, 0, 0.0]), np.array([0, 1, 0, 1, 3, 0, 0.0])
    both = [(square(0.03, (0, 0, 0.02)), red), (square(0.03), green)]
    for points, look in both[:: -1 if swapped else 1]:
        add_square(scene, points, look)
    assert tuple(rendered(scene)[HEIGHT // 2, WIDTH // 2]) == (1.0, 0.0, 0.0)


def test_hatching_has_its_pitch_and_dots_let_the_background_through() -> None:
    scene = RasterScene()
    points = square(0.04)
    along = 0.25 * points @ facing(Orbit())[:, 1]  # lines 8 px apart
    add_square(scene, points, np.array([1, 1, 1, 1, 1.0, 1, 0]), along=along)
    column = rendered(scene)[10:110, WIDTH // 2, 0]
    dark = (column[1:-1] < column[:-2]) & (column[1:-1] <= column[2:])
    pitch_px = 4 * 0.0042 * FOCAL / Orbit().distance
    assert dark.sum() == pytest.approx(0.08 * FOCAL / Orbit().distance / pitch_px, abs=2)
    dotted = RasterScene()
    add_square(dotted, points, np.array([1, 1, 1, 1, 3.0, 0, 1]))
    inner = rendered(dotted)[50:70, 70:90, 0]
    assert inner.min() < 0.3 and inner.max() > 0.9
    assert 0.3 < inner.mean() < 0.7


@pytest.mark.parametrize("outline", [False, True])
def test_pixels_of_an_earlier_image_are_cleared(outline: bool) -> None:
    def drawn_at(scene: RasterScene, x: float, y: float) -> np.ndarray:
        drawn.drape(square(0.02, (x, y, 0)), np.zeros((4, 3)) + facing(Orbit())[:, 2], dress)
        return rendered(scene)

    dress = np.tile(FLAT, (4, 1))
    scene = RasterScene()
    scene.set_ink("#FFFFFF")
    drawn = add_square(scene, square(0.02), outline=outline)
    for x, y in ((-0.06, 0.04), (0.05, -0.03), (0.2, 0.0), (0.115, 0.08), (0.0, 0.0)):
        seen = drawn_at(scene, x, y)
        fresh = RasterScene()
        fresh.set_ink("#FFFFFF")
        add_square(fresh, square(0.02, (x, y, 0)), outline=outline)
        np.testing.assert_array_equal(seen, rendered(fresh))


@pytest.mark.usefixtures("compare_large")
def test_an_outline_is_drawn_around_and_not_within() -> None:
    scene = RasterScene()
    scene.set_ink("#FFFFFF")
    add_square(scene, square(0.03), outline=True)
    image = rendered(scene)[..., 0]
    half_px = 0.03 * FOCAL / Orbit().distance
    assert not image[HEIGHT // 2 - 12 : HEIGHT // 2 + 12, WIDTH // 2 - 12 : WIDTH // 2 + 12].any()
    row = np.flatnonzero(image[HEIGHT // 2])
    edges = np.abs(row + 0.5 - WIDTH / 2)
    assert len(row) and np.abs(edges - half_px).max() < 2.0


def test_ground_lines_are_behind_and_fade_towards_their_ends() -> None:
    scene = RasterScene()
    scene.set_ink("#FFFFFF")
    x = facing(Orbit())[:, 0]
    scene.set_ground(GroundLines(np.array([[*(-0.1 * x), *(0.1 * x)]]), np.array([1.0])))
    add_square(scene, square(0.01), np.array([1, 0, 0, 1, 3.0, 0, 0]))
    image = rendered(scene)
    band = image[HEIGHT // 2 - 2 : HEIGHT // 2 + 2].max(axis=0)
    assert tuple(band[WIDTH // 2]) == (1.0, 0.0, 0.0)
    assert band[WIDTH // 2 + 20, 1] > band[WIDTH // 2 + 40, 1] > 0.05


@pytest.fixture(scope="module")
def skin() -> HandSkin:
    hand, glove, _ = models()
    return HandSkin(hand, glove)


def test_a_skin_is_built_only_once(skin: HandSkin) -> None:
    """A session has the same hand in another object."""
    hand, glove, _ = models()
    longer = dataclasses.replace(hand.segments[1], length=hand.segments[1].length + 1e-4)
    other = dataclasses.replace(hand, segments=(hand.segments[0], longer, *hand.segments[2:]))
    assert HandSkin(dataclasses.replace(hand), glove).skin is skin.skin
    assert MADE.has(hand, glove) and not MADE.has(other, glove)


def pose(side_step: float = 0.0) -> tuple[np.ndarray, np.ndarray]:
    hand = models()[0]
    angles = np.zeros(len(hand.joint_names))
    return hand.forward(angles, np.eye(3), np.array([0.0, side_step, 0.0]))


def test_each_state_is_drawn_with_a_pattern_of_its_own(skin: HandSkin) -> None:
    """Without colour: plain, hatched, dotted."""
    hand = models()[0]
    states = np.full(len(hand.segments), int(Validity.MEASURED))
    states[hand.index["ring_proximal"]] = Validity.INFERRED
    states[hand.index["little_distal"]] = Validity.LOST
    looks = skin.draped(*pose(), states).looks
    alone = skin.skin.shares[:, 0] == 1.0
    for name, hatch, dots in (
        ("index_proximal", 0, 0),
        ("ring_proximal", 1, 0),
        ("little_distal", 0, 1),
    ):
        own = alone & (skin.skin.bones[:, 0] == hand.index[name])
        assert own.any()
        np.testing.assert_allclose(looks[own, 5], hatch)
        np.testing.assert_allclose(looks[own, 6], dots)


def test_patches_are_on_the_skin_and_show_their_state(skin: HandSkin) -> None:
    hand, glove, _ = models()
    R, p = pose()
    colours = ["#FF0000"] * len(glove.markers)
    draped = skin.draped_patches(R, p, colours)
    per = len(draped.points) // len(glove.markers)
    centres = draped.points[::per]
    segment = glove.marker_segment(hand)
    expected = p[segment] + np.einsum("mij,mj->mi", R[segment], glove.marker_position)
    away = np.linalg.norm(centres - expected, axis=1)
    assert away.max() < 1.5e-3  # along the skin where the normal of the file is not its own
    rest = skin.draped(R, p, np.full(len(hand.segments), 2)).points
    from scipy.spatial import cKDTree

    assert cKDTree(rest).query(draped.points)[0].max() < 0.004  # a cell
    now, lately = np.zeros(len(glove.markers), bool), np.zeros(len(glove.markers), bool)
    now[0], lately[1] = True, True
    faces = skin.patch_faces(now, lately).reshape(len(glove.markers), -1)
    assert faces[0].all() and 0 < faces[1].sum() < faces[0].sum()
    assert faces[2].sum() > 0 and not (faces[2] & faces[1]).any()  # a ring, outside what is smaller


def test_the_skin_is_as_large_as_the_wearer(skin: HandSkin) -> None:
    hand, _, _ = models()
    nothing = np.full((2, 3), np.nan)
    scale = np.array([[1.1, 1.05, 1.0], [1.2, 1.0, 1.0]])
    calibration = Calibration(
        0.0, ("dorsum", "index_proximal"), scale, nothing, nothing, nothing, nothing, nothing,
        nothing, nothing, 0.18, 0.0,
    )  # fmt: skip
    rows = scales(hand, calibration)
    np.testing.assert_allclose(rows[hand.index["index_distal"]], scale[1])  # as its finger
    np.testing.assert_allclose(rows[hand.index["little_distal"]], scale.mean(axis=0))
    states = np.full(len(hand.segments), 2)
    before = skin.draped(*pose(), states).points
    grown = np.full((len(hand.segments), 3), 1.1)
    skin.fit(grown)
    R, p = hand.forward(np.zeros(len(hand.joint_names)), np.eye(3), np.zeros(3), grown)
    np.testing.assert_allclose(skin.draped(R, p, states).points, 1.1 * before, atol=1e-9)
    skin.fit(np.ones_like(grown))


def test_the_ground_is_fixed_under_a_hand_that_moves_slightly() -> None:
    ground, hand = HandGround(), pose()[1]
    assert ground.follow(hand)
    corner = ground.grid.corner.copy()
    assert corner[2] < hand[:, 2].min()
    assert not ground.follow(hand + [0.03, 0.0, 0.02])
    assert ground.follow(hand - [0.0, 0.0, 0.2])  # it would be below the ground
    assert ground.grid.corner[2] < corner[2]
    assert ground.follow(hand + [0.5, 0.0, 0.0])


def test_a_trail_is_a_ribbon_that_ends_at_the_fingertip_and_faces_the_eye() -> None:
    trail = np.stack([np.linspace(0, 0.1, 20), np.zeros(20), np.zeros(20)], axis=1)
    eye = np.array([0.05, 0.0, 0.5])
    points, normals, looks = ribbon(trail, eye, (1.0, 0.0, 0.0))
    np.testing.assert_allclose(0.5 * (points[-2] + points[-1]), trail[-1], atol=1e-9)
    width = np.linalg.norm(points[1::2] - points[::2], axis=1)
    assert width[-1] > 2 * width[0] > 0
    assert looks[0, 3] == 0.0 and looks[-1, 3] == 1.0
    faces = ribbon_faces(20)[:38]
    flat = np.cross(
        points[faces[:, 1]] - points[faces[:, 0]], points[faces[:, 2]] - points[faces[:, 0]]
    )
    assert (np.abs(flat[:, 2]) > 0).all() and len(np.unique(np.sign(flat[:, 2]))) == 1
    assert normals[:, 2].min() > 0.9


def test_the_window_draws_the_skin_once_it_is_built(live, qtbot) -> None:
    """And the outline of the reference, when it is asked for."""
    qtbot.waitUntil(lambda: live.hand._hands[0].skin is not None)
    hand = live.hand
    hand.refresh(hand.host.snapshot())
    scene = hand._scene
    drawn = hand.view.scene.surfaces.rows.points[hand._hands[0].bodies._hand._points]
    expected = (
        hand._hands[0].skin.draped(scene.segment_R, scene.segment_p, scene.segment_state).points
    )
    np.testing.assert_allclose(drawn, expected)
    assert hand._hands[0].bodies._hand.shown and hand._hands[0].bodies._markers.shown
    assert not hand._hands[0].bodies._reference.shown
    hand.controls.show_reference("truth")
    hand.refresh(hand.host.snapshot())
    assert hand._hands[0].bodies._reference.shown
    far = dataclasses.replace(scene, p_GC=hand.view.orbit.eye)
    hand._hands[0].bodies.update(far, hand.controls.shown(), hand.view.orbit)
    assert not hand._hands[0].bodies._camera.shown  # no lines from beside the eye
