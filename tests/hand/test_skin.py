"""The skin built from a hand file: a closed surface that follows its joints."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import trimesh
from trimesh.proximity import closest_point

from tracker.glove.files import load_glove
from tracker.glove.model import GloveModel
from tracker.hand.files import load_hand
from tracker.hand.model import HandModel
from tracker.hand.skin.form import FABRIC, bind_angles
from tracker.hand.skin.mesh import Skin, SkinMaker
from tracker.hand.skin.posing import posed, rest_of

RESOURCES = Path(__file__).parents[2] / "resources"
PAIRS = {
    "right": ("reference-right", "vist-small"),
    "left": ("reference-left", "vist-small-left"),
    "large": ("large-right", "vist-large"),
    "five": ("reference-right", "five-finger"),
}
Made = tuple[HandModel, GloveModel, Skin]


@pytest.fixture(scope="module", params=PAIRS.values(), ids=PAIRS.keys())
def made(request: pytest.FixtureRequest) -> Made:
    hand = load_hand(RESOURCES / f"hands/{request.param[0]}.toml")
    glove = load_glove(RESOURCES / f"gloves/{request.param[1]}.toml", hand)
    maker = SkinMaker(hand, (glove.marker_segment(hand), glove.marker_position))
    return hand, glove, maker.skin()


def mesh_of(points: np.ndarray, skin: Skin) -> trimesh.Trimesh:
    return trimesh.Trimesh(points, skin.faces, process=False)


def random_pose(hand: HandModel, seed: int) -> tuple[np.ndarray, np.ndarray]:
    """Random angles within nine tenths of their limits."""
    low, high = 0.9 * hand.angle_limits.T
    angles = low + np.random.default_rng(seed).random(len(low)) * (high - low)
    return hand.forward(angles, np.eye(3), np.zeros(3))


def test_the_skin_is_one_closed_surface_oriented_outward(made: Made) -> None:
    _, _, skin = made
    mesh = mesh_of(skin.points, skin)
    assert mesh.is_watertight and mesh.is_winding_consistent and mesh.body_count == 1
    assert mesh.volume > 0
    # a sphere's Euler characteristic: no tunnel between fingers
    assert mesh.euler_number == 2


def test_normals_point_outward(made: Made) -> None:
    _, _, skin = made
    np.testing.assert_allclose(np.linalg.norm(skin.normals, axis=1), 1.0)
    by_faces = mesh_of(skin.points, skin).vertex_normals
    assert (by_faces * skin.normals).sum(axis=1).min() > 0.5
    assert np.median((by_faces * skin.normals).sum(axis=1)) > 0.98


def test_the_bind_pose_is_reproduced(made: Made) -> None:
    hand, _, skin = made
    pose = hand.forward(bind_angles(hand), np.eye(3), np.zeros(3))
    points, normals = posed(rest_of(skin, hand), *pose)
    np.testing.assert_allclose(points, skin.points, atol=1e-12)
    np.testing.assert_allclose(normals, skin.normals, atol=1e-12)


def test_fingers_have_the_length_and_thickness_of_the_file(made: Made) -> None:
    hand, _, skin = made
    for name in ("thumb", "index", "middle", "ring", "little"):
        i = hand.index[f"{name}_distal"]
        local = (skin.points - skin.bind_p[i]) @ skin.bind_R[i]
        near = np.linalg.norm(local[:, 1:], axis=1) < 2 * hand.segments[i].radius
        assert local[near, 0].max() == pytest.approx(hand.segments[i].length + FABRIC, abs=1e-3)
        middle = f"{name}_{'proximal' if name == 'thumb' else 'intermediate'}"
        i = hand.index[middle]
        local = (skin.points - skin.bind_p[i]) @ skin.bind_R[i]
        own = (skin.bones[:, 0] == i) & (np.abs(local[:, 0] / hand.segments[i].length - 0.5) < 0.1)
        girth = np.linalg.norm(local[own, 1:], axis=1)
        # the taper to thinner neighbours, and markers that deform the cloth
        assert girth.mean() == pytest.approx(hand.segments[i].radius + FABRIC, rel=0.06)


@pytest.mark.parametrize("seed", range(3))
def test_markers_are_on_the_skin_in_any_pose(made: Made, seed: int) -> None:
    hand, glove, skin = made
    R, p = random_pose(hand, seed)
    points, _ = posed(rest_of(skin, hand), R, p)
    segment = glove.marker_segment(hand)
    markers = p[segment] + np.einsum("mij,mj->mi", R[segment], glove.marker_position)
    away = closest_point(mesh_of(points, skin), markers)[1]
    assert away.max() < 5e-4


def test_far_from_joints_it_is_rigid_and_weights_sum_to_one(made: Made) -> None:
    hand, _, skin = made
    np.testing.assert_allclose(skin.shares.sum(axis=1), 1.0)
    assert skin.shares.min() >= 0.0
    R, p = random_pose(hand, 11)
    points, normals = posed(rest_of(skin, hand), R, p)
    alone = skin.shares[:, 0] == 1.0
    assert alone.mean() > 0.5  # forearm and palm, and the middles of the fingers
    for i in range(len(hand.segments)):
        own = alone & (skin.bones[:, 0] == i)
        assert own.any()
        local = (skin.points[own] - skin.bind_p[i]) @ skin.bind_R[i]
        np.testing.assert_allclose(points[own], local @ R[i].T + p[i], atol=1e-9)
        turned = skin.normals[own] @ skin.bind_R[i] @ R[i].T
        np.testing.assert_allclose(normals[own], turned, atol=1e-9)


def test_a_bent_finger_keeps_its_thickness_at_the_joint(made: Made) -> None:
    """A blend of matrices would leave cos(45°) of it at a joint bent by 90°."""
    hand, _, skin = made
    angles = bind_angles(hand)
    angles[hand.angle_index["index_pip_flexion"]] = np.deg2rad(90)
    R, p = hand.forward(angles, np.eye(3), np.zeros(3))
    points, _ = posed(rest_of(skin, hand), R, p)
    i = hand.index["index_intermediate"]
    before = np.linalg.norm(skin.points - skin.bind_p[i], axis=1)
    around = before < 1.3 * hand.segments[i].radius + FABRIC
    after = np.linalg.norm(points[around] - p[i], axis=1)
    np.testing.assert_allclose(after, before[around], atol=2e-4)


def test_a_larger_wearer_has_a_larger_skin(made: Made) -> None:
    hand, _, skin = made
    scale = np.full((len(hand.segments), 3), 1.07)
    grown = rest_of(skin, hand, scale)
    np.testing.assert_allclose(grown.points, 1.07 * skin.points, atol=1e-12)
    long = np.ones_like(scale)
    i = hand.index["index_proximal"]
    long[i, 0] = 1.2
    stretched = rest_of(skin, hand, long)
    moved = np.linalg.norm(stretched.points - skin.points, axis=1)
    tip = (skin.bones[:, 0] == hand.index["index_distal"]) & (skin.shares[:, 0] == 1)
    assert moved[tip] == pytest.approx(0.2 * hand.segments[i].length, rel=1e-6)
    assert moved[skin.points[:, 0] < 0.03].max() < 1e-12


def test_left_and_right_are_mirror_images() -> None:
    points = []
    for side in ("right", "left"):
        hand = load_hand(RESOURCES / f"hands/reference-{side}.toml")
        points.append(SkinMaker(hand).skin().points)
    mirrored = points[1] * [1, -1, 1]
    from scipy.spatial import cKDTree

    away, _ = cKDTree(points[0]).query(mirrored)
    assert np.percentile(away, 99) < 0.0027  # half a cell's diagonal: two lattices, one surface


def test_a_hand_with_a_thumb_and_a_finger_has_a_skin_too(tmp_path: Path) -> None:
    hand = load_hand(RESOURCES / "hands/reference-right.toml")
    keep = [s for s in hand.segments if s.name.split("_")[0] in ("dorsum", "thumb", "index")]
    names = {s.name for s in keep}
    small = HandModel(
        "two", "right", hand.length, "index_distal", tuple(keep),
        tuple(j for j in hand.joints if j.child in names), (),
    )  # fmt: skip
    skin = SkinMaker(small).skin()
    assert mesh_of(skin.points, skin).is_watertight
