"""Images and blobs of one scene are consistent."""

from dataclasses import replace

import cv2
import numpy as np
import pytest

from tests.notices import raises
from tracker.base.errors import ConfigError, FileError
from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.simulation.backgrounds import FABRIC_HSV, BackgroundParams, fabric_bgr
from tracker.simulation.camera_view import pitch_of, pixels_of, ray_map
from tracker.simulation.exposure import JITTER_PX, patches_of_all
from tracker.simulation.motion import Still
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.raster import Buffer, PixelRays, bounds, draw
from tracker.simulation.render import Renderer, RenderParams
from tracker.simulation.scene import BlobParams, SimulatedScene
from tracker.simulation.sewn import patch_at
from tracker.simulation.solids import GLOVE_BGR
from tracker.simulation.wearer import Wearer
from tracker.vision.rig import StereoRig, ideal_rig

HUE = {"red": 0, "yellow": 28, "green": 65, "blue": 110}
NOISELESS = BlobParams(noise_px=0, dropout=0, size_noise=0)


@pytest.fixture(scope="module")
def flat(hand: HandModel, glove: GloveModel) -> SimulatedScene:
    """The exact hand, flat under the camera."""
    place = np.array([0.08, 0.0, 0.10])
    still = Still(np.zeros(len(hand.joint_names)), np.eye(3), place)
    return SimulatedScene(Wearer.exact(hand, glove), still, ideal_rig(), 1, NOISELESS)


def _hue_of(image: np.ndarray, uv: np.ndarray) -> int:
    u, v = np.round(uv).astype(int)
    patch = image[v - 1 : v + 2, u - 1 : u + 2].reshape(-1, 3).mean(axis=0)
    return int(cv2.cvtColor(patch.astype(np.uint8)[None, None], cv2.COLOR_BGR2HSV)[0, 0, 0])


def test_every_visible_marker_has_its_hue_in_both_images(flat: SimulatedScene) -> None:
    images = Renderer(flat).pair(1.0)
    now = flat.instant(1.0)
    checked = 0
    for right, image in enumerate(images):
        seen = flat.markers_seen(now, bool(right))
        for marker, uv, visible in zip(
            flat.wearer.glove.markers, seen.uv, seen.visible, strict=True
        ):
            if visible:
                gap = abs(_hue_of(image, uv) - HUE[marker.hue])
                assert min(gap, 180 - gap) <= 5, marker.id
                checked += 1
    assert checked > 20


