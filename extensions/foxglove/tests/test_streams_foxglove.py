"""The Foxglove server, read by a client written from the protocol's specification.

Protocol: github.com/foxglove/ws-protocol.
"""

from __future__ import annotations

import contextlib
import json
import socket
import struct
import time
from collections.abc import Iterator
from dataclasses import replace
from io import BytesIO
from typing import Any

import numpy as np
import pytest

pytest.importorskip("websockets", reason="websockets is not installed (extra `streams`)")
import jsonschema
import yourdfpy
from rosbags.typesys import Stores, get_types_from_msg, get_typestore
from scipy.spatial.transform import Rotation
from websockets.exceptions import InvalidStatus
from websockets.sync.client import ClientConnection, connect

from extensions.foxglove.live import FoxglovePublisher
from extensions.foxglove.scene import estimate_schema
from tests.notices import raises, shows
from tests.streaming.recorded_hand import (
    OPENXR_JOINTS,
    RecordedHand,
    assert_near,
    assert_parallel,
)
from tracker.base.clock import ClockAnchor
from tracker.hand.names import bones
from tracker.messages import Estimate, Validity
from tracker.streaming.client_queue import BACKLOG
from tracker.streaming.payload import LATEST, to_json
from tracker.streaming.publisher import Names, StreamError

PROTOCOL, OLD_PROTOCOL, MESSAGE_DATA = "foxglove.sdk.v1", "foxglove.websocket.v1", 1
TOPIC = "/glovetrack/right"


@pytest.fixture
def server(names: Names) -> Iterator[FoxglovePublisher]:
    out = FoxglovePublisher(replace(names, anchor=ClockAnchor(10**12, 0)), port=0)
    yield out
    out.close()


class Client:
    """Connects, reads the advertised channels, subscribes."""

    def __init__(self, connection: ClientConnection) -> None:
        self.connection = connection
        self.info = self.text("serverInfo")
        self.channels = {c["topic"]: c for c in self.text("advertise")["channels"]}

    def text(self, op: str) -> dict:
        message = json.loads(self.connection.recv(timeout=60))
        assert message["op"] == op
        return message

    def say(self, op: str, **words: object) -> None:
        self.connection.send(json.dumps({"op": op, **words}))

    def subscribe(self, topic: str, number: int = 7) -> None:
        channel = self.channels[topic]["id"]
        self.say("subscribe", subscriptions=[{"id": number, "channelId": channel}])

    def message(self, number: int = 7) -> tuple[int, dict]:
        """Time in ns and content of the next message."""
        stamp, data = self.bytes(number)
        return stamp, json.loads(data)

    def ros(self, topic: str, number: int = 7) -> Any:
        """The next message of ROS 2, read by ``rosbags`` with the advertised definition."""
        channel, store = self.channels[topic], get_typestore(Stores.EMPTY)
        assert (channel["encoding"], channel["schemaEncoding"]) == ("cdr", "ros2msg")
        store.register(get_types_from_msg(channel["schema"], channel["schemaName"]))
        return store.deserialize_cdr(self.bytes(number)[1], channel["schemaName"])

    def bytes(self, number: int) -> tuple[int, bytes]:
        """Time in ns and payload of the next message."""
        data = self.connection.recv(timeout=60)
        assert isinstance(data, bytes)
        opcode, subscription, stamp = struct.unpack_from("<BIQ", data)
        assert (opcode, subscription) == (MESSAGE_DATA, number)
        return stamp, data[13:]


@contextlib.contextmanager
def connected(server: FoxglovePublisher, protocol: str = PROTOCOL) -> Iterator[Client]:
    url = f"ws://127.0.0.1:{server.port}"
    with connect(url, subprotocols=[protocol]) as connection:  # type: ignore[list-item]
        yield Client(connection)


@pytest.fixture
def client(server: FoxglovePublisher) -> Iterator[Client]:
    with connected(server) as out:
        yield out


def test_what_is_advertised(client: Client, names: Names) -> None:
    assert client.info["name"] == "Glovetrack"
    assert client.info["capabilities"] == []
    assert {(c["encoding"], c["schemaEncoding"]) for c in client.channels.values()} == {
        ("json", "jsonschema"),
        ("cdr", "ros2msg"),
    }
    schema = json.loads(client.channels[TOPIC]["schema"])
    assert tuple(schema["properties"]["keypoints"]["properties"]) == names.keypoints
    assert client.channels[f"{TOPIC}/scene"]["schemaName"] == "foxglove.SceneUpdate"


