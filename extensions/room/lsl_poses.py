"""Poses from a Lab Streaming Layer stream of seven channels: x y z qx qy qz qw, m.

Three channels are positions alone. LSL measures how far the sender's clock is from this one's, so
the poses have the instants at which they were measured.
"""

from __future__ import annotations

import contextlib
import math
import threading

import numpy as np
import pylsl

from extensions.lsl.outlet import LOCAL_ONLY
from extensions.room.extension import LslPoseOptions
from extensions.room.frames import UP_AXES, from_upright
from extensions.room.osc_poses import NO_ROTATION, RoomPose
from extensions.room.placement import Placement, placement_of
from extensions.room.taker import PoseTaker
from tracker.base.clock import monotonic
from tracker.base.errors import ConfigError
from tracker.base.notices import failure
from tracker.streaming.remote.doors import Door
from tracker.streaming.remote.reception import Answer, DoorCounts

LOOK_FOR = 0.5  # s
MEASURE_EVERY, MEASURE_WAIT = 5.0, 2.0  # s
PULL_WAIT = 0.02
CHANNELS = (3, 7)
MOST_SAMPLES = 256


class LslPoses:
    """Reads the first stream of a type; ``network``: other computers' too."""

    port = 0

    def __init__(
        self, answer: Answer, placement: Placement, kind: str, up: str, network: bool
    ) -> None:
        if up not in UP_AXES:
            raise ConfigError(failure("room.unknown_axis", axis=up))
        if not network:
            pylsl.set_config_content(LOCAL_ONLY)
        self.taker, self._kind, self._up = PoseTaker(answer, placement), kind, up
        self._clients = 0
        self._ended = threading.Event()
        self._thread = threading.Thread(target=self._run, name="glovetrack-remote-lsl-poses")
        self._thread.daemon = True
        self._thread.start()

    def counts(self) -> DoorCounts:
        return self.taker.counts(f"LSL, streams of type {self._kind}", self._clients)

    def close(self) -> None:
        self._ended.set()
        self._thread.join()

    def _run(self) -> None:
        while not self._ended.is_set():
            found = pylsl.resolve_byprop("type", self._kind, 1, LOOK_FOR)
            usable = [info for info in found if info.channel_count() in CHANNELS]
            if not usable:
                self._ended.wait(0.1)
                continue
            inlet = pylsl.StreamInlet(usable[0], max_buflen=2, recover=False)
            self._clients = 1
            with contextlib.suppress(pylsl.util.LostError):
                self._follow(inlet, usable[0].name())
            self._clients = 0
            inlet.close_stream()

    def _follow(self, inlet: pylsl.StreamInlet, name: str) -> None:
        offset, due = math.nan, -math.inf
        while not self._ended.is_set():
            now = monotonic()
            if now >= due:
                due = now + MEASURE_EVERY
                with contextlib.suppress(pylsl.util.TimeoutError):
                    offset = inlet.time_correction(MEASURE_WAIT)
            samples, stamps = inlet.pull_chunk(timeout=PULL_WAIT, max_samples=MOST_SAMPLES)
            for values, stamp in zip(samples, stamps, strict=True):
                self._sample(np.array(values, float), stamp + offset, name)

    def _sample(self, values: np.ndarray, stamp: float, name: str) -> None:
        """``stamp`` is by this computer's LSL clock; NaN while the sender's is not known."""
        if not np.isfinite(values).all():
            return  # the tracking system does not see the tracker
        now = monotonic()
        t = now - (pylsl.local_clock() - stamp) if math.isfinite(stamp) else now
        q = NO_ROTATION
        if len(values) == 7:
            length = float(np.linalg.norm(values[3:]))
            if length < 0.5:
                self.taker.refuse()
                return
            q = values[3:] / length
        pose = RoomPose(name, *from_upright(values[:3], q, self._up))
        self.taker.take([pose], min(t, now), name)


def open_lsl(options: LslPoseOptions, answer: Answer) -> Door:
    """Starts to receive poses."""
    return LslPoses(answer, placement_of(options), options.type, options.up, options.network)
