"""Recorders: made for a live engine, and held back in a pause, which leaves a gap in the file."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from app.engines.engine import RecordingRequest
from tracker.config import to_toml
from tracker.live.recording import Recorder
from tracker.live.runner import LiveTracker
from tracker.messages import Calibration, EngineState, Event, Message
from tracker.session.description import SessionInfo
from tracker.session.writer import SessionRecorder
from tracker.vision.colours import profile_to_toml


class PausableRecorder:
    """Passes messages on to ``inner`` unless ``paused``; what happens only once always."""

    def __init__(self, inner: Recorder) -> None:
        self._inner = inner
        self.paused = False
        self.written = 0  # messages so far

    def write(self, message: Message, overloaded: bool = False) -> None:
        if not self.paused or isinstance(message, Event | Calibration | EngineState):
            self._inner.write(message, overloaded)
            self.written += 1

    def close(self) -> None:
        self._inner.close()


def recorder_maker(
    tracker: LiveTracker, info: SessionInfo
) -> Callable[[RecordingRequest], SessionRecorder]:
    """Recordings hold the engine, settings and colours of the instant they begin at."""

    def make_recorder(request: RecordingRequest) -> SessionRecorder:
        named = replace(
            info,
            participant=request.participant,
            notes=request.task,
            engine=tracker.settings.engine,
            settings_text=to_toml(tracker.settings),
            colours_text=profile_to_toml(tracker.profile),
        )
        return SessionRecorder(request.path, named)

    return make_recorder