def unreadable(schema: dict, where: str = "") -> Iterator[str]:
    """Fields that Foxglove cannot read; its parseJsonSchema.ts refuses a channel for one."""
    for name, field in schema["properties"].items():
        place = f"{where}.{name}"
        if "oneOf" in field:
            if not all(isinstance(choice["const"], int) for choice in field["oneOf"]):
                yield place
        elif field.get("type") == "array":
            yield from unreadable({"properties": {"item": field["items"]}}, place)
        elif field.get("type") == "object":
            yield from unreadable(field, place)
        elif field.get("type") not in ("boolean", "string", "number", "integer"):
            yield place


def test_foxglove_can_read_the_schemas(client: Client) -> None:
    assert list(unreadable({"properties": {"x": {"type": ["number", "null"]}}})) == [".x"]
    for channel in client.channels.values():
        if channel["encoding"] != "json":
            continue
        schema = json.loads(channel["schema"])
        assert schema["type"] == "object"
        assert list(unreadable(schema)) == []


def test_json_carries_every_state(client, server, make_estimate, wait_for) -> None:
    client.subscribe(TOPIC)
    wait_for(lambda: server.clients == 1)
    server.send(make_estimate(2.5, lost=("thumb_tip",)))
    stamp, read = client.message()
    assert stamp == 1_002_500_000_000
    assert read["t"] == 2.5
    assert read["keypoints"]["thumb_tip"] == {
        "state": "lost",
        "position": None,
        "orientation_xyzw": None,
        "sd": None,
    }
    assert read["keypoints"]["wrist"]["state"] == "measured"


def test_a_lost_joint_is_not_in_the_scene(client, server, make_estimate, names, wait_for) -> None:
    client.subscribe(f"{TOPIC}/scene")
    wait_for(lambda: server.clients == 1)
    estimate = make_estimate(2.5, lost=("thumb_tip",))
    server.send(estimate)
    _, scene = client.message()
    jsonschema.validate(scene, json.loads(client.channels[f"{TOPIC}/scene"]["schema"]))
    (entity,) = scene["entities"]
    assert (entity["frame_id"], entity["timestamp"]) == ("world", {"sec": 1002, "nsec": 500000000})
    states = {pair["key"]: pair["value"] for pair in entity["metadata"]}
    assert states["thumb_tip"] == "lost" and states["wrist"] == "measured"
    assert tuple(states) == ("tracking", *names.keypoints)
    known = estimate.keypoint_state != Validity.LOST
    places = [s["pose"]["position"] for s in entity["spheres"]]
    read = np.array([[p[axis] for axis in "xyz"] for p in places])
    assert np.allclose(read, estimate.keypoints[known], atol=1e-6)
    (lines,) = entity["lines"]
    assert len(lines["points"]) == 2 * (len(bones(names.keypoints)) - 1)


def test_an_inferred_joint_looks_different(client, server, make_estimate, names, wait_for) -> None:
    client.subscribe(f"{TOPIC}/scene")
    wait_for(lambda: server.clients == 1)
    estimate = make_estimate(2.5)
    state = estimate.keypoint_state.copy()
    tip = names.keypoints.index("thumb_tip")
    state[tip] = int(Validity.INFERRED)
    server.send(replace(estimate, keypoint_state=state))
    (entity,) = client.message()[1]["entities"]
    pale = entity["spheres"].pop(tip)
    assert pale["size"]["x"] < min(s["size"]["x"] for s in entity["spheres"])
    assert pale["color"] not in [s["color"] for s in entity["spheres"]]
    measured, inferred = entity["lines"]
    assert len(inferred["points"]) == 2 < len(measured["points"])


def test_joint_states_are_read_by_rosbags(recorded: RecordedHand, wait_for) -> None:
    """Of a recording; angles that are lost are left out, as in recordings."""
    with served(recorded) as (server, client):
        client.subscribe(f"{TOPIC}/joint_states")
        wait_for(lambda: server.clients == 1)
        for e in recorded.estimates:
            state = e.angle_state.copy()
            state[3] = int(Validity.LOST)
            server.send(replace(e, angle_state=state))
            read = client.ros(f"{TOPIC}/joint_states")
            stamp = read.header.stamp
            assert abs(stamp.sec * 10**9 + stamp.nanosec - recorded.unix_ns(e)) < 1000
            wanted = recorded.angles(e)
            del wanted[recorded.names.angles[3]]
            assert dict(zip(read.name, read.position, strict=True)) == pytest.approx(wanted)


