"""Ring and little finger, which carry no sensors, measured by the cloth of a drawn hand."""

import copy
from dataclasses import replace

import numpy as np
import pytest

from tests.cloth_masks import cloth_of
from tests.cloth_scene import CAMERA, TIPS, Capsule, Scene, outline
from tracker.engine.pipeline import Pipeline
from tracker.engine.settings import Settings
from tracker.fusion.chain.cloth_fingers import LASTS
from tracker.fusion.chain.confidence import MEASURED_SD
from tracker.fusion.chain.params import ChainParams, ClothParams
from tracker.fusion.chain.recognition import SeenImage
from tracker.fusion.chain.tracker import ChainTracker
from tracker.gestures.shape import ShapeReader
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.hand.names import FINGERS
from tracker.hand.openxr import JOINTS, joint_radii, to_openxr
from tracker.messages import (
    BlobFrame,
    ImuSample,
    Validity,
)
from tracker.simulation.random_postures import RandomPostures
from tracker.simulation.scenario import Simulation


@pytest.mark.parametrize("bent", [(30.0, 0.0), (-10.0, 20.0)])
def test_fingers_are_measured_that_do_not_follow_their_neighbours(
    hand: HandModel, glove: GloveModel, bent: tuple[float, float]
) -> None:
    scene = Scene(hand, glove, {"ring": (0.0, 0.0), "little": bent})
    unseen = scene.estimate()
    before = scene.point(unseen, "little_tip")
    after = scene.look()
    for name in TIPS:
        off, sd, _ = scene.point(after, name)
        assert off < 0.012  # the accuracy expected of a finger in plain sight
        assert off < 3 * sd
    assert scene.point(after, "little_tip")[0] < max(0.5 * before[0], 0.006)
    assert scene.point(after, "ring_tip")[2] == int(Validity.MEASURED)
    assert before[2] == int(Validity.INFERRED)
    # Gestures and OpenXR's joints follow.
    names, ring = glove.keypoint_names(hand), FINGERS.index("ring")
    shapes = [ShapeReader(hand, names).read(e) for e in (unseen, after)]
    assert [shape.measured[ring] for shape in shapes] == [False, True]
    true = np.deg2rad(bent[0] + 1.67 * bent[1])
    assert abs(shapes[1].bend[ring + 1] - true) < abs(shapes[0].bend[ring + 1] - true)
    joints = to_openxr(after, names, joint_radii(hand))
    tip, index = JOINTS.index("ring_tip"), JOINTS.index("index_tip")
    assert joints.state[tip] == int(Validity.MEASURED)
    apart = np.linalg.norm(joints.position[tip] - joints.position[index])
    assert abs(apart - np.linalg.norm(scene.tip("ring_tip") - scene.tip("index_tip"))) < 0.012


def test_nothing_is_claimed_where_the_background_has_the_gloves_colours(
    hand: HandModel, glove: GloveModel
) -> None:
    scene = Scene(hand, glove, {"ring": (0.0, 0.0), "little": (40.0, 50.0)})
    before = scene.estimate()
    after = scene.look(radius=1.0)
    assert not len(scene.fingers.saved.posterior)
    assert np.array_equal(after.keypoints, before.keypoints)
    assert np.array_equal(after.keypoint_sd, before.keypoint_sd)


def test_fingers_that_merge_with_an_object_stay_near_their_neighbours_posture(
    hand: HandModel, glove: GloveModel
) -> None:
    """A dark cushion under them: nothing suggests that they do not follow."""
    scene = Scene(hand, glove, {"ring": (0.0, 0.0), "little": (20.0, 30.0)})
    before = scene.estimate()
    after = scene.look(radius=0.06)
    assert len(scene.fingers.saved.posterior)
    assert np.linalg.norm(after.keypoints - before.keypoints, axis=1).max() < 0.015
    assert np.array_equal(after.keypoint_state, before.keypoint_state)
    for name in TIPS:
        off, sd, _ = scene.point(after, name)
        assert off < 3 * sd
        assert sd >= scene.point(before, name)[1]


def disturbances(scene: Scene) -> dict[str, list[Capsule]]:
    """Other things of the glove's colour next to a hand."""
    hand = scene.layout.hand
    wrist, (X, Y, Z) = scene.p[hand.root], scene.R[hand.root].T
    knuckles = [scene.p[hand.index[f"{f}_proximal"]] for f in ("index", "little")]
    out = (knuckles[1] - knuckles[0]) / np.linalg.norm(knuckles[1] - knuckles[0])
    sides = [wrist + 0.03 * X + side * Y for side in (-0.03, 0.0, 0.03)]
    tips = scene.tip("index_tip"), scene.tip("little_tip")
    in_palm = knuckles[1] + 0.03 * X - 0.03 * Z
    return {
        "a sleeve": [(side, side - 0.2 * X, 0.035) for side in sides],
        "a second glove": scene.capsules(0.09 * out),
        "a second glove across": scene.capsules(0.05 * out + 0.06 * X - 0.03 * Z),
        "a pen across the tips": [(tips[0] - 0.04 * out, tips[1] + 0.08 * out, 0.005)],
        "a ball in the hand": [(in_palm, in_palm, 0.035)],
        "a shadow": scene.capsules(-0.1 * Z + 0.05 * out + 0.03 * X),
    }


