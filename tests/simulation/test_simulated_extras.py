"""Objects and devices occlude markers; distractors look like markers."""

import numpy as np
import pytest

from extensions.evaluation.vist.scenes import OBJECTS, Distractors, FingertipDevices, HeldObject
from tests.notices import raises
from tracker.base.errors import ConfigError
from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.simulation.motion import Still
from tracker.simulation.render import Renderer
from tracker.simulation.scene import BlobParams, Extra, SimulatedScene
from tracker.simulation.wearer import Wearer
from tracker.vision.rig import ideal_rig

NOISELESS = BlobParams(noise_px=0, dropout=0, size_noise=0)


def _scene(hand: HandModel, glove: GloveModel, turn: float, *extras: Extra) -> SimulatedScene:
    at = Still(np.zeros(len(hand.joint_names)), so3.rx(turn), np.array([0.08, 0.0, 0.1]))
    return SimulatedScene(Wearer.exact(hand, glove), at, ideal_rig(), 1, NOISELESS, extras)


@pytest.mark.parametrize("kind", OBJECTS)
def test_object_is_occluded_by_the_back_and_occludes_the_palm(
    hand: HandModel, glove: GloveModel, kind: str
) -> None:
    thing = HeldObject(hand, kind)
    for turn, hides in ((0.0, False), (np.pi, True)):
        bare = _scene(hand, glove, turn).visible(0.0)[0]
        held = _scene(hand, glove, turn, thing).visible(0.0)[0]
        dorsum = np.array([m.segment == "dorsum" for m in glove.markers])
        assert not np.any(held & ~bare)
        if not hides:
            assert np.array_equal(bare[dorsum], held[dorsum])
        elif kind not in ("pen", "stick"):
            assert held.sum() < bare.sum()


def test_unknown_object_is_rejected(hand: HandModel) -> None:
    with raises(ConfigError, "option.choice", value="piano"):
        HeldObject(hand, "piano")


def test_devices_are_boxes_at_the_tips(hand: HandModel, glove: GloveModel) -> None:
    scene = _scene(hand, glove, 0.0)
    R, p, _ = scene.wearer.segments(scene.motion, np.zeros(1))
    tip = scene.wearer.keypoints(R[0], p[0])[hand.keypoint_names.index("index_tip")]
    solids = FingertipDevices(hand).solids(0.0, R[0], p[0])
    local = solids.box_R[1].T @ (tip - solids.centre[1])
    assert np.all(np.abs(local) < solids.half[1])


def test_distractors_are_blobs_unless_behind_the_hand(hand: HandModel, glove: GloveModel) -> None:
    distractors = Distractors(3, 60)
    frame = _scene(hand, glove, 0.0, distractors).blobs(0.5)
    bare = _scene(hand, glove, 0.0).blobs(0.5)
    assert frame.left is not None and bare.left is not None
    more = len(frame.left) - len(bare.left)
    assert 30 < more <= 60


def test_distractors_move_only_on_request(hand: HandModel) -> None:
    still, moving = Distractors(3), Distractors(3, moving=0.05)
    np.testing.assert_array_equal(still.coloured(0.0)[0], still.coloured(2.0)[0])
    step = moving.coloured(2.0)[0] - moving.coloured(0.0)[0]
    assert 0.02 < step.std() < 0.12


def test_distractors_are_drawn_where_they_are_detected(hand: HandModel, glove: GloveModel) -> None:
    scene = _scene(hand, glove, 0.0, Distractors(3, 60))
    frame, image = scene.blobs(0.5), Renderer(scene).pair(0.5)[0]
    assert frame.left is not None
    for uv, hue in zip(frame.left.uv, frame.left.hue, strict=True):
        u, v = np.round(uv).astype(int)
        b, g, r = image[v, u].astype(int)
        name = frame.hue_names[hue]
        largest = {"red": r, "green": g, "blue": b, "yellow": min(r, g)}[name]
        assert largest >= max(b, g, r) * (0.8 if name == "yellow" else 1.0)
