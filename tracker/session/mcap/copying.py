"""Records from one file to another."""

from __future__ import annotations

from tracker.session.mcap.container import McapOutput
from tracker.session.mcap.input import McapInput, RawMessage


class Copier:
    """Writes messages of ``source`` to ``out`` as they are, with their channels and schemas."""

    def __init__(self, source: McapInput, out: McapOutput) -> None:
        contents = source.contents
        self._out = out
        schemas = {
            s.id: out.add_schema(s.name, s.encoding, s.data) for s in contents.schemas.values()
        }
        self._channels = {
            (c.topic, source.type_of(c)): out.add_channel(
                c.topic, c.message_encoding, schemas.get(c.schema_id, 0), dict(c.metadata)
            )
            for c in contents.channels.values()
        }

    def copy(self, m: RawMessage) -> None:
        channel = self._channels[m.topic, m.type]
        self._out.write(channel, m.log_time, m.publish_time, m.data, m.sequence)