@pytest.mark.long
@pytest.mark.parametrize("bent", [(40.0, 50.0), (-10.0, 20.0)])
def test_nothing_false_is_measured_beside_other_things_of_the_gloves_colour(
    hand: HandModel, glove: GloveModel, bent: tuple[float, float]
) -> None:
    ring = (0.0, 0.0) if bent[0] > 0.0 else (30.0, 30.0)
    plain = Scene(hand, glove, {"ring": ring, "little": bent})
    seen = {name: plain.point(plain.look(), name)[2] for name in TIPS}
    assert int(Validity.MEASURED) in seen.values()
    for name, beside in disturbances(plain).items():
        scene = Scene(hand, glove, {"ring": ring, "little": bent})
        found = scene.look(beside=beside)
        for tip in TIPS:
            off, sd, state = scene.point(found, tip)
            assert off < 3 * sd, (name, tip)
            assert state != int(Validity.MEASURED) or off < 0.025, (name, tip)
            if name == "a sleeve":
                assert state == seen[tip]


@pytest.mark.long
@pytest.mark.parametrize("bent", [(60.0, 80.0), (95.0, 100.0), (80.0, 90.0)])
def test_a_shadow_near_the_hand_is_not_a_finger(
    hand: HandModel, glove: GloveModel, bent: tuple[float, float]
) -> None:
    """Its outline is where an extended ring finger would be, but it is 3 cm farther away."""
    little = (0.0, 0.0) if bent[0] == 80.0 else (95.0, 100.0)
    scene = Scene(hand, glove, {"ring": bent, "little": little})
    (X, Y, Z), knuckles = scene.R[hand.root].T, [f"{f}_proximal" for f in ("middle", "little")]
    middle, outer = (scene.p[hand.index[name]] for name in knuckles)
    outwards = np.sign((outer - middle) @ Y) * Y
    shadow = scene.capsules(-0.03 * Z + 0.015 * outwards + 0.009 * X)
    states = scene.point(scene.look_at_texture(shadow), "ring_tip")
    assert states[2] == int(Validity.INFERRED)
    alone = Scene(hand, glove, {"ring": (0.0, 0.0), "little": little})
    off, sd, state = alone.point(alone.look_at_texture(), "ring_tip")
    assert state == int(Validity.MEASURED) and off < 0.01 and off < 3 * sd


@pytest.mark.long
@pytest.mark.parametrize("bent", [(60.0, 80.0), (95.0, 100.0)])
def test_a_bar_in_place_of_a_finger_is_longer_than_one(
    hand: HandModel, glove: GloveModel, bent: tuple[float, float]
) -> None:
    extended = Scene(hand, glove, {})
    knuckle, tip = extended.p[hand.index["ring_proximal"]], extended.tip("ring_tip")
    bar = [(knuckle + 0.2 * (tip - knuckle), tip + 0.5 * (tip - knuckle), 0.008)]
    for look in (Scene.look, Scene.look_at_texture):
        scene = Scene(hand, glove, {"ring": bent, "little": bent})
        assert scene.point(look(scene, beside=bar), "ring_tip")[2] == int(Validity.INFERRED)


def test_fingers_under_the_palm_are_inferred_where_their_neighbour_is_extended(
    hand: HandModel, glove: GloveModel
) -> None:
    """The image shows that they do not follow it, but not where they are."""
    scene = Scene(hand, glove, {"ring": (95.0, 100.0), "little": (95.0, 100.0)})
    before, after = scene.estimate(), scene.look()
    for name in TIPS:
        off, sd, state = scene.point(after, name)
        assert state == int(Validity.INFERRED) and sd > MEASURED_SD
        assert off < min(3.5 * sd, scene.point(before, name)[0])


