"""The messages between the window's process and the recorder's, through one pipe.

To the recorder: `Begin`, then lists of `Item`, then `End`. Back: `Begun`, at most one
`RecordingFailed` at any time, and `Ended` in answer to `End`.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple, Protocol

from tracker.base.errors import GlovetrackError
from tracker.messages import Message
from tracker.session.description import SessionInfo
from tracker.session.recording.image_slots import ImageInSlot, SlotsOpened
from tracker.session.writer import RecorderParams, SessionRecorder


class Sink(Protocol):
    """Takes messages: a `SessionRecorder` or a wrapper of one."""

    def write(self, message: Message, overloaded: bool = False, side: str = "") -> bool: ...

    def close(self) -> None: ...


class PackedState(NamedTuple):
    """An EngineState as bytes, so that the recorder does not have to import engines."""

    t: float
    data: bytes


class OfHand(NamedTuple):
    """A message of the hand on one side."""

    side: str
    message: Message


Item = Message | OfHand | ImageInSlot | SlotsOpened | PackedState


def alone(recorder: SessionRecorder) -> Sink:
    """The recorder itself, for recordings without a companion."""
    return recorder


@dataclass(frozen=True)
class Begin:
    """``companion`` wraps the recorder in its process, for example to add the truth of a
    simulation."""

    path: Path
    info: SessionInfo
    params: RecorderParams
    companion: Callable[[SessionRecorder], Sink] = alone


class End(NamedTuple):
    """Writes the received messages and closes the file."""


class Begun(NamedTuple):
    """The file is open."""

    path: Path


class RecordingFailed(NamedTuple):
    """Writing has failed and ended, with the error that a recorder in the same process would
    raise."""

    error: GlovetrackError


class Ended(NamedTuple):
    """The file is closed, and whole unless `RecordingFailed` was sent before."""
