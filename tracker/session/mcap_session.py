"""An opened session file: its clock and span, its metadata and attachments."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property
from importlib import import_module
from pathlib import Path
from types import TracebackType
from typing import Self

from tracker.base.clock import NS, ClockAnchor
from tracker.base.errors import FileError
from tracker.base.notices import notice
from tracker.base.toml_reader import MOST_BYTES
from tracker.messages import EngineState
from tracker.session import edits, engine_state
from tracker.session.description import METADATA
from tracker.session.edits import Edit
from tracker.session.mcap.input import McapInput
from tracker.session.mcap.ordering import ordered
from tracker.session.mcap.records import LATEST
from tracker.session.ros import motion, sensors

_LATEST_WALL = 2**31 * NS  # ns since 1970: stamps of ROS 2 have 31 bits for the seconds
_MOST_ATTACHMENTS = 1000
_RECORD_BYTES = 1000  # of an attachment's record, without its data
STATE_MODULES = ("..engine.pipeline", "..engine.hands")
"""With the states of all engines they import every module with a ``@record``; a test compares that
with the source. The names are relative because an installed program has these modules in another
package."""
MEASURED = frozenset({sensors.IMU, sensors.IMAGE, sensors.DETECTIONS, motion.POSES, motion.JOINTS})
"""Types of sensor messages and of estimates, each with a stamp of its own."""


class McapSession:
    """A session file opened for reading; a context manager. Raises FileError if it is not one.

    ``instead`` replaces attachments by name, or adds those that the file lacks.
    """

    def __init__(self, path: Path, instead: Mapping[str, str] | None = None) -> None:
        self.path, self._replace = Path(path), dict(instead or {})
        self.source = McapInput(self.path)

    def close(self) -> None:
        self.source.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self,
        kind: type[BaseException] | None,
        error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:
        self.close()

    @cached_property
    def topic_names(self) -> frozenset[str]:
        return frozenset(c.topic for c in self.source.contents.channels.values())

    @cached_property
    def metadata(self) -> dict[str, str]:
        """The record ``glovetrack``; empty in a session of another program."""
        for record in self.source.metadata():
            if record.name == METADATA:
                return dict(record.metadata)
        return {}

    @cached_property
    def attachments(self) -> dict[str, str]:
        """Text attachments by file name; those with a path in their name and large ones are left
        out."""
        out: dict[str, str] = {}
        for entry in self.source.contents.attachments[:_MOST_ATTACHMENTS]:
            if entry[1] > MOST_BYTES + _RECORD_BYTES:
                continue
            a = self.source.attachment_at(entry)
            if "/" in a.name or "\\" in a.name or a.name == engine_state.NAME:
                continue
            try:
                out[a.name] = a.data.decode()
            except UnicodeDecodeError:
                continue  # not Glovetrack's, which are TOML
        return {**out, **self._replace}

    @cached_property
    def edits(self) -> tuple[Edit, ...]:
        """The changes of this session after it was recorded or tracked; see `edits`.

        Raises FileError if they cannot be read.
        """
        text = self.attachments.get(edits.NAME)
        return () if text is None else edits.parse_edits(text, f"{self.path}, {edits.NAME}")

    @property
    def has_start_state(self) -> bool:
        """Whether a live tracker recorded its state."""
        return any(a.name == engine_state.NAME for a in self.source.attachments())

    def engine_states(self) -> list[EngineState]:
        """Returns the engine's states at the start of the recording and after each command.

        Raises FileError if one is damaged or of another version.
        """
        register_states()
        found = [
            EngineState(self.anchor.monotonic(a.log_time), *engine_state.unpack(a.data))
            for a in self.source.attachments()
            if a.name == engine_state.NAME
        ]
        return sorted(found, key=lambda state: state.t)

    def attachment(self, name: str) -> str:
        """Returns an attached text. Raises FileError if it is missing."""
        if name not in self.attachments:
            large = any(n > MOST_BYTES + _RECORD_BYTES for _, n in self.source.contents.attachments)
            if large:
                raise FileError(
                    notice(
                        "session.part_too_large", path=self.path, part=name, limit_bytes=MOST_BYTES
                    )
                )
            raise FileError(notice("session.part_missing", path=self.path, part=name))
        return self.attachments[name]

    @cached_property
    def anchor(self) -> ClockAnchor:
        """The session's clock; in a session of another program it starts at 1 s.

        Raises FileError for an impossible instant.
        """
        try:
            anchor = ClockAnchor(
                int(self.metadata["wall_clock_ns"]), int(self.metadata["monotonic_ns"])
            )
        except (KeyError, ValueError):
            anchor = ClockAnchor(self.source.contents.spans.bounds()[0], NS)
        if not (0 <= anchor.wall_ns < _LATEST_WALL and 0 <= anchor.monotonic_ns < LATEST):
            raise FileError(notice("session.start_time", path=self.path))
        return anchor

    @cached_property
    def span_ns(self) -> tuple[int, int]:
        """Log times of the first sensor message or estimate, and of the last message.

        Descriptions of a session may have been stamped long before, at the start of tracking.
        Without measurements, all messages count; (0, 0) if there are none.
        """
        first, last = self.source.contents.spans.bounds()
        try:
            measured = next(ordered(self.source, self._streams), None)
        except FileError:  # a damaged start: `verify` reports it
            measured = None
        return (first if measured is None else measured.log_time), last

    @property
    def _streams(self) -> frozenset[str]:
        channels = self.source.contents.channels.values()
        return frozenset(c.topic for c in channels if self.source.type_of(c) in MEASURED)

    @property
    def duration(self) -> float:
        """Seconds from the first message to the last; see `span_ns`."""
        return (self.span_ns[1] - self.span_ns[0]) / NS


def register_states() -> None:
    """Imports every module that a recorded state of tracking needs, including those of packages.

    A record registers itself when its module is imported. A program that only reads a session has
    not imported the engines; their layers are above this package, so they are imported here, by
    name.
    """
    for name in STATE_MODULES:
        import_module(name, __package__)
    import_module("..engine.kinds", __package__).load_states()