@contextlib.contextmanager
def served(recorded: RecordedHand) -> Iterator[tuple[FoxglovePublisher, Client]]:
    """The stream of the recorded hand, and a client of it."""
    server = FoxglovePublisher(recorded.names, port=0)
    try:
        with connected(server) as client:
            yield server, client
    finally:
        server.close()


def test_frames_and_joints_move_the_model(recorded: RecordedHand, wait_for) -> None:
    """The URDF, read by ``yourdfpy``, has a link for each frame and a joint for each state; the
    frames are those of a recording."""
    names = recorded.names
    with served(recorded) as (server, client):
        client.subscribe(f"{TOPIC}/robot_description", number=1)
        text = client.ros(f"{TOPIC}/robot_description", number=1).data
        model = yourdfpy.URDF.load(
            BytesIO(text.encode()), load_meshes=False, build_scene_graph=False
        )
        client.subscribe(f"{TOPIC}/transforms", number=2)
        wait_for(lambda: server.clients == 1 and client_has(server, 2))
        for e in recorded.estimates:
            server.send(e)
            _, read = client.message(number=2)
            jsonschema.validate(read, json.loads(client.channels[f"{TOPIC}/transforms"]["schema"]))
            frames = {t["child_frame_id"]: t for t in read["transforms"]}
            assert {t["parent_frame_id"] for t in read["transforms"]} == {"world"}
            assert frames.keys() <= model.link_map.keys()
            assert len(frames) == len(names.model.segments)
            check_frames(frames, recorded, e)
    assert set(names.angles) <= model.joint_map.keys()


def check_frames(frames: dict[str, Any], recorded: RecordedHand, e: Estimate) -> None:
    points, turns = recorded.points(e), recorded.turns(e)
    for segment in recorded.names.model.segment_names:
        keypoint = "wrist" if segment == "dorsum" else OPENXR_JOINTS[segment]
        place, turn = (frames[f"right_{segment}"][part] for part in ("translation", "rotation"))
        assert_near([place[a] for a in "xyz"], points[keypoint])
        assert_parallel(Rotation.from_quat([turn[a] for a in "xyzw"]), turns[keypoint])


def client_has(server: FoxglovePublisher, count: int) -> bool:
    """Whether the only client has that many subscriptions."""
    return [len(c.wants.by_channel) for c in server._clients] == [count]


def test_each_client_gets_the_model_once_for_each_subscription(server, make_estimate) -> None:
    for _ in range(2):
        with connected(server) as client:
            client.subscribe(f"{TOPIC}/robot_description", number=4)
            assert client.ros(f"{TOPIC}/robot_description", number=4).data.startswith("<?xml")
            server.send(make_estimate())
            client.say("no such thing")
            client.text("status")  # the reply is the next message: the model is not sent again


def test_names_without_a_glove_have_no_model(make_estimate, names: Names, wait_for) -> None:
    server = FoxglovePublisher(replace(names, glove=None), port=0)
    with connected(server) as client:
        assert f"{TOPIC}/robot_description" not in client.channels
        assert f"{TOPIC}/joint_states" in client.channels
    server.close()


def test_the_previous_protocol_of_foxglove_is_supported(server, make_estimate, wait_for) -> None:
    with connected(server, OLD_PROTOCOL) as client:
        client.subscribe(TOPIC, number=12)
        wait_for(lambda: server.clients == 1)
        server.send(make_estimate(3.0))
        assert client.message(number=12)[1]["t"] == 3.0


def test_clients_without_the_protocol_are_rejected(server) -> None:
    with pytest.raises(InvalidStatus) as refused, connect(f"ws://127.0.0.1:{server.port}"):
        pass
    assert refused.value.response.status_code == 400


def test_unsubscribing_ends_a_topic_and_leaves_the_other(
    client, server, make_estimate, wait_for
) -> None:
    client.subscribe(TOPIC, number=1)
    client.subscribe(f"{TOPIC}/scene", number=2)
    client.say("unsubscribe", subscriptionIds=[1])
    client.subscribe(f"{TOPIC}/scene", number=3)
    client.text("status")  # a channel has one subscription; and all earlier requests were read
    server.send(make_estimate())
    assert "entities" in client.message(number=2)[1]
    client.say("unsubscribe", subscriptionIds=[2])
    wait_for(lambda: server.clients == 0)


