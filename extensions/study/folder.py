"""The folder of a study: a copy of its protocol, and a folder for each participant.

protocol/protocol.toml               as the study began, with its pictures
sub-P01/progress.json                what was done, with verdicts
sub-P01/ses-free/sub-P01_….mcap      accepted trials
sub-P01/superseded/                  repeated and interrupted trials
"""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from extensions.study.progress import ACCEPTED, Progress
from extensions.study.protocol import Protocol, load_protocol
from extensions.study.schedule import ScheduleStep
from tracker.base.errors import ConfigError, FileError
from tracker.base.files import make_folder, write_whole
from tracker.base.notices import failure

STORED = Path("protocol") / "protocol.toml"


@dataclass(frozen=True)
class Accepted:
    """An accepted trial and its file."""

    step: ScheduleStep
    path: Path


@dataclass(frozen=True)
class Study:
    """A study that has begun."""

    folder: Path
    protocol: Protocol

    def progress(self, participant: str) -> Progress:
        """Raises FileError for an unknown participant or a damaged file."""
        return Progress(self.folder, self.protocol, participant)

    def all_progress(self) -> Iterator[Progress]:
        """For each participant, in the protocol's order."""
        for participant in self.protocol.participants:
            yield self.progress(participant)

    def accepted(self) -> list[Accepted]:
        """All accepted trials. Raises ConfigError if there is none."""
        found = [
            Accepted(step, progress.path(step))
            for progress in self.all_progress()
            for step in progress.trials
            if progress.entry(step).state == ACCEPTED
        ]
        if not found:
            raise ConfigError(failure("study.no_trials", folder=self.folder))
        return found

    def next_participant(self) -> str:
        """The first participant with an unfinished step; empty if all are done."""
        return next((p.participant for p in self.all_progress() if p.step is not None), "")


def open_study(folder: Path) -> Study:
    """A study that was started before. Raises FileError."""
    stored = folder / STORED
    if not stored.is_file():
        raise FileError(failure("study.no_study", folder=folder))
    protocol, _ = load_protocol(stored)
    return Study(folder, protocol)


def start_study(path: Path, folder: Path) -> Study:
    """The study of a protocol file in ``folder``, begun or continued.

    The protocol is copied with its pictures. Raises FileError if the folder contains a study by
    another protocol.
    """
    protocol, text = load_protocol(path)
    stored = folder / STORED
    if stored.is_file():
        if stored.read_text("utf-8") != text:
            raise FileError(failure("study.other_protocol", folder=folder, stored=stored))
        return Study(folder, protocol)
    make_folder(stored.parent)
    for picture in protocol.pictures:
        make_folder((stored.parent / picture).parent)
        shutil.copyfile(path.parent / picture, stored.parent / picture)
    write_whole(stored, text)
    return Study(folder, protocol)
