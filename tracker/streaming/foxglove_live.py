"""A Foxglove live server: the estimate as JSON for plots and as a scene for the 3D panel.

The protocol is spoken by foxglove-sdk, in threads of its own. Topics, per hand:

    /glovetrack/right         the JSON of `payload`, with its schema
    /glovetrack/right/scene   foxglove.SceneUpdate in the frame ``world`` (G, z up)

In the scene a bone or joint that is lost is left out, an inferred one is small and pale, and the
entity's metadata tells every keypoint's state in words.
"""

from __future__ import annotations

import socket
import time
from typing import Any

import foxglove
import numpy as np
from foxglove import messages as fg
from foxglove.channels import SceneUpdateChannel

from tracker.hand.names import KEYPOINTS
from tracker.messages import Array, Estimate, Validity
from tracker.streaming.payload import to_json
from tracker.streaming.publisher import LOOPBACK, STATE_WORDS, Names, StreamError

DEFAULT_PORT = 8765  # where Foxglove looks by itself
CLOSE_WAIT = 1.0  # s
BACKLOG = 64  # messages kept per client; the oldest go first
FRAME = "world"
LIFETIME = fg.Duration(1)  # of a hand in the view after the last estimate
SIZE_M = {Validity.MEASURED: 0.010, Validity.INFERRED: 0.006}
COLOURS = {
    Validity.MEASURED: fg.Color(r=0.12, g=0.47, b=0.71, a=1.0),
    Validity.INFERRED: fg.Color(r=0.85, g=0.60, b=0.20, a=0.6),
}
STATE_SCHEMA = {"enum": list(STATE_WORDS.values())}


