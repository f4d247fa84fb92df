"""Sessions in which single messages are damaged, while all checksums are right."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path

from tracker.session.mcap.container import Copier, McapOutput
from tracker.session.mcap.input import McapInput, RawMessage
from tracker.session.mcap.ordering import ordered

Spoil = Callable[[RawMessage], bytes]


def cut_message(m: RawMessage) -> bytes:
    return m.data[: len(m.data) * 2 // 3]


def spoilt(source: Path, out: Path, topics: Iterable[str], spoil: Spoil, nth: int = 5) -> Path:
    """A copy of ``source`` in which the ``nth`` message of each of ``topics`` is damaged; the
    checksums of the file are right."""
    counts = dict.fromkeys(topics, 0)
    reader = McapInput(source)
    output = McapOutput(out, sync=False)
    try:
        for record in reader.metadata():
            output.metadata(record.name, dict(record.metadata))
        for a in reader.attachments():
            output.attach_bytes(a.name, a.media_type, a.data, a.log_time)
        copier = Copier(reader, output)
        for m in ordered(reader):
            if m.topic in counts:
                counts[m.topic] += 1
                if counts[m.topic] == nth:
                    m = m._replace(data=spoil(m))
            copier.copy(m)
    finally:
        output.finish()
        reader.close()
    return out