def test_an_image_of_a_fast_camera_is_evaluated_for_one_finger(
    hand: HandModel, glove: GloveModel
) -> None:
    """Which limits what an image costs; both are still evaluated as often as with a slow camera."""
    scene = Scene(hand, glove, {"ring": (0.0, 0.0), "little": (30.0, 0.0)})
    left, right = (scene.image(side, 0.0) for side in (False, True))
    times = []
    for _ in range(31):
        scene.state.t += 1 / 60
        frame = BlobFrame(scene.state.t, scene.state.t, (), left, right)
        scene.fingers.image(scene.state, frame, CAMERA)
        times.append(scene.fingers.saved.fitted_at)
    changes = np.diff(np.array(times), axis=0) > 0.0
    assert changes.sum(axis=1).max() == 1
    assert changes.sum(axis=0).min() >= 4  # in half a second
    found = scene.estimate()
    for name in TIPS:
        off, sd, _ = scene.point(found, name)
        assert off < 0.012 and off < 3 * sd


def test_a_saved_state_continues_identically(hand: HandModel, glove: GloveModel) -> None:
    scene = Scene(hand, glove, {"ring": (0.0, 0.0), "little": (40.0, 50.0)})
    scene.look()
    other = Scene(hand, glove, {"ring": (0.0, 0.0), "little": (40.0, 50.0)})
    other.state.t = scene.state.t
    other.fingers.restore(copy.deepcopy(scene.fingers.saved))
    assert np.array_equal(other.estimate().keypoints, scene.estimate().keypoints)
    assert np.array_equal(other.look().keypoints, scene.look().keypoints)


def test_fingers_follow_their_neighbours_again_without_images(
    hand: HandModel, glove: GloveModel
) -> None:
    scene = Scene(hand, glove, {"ring": (0.0, 0.0), "little": (40.0, 50.0)})
    before = scene.estimate()
    scene.look()
    scene.fingers.no_image(scene.state.t + LASTS / 2)
    assert not np.array_equal(scene.estimate().keypoints, before.keypoints)
    scene.fingers.no_image(scene.state.t + 1.1 * LASTS)
    assert np.array_equal(scene.estimate().keypoints, before.keypoints)


def with_cloth(sim: Simulation, frame: BlobFrame) -> BlobFrame:
    """The frame as learned colours would show it."""
    true = sim.truth(frame.t)
    left, right = (
        replace(side, cloth=cloth_of(outline(sim.hand, sim.rig, true.R_GB, true.p_GB, bool(c))))
        for c, side in enumerate((frame.left, frame.right))
        if side is not None
    )
    return replace(frame, left=left, right=right)


@pytest.mark.long
def test_an_engine_measures_them_unless_it_is_set_not_to(
    hand: HandModel, glove: GloveModel
) -> None:
    sim = Simulation(hand, glove, RandomPostures(hand, 1, duration=0.9), 1, fps=10)
    messages = [
        with_cloth(sim, m) if isinstance(m, BlobFrame) and m.t > 0.6 else m for m in sim.feed()
    ]
    row, shown = glove.keypoint_names(hand).index("ring_tip"), []
    for enabled in (False, True):
        params = ChainParams(cloth=ClothParams(fingers=enabled))
        pipeline = Pipeline(hand, glove, sim.rig, Settings(chain=params))
        for message in messages:
            if isinstance(message, ImuSample):
                last = pipeline.feed_imu(message)
            else:
                pipeline.feed_frame(message)
        off = np.linalg.norm(last.keypoints[row] - sim.truth(last.t).keypoints[row])
        assert off < 3 * last.keypoint_sd[row]
        shown.append(last)
    assert ChainParams().cloth.fingers
    assert not np.array_equal(shown[0].keypoints[row], shown[1].keypoints[row])
    assert shown[1].keypoint_sd[row] < 0.75 * shown[0].keypoint_sd[row]


@pytest.mark.long
def test_an_image_of_a_fast_camera_is_evaluated_for_fingertips_or_for_one_finger(
    hand: HandModel, glove: GloveModel, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Which limits what an image costs."""
    sim = Simulation(hand, glove, RandomPostures(hand, 1, duration=0.9), 1, fps=30)
    look, times = ChainTracker.measure_cloth, []

    def looked(self: ChainTracker, image: SeenImage) -> None:
        look(self, image)
        fitted = self._fingers.saved.fitted_at
        times.append((max(self._tips.saved.t, -1.0), *(fitted if len(fitted) else (-1.0, -1.0))))

    monkeypatch.setattr(ChainTracker, "measure_cloth", looked)
    pipeline = Pipeline(hand, glove, sim.rig, Settings())
    for message in sim.feed():
        if isinstance(message, ImuSample):
            pipeline.feed_imu(message)
        else:
            pipeline.feed_frame(with_cloth(sim, message) if message.t > 0.3 else message)
    changed = np.diff(np.array(times), axis=0) > 0.0
    since = (
        int(np.argmax(changed[:, 1:].all(axis=1))) + 1
    )  # the first image with cloth: all at once
    assert changed[since:].sum(axis=1).max() == 1
    assert changed[since:].sum(axis=0).min() >= 4  # in 0.6 s
