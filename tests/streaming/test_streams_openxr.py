"""OpenXR's joints on every way out: the same hand as `to_openxr` gives, and nothing where lost."""

from __future__ import annotations

import json
import socket

import numpy as np
import pytest
from numpy.testing import assert_allclose
from pythonosc.osc_bundle import OscBundle

from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.hand.openxr import JOINTS, joint_radii, to_openxr
from tracker.streaming.foxglove_scene import estimate_schema
from tracker.streaming.osc import OPENXR_JOINT, VmcPublisher
from tracker.streaming.params import StreamParams, open_publishers, with_streams
from tracker.streaming.payload import to_json
from tracker.streaming.publisher import LOOPBACK, OPENXR, Names, StreamError

LOST = ("middle_mcp",)
GONE = ("palm", "middle_metacarpal", "middle_proximal")


@pytest.fixture
def openxr(hand: HandModel, glove: GloveModel) -> Names:
    return Names.of(hand, glove, OPENXR)


def test_json_has_26_joints_and_null_for_what_is_lost(make_estimate, openxr: Names, hand) -> None:
    e = make_estimate(lost=LOST)
    read = json.loads(to_json(e, openxr))
    wanted = to_openxr(e, openxr.keypoints, joint_radii(hand))
    assert tuple(read["joints"]) == JOINTS and "keypoints" not in read
    for i, name in enumerate(JOINTS):
        said = read["joints"][name]
        if name in GONE:
            assert said == {
                "state": "lost",
                "position": None,
                "orientation_xyzw": None,
                "radius": None,
            }
            continue
        assert_allclose(said["position"], wanted.position[i], atol=1e-6)
        assert_allclose(said["orientation_xyzw"], wanted.orientation[i], atol=1e-6)
        assert said["radius"] == pytest.approx(wanted.radius[i], abs=1e-6)
    assert tuple(read["angles"]) == openxr.angles


def test_the_schema_for_foxglove_lists_every_joint(make_estimate, openxr: Names) -> None:
    fields = estimate_schema(openxr)["properties"]
    said = json.loads(to_json(make_estimate(), openxr, openxr.recogniser()))
    assert fields.keys() == said.keys()
    for part in ("joints", "angles"):
        assert fields[part]["properties"].keys() == said[part].keys()
    joint = fields["joints"]["properties"]["palm"]["properties"]
    assert joint.keys() == said["joints"]["palm"].keys()


def test_osc_has_a_bundle_of_joints_that_python_osc_reads(make_estimate, openxr, hand) -> None:
    e = make_estimate(lost=LOST)
    wanted = to_openxr(e, openxr.keypoints, joint_radii(hand))
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as client:
        client.bind((LOOPBACK, 0))
        client.settimeout(5)
        publisher = VmcPublisher(hand, LOOPBACK, client.getsockname()[1], openxr)
        publisher.send(e)
        client.recv(65536)  # VMC's own
        told = {m.params[0]: m.params[1:] for m in OscBundle(client.recv(65536))}
        assert all(m.address == OPENXR_JOINT for m in OscBundle(_again(publisher, e, client)))
        publisher.close()
    assert tuple(told) == JOINTS
    for i, name in enumerate(JOINTS):
        if name in GONE:
            assert told[name] == ["lost"]
        else:
            pose = [*wanted.position[i], *wanted.orientation[i], wanted.radius[i]]
            assert_allclose(told[name][:8], pose, atol=1e-6)


def _again(publisher: VmcPublisher, e, client: socket.socket) -> bytes:
    publisher.send(e)
    client.recv(65536)
    return client.recv(65536)


def test_lsl_labels_pose_radius_and_state(make_estimate, openxr: Names, hand) -> None:
    lsl = pytest.importorskip("tracker.streaming.lsl", exc_type=(ImportError, RuntimeError))
    e = make_estimate(lost=LOST)
    labels = [label for label, _ in lsl.channels(openxr)]
    read = dict(zip(labels, lsl.sample(e, openxr), strict=True))
    wanted = to_openxr(e, openxr.keypoints, joint_radii(hand))
    i = JOINTS.index("ring_tip")
    pose = [read[f"ring_tip_{c}"] for c in ("x", "y", "z", "qx", "qy", "qz", "qw", "radius")]
    assert_allclose(pose, [*wanted.position[i], *wanted.orientation[i], wanted.radius[i]])
    assert read["ring_tip_state"] == 2 and read["palm_state"] == 0
    assert np.isnan([read["palm_x"], read["palm_qw"], read["palm_radius"]]).all()


def test_the_choice_is_made_for_all_outputs_and_refused_in_words(hand, glove) -> None:
    params = with_streams(StreamParams(), "udp", joints=OPENXR)
    assert params.joints == OPENXR
    with pytest.raises(StreamError, match=r"own or openxr, not 'mano'"):
        open_publishers(StreamParams(joints="mano"), hand, glove)
