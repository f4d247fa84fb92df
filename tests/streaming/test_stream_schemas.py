"""Both versions of the JSON messages against their JSON Schemas, and how a client chooses one."""

from __future__ import annotations

import json
import socket
import threading
from collections.abc import Callable
from typing import Any

import jsonschema
import numpy as np
import pytest
from numpy.testing import assert_allclose

from tests.notices import raises
from tests.streaming.moving_hand import turning
from tracker.base.clock import ClockAnchor
from tracker.base.errors import ConfigError
from tracker.cli import main
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.hand.openxr import JOINTS
from tracker.messages import Estimate, Tracking
from tracker.streaming.connection import LOOPBACK
from tracker.streaming.payload import FIRST, LATEST, SCHEMAS, to_json
from tracker.streaming.publisher import Names, StreamError
from tracker.streaming.registry import STREAMS, StreamSettings, open_streams, with_streams
from tracker.streaming.schema import schema_text
from tracker.streaming.streams import BACKLOG, Streams
from tracker.streaming.udp import UdpPublisher

ANCHOR = ClockAnchor(1_732_538_096_123_456_789, 0)


@pytest.fixture
def dated(hand: HandModel, glove: GloveModel) -> Names:
    return Names.of(hand, glove, anchor=ANCHOR)


def valid(text: str) -> dict[str, Any]:
    message: dict[str, Any] = json.loads(text)
    schema = json.loads(schema_text(message["schema"]))
    jsonschema.Draft202012Validator.check_schema(schema)
    jsonschema.validate(message, schema, jsonschema.Draft202012Validator)
    return message


@pytest.mark.parametrize("schema", SCHEMAS)
@pytest.mark.parametrize("openxr", [False, True])
@pytest.mark.parametrize("moving", [False, True])
def test_every_kind_of_message_matches_its_schema(
    make_estimate, dated: Names, schema: int, openxr: bool, moving: bool
) -> None:
    names = dated.with_openxr() if openxr else dated
    everything = (*names.keypoints, *names.angles)
    for e in (
        make_estimate(lost=("thumb_tip", "index_mcp_flexion")),
        make_estimate(lost=everything, tracking=Tracking.SEARCHING),
    ):
        made = turning(e, names) if moving else e
        message = valid(to_json(made, names, names.recogniser(), schema))
        assert ("joints" if openxr else "keypoints") in message


def test_the_first_schema_is_unchanged(make_estimate, names: Names) -> None:
    """Key by key as sent by version 0.1 of the program, without later additions."""
    text = to_json(turning(make_estimate(), names), names)
    message = valid(text)
    assert list(message) == ["schema", "side", "t", "tracking", "keypoints", "angles"]
    assert text.startswith('{"schema":1,"side":"right","t":1.25,"tracking":"tracking",')
    assert list(message["keypoints"]["wrist"]) == ["state", "position", "orientation_xyzw", "sd"]
    assert list(message["angles"]["index_mcp_flexion"]) == ["state", "value"]


def test_the_second_schema_includes_the_first(make_estimate, dated: Names) -> None:
    e = turning(make_estimate(lost=("thumb_tip",)), dated)
    first, second = (valid(to_json(e, dated, None, s)) for s in SCHEMAS)
    for name, angle in first["angles"].items():
        assert angle.items() <= second["angles"][name].items()
    assert {**second, **first, "angles": second["angles"], "schema": 2} == second
    assert second["seq"] == 7
    assert second["t_unix_ns"] == ANCHOR.wall_ns + 1_250_000_000


def test_velocities_are_those_of_the_estimate(make_estimate, dated: Names) -> None:
    e = turning(make_estimate(lost=("thumb_tip", "index_mcp_flexion")), dated)
    message = valid(to_json(e, dated, None, LATEST))
    assert tuple(message["velocity"]) == dated.keypoints
    assert e.motion is not None
    for i, name in enumerate(dated.keypoints):
        velocity = message["velocity"][name]
        if name == "thumb_tip":
            assert set(velocity.values()) == {None}
        else:
            assert_allclose(velocity["linear"], e.motion.linear[i], atol=1e-6)
            assert velocity["angular"] == [0, 0, 2]
            assert (velocity["sd"], velocity["angular_sd"]) == (0.02, 0.03)
    assert message["angles"]["index_mcp_flexion"]["rate"] is None
    j = dated.angles.index("middle_pip_flexion")
    moving = message["angles"]["middle_pip_flexion"]
    assert moving["rate"] == pytest.approx(e.motion.angle_rate[j], abs=1e-6)
    assert (moving["rate_sd"], moving["sd"]) == (0.05, 0.01)


