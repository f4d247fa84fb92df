"""Records trials with the window's engine."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from datetime import UTC, datetime
from pathlib import Path

from app.engines.engine_host import EngineHost
from app.engines.protocols import RecordingRequest
from extensions.study.schedule import ScheduleStep
from tracker.base.errors import DeviceError, FileError
from tracker.base.notices import failure


class HostStation:
    """A `Station`. ``touch`` begins a touch test, which records itself."""

    def __init__(self, host: EngineHost, touch: Callable[[ScheduleStep], bool]) -> None:
        self._host, self._touch = host, touch

    def begin(self, path: Path, step: ScheduleStep) -> None:
        """Begin a file. Raises DeviceError without a running engine, FileError."""
        if self._touch(step):
            return
        if not self._host.running or not self._host.recording.is_possible:
            raise DeviceError(failure("study.no_engine"))
        request = RecordingRequest(path, step.participant, step.task)
        if not self._host.recording.begin(request):
            raise FileError(self._host.recording.refusal or failure("study.no_recording"))

    def note(self, text: str, data: Mapping[str, object]) -> None:
        """Write a note."""
        self._host.notes.add(text, data=data)

    def end(self) -> None:
        """End the file; ``host.recording.finished`` is emitted when it is complete."""
        if self._host.recording.request is not None:
            self._host.recording.end()

    def stamp(self) -> str:
        """The present date and time, UTC."""
        return datetime.now(UTC).isoformat(timespec="seconds")
