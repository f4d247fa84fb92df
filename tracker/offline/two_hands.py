"""A session of both hands through their pipelines: what `runs` does for one."""

from __future__ import annotations

import heapq
from collections import deque
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np

from tracker.engine.two_hands import Sided, TwoHands
from tracker.fusion.engine import Engine
from tracker.messages import BlobFrame, CameraImuSample, EngineState, Event, ImuSample, Tracking
from tracker.offline.own_colours import OwnColours
from tracker.offline.runs import CALIBRATION_PERIOD, Fed, Output, arrival
from tracker.session.images import PackedFrame
from tracker.session.reader import SessionReader
from tracker.session.state_check import require_match
from tracker.vision.rig import StereoRig


def with_other(reader: SessionReader, messages: Iterator[Fed]) -> Iterator[Fed | Sided]:
    """``messages`` of a session of both hands with the packets of the hand that ``reader`` does not
    read, each packet with its side; in the order of the live run."""
    side = reader.info.side
    (other,) = (s for s in reader.sides if s != side)
    with SessionReader(reader.path, side=other) as second:
        packets = second.messages((ImuSample,))
        streams: list[Iterator[Fed | Sided]] = [
            (Sided(m, side) if isinstance(m, ImuSample) else m for m in messages),
            (Sided(m, other) for m in packets if isinstance(m, ImuSample)),
        ]
        yield from heapq.merge(*streams, key=_order)


def _order(message: Fed | Sided) -> tuple[float, bool]:
    return arrival(message), not isinstance(message, Sided)


class TwoHandsRun:
    """The estimates of a live run of two hands, bit for bit; see `tracker.offline.runs.LiveRun`.

    ``make`` builds both with the engine of that name and that camera; ``outputs`` are by side, and
    ``main`` is the one that takes what is of no side.
    """

    def __init__(
        self,
        make: Callable[[str, StereoRig | None], TwoHands],
        rig: StereoRig | None,
        engine: str,
        outputs: Mapping[str, Output],
        main: str,
        changes: Sequence[tuple[float, EngineState | StereoRig]] = (),
        colours: OwnColours | None = None,
    ) -> None:
        """``colours``, where images are searched, follow the main hand."""
        self._make, self._hands, self._rig = make, make(engine, rig), rig
        self._outputs, self._main, self._changes = outputs, main, deque(changes)
        self._next_calibration = dict.fromkeys(outputs, -np.inf)
        self._engine, self._camera_tells = engine, False
        self._colours, self._tracking = colours, dict.fromkeys(outputs, Tracking.SEARCHING)

    @property
    def engines(self) -> dict[str, Engine]:
        return {side: pipeline.engine for side, pipeline in self._hands.pipelines.items()}

    def feed(self, message: Fed | Sided) -> None:
        while self._changes and self._changes[0][0] <= arrival(message):
            self._change(*self._changes.popleft())
        if isinstance(message, Sided):
            self._feed_imu(message.side, message.sample)
            return
        self._camera_tells |= isinstance(message, CameraImuSample)
        self._outputs[self._main].message(self._posed(message))
        if isinstance(message, BlobFrame):
            self._feed_frame(message)
        elif isinstance(message, CameraImuSample):
            self._hands.feed_camera_imu(message)
        elif isinstance(message, Event):
            self._hands.feed_event(message)
        elif not isinstance(message, PackedFrame):
            raise TypeError("a packet of a session of both hands has a side")
        for side in self._outputs:
            self._used(side)
        self._look(message)

    def _used(self, side: str) -> None:
        """What the engines have made of images."""
        results = self._hands.take_results(side)
        if self._colours is not None and side == self._main:
            self._colours.used(results)

    def _look(self, message: Fed) -> None:
        """What an image says of the colours: no hand is seen where neither is."""
        if self._colours is None or not isinstance(message, BlobFrame):
            return
        tracked = [
            t for t in self._tracking.values() if t not in (Tracking.SEARCHING, Tracking.LOST)
        ]
        self._colours.looked(message, tracked[0] if tracked else Tracking.LOST)
        for event in self._colours.take_words():
            self._outputs[self._main].say(event)

    def _posed(self, message: Fed) -> Fed:
        """A frame with the pose that the main hand's pipeline gives it."""
        if self._camera_tells and isinstance(message, BlobFrame) and message.pose is None:
            pipeline = self._hands.pipelines[self._main]
            pose = pipeline.camera_pose(message.t - pipeline.timing.applied)
            return replace(message, pose=pose)
        return message

    def _change(self, t: float, what: EngineState | StereoRig) -> None:
        output = self._outputs[self._main]
        if isinstance(what, StereoRig):
            state, self._rig = self._hands.get_state(), what
            self._hands = self._make(self._engine, what)
            self._hands.set_state(state)
            output.rig(what, t)
            return
        self._engine, self._hands = what.engine, self._make(what.engine, self._rig)
        require_match(what.state, self._hands.get_state(), what.engine)
        self._hands.set_state(what.state)
        output.state(what)

    def _feed_frame(self, frame: BlobFrame) -> None:
        self._hands.feed_frame(frame)
        for side, output in self._outputs.items():
            estimate = self._hands.pipelines[side].without_packets(frame)
            if estimate is not None:
                self._tracking[side] = estimate.tracking
                output.source(frame.t, self._hands.pipelines[side])
                output.between(estimate)

    def _feed_imu(self, side: str, sample: ImuSample) -> None:
        output = self._outputs[side]
        output.message(sample)
        estimate = self._hands.feed_imu(side, sample)
        output.source(sample.t, self._hands.pipelines[side])
        output.estimate(sample, estimate)
        self._tracking[side] = estimate.tracking
        if sample.t >= self._next_calibration[side]:
            self._next_calibration[side] = sample.t + CALIBRATION_PERIOD
            if estimate.tracking != Tracking.SEARCHING:
                output.calibration(self._hands.pipelines[side].calibration())
        self._used(side)

    def finish(self, progress: Callable[[float], None]) -> None:
        for side, output in self._outputs.items():
            if output.report.estimates:
                output.calibration(self._hands.pipelines[side].calibration())

    def state(self, t: float) -> EngineState:
        """What both engines know after all that was fed, to go on from at ``t`` s."""
        return EngineState(t, self._engine, self._hands.get_state())
