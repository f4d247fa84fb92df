"""The Foxglove server, read by a client written from the protocol's text alone.

Protocol: github.com/foxglove/ws-protocol; protobuf's wire format: protobuf.dev/programming-guides.
"""

from __future__ import annotations

import base64
import json
import socket
import struct
from collections.abc import Iterator

import numpy as np
import pytest

pytest.importorskip("foxglove", reason="foxglove-sdk is not installed (extra `streams`)")
pytest.importorskip("websockets", reason="websockets is not installed (extra `streams`)")
from websockets.sync.client import ClientConnection, connect

from tracker.messages import Validity
from tracker.streaming.foxglove_live import FoxglovePublisher, bones
from tracker.streaming.publisher import Names, StreamError

PROTOCOL, MESSAGE_DATA = "foxglove.sdk.v1", 1
Fields = dict[int, list]


@pytest.fixture
def server(names: Names) -> Iterator[FoxglovePublisher]:
    out = FoxglovePublisher(names, port=0, wall_offset=1000.0)
    yield out
    out.close()


class Client:
    """Says hello, reads what is advertised, subscribes."""

    def __init__(self, connection: ClientConnection) -> None:
        self._connection = connection
        self.info = self._text("serverInfo")
        self.channels = {c["topic"]: c for c in self._text("advertise")["channels"]}

    def _text(self, op: str) -> dict:
        message = json.loads(self._connection.recv(timeout=2))
        assert message["op"] == op
        return message

    def subscribe(self, topic: str) -> None:
        wanted = [{"id": 7, "channelId": self.channels[topic]["id"]}]
        self._connection.send(json.dumps({"op": "subscribe", "subscriptions": wanted}))

    def message(self) -> tuple[int, bytes]:
        """Time in ns and payload of the next message."""
        data = self._connection.recv(timeout=2)
        assert isinstance(data, bytes)
        opcode, subscription, stamp = struct.unpack_from("<BIQ", data)
        assert (opcode, subscription) == (MESSAGE_DATA, 7)
        return stamp, data[13:]


@pytest.fixture
def client(server: FoxglovePublisher) -> Iterator[Client]:
    with connect(f"ws://127.0.0.1:{server.port}", subprotocols=[PROTOCOL]) as connection:  # type: ignore[list-item]
        yield Client(connection)


def protobuf(data: bytes) -> Fields:
    """Fields of a message by number: integers, doubles, and bytes not looked into."""
    out: Fields = {}
    at = 0
    while at < len(data):
        tag, at = varint(data, at)
        if tag & 7 == 0:
            value, at = varint(data, at)
        elif tag & 7 == 1:
            value, at = struct.unpack_from("<d", data, at)[0], at + 8
        else:
            assert tag & 7 == 2
            size, at = varint(data, at)
            value, at = data[at : at + size], at + size
        out.setdefault(tag >> 3, []).append(value)
    return out


def varint(data: bytes, at: int) -> tuple[int, int]:
    value = shift = 0
    while True:
        value |= (data[at] & 127) << shift
        shift, at = shift + 7, at + 1
        if not data[at - 1] & 128:
            return value, at


def test_what_is_advertised(client: Client, names: Names) -> None:
    assert client.info["name"] == "Glovetrack"
    topic = client.channels["/glovetrack/right"]
    assert (topic["encoding"], topic["schemaEncoding"]) == ("json", "jsonschema")
    schema = json.loads(topic["schema"])
    assert tuple(schema["properties"]["keypoints"]["properties"]) == names.keypoints
    scene = client.channels["/glovetrack/right/scene"]
    assert (scene["encoding"], scene["schemaName"]) == ("protobuf", "foxglove.SceneUpdate")
    assert b"foxglove.SceneEntity" in base64.b64decode(scene["schema"] + "==")


def test_json_carries_every_state(client, server, make_estimate, wait_for) -> None:
    client.subscribe("/glovetrack/right")
    wait_for(lambda: server.clients == 1)
    server.send(make_estimate(2.5, lost=("thumb_tip",)))
    stamp, data = client.message()
    read = json.loads(data)
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
    client.subscribe("/glovetrack/right/scene")
    wait_for(lambda: server.clients == 1)
    estimate = make_estimate(2.5, lost=("thumb_tip",))
    server.send(estimate)
    _, data = client.message()
    entity = protobuf(protobuf(data)[2][0])  # SceneUpdate.entities
    assert entity[2] == [b"world"]
    pairs = [protobuf(p) for p in entity[6]]
    states = {p[1][0].decode(): p[2][0].decode() for p in pairs}
    assert states["thumb_tip"] == "lost" and states["wrist"] == "measured"
    assert tuple(states) == ("tracking", *names.keypoints)
    known = estimate.keypoint_state != Validity.LOST
    places = [protobuf(protobuf(protobuf(s)[1][0])[1][0]) for s in entity[9]]  # pose.position
    read = np.array([[p[k][0] for k in (1, 2, 3)] for p in places])
    assert np.allclose(read, estimate.keypoints[known])
    (lines,) = [protobuf(line) for line in entity[11]]
    assert len(lines[5]) == 2 * (len(bones(names)) - 1)


def test_nobody_listening_costs_nothing_and_leaving_is_seen(
    server, make_estimate, wait_for
) -> None:
    server.send(make_estimate())
    assert server.clients == 0
    with connect(f"ws://127.0.0.1:{server.port}", subprotocols=[PROTOCOL]) as connection:
        Client(connection).subscribe("/glovetrack/right")
        wait_for(lambda: server.clients == 1)
    wait_for(lambda: server.clients == 0)


def test_only_this_machine_is_listened_to_by_default(server) -> None:
    with socket.socket() as other:
        other.settimeout(1)
        assert other.connect_ex(("127.0.0.2", server.port)) != 0


def test_a_taken_port_is_said_in_words_and_closing_frees_it(names, make_estimate) -> None:
    first = FoxglovePublisher(names, port=0)
    with pytest.raises(StreamError, match="No Foxglove server at"):
        FoxglovePublisher(names, port=first.port)
    first.close()
    first.close()
    with pytest.raises(StreamError, match="closed"):
        first.send(make_estimate())
    FoxglovePublisher(names, port=first.port).close()
