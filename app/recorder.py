"""A recorder that can hold back: a pause leaves a gap in the file, not a second file."""

from __future__ import annotations

from app.engine import Recorder
from tracker.messages import Calibration, EngineState, Event, Message


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
