"""Interfaces of gloves and cameras, real, recorded or simulated, for the live tracker."""

from __future__ import annotations

import threading
from collections.abc import Sequence
from typing import Protocol, runtime_checkable

from tracker.messages import Event, ImuSample, StereoFrame
from tracker.sensors.link_figures import LinkFigures


class GloveSource(Protocol):
    """A glove, real or simulated."""

    def poll(self, timeout: float) -> Sequence[ImuSample | Event]:
        """Returns what arrived, after waiting at most ``timeout`` s for anything."""

    def close(self) -> None:
        """Free the port."""


@runtime_checkable
class ReportingGlove(Protocol):
    """A glove that reports its state."""

    figures: LinkFigures


class CameraSource(Protocol):
    """A stereo camera, real or simulated."""

    def read(self, timeout: float) -> StereoFrame | None:
        """Returns the next image pair; None if none arrived within ``timeout`` s."""

    def drain_events(self) -> Sequence[Event]:
        """Returns the device's events since the last call."""

    def close(self) -> None:
        """Free the device."""


class NoGlove:
    """Replaces a missing glove: delivers nothing, and waits like a glove that does not respond."""

    def __init__(self) -> None:
        self._closed = threading.Event()

    def poll(self, timeout: float) -> Sequence[ImuSample | Event]:
        self._closed.wait(timeout)
        return ()

    def close(self) -> None:
        self._closed.set()


class NoCamera:
    """Replaces a missing camera: delivers nothing, and waits like a camera without images."""

    def __init__(self) -> None:
        self._closed = threading.Event()

    def read(self, timeout: float) -> StereoFrame | None:
        self._closed.wait(timeout)
        return None

    def drain_events(self) -> Sequence[Event]:
        return ()

    def close(self) -> None:
        self._closed.set()