def test_centroids_of_images_are_those_of_blobs(flat: SimulatedScene) -> None:
    """An independent search (OpenCV contours) finds the blobs at their predicted centroids."""
    image = Renderer(flat, RenderParams(noise=0.0)).pair(1.0)[0]
    seen = flat.markers_seen(flat.instant(1.0), False)
    hsv = cv2.cvtColor(image, cv2.COLOR_BGR2HSV)
    errors = []
    for marker, uv, visible in zip(flat.wearer.glove.markers, seen.uv, seen.visible, strict=True):
        hue = HUE[marker.hue]
        gap = np.abs((hsv[..., 0].astype(int) - hue + 90) % 180 - 90)
        mask = ((gap < 11) & (hsv[..., 1] > 90) & (hsv[..., 2] > 45)).astype(np.uint8)
        contours, _ = cv2.findContours(mask, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
        moments = [cv2.moments(c) for c in contours]
        found = np.array([[m["m10"] / m["m00"], m["m01"] / m["m00"]] for m in moments if m["m00"]])
        if visible:
            errors.append(np.linalg.norm(found - uv, axis=1).min())
    assert np.median(errors) < 0.35 and np.max(errors) < 1.2


def test_a_glove_ends_with_its_fingers(flat: SimulatedScene) -> None:
    """A fingertip is a sphere that ends with its segment, plus a millimetre of cloth: its drawn
    extent in the finger's direction is correct within a millimetre."""
    dark = Renderer(flat, RenderParams(noise=0.0)).pair(1.0)[0].max(axis=2) < 110
    hand, now, rig = flat.wearer.hand, flat.instant(1.0), flat.rig
    for name in ("index", "middle", "ring", "little"):
        row = hand.index[f"{name}_distal"]
        last, along = hand.segments[row], now.R_CB[row, :, 0]
        middle = now.p_CB[row] + (last.length - last.radius) * along
        start, ahead = rig.project(np.stack([middle, middle + 0.001 * along]))
        way = (ahead - start) / np.linalg.norm(ahead - start)
        px = np.arange(0.0, 40.0, 0.2)
        u, v = np.round(start + px[:, None] * way).astype(int).T
        radius = px[dark[v, u]].max() * middle[2] / rig.fx
        assert radius == pytest.approx(last.radius + 0.001, abs=0.001), name


def test_flat_hand_shows_its_back_only(flat: SimulatedScene) -> None:
    left, right = flat.visible(1.0)
    markers = flat.wearer.glove.markers
    for m in markers:
        if m.segment == "dorsum":
            assert left[m.id] == right[m.id] == (m.normal[2] > 0)
        if m.normal[2] < -0.9:
            assert not left[m.id]


def test_blobs_are_at_the_projections_of_the_markers(flat: SimulatedScene) -> None:
    """On the flat back of the hand the visible centroid is the projected centre."""
    now, rig, glove = flat.instant(0.0), flat.rig, flat.wearer.glove
    seen = flat.markers_seen(now, True)
    for m in glove.markers:
        if m.segment == "dorsum" and seen.visible[m.id]:
            p_C = now.R_CB[0] @ m.position + now.p_CB[0]
            np.testing.assert_allclose(seen.uv[m.id], rig.project(p_C, True), atol=0.15)


def test_turned_over_the_other_side_is_visible(hand: HandModel, glove: GloveModel) -> None:
    place = np.array([0.08, 0.0, 0.10])
    still = Still(np.zeros(len(hand.joint_names)), so3.rx(np.pi), place)
    scene = SimulatedScene(Wearer.exact(hand, glove), still, ideal_rig(), 1, NOISELESS)
    left, _ = scene.visible(0.0)
    back = [m.id for m in glove.markers if m.segment == "dorsum" and m.normal[2] > 0]
    palm = [m.id for m in glove.markers if m.segment == "dorsum" and m.normal[2] < 0]
    assert left[palm].all() and not left[back].any()


def test_blob_noise_and_dropouts_are_the_given_ones(hand: HandModel, glove: GloveModel) -> None:
    still = Still(np.zeros(len(hand.joint_names)), np.eye(3), np.array([0.08, 0.0, 0.10]))
    params = BlobParams(noise_px=0.3, dropout=0.1)
    scene = SimulatedScene(Wearer.exact(hand, glove), still, ideal_rig(), 1, params)
    seen = scene.markers_seen(scene.instant(0.0), False)
    truth = seen.uv[seen.visible]
    errors, counts = [], []
    for k in range(200):
        blobs = scene.blobs(0.01 * k).left
        assert blobs is not None
        gaps = blobs.uv[:, None] - truth[None]
        nearest = np.argmin(np.linalg.norm(gaps, axis=2), axis=1)
        errors.append(gaps[np.arange(len(blobs)), nearest])
        counts.append(len(blobs))
    assert np.concatenate(errors).std() == pytest.approx(0.3, rel=0.05)
    assert np.mean(counts) == pytest.approx(0.9 * len(truth), rel=0.03)


def test_mean_number_of_stereo_markers_is_the_papers(hand: HandModel, glove: GloveModel) -> None:
    """Lee et al. 2021 matched 10.93 markers on average."""
    counts = []
    for seed in range(5):
        motion = RandomPostures(hand, seed, duration=60)
        scene = SimulatedScene(Wearer(hand, glove, seed), motion, ideal_rig(), seed)
        for t in np.arange(0.1, 59, 1.0):
            left, right = scene.visible(t)
            counts.append(int((left & right).sum()))
    assert 10.0 <= np.mean(counts) <= 12.0


def test_images_are_reproducible_and_differ_in_time(hand: HandModel, glove: GloveModel) -> None:
    def pair(t: float) -> np.ndarray:
        scene = SimulatedScene(Wearer(hand, glove, 2), RandomPostures(hand, 2), ideal_rig(), 2)
        return Renderer(scene, RenderParams(background=BackgroundParams("painted"))).pair(t)[0]

    np.testing.assert_array_equal(pair(2.0), pair(2.0))
    assert np.any(pair(2.0) != pair(2.2))


def test_motion_blur(hand: HandModel, glove: GloveModel) -> None:
    """A fast hand blurs its markers' edges along its motion; a still one does not."""

    class Slide:
        duration, follows_synergies = 2.0, True

        def __init__(self, speed: float) -> None:
            self.speed = speed

        def poses(self, t: np.ndarray):  # type: ignore[no-untyped-def]
            at = Still(np.zeros(len(hand.joint_names)), np.eye(3), np.array([0.08, 0.0, 0.1]))
            poses = at.poses(t)
            return poses._replace(p_GB=poses.p_GB + np.outer(t - 1.0, [0, self.speed, 0]))

    def sharpness(speed: float) -> float:
        scene = SimulatedScene(Wearer.exact(hand, glove), Slide(speed), ideal_rig(), 0)
        image = Renderer(scene, RenderParams(noise=0)).pair(1.0)[0].astype(float)
        return float(np.abs(np.diff(image, axis=1)).max())

    assert sharpness(1.5) < 0.75 * sharpness(0.0)


@pytest.mark.parametrize("hue", ["red", "yellow", "green", "blue"])
def test_fabrics_have_the_default_profiles_hues(hue: str) -> None:
    bgr = np.array([[fabric_bgr(hue)]], np.uint8)
    assert abs(int(cv2.cvtColor(bgr, cv2.COLOR_BGR2HSV)[0, 0, 0]) - HUE[hue]) <= 1
    assert FABRIC_HSV[hue][1] > 150


def test_unknown_fabric_and_image_are_rejected() -> None:
    with raises(ConfigError, "simulate.no_fabric", hue="plaid"):
        fabric_bgr("plaid")


def test_missing_photograph_is_reported(flat: SimulatedScene) -> None:
    params = RenderParams(background=BackgroundParams("photograph", "nowhere.jpg"))
    with raises(FileError, "images.not_readable"):
        Renderer(flat, params)


def test_lens_distortion_affects_images_and_blobs_alike(hand: HandModel, glove: GloveModel) -> None:
    ideal, D = ideal_rig(), np.array([-0.17, 0.027, 0.0004, -0.0003, 0.0])
    bent = StereoRig(replace(ideal.left, D=D), replace(ideal.right, D=D), ideal.pose)
    place = np.array([0.06, 0.12, 0.10])  # to the side, where the distortion is largest
    still = Still(np.zeros(len(hand.joint_names)), np.eye(3), place)
    scene = SimulatedScene(Wearer.exact(hand, glove), still, bent, 1, NOISELESS)
    straight = SimulatedScene(Wearer.exact(hand, glove), still, ideal, 1, NOISELESS)
    seen = scene.markers_seen(scene.instant(0.0), False)
    unbent = straight.markers_seen(straight.instant(0.0), False)
    image = Renderer(scene, RenderParams(noise=0.0)).pair(0.0)[0]
    shown = seen.visible & (seen.facing > 0.6)
    assert shown.sum() >= 6
    assert np.linalg.norm(seen.uv[shown] - unbent.uv[shown], axis=1).min() > 3
    for m in np.flatnonzero(shown):
        gap = abs(_hue_of(image, seen.uv[m]) - HUE[glove.markers[m].hue])
        assert min(gap, 180 - gap) <= 5, m


def test_a_pixel_shows_the_patch_that_covers_its_point(hand: HandModel, glove: GloveModel) -> None:
    """Even light, no noise: an image of nothing but fabrics, cloth and wall. Each pixel is
    recomputed, its point in its segment's own frame, against all patches of the segment."""
    rig = ideal_rig(200, 150)
    scene = SimulatedScene(Wearer(hand, glove, 3), RandomPostures(hand, 3), rig, 3)
    renderer = Renderer(scene, RenderParams(noise=0.0, ambient=1.0, exposures=1))
    image = renderer.pair(2.0)[0].astype(int)
    now, eye = scene.instant(2.0), np.zeros(3)
    K = np.array([rig.fx, rig.fy, rig.cx, rig.cy])
    pixels = pixels_of(bounds(now.solids, eye, K), rig.left)
    rays = ray_map(rig.left)
    buffer = Buffer(np.empty((150, 200), np.float32), np.empty((150, 200), np.int16))
    view = PixelRays(rays, pitch_of(rays), JITTER_PX[0] / K[:2], eye, np.zeros(2, np.int64))
    draw(view, pixels, now.solids, buffer)
    order, patches = patches_of_all(scene.wearers, lambda hue: np.array(fabric_bgr(hue)))
    patches = patches._replace(position=now.markers[order])
    owner = np.concatenate([now.solids.owner, now.solids.box_owner])
    on_patch = wrong = 0
    for v, u in np.argwhere(buffer.solid >= 0):
        segment = owner[buffer.solid[v, u]]
        if segment < 0:
            continue
        x, y = rays[v, u] + view.jitter
        q = float(buffer.depth[v, u]) * np.array([x, y, 1.0])
        m = patch_at((q[0], q[1], q[2]), now.R_CB, now.p_CB, segment, patches)
        expected = patches.fabric[m] if m >= 0 else np.array(GLOVE_BGR)
        on_patch += m >= 0
        wrong += bool(np.abs(image[v, u] - expected).max() > 1)
    assert on_patch > 50
    assert wrong <= 2  # single precision, on an edge
