"""What a file holds, at a glance."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from tracker.errors import FileError
from tracker.session.reader import SessionReader


def session_summary(path: Path) -> dict[str, Any]:
    """Length, topics with rates, engine and whether the file is whole (see `commands`' --json)."""
    with SessionReader(path) as reader:
        duration = reader.duration
        counts = _counts(reader)
        topics = {
            channel.topic: {
                "type": reader.source.type_of(channel),
                "count": counts.get(i, 0),
                "rate_hz": round(counts.get(i, 0) / duration, 3) if duration else 0.0,
            }
            for i, channel in sorted(
                reader.source.contents.channels.items(), key=lambda c: c[1].topic
            )
        }
        metadata = reader.metadata
        return {
            "duration_s": duration,
            "topics": topics,
            "engine": metadata.get("engine", ""),
            "version": metadata.get("version", ""),
            "simulated": metadata.get("simulated") == "true",
            "integrity": _integrity(reader),
        }


def _integrity(reader: SessionReader) -> str:
    contents = reader.source.contents
    if not contents.finished:
        return "unfinished"
    return "damaged" if contents.damage else "ok"


def _counts(reader: SessionReader) -> dict[int, int]:
    """Messages by channel id; counted one by one where the file has no summary."""
    contents = reader.source.contents
    if contents.counts is not None:
        return contents.counts
    ids = {c.topic: i for i, c in contents.channels.items()}
    counts: dict[int, int] = {}
    for i in range(len(contents.spans)):
        try:
            messages = reader.source.messages_in(contents.spans[i])
        except FileError:
            continue  # a damaged chunk holds no message; `verify` speaks of it
        for m in messages:
            counts[ids[m.topic]] = counts.get(ids[m.topic], 0) + 1
    return counts