class FoxglovePublisher:
    """Serves ws://host:port. Port 0 takes any free one; ``port`` says which."""

    def __init__(
        self,
        names: Names,
        host: str = LOOPBACK,
        port: int = DEFAULT_PORT,
        wall_offset: float | None = None,
    ) -> None:
        """``wall_offset``: s since 1970 at the monotonic clock's zero; by default as of now."""
        self._names, self._bones = names, bones(names)
        self._wall = time.time() - time.monotonic() if wall_offset is None else wall_offset
        self._audience = _Audience()
        context = self._context = foxglove.Context()  # kept: channels die with it
        try:
            self._server = foxglove.start_server(
                name="Glovetrack",
                host=host,
                port=port,
                context=context,
                server_listener=self._audience,
                message_backlog_size=BACKLOG,
            )
        except (RuntimeError, OSError, OverflowError) as error:
            raise StreamError(f"No Foxglove server at {host}:{port}: {error}.") from error
        topic = f"/glovetrack/{names.side}"
        self._json = foxglove.Channel(topic, schema=json_schema(names), context=context)
        self._scene = SceneUpdateChannel(f"{topic}/scene", context=context)
        self._closed, self._host = False, host
        self.port = self._server.port
        self.name = f"Foxglove at {host}:{self.port}"

    @property
    def clients(self) -> int:
        """How many have subscribed to something."""
        return self._audience.count

    def send(self, estimate: Estimate) -> None:
        if self._closed:
            raise StreamError("the Foxglove server is closed")
        stamp = round((estimate.t + self._wall) * 1e9)
        if self._json.has_sinks():
            self._json.log(to_json(estimate, self._names).encode(), log_time=stamp)
        if self._scene.has_sinks():
            self._scene.log(self._update(estimate, stamp), log_time=stamp)

    def close(self) -> None:
        if not self._closed:
            self._closed = True
            self._json.close()
            self._scene.close()
            self._server.stop()
            self._wait_until_free()

    def _wait_until_free(self) -> None:
        """The SDK frees its port a moment after `stop`; whoever opens it next must not find it."""
        end = time.monotonic() + CLOSE_WAIT
        while time.monotonic() < end:
            try:
                socket.create_connection((self._host, self.port), 0.1).close()
            except OSError:
                return
            time.sleep(0.02)

    def _update(self, e: Estimate, stamp: int) -> fg.SceneUpdate:
        states = [Validity(int(s)) for s in e.keypoint_state]
        entity = fg.SceneEntity(
            timestamp=fg.Timestamp(stamp // 10**9, stamp % 10**9),
            frame_id=FRAME,
            id=f"hand {self._names.side}",
            lifetime=LIFETIME,
            metadata=[
                fg.KeyValuePair(key="tracking", value=e.tracking.name.lower()),
                *(
                    fg.KeyValuePair(key=n, value=STATE_WORDS[s])
                    for n, s in zip(self._names.keypoints, states, strict=True)
                ),
            ],
            spheres=_spheres(e.keypoints, states),
            lines=self._lines(e.keypoints, states),
        )
        return fg.SceneUpdate(entities=[entity])

    def _lines(self, points: Array, states: list[Validity]) -> list[fg.LinePrimitive]:
        """A bone is as sure as the less sure of its ends."""
        out = []
        for state in SIZE_M:
            ends = [
                _point(points[i])
                for bone in self._bones
                if min(states[bone[0]], states[bone[1]]) == state
                for i in bone
            ]
            if ends:
                out.append(
                    fg.LinePrimitive(
                        type=fg.LinePrimitiveLineType.LineList,
                        thickness=SIZE_M[state] / 2,
                        points=ends,
                        color=COLOURS[state],
                    )
                )
        return out


class _Audience(foxglove.ServerListener):
    """Who listens. Called by the server's threads."""

    def __init__(self) -> None:
        self._subscribed: set[tuple[int, int]] = set()

    @property
    def count(self) -> int:
        return len({client for client, _ in self._subscribed.copy()})

    def on_subscribe(self, client: Any, channel: Any) -> None:
        self._subscribed.add((client.id, channel.id))

    def on_unsubscribe(self, client: Any, channel: Any) -> None:
        self._subscribed.discard((client.id, channel.id))


def bones(names: Names) -> list[tuple[int, int]]:
    """Rows of keypoints that a bone joins: along each finger, and from the wrist to it."""
    row = {n: i for i, n in enumerate(names.keypoints)}
    wrist, out, before = row["wrist"], [], row["wrist"]
    for name in KEYPOINTS:
        if name == "wrist" or name not in row:
            continue
        out.append((before, row[name]))
        before = wrist if name.endswith("_tip") else row[name]
    return out


def json_schema(names: Names) -> dict[str, Any]:
    """JSON schema of `payload`, so that Foxglove lists every keypoint and angle for plots."""
    number: dict[str, Any] = {"type": ["number", "null"]}
    numbers: dict[str, Any] = {"type": ["array", "null"], "items": {"type": "number"}}
    point = {"state": STATE_SCHEMA, "position": numbers, "orientation_xyzw": numbers, "sd": number}
    angle = {"state": STATE_SCHEMA, "value": number}
    return {
        "title": "glovetrack.Estimate",
        "type": "object",
        "properties": {
            "schema": {"type": "integer"},
            "side": {"type": "string"},
            "t": {"type": "number"},
            "tracking": {"type": "string"},
            "keypoints": _objects(names.keypoints, point),
            "angles": _objects(names.angles, angle),
        },
    }


def _objects(keys: tuple[str, ...], properties: dict[str, Any]) -> dict[str, Any]:
    one = {"type": "object", "properties": properties}
    return {"type": "object", "properties": dict.fromkeys(keys, one)}


def _spheres(points: Array, states: list[Validity]) -> list[fg.SpherePrimitive]:
    """One per keypoint that is known."""
    upright = fg.Quaternion(x=0.0, y=0.0, z=0.0, w=1.0)
    out = []
    for p, state in zip(points, states, strict=True):
        if state == Validity.LOST or not np.isfinite(p).all():
            continue
        x, y, z = p.tolist()
        d = SIZE_M[state]
        pose = fg.Pose(position=fg.Vector3(x=x, y=y, z=z), orientation=upright)
        size = fg.Vector3(x=d, y=d, z=d)
        out.append(fg.SpherePrimitive(pose=pose, size=size, color=COLOURS[state]))
    return out


def _point(p: Array) -> fg.Point3:
    x, y, z = p.tolist()
    return fg.Point3(x=x, y=y, z=z)
