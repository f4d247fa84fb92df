"""What the live tracker asks of a glove and of a camera, real, recorded or simulated."""

from __future__ import annotations

import threading
from collections.abc import Sequence
from typing import Protocol, runtime_checkable

from tracker.messages import Event, ImuSample, StereoFrame
from tracker.sensors.link_figures import LinkFigures


class GloveSource(Protocol):
    """A glove, real or simulated."""

    def poll(self, timeout: float) -> Sequence[ImuSample | Event]:
        """What came, after waiting at most ``timeout`` s for anything."""

    def close(self) -> None:
        """Free the port."""


@runtime_checkable
class ReportingGlove(Protocol):
    """A glove that tells how it is."""

    figures: LinkFigures


class CameraSource(Protocol):
    """A stereo camera, real or simulated."""

    def read(self, timeout: float) -> StereoFrame | None:
        """The next image pair; None if none came within ``timeout`` s."""

    def drain_events(self) -> Sequence[Event]:
        """What happened to the device since the last call."""

    def close(self) -> None:
        """Free the device."""


class NoGlove:
    """Stands for a glove where there is none: gives nothing, and waits as a silent one does."""

    def __init__(self) -> None:
        self._closed = threading.Event()

    def poll(self, timeout: float) -> Sequence[ImuSample | Event]:
        self._closed.wait(timeout)
        return ()

    def close(self) -> None:
        self._closed.set()


class NoCamera:
    """Stands for a camera where there is none: gives nothing, and waits as a dark one does."""

    def __init__(self) -> None:
        self._closed = threading.Event()

    def read(self, timeout: float) -> StereoFrame | None:
        self._closed.wait(timeout)
        return None

    def drain_events(self) -> Sequence[Event]:
        return ()

    def close(self) -> None:
        self._closed.set()
