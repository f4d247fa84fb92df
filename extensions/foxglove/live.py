"""A Foxglove live server: the estimate as JSON for plots and as a scene for the 3D panel.

Topics, per hand:

    /glovetrack/right                     the JSON of `payload`, with its schema
    /glovetrack/right/scene               foxglove.SceneUpdate in the frame ``world``; see `scene`
    /glovetrack/right/transforms          foxglove.FrameTransforms of the segments in ``world``
    /glovetrack/right/joint_states        sensor_msgs/JointState
    /glovetrack/right/robot_description   std_msgs/String with the hand's URDF, once for each client

A client that reads slowly misses the oldest of `client_queue.BACKLOG` waiting messages, which are
counted. Pages of other sites than
Foxglove's own and this machine's are turned away, as the WebSocket server does.
"""

from __future__ import annotations

import asyncio
import json
import time
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from functools import partial
from typing import Any

import numpy as np
from websockets.asyncio.server import ServerConnection
from websockets.typing import Origin, Subprotocol

from extensions.foxglove.extension import FoxgloveOptions
from extensions.foxglove.protocol import (
    SUBPROTOCOLS,
    Channel,
    ProtocolError,
    Subscriptions,
    advertise,
    error,
    message_data,
    server_info,
)
from extensions.foxglove.scene import (
    FRAME,
    INTEGER,
    NUMBER,
    STRING,
    FoxgloveScene,
    array_of,
    estimate_schema,
    object_of,
    scene_schema,
    xyz,
)
from tracker.base.clock import ClockAnchor
from tracker.base.notices import notice
from tracker.geometry.kernels import quats
from tracker.messages import Estimate, Validity
from tracker.session.description import SessionInfo
from tracker.session.export.urdf import robot_description
from tracker.session.ros import motion
from tracker.session.ros.definitions import definition
from tracker.streaming.client_queue import ClientQueue
from tracker.streaming.payload import to_json
from tracker.streaming.publisher import LOOPBACK, Names, OtherHand, Publisher, StreamError
from tracker.streaming.server_thread import LOCAL_PAGE, ServerThread
from tracker.streaming.text import HOLE, TextForm, holes

MAX_CLIENT_MESSAGE = 2**16  # bytes of a client's message
ESTIMATE, SCENE, TRANSFORMS, JOINTS, DESCRIPTION = 1, 2, 3, 4, 5
"""Channels of the first hand; those of the next hand are 6 to 10."""
FOXGLOVE_PAGES = ("https://app.foxglove.dev", "https://studio.foxglove.dev")


