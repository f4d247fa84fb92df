"""Decodes topics of a session to messages of the engine; the inverse of `encode`."""

from __future__ import annotations

import json
from collections.abc import Callable, Collection, Sequence
from typing import Any

import numpy as np

from tracker.base.clock import ClockAnchor
from tracker.base.damage import LeftOut
from tracker.base.notices import from_json
from tracker.messages import (
    EYES,
    BlobFrame,
    Calibration,
    CameraImuSample,
    Estimate,
    Event,
    ImuSample,
    Message,
    Status,
    StereoFrame,
    WristPose,
)
from tracker.session.decode_estimate import EstimateDecoder, tracking_of
from tracker.session.decode_sensors import SensorDecoder, Timing
from tracker.session.description import SessionInfo
from tracker.session.encode import CALIBRATION_ROWS, status_name
from tracker.session.images import PackedFrame
from tracker.session.mcap.input import RawMessage
from tracker.session.ros import motion, topics

MESSAGE_KINDS: tuple[type, ...] = (
    ImuSample,
    CameraImuSample,
    WristPose,
    StereoFrame,
    BlobFrame,
    Estimate,
    Calibration,
    Status,
    Event,
)

Decoded = Message | PackedFrame
"""The results of a `MessageDecoder`: a StereoFrame is a PackedFrame."""


class MessageDecoder:
    """Converts raw messages, in order, to the engine's messages, with images still packed.

    Damaged messages are skipped and counted in ``left_out``.
    """

    def __init__(self, info: SessionInfo, packets: bool, timing: Timing, left_out: LeftOut) -> None:
        """``packets``: the file marks the end of each glove packet."""
        self._info, self._left_out = info, left_out
        self._sensors = SensorDecoder(info, packets, timing, left_out)
        self._estimates = EstimateDecoder(info, "hand")
        self._handlers = self._handler_table()

    def _handler_table(self) -> dict[str, Callable[[RawMessage], Sequence[Decoded]]]:
        anchor = self._info.anchor
        table: dict[str, Callable[[RawMessage], Sequence[Decoded]]] = {
            **self._sensors.handlers(),
            topics.TF: self._transforms,
            topics.hand(self._info.side, "calibration"): lambda raw: _calibration(raw, anchor),
            topics.STATUS: lambda raw: _statuses(
                raw, anchor, status_name(self._info, self._info.side)
            ),
            topics.EVENTS: lambda raw: [_event(raw, anchor)],
        }
        return table | dict.fromkeys(self._estimates.topics, self._estimate)

    def topics_of(self, kinds: Collection[type]) -> frozenset[str]:
        """The topics from which messages of these kinds are decoded."""
        side, hand = self._info.side, self._estimates.topics
        imus = [topics.imu(side, n) for n in self._info.glove.imu_names]
        camera = [topics.TF, topics.CAMERA_POSE]
        table: dict[type, list[str]] = {
            ImuSample: [*imus, topics.packets(side), topics.temperatures(side)],
            CameraImuSample: [topics.CAMERA_IMU],
            WristPose: [topics.wrist_exact(side)],
            StereoFrame: [*(topics.image(c) for c in EYES), *camera],
            BlobFrame: [
                *(f(c) for c in EYES for f in (topics.cloth, topics.blobs)),
                *camera,
            ],
            Estimate: [*hand, topics.TF],
            Calibration: [topics.hand(side, "calibration")],
            Status: [topics.STATUS],
            Event: [topics.EVENTS],
        }
        return frozenset(t for kind in kinds for t in table.get(kind, ()))

    def rank(self, topic: str) -> int:
        """Returns the order of topics at one log time: IMU, the camera's own IMU, detections."""
        if topic.startswith("/glove/"):
            return 0
        return 1 if topic in (topics.TF, topics.CAMERA_POSE, topics.CAMERA_IMU) else 2

    def remember(self, raw: RawMessage) -> None:
        """Takes a message from before the part to be read, for its values that are still valid."""
        self._handle(raw)

    def feed(self, raw: RawMessage) -> list[Decoded]:
        """Returns the messages that are complete at the time of ``raw``."""
        before = self._sensors.release(raw.log_time)
        return [*before, *self._handle(raw), *self._sensors.release(-1)]

    def _handle(self, raw: RawMessage) -> Sequence[Decoded]:
        handler = self._handlers.get(raw.topic)
        if handler is None:
            return []
        with self._left_out.reading(raw.topic, raw.log_time):
            return handler(raw)
        return []

    def finish(self) -> list[Decoded]:
        """Returns the messages that were still incomplete."""
        return list(self._sensors.release(None))

    def _transforms(self, raw: RawMessage) -> list[Decoded]:
        transforms = motion.unpack_transforms(raw.data)
        self._estimates.set_segments(transforms)
        self._sensors.set_camera(transforms)
        return []

    def _estimate(self, raw: RawMessage) -> list[Decoded]:
        estimate = self._estimates.feed(raw)
        return [] if estimate is None else [estimate]


def _calibration(raw: RawMessage, anchor: ClockAnchor) -> list[Calibration]:
    stamp, statuses = motion.unpack_diagnostics(raw.data)
    hand = {s.name: s.values for s in statuses}.get("hand", {})
    rows = [s for s in statuses if s.name != "hand"]
    fields = {
        name: np.array([[_number(s.values, f"{name}_{a}") for a in "xyz"] for s in rows])
        for name in CALIBRATION_ROWS
    }
    segments = tuple(s.name for s in rows)
    length, sd = _number(hand, "length"), _number(hand, "length_sd")
    t = anchor.monotonic(stamp)
    return [Calibration(t, segments, **fields, hand_length=length, hand_length_sd=sd)]


def _number(values: dict[str, str], key: str) -> float:
    return float(values.get(key, "nan"))


def _statuses(raw: RawMessage, anchor: ClockAnchor, name: str) -> list[Status]:
    stamp, statuses = motion.unpack_diagnostics(raw.data)
    t = anchor.monotonic(stamp)
    return [
        Status(t, tracking_of(s.message), {k: float(v) for k, v in s.values.items()})
        for s in statuses
        if s.name == name
    ]


def _event(raw: RawMessage, anchor: ClockAnchor) -> Event:
    """Decodes an event; another program's text becomes a note."""
    text = motion.unpack_string(raw.data)
    try:
        content: Any = json.loads(text)
    except (json.JSONDecodeError, RecursionError):
        content = None
    if not isinstance(content, dict):
        content = {"text": text}
    data = content.get("data")
    return Event(
        anchor.monotonic(int(content.get("stamp_ns", raw.log_time))),
        str(content.get("kind", "note")),
        str(content.get("text", "")),
        data if isinstance(data, dict) else {},
        from_json(content),
    )
