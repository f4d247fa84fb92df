"""MCAP: the session itself, or a part of it, without data that must not be published."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path

from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.messages import EYES, Estimate
from tracker.session import description, edits, engine_state
from tracker.session.export.options import ExportOptions
from tracker.session.mcap.container import Copier, McapOutput
from tracker.session.mcap.input import FOREVER, RawMessage
from tracker.session.mcap.ordering import last_before, ordered
from tracker.session.message_check import check_message, sound
from tracker.session.reader import SessionReader
from tracker.session.ros import motion, topics

_IDENTIFYING = ("source",)  # a file's name contains the participant's


def export_mcap(reader: SessionReader, path: Path, options: ExportOptions) -> None:
    """Messages are copied unchanged, so rate, axes, units and joints have no effect here.

    Raises ConfigError if one of them, or omission of the hand or the time, is requested.
    """
    _check(options)
    copy_part(reader, path, _span(reader, options), options)


def copy_part(
    reader: SessionReader,
    path: Path,
    span: tuple[int, int],
    options: ExportOptions,
    state: bytes | None = None,
) -> None:
    """Copies the messages with log times (ns) of ``span``, and the values from before that are
    valid until they are published again; damaged ones are left out. A recording that began while
    the engine was behind has its descriptions after its first messages; those are copied, too.

    ``state``: an engine's state at the start of the part, from `engine_state.pack`. The clocks of a
    part start at its beginning.
    """
    start, end = span
    out = McapOutput(path, sync=False)
    try:
        _write_extras(reader, out, options, start)
        if state is not None:
            out.attach_bytes(engine_state.NAME, engine_state.MEDIA_TYPE, state, start)
        copier = Copier(reader.source, out)
        descriptions = _description_topics(reader)
        for topic in _latched_topics(reader) if start else ():
            valid = last_before(reader.source, topic, start, check_message)
            if valid is None and topic in descriptions:
                valid = _first_after(reader, topic, end)
            if valid is not None:
                copier.copy(valid._replace(log_time=start))
        for m in sound(ordered(reader.source, None, start, end), reader.source.left_out):
            if not ("notes" in options.anonymous and _is_note(m)):
                copier.copy(m)
    finally:
        out.finish()


def _first_after(reader: SessionReader, topic: str, end: int) -> RawMessage | None:
    """The first message of a topic from ``end`` (ns) on; earlier ones are in the part itself."""
    found = ordered(reader.source, frozenset([topic]), end)
    return next(sound(found, reader.source.left_out), None)


def copy_extras(reader: SessionReader, out: McapOutput, without: Sequence[str] = ()) -> None:
    """Copies a session's metadata and its attachments, except those named in ``without``."""
    _write_extras(reader, out, ExportOptions(), 0, without)


def _check(options: ExportOptions) -> None:
    hidden = [name for name in ("hand", "time") if name in options.anonymous]
    if hidden:
        raise ConfigError(notice("export.session_needs", parts=hidden))


def _span(reader: SessionReader, options: ExportOptions) -> tuple[int, int]:
    """Log times (ns); 0 and `FOREVER` at ends that are not cut."""
    if options.start is None and options.stop is None:
        return 0, FOREVER
    first = next((m.t for m in reader.messages((Estimate,)) if isinstance(m, Estimate)), None)
    zero = reader.span_ns[0] if first is None else reader.anchor.wall(first)
    start = 0 if options.start is None else zero + round(options.start * 1e9)
    end = FOREVER if options.stop is None else zero + round(options.stop * 1e9)
    return max(start, 0), max(end, 0)


def _write_extras(
    reader: SessionReader,
    out: McapOutput,
    options: ExportOptions,
    start: int,
    without: Sequence[str] = (),
) -> None:
    for record in reader.source.metadata():
        values = dict(record.metadata)
        if record.name == description.METADATA:
            values |= _anchored_at(values, start)
            values |= {k: "" for k in options.anonymous if k in values}
            if "participant" in options.anonymous:
                values = {k: v for k, v in values.items() if k not in _IDENTIFYING}
        out.metadata(record.name, values)
    for a in reader.source.attachments():
        if a.name in without or (a.name == engine_state.NAME and a.log_time < start):
            continue
        data = a.data
        if a.name == edits.NAME and "participant" in options.anonymous:
            data = edits.without_person(data.decode()).encode()
        out.attach_bytes(a.name, a.media_type, data, a.log_time)


def _anchored_at(values: dict[str, str], start: int) -> dict[str, str]:
    """Returns the same two clocks, anchored at the start of the part (ns); stamps do not change."""
    try:
        wall, monotonic = int(values["wall_clock_ns"]), int(values["monotonic_ns"])
    except (KeyError, ValueError):
        return {}
    if start <= wall:
        return {}
    return {"wall_clock_ns": str(start), "monotonic_ns": str(start - wall + monotonic)}


def _latched_topics(reader: SessionReader) -> list[str]:
    """Returns the topics whose last message is valid until the next."""
    sides = [hand.side for hand in reader.info.hands]
    hand = [topics.hand(s, what) for s in sides for what in ("states", "calibration")]
    return [*hand, *_description_topics(reader)]


def _description_topics(reader: SessionReader) -> list[str]:
    """The latched topics that describe cameras and robots, which rarely change."""
    camera = [topics.camera_info(c) for c in EYES]
    latched = ("robot_description", "model")  # in this order: reading the second requires the first
    robot = [t for t in reader.topic_names if topics.robot_of(t)[1] in latched]
    return [*camera, topics.TF_STATIC, topics.CAMERA_POSE, *sorted(robot, reverse=True)]


def _is_note(m: RawMessage) -> bool:
    """Returns whether a message is a note, or another program's event, which may be one."""
    if m.topic != topics.EVENTS:
        return False
    text = motion.unpack_string(m.data)
    try:
        content = json.loads(text)
    except json.JSONDecodeError:
        return True
    return not isinstance(content, dict) or content.get("kind", "note") == "note"
