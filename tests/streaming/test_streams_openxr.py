"""OpenXR's joints in every output: the same hand as `to_openxr`, without lost parts."""

from __future__ import annotations

import json

import pytest
from numpy.testing import assert_allclose

from tests.notices import raises
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.hand.openxr import JOINTS, joint_radii, to_openxr
from tracker.streaming.payload import to_json
from tracker.streaming.publisher import OPENXR, Names, StreamError
from tracker.streaming.registry import StreamSettings, with_streams

LOST = ("middle_mcp",)
GONE = ("palm", "middle_metacarpal", "middle_proximal")


@pytest.fixture
def openxr(hand: HandModel, glove: GloveModel) -> Names:
    return Names.of(hand, glove, OPENXR)


def test_json_has_26_joints_and_null_for_lost_ones(make_estimate, openxr: Names, hand) -> None:
    e = make_estimate(lost=LOST)
    read = json.loads(to_json(e, openxr))
    wanted = to_openxr(e, openxr.keypoints, joint_radii(hand))
    assert tuple(read["joints"]) == JOINTS and "keypoints" not in read
    for i, name in enumerate(JOINTS):
        joint = read["joints"][name]
        if name in GONE:
            assert joint == {
                "state": "lost",
                "position": None,
                "orientation_xyzw": None,
                "radius": None,
            }
            continue
        assert_allclose(joint["position"], wanted.position[i], atol=1e-6)
        assert_allclose(joint["orientation_xyzw"], wanted.orientation[i], atol=1e-6)
        assert joint["radius"] == pytest.approx(wanted.radius[i], abs=1e-6)
    assert tuple(read["angles"]) == openxr.angles


def test_the_option_applies_to_all_outputs_and_is_validated(hand, glove) -> None:
    settings = with_streams(StreamSettings(), "udp", joints=OPENXR)
    assert settings.joints == OPENXR
    with raises(StreamError, "stream.joints"):
        Names.of(hand, glove, "mano")
