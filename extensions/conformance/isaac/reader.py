"""Reads records from files of this or other programs."""

from __future__ import annotations

import struct
from collections.abc import Iterator
from pathlib import Path

from mcap.exceptions import McapError
from mcap.reader import make_reader

from extensions.conformance.isaac.record import HandRecord, decode
from extensions.conformance.isaac.schema import NAME
from tracker.base.errors import FileError
from tracker.base.files import check_regular
from tracker.base.notices import notice
from tracker.hand.names import SIDES


def read_records(path: Path) -> Iterator[tuple[str, HandRecord]]:
    """Yields (side, record) in the order of log times. Raises FileError for other files."""
    try:
        check_regular(Path(path))
        with Path(path).open("rb") as file:
            for schema, channel, message in make_reader(file).iter_messages():
                leaf = channel.topic.rsplit("/", 1)[-1]
                side = next((s for s in SIDES if leaf.startswith(s)), None)
                if side is not None and schema is not None and schema.name == NAME:
                    yield side, decode(message.data)
    except (McapError, struct.error, EOFError) as error:
        raise FileError(notice("isaac.not_mcap", path=path)) from error
    except OSError as error:
        raise FileError(notice("file.not_readable", path=path, why=error.strerror)) from error