@pytest.mark.parametrize(
    ("request_text", "code"),
    [
        ("nonsense", "foxglove.not_understood"),
        ("[]", "foxglove.not_understood"),
        ("[" * 60000, "foxglove.not_understood"),
        ('{"op": "subscribe"}', "foxglove.not_understood"),
        (
            '{"op": "subscribe", "subscriptions": [{"id": -1, "channelId": 1}]}',
            "foxglove.not_understood",
        ),
        (
            '{"op": "subscribe", "subscriptions": [{"id": 1, "channelId": 99}]}',
            "foxglove.no_channel",
        ),
        ('{"op": "getParameters", "parameterNames": []}', "foxglove.no_operation"),
    ],
)
def test_invalid_requests_are_answered_and_the_client_stays(
    client, server, request_text, code
) -> None:
    client.connection.send(request_text)
    status = client.text("status")
    assert status["level"] == 2 and shows(status["message"], code)
    client.subscribe(TOPIC)
    client.say("no such thing")
    client.text("status")
    assert server.clients == 1


@pytest.mark.long
def test_a_slow_client_loses_the_oldest_and_delays_no_one(server, make_estimate, wait_for) -> None:
    """It wakes up after 1500 estimates, about 6 MB: far more than the buffers can contain."""
    with connected(server) as slow, connected(server) as quick:
        slow.subscribe(TOPIC)
        quick.subscribe(TOPIC)
        wait_for(lambda: server.clients == 2)
        estimate, count, took = make_estimate(), 1500, []
        for k in range(count):
            started = time.perf_counter()
            server.send(replace(estimate, t=float(k)))
            took.append(time.perf_counter() - started)
            assert quick.message()[1]["t"] == k
        assert sum(s > 0.5 for s in took) < 10, "a busy computer stalls a few, not every one"
        read = [slow.message()[1]["t"]]
        while read[-1] < count - 1:
            read.append(slow.message()[1]["t"])
    assert read == sorted(read) and len(read) < count
    assert read[-BACKLOG:] == [float(k) for k in range(count - BACKLOG, count)]


def test_without_clients_nothing_is_encoded_and_leaving_is_noticed(
    server, make_estimate, wait_for
) -> None:
    server.send(make_estimate())
    assert server.clients == 0
    with connected(server) as client:
        client.subscribe(TOPIC)
        wait_for(lambda: server.clients == 1)
    wait_for(lambda: server.clients == 0)


def let_in(server: FoxglovePublisher, origin: str) -> bool:
    """Whether a page of ``origin`` may connect."""
    try:
        with connect(
            f"ws://127.0.0.1:{server.port}", subprotocols=[PROTOCOL], origin=origin
        ) as client:
            return json.loads(client.recv(timeout=60))["op"] == "serverInfo"
    except InvalidStatus as refused:
        assert refused.response.status_code == 403
        return False


@pytest.mark.parametrize(
    "origin",
    [
        "https://app.foxglove.dev",
        "http://localhost:8080",
        "http://[::1]",
        "https://studio.foxglove.dev",
    ],
)
def test_pages_of_foxglove_and_of_this_machine_may_read(server, origin: str) -> None:
    assert let_in(server, origin)


@pytest.mark.parametrize(
    "origin",
    [
        "https://evil.example",
        "null",
        "file://",
        "https://app.foxglove.dev.evil.example",
        "http://localhost.evil.example",
        "http://app.foxglove.dev",
    ],
)
def test_pages_of_other_sites_are_rejected(server, origin: str) -> None:
    assert not let_in(server, origin)


def test_a_site_in_the_settings_may_read(names: Names) -> None:
    out = FoxglovePublisher(names, port=0, origins=["https://viz.example.org"])
    assert let_in(out, "https://viz.example.org")
    assert not let_in(out, "https://example.org")
    out.close()


def test_only_local_clients_are_accepted_by_default(server) -> None:
    with socket.socket() as other:
        other.settimeout(1)
        assert other.connect_ex(("127.0.0.2", server.port)) != 0


def test_a_port_in_use_is_reported_and_closing_frees_it(names, make_estimate) -> None:
    first = FoxglovePublisher(names, port=0)
    with raises(StreamError, "stream.server_not_started"):
        FoxglovePublisher(names, port=first.port)
    first.close()
    first.close()
    with raises(StreamError, "stream.closed"):
        first.send(make_estimate())
    FoxglovePublisher(names, port=first.port).close()


def test_the_schema_for_foxglove_lists_every_joint(make_estimate, names: Names) -> None:
    openxr = names.with_openxr()
    fields = estimate_schema(openxr)["properties"]
    said = json.loads(to_json(make_estimate(), openxr, openxr.recogniser(), LATEST))
    assert fields.keys() == said.keys()
    for part in ("joints", "angles"):
        assert fields[part]["properties"].keys() == said[part].keys()
    joint = fields["joints"]["properties"]["palm"]["properties"]
    assert joint.keys() == said["joints"]["palm"].keys()