def test_openxr_joints_move_in_openxrs_world(make_estimate, dated: Names) -> None:
    """A hand that rotates rigidly about the vertical: every joint has v = w x p + rise, including
    those on the dorsum that are not keypoints."""
    e = turning(make_estimate(lost=("little_mcp",)), dated)
    message = valid(to_json(e, dated.with_openxr(), None, LATEST))
    w, rise = np.array([0.0, 2.0, 0.0]), np.array([0.0, 0.5, 0.0])  # y is up
    assert tuple(message["velocity"]) == JOINTS
    for name, velocity in message["velocity"].items():
        if name in ("little_metacarpal", "little_proximal"):
            assert velocity["linear"] is None and velocity["angular"] is None
            continue
        position = np.array(message["joints"][name]["position"])
        assert_allclose(velocity["linear"], np.cross(w, position) + rise, atol=2e-5)
        assert_allclose(velocity["angular"], w, atol=1e-4)
    velocity = message["velocity"]
    assert velocity["palm"]["sd"] == pytest.approx(np.hypot(0.02, 0.02), abs=1e-6)


def test_an_engine_without_velocities_sends_null(make_estimate, names: Names) -> None:
    message = valid(to_json(make_estimate(), names, None, LATEST))
    assert message["seq"] is None and message["t_unix_ns"] is None
    assert set(message["velocity"]["wrist"].values()) == {None}
    assert message["angles"]["index_mcp_flexion"]["rate"] is None


def test_numbers_are_consecutive_except_for_dropped_estimates(
    make_estimate, names: Names, wait_for: Callable[[Callable[[], object]], None]
) -> None:
    """An output that blocks for longer than its queue can buffer."""
    seen: list[int] = []
    entered = threading.Event()

    class Slow:
        name = "slow"

        def send(self, estimate: Estimate) -> None:
            entered.set()
            if not seen:
                wait_for(lambda: streams.counts()[0].dropped == 10)
            seen.append(json.loads(to_json(estimate, names, None, LATEST))["seq"])

        def close(self) -> None: ...

    streams = Streams([Slow()])
    streams.offer(make_estimate())
    assert entered.wait(60)
    for _ in range(BACKLOG + 10):
        streams.offer(make_estimate())
    wait_for(lambda: len(seen) == BACKLOG + 1)
    streams.close()
    assert seen == [0, *range(11, BACKLOG + 11)]
    assert streams.counts()[0].dropped == 10


@pytest.mark.parametrize(
    ("words", "schema"), [("udp", LATEST), ("udp?schema=1", FIRST), ("udp:{}?schema=2", LATEST)]
)
def test_udp_uses_the_selected_schema(words: str, schema: int, make_estimate, dated: Names) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as client:
        client.bind((LOOPBACK, 0))
        client.settimeout(60)
        port = client.getsockname()[1]
        settings = with_streams(StreamSettings({"udp_port": port}), words.format(port))
        (publisher,) = open_streams(settings, [dated])["udp"]
        publisher.send(turning(make_estimate(), dated))
        publisher.close()
        assert valid(client.recv(65536).decode())["schema"] == schema


def test_an_unknown_schema_is_rejected(names: Names) -> None:
    with raises(StreamError, "stream.schema"):
        UdpPublisher(names, schema=3)


@pytest.mark.parametrize(
    ("words", "code", "values"),
    [
        ("udp?host=x", "stream.no_option", {"option": "host", "known": ("port", "schema")}),
        ("udp?scheme=1", "stream.no_option", {"option": "scheme"}),
        ("udp?schema=one", "stream.bad_option", {"value": "one", "option": "schema"}),
        ("lsl?network=maybe", "stream.bad_option", {"value": "maybe", "option": "network"}),
    ],
)
def test_options_of_the_command_line_are_checked(
    words: str, code: str, values: dict[str, object]
) -> None:
    with raises(ConfigError, code, **values):
        with_streams(StreamSettings(), words)


def test_command_line_options_have_their_fields_types() -> None:
    settings = with_streams(StreamSettings(), "udp?schema=1&port=9000,lsl?network=true")
    assert settings.options(STREAMS.get("udp")).schema == 1
    assert settings.options(STREAMS.get("udp")).port == 9000
    assert settings.options(STREAMS.get("lsl")).network is True


def test_the_command_prints_the_schema(capsys: pytest.CaptureFixture[str]) -> None:
    for words, version in ((["schema", "stream"], 2), (["schema", "stream", "--version", "1"], 1)):
        assert main(words) == 0
        assert capsys.readouterr().out == schema_text(version)