class FoxglovePublisher:
    """Serves ws://host:port. Port 0 takes any free one; ``port`` is the one in use."""

    def __init__(
        self,
        names: Names,
        host: str = LOOPBACK,
        port: int = 0,
        origins: Collection[str] = (),
        others: Sequence[Names] = (),
    ) -> None:
        """``others``: further hands, see `for_other_hand`. Stamps are those of the session's
        clocks, by the anchor of ``names``; for names without one, of this computer's.

        ``origins``: further sites whose pages may connect, such as ``https://viz.example.org``.
        """
        self._anchor = names.anchor or ClockAnchor(time.time_ns(), time.monotonic_ns())
        self._hands = [_HandChannels(n, DESCRIPTION * i) for i, n in enumerate((names, *others))]
        self._greeting = _greeting(self._hands, session_id=str(time.time_ns()))
        self._clients: tuple[
            _Connection, ...
        ] = ()  # replaced by the server's thread, never changed
        self._missed = 0  # by clients that have left
        self._closed = False
        self._server = ServerThread(
            "Foxglove",
            self._serve,
            host,
            port,
            subprotocols=[Subprotocol(s) for s in SUBPROTOCOLS],
            origins=[None, LOCAL_PAGE, *(Origin(o) for o in (*FOXGLOVE_PAGES, *origins))],
            max_size=MAX_CLIENT_MESSAGE,
        )
        self.port = self._server.port
        self.name = notice("stream.at", stream="Foxglove", host=host, port=self.port)

    @property
    def clients(self) -> int:
        """How many have subscribed to something."""
        return sum(bool(c.wants.by_channel) for c in self._clients)

    def missed(self) -> dict[str, int]:
        """Messages that slow clients missed, by their address; under "" those of former clients."""
        return {"": self._missed} | {c.queue.name: c.queue.dropped for c in self._clients}

    def send(self, estimate: Estimate) -> None:
        self._send(self._hands[0], estimate)

    def for_other_hand(self, names: Names) -> OtherHand:
        """One of the others of the beginning."""
        (hand,) = (h for h in self._hands if h.names is names)
        return OtherHand(self.name, partial(self._send, hand))

    def _send(self, hand: _HandChannels, estimate: Estimate) -> None:
        if self._closed:
            raise StreamError(notice("stream.closed", what="Foxglove server"))
        stamp_ns = self._anchor.wall(estimate.t)
        wanted = {channel for c in self._clients for channel in tuple(c.wants.by_channel)}
        channels = sorted(wanted & hand.encoders.keys())
        if channels:
            payloads = {c: hand.encoders[c](estimate, stamp_ns) for c in channels}
            self._server.call(self._hand_out, stamp_ns, payloads)

    def close(self) -> None:
        self._closed = True
        self._server.close()

    # ---- in the server's own thread

    def _hand_out(self, stamp_ns: int, payloads: Mapping[int, bytes]) -> None:
        """``payloads`` by channel."""
        for client in self._clients:
            for channel, payload in payloads.items():
                client.offer(channel, stamp_ns, payload)

    async def _serve(self, connection: ServerConnection) -> None:
        for text in self._greeting:
            await connection.send(text)
        channels = {channel.id for hand in self._hands for channel in hand.channels()}
        once = {c: text for hand in self._hands for c, text in hand.once.items()}
        client = _Connection(connection, channels, once)
        self._clients += (client,)
        sending = asyncio.create_task(client.queue.send())
        try:
            await client.listen()
        finally:
            self._clients = tuple(c for c in self._clients if c is not client)
            self._missed += client.queue.dropped
            sending.cancel()


class _HandChannels:
    """The channels of one hand; ``first`` is added to the numbers of the first hand's channels.

    ``once`` has the messages that a client gets when it subscribes, by channel.
    """

    def __init__(self, names: Names, first: int) -> None:
        self.names, self._first = names, first
        scene, gestures = FoxgloveScene(names), names.recogniser()
        self.encoders: dict[int, Callable[[Estimate, int], bytes]] = {
            ESTIMATE + first: lambda e, _: to_json(e, names, gestures).encode(),
            SCENE + first: lambda e, stamp_ns: scene.text(e, stamp_ns).encode(),
            JOINTS + first: partial(joint_states, names),
        }
        self.once: dict[int, bytes] = {}
        if names.hand is not None:
            transforms = FrameTransforms(names)
            self.encoders[TRANSFORMS + first] = lambda e, ns: transforms.text(e, ns).encode()
        if names.glove is not None:
            self.once[DESCRIPTION + first] = description(names)

    def channels(self) -> list[Channel]:
        """The advertised channels; without a hand there are no frames, without a glove no model."""
        topic, first = f"/glovetrack/{self.names.side}", self._first
        schema, scene = json.dumps(estimate_schema(self.names)), json.dumps(scene_schema())
        frames = json.dumps(transforms_schema())
        every = (
            Channel(ESTIMATE + first, topic, "glovetrack.Estimate", schema),
            Channel(SCENE + first, f"{topic}/scene", "foxglove.SceneUpdate", scene),
            Channel(TRANSFORMS + first, f"{topic}/transforms", "foxglove.FrameTransforms", frames),
            _ros_channel(JOINTS + first, f"{topic}/joint_states", motion.JOINTS),
            _ros_channel(DESCRIPTION + first, f"{topic}/robot_description", motion.STRING),
        )
        known = self.encoders.keys() | self.once.keys()
        return [channel for channel in every if channel.id in known]


def _ros_channel(number: int, topic: str, name: str) -> Channel:
    return Channel(number, topic, name, definition(name), "cdr", "ros2msg")


