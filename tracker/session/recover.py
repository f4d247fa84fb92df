"""Recovers the readable part of a damaged recording into a regular file."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from tracker.base.errors import FileError
from tracker.base.files import DiskError, free_path, whole_file
from tracker.base.notices import notice
from tracker.session.mcap.container import Copier, McapOutput
from tracker.session.mcap.input import McapInput
from tracker.session.mcap.records import Damage
from tracker.session.message_check import sound


@dataclass(frozen=True)
class Recovery:
    """The result of a recovery. ``damage`` lists what could not be recovered; ``left_out`` counts
    damaged messages in intact chunks, by topic."""

    path: Path
    messages: int
    damage: tuple[Damage, ...]
    left_out: dict[str, int]


def needs_recovery(path: Path) -> bool:
    """Returns whether a file was not finished. Raises FileError if it is not an MCAP."""
    source = McapInput(path)
    source.close()
    return not source.contents.finished


def recover(path: Path, out: Path | None = None, force: bool = False) -> Recovery:
    """Copies every intact record of ``path`` to a new file, by default ``<name>_recovered.mcap``.

    The input is not changed, and the new file is complete or absent; ``force`` replaces an existing
    one. Raises FileError if nothing can be recovered.
    """
    path = Path(path)
    out = out or free_path(path.with_name(f"{path.stem}_recovered{path.suffix}"))
    source = McapInput(path, scan=True)
    try:
        if not source.contents.channels and not source.contents.attachments:
            raise FileError(notice("session.nothing_recovered", path=path))
        with whole_file(out, force, [path]) as part:
            copy = _Copy(source, McapOutput(part, sync=False))
            try:
                copy.run()
            finally:
                copy.out.finish()
    finally:
        source.close()
    damage = (*source.contents.damage, *copy.damage)
    return Recovery(out, copy.messages, damage, source.left_out.by_topic())


class _Copy:
    """Copies the records of a file to another."""

    def __init__(self, source: McapInput, out: McapOutput) -> None:
        self.source, self.out = source, out
        self.messages = 0
        self.damage: list[Damage] = []

    def run(self) -> None:
        self._extras()
        copier = Copier(self.source, self.out)
        for i in range(len(self.source.contents.spans)):
            span = self.source.contents.spans[i]
            try:
                messages = self.source.messages_in(span)
            except FileError as error:
                self.damage.append(Damage(span.offset, error.notice))
                continue
            for m in sound(messages, self.source.left_out):
                self.messages += 1
                copier.copy(m)

    def _extras(self) -> None:
        """Copies metadata and attachments, except damaged ones."""
        for entry in self.source.contents.metadata:
            with self._recording_damage(entry[0]):
                record = self.source.metadata_at(entry)
                self.out.metadata(record.name, dict(record.metadata))
        for entry in self.source.contents.attachments:
            with self._recording_damage(entry[0]):
                a = self.source.attachment_at(entry)
                self.out.attach_bytes(a.name, a.media_type, a.data, a.log_time)

    @contextmanager
    def _recording_damage(self, offset: int) -> Iterator[None]:
        """Records errors of reading as damage; errors of writing are raised."""
        try:
            yield
        except DiskError:
            raise
        except FileError as error:
            self.damage.append(Damage(offset, error.notice))
