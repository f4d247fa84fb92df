"""What was measured and estimated in the last seconds, for curves on the screen."""

from __future__ import annotations

from collections import deque
from typing import Generic, NamedTuple, Protocol, TypeVar

from tracker.live.telemetry import Telemetry
from tracker.messages import FrameResult, ImuSample

HISTORY_S = 10.0
"""Seconds that are stored for curves and for the steps of the set-up."""


class Timed(Protocol):
    """A message of one instant."""

    @property
    def t(self) -> float: ...


T = TypeVar("T", bound=Timed)


class History(Generic[T]):
    """The messages of the last `HISTORY_S` seconds. Written by one thread, read by any."""

    def __init__(self) -> None:
        self._messages: deque[T] = deque()

    def add(self, message: T) -> None:
        """Appends the next message, which is not earlier than the last."""
        messages = self._messages
        messages.append(message)
        while messages[-1].t - messages[0].t > HISTORY_S:
            messages.popleft()

    def clear(self) -> None:
        """Forgets all messages."""
        self._messages.clear()

    def recent(self) -> list[T]:
        """Returns the messages, oldest first."""
        while True:
            try:
                return list(self._messages)
            except RuntimeError:  # the other thread has added a message meanwhile
                continue


class ImuHistory(History[ImuSample]):
    """The packets of the last seconds, and how many were lost."""

    def __init__(self, telemetry: Telemetry) -> None:
        super().__init__()
        self._telemetry = telemetry
        self._lost = 0

    def add(self, sample: ImuSample) -> None:
        """Appends the next packet."""
        self._telemetry.tick("imu", sample.t_arrival)
        last = self._messages[-1] if self._messages else None
        if last is not None and sample.seq > last.seq + 1 > 0:
            self._lost += sample.seq - last.seq - 1
        super().add(sample)

    def silent(self, t: float, after: float) -> bool:
        """Returns whether no packet had arrived for ``after`` s at ``t`` (s)."""
        return not self._messages or t - self._messages[-1].t_arrival > after

    def figures(self) -> dict[str, float]:
        """Returns the number of packets that are missing in the sequence numbers."""
        return {"imu_lost": self._lost}


class SearchedImage(NamedTuple):
    """What was found in one stereo exposure, without its images; ``left`` and ``right`` are the
    numbers of blobs, 0 of a camera without an image."""

    t: float
    left: int
    right: int
    result: FrameResult