class _Connection:
    """One connection: what it wants, and what waits to be sent."""

    def __init__(
        self, connection: ServerConnection, channels: set[int], once: Mapping[int, bytes]
    ) -> None:
        """``once``: messages for a client that subscribes, by channel."""
        self._connection, self._once = connection, once
        self.wants = Subscriptions(channels)
        self.queue = ClientQueue(connection)

    def offer(self, channel: int, stamp_ns: int, payload: bytes) -> None:
        """Leave a message, where the client wants this channel's."""
        subscription = self.wants.by_channel.get(channel)
        if subscription is not None:
            self.queue.put(message_data(subscription, stamp_ns, payload))

    async def listen(self) -> None:
        """Hear the client until it leaves."""
        async for text in self._connection:
            before = set(self.wants.by_channel)
            try:
                self.wants.receive(text)
            except ProtocolError as problem:
                await self._connection.send(error(str(problem)))
            for channel in self.wants.by_channel.keys() & self._once.keys() - before:
                self.offer(channel, time.time_ns(), self._once[channel])


def _greeting(hands: Sequence[_HandChannels], session_id: str) -> tuple[str, str]:
    """What every client hears first."""
    channels = [channel for hand in hands for channel in hand.channels()]
    return server_info("Glovetrack", session_id), advertise(channels)


def open_stream(options: FoxgloveOptions, hands: Sequence[Names]) -> Iterator[Publisher]:
    """Yields the publisher of each hand."""
    origins = [o.strip() for o in options.origins.split(",") if o.strip()]
    first, *others = hands
    server = FoxglovePublisher(first, options.host, options.port, origins=origins, others=others)
    yield server
    yield from map(server.for_other_hand, others)


# ---- the hand as a robot for Foxglove: model (URDF), joint states and frames as in recordings
#
# Sources: docs.foxglove.dev/docs/sdk/schemas/frame-transforms; sensor_msgs/JointState and
# std_msgs/String of ROS 2. Frames have the names of the model's links.

Json = dict[str, Any]


def joint_states(names: Names, e: Estimate, stamp_ns: int) -> bytes:
    """A sensor_msgs/JointState (CDR) of the angles that are known, in rad."""
    known = np.flatnonzero(np.isfinite(e.angles) & (e.angle_state != Validity.LOST))
    rows = [names.angles[i] for i in known]
    return motion.pack_joints(motion.JointState(stamp_ns, rows, e.angles[known]))


class FrameTransforms:
    """Texts of foxglove.FrameTransforms of a hand's segments in ``world``."""

    def __init__(self, names: Names) -> None:
        self._frames = [f"{names.side}_{segment}" for segment in names.model.segment_names]
        self._forms: dict[bytes, TextForm] = {}  # by the segments that are known

    def text(self, e: Estimate, stamp_ns: int) -> str:
        known = np.isfinite(e.segment_p).all(axis=1)
        rows, key = np.flatnonzero(known), known.tobytes()
        if key not in self._forms:
            self._forms[key] = TextForm(self._message(rows.tolist()))
        sec, nsec = divmod(stamp_ns, 10**9)
        flat = np.column_stack([e.segment_p[rows], quats(e.segment_R[rows])]).ravel()
        return self._forms[key].fill(flat, [str(sec), str(nsec)] * len(rows))

    def _message(self, rows: Sequence[int]) -> Json:
        (poses,) = holes([(len(rows), 7)], None)
        return {
            "transforms": [
                {
                    "timestamp": {"sec": HOLE, "nsec": HOLE},
                    "parent_frame_id": FRAME,
                    "child_frame_id": self._frames[i],
                    "translation": xyz(pose[:3]),
                    "rotation": dict(zip("xyzw", pose[3:], strict=True)),
                }
                for i, pose in zip(rows, poses, strict=True)
            ]
        }


def transforms_schema() -> Json:
    """JSON schema of foxglove.FrameTransforms."""
    stamp = object_of("time", sec=INTEGER, nsec=INTEGER)
    transform = object_of(
        "foxglove.FrameTransform",
        timestamp=stamp,
        parent_frame_id=STRING,
        child_frame_id=STRING,
        translation=object_of("foxglove.Vector3", **dict.fromkeys("xyz", NUMBER)),
        rotation=object_of("foxglove.Quaternion", **dict.fromkeys("xyzw", NUMBER)),
    )
    return object_of("foxglove.FrameTransforms", transforms=array_of(transform))


def description(names: Names) -> bytes:
    """A std_msgs/String (CDR) with the hand's URDF. Raises ValueError for names without a hand."""
    if names.glove is None:
        raise ValueError("these names have no glove")
    session = SessionInfo(names.model, names.glove, "", "", names.anchor or ClockAnchor(0, 0))
    return motion.pack_string(robot_description(session))
