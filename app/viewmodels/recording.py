"""A recording: its name and contents, size, data rate and the recording time left on the disk."""

from __future__ import annotations

import re
import shutil
from collections.abc import Mapping
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path

from app.engines.protocols import RecordingRequest
from app.storage.settings import SettingsStore, sessions_folder
from app.words import decimal, local, tr
from tracker.base.errors import ConfigError, FileError
from tracker.base.files import free_path, name_part
from tracker.base.notices import notice

LOW_BYTES = 5_000_000_000
STOP_BYTES = 1_000_000_000
COUNTDOWNS = (0, 3, 5)  # s


USUAL = "{participant}_{task}_{date}_{time}"
FIELDS = ("participant", "task", "date", "time", "n")
_FIELD = re.compile(r"\{(\w+)(?::0?(\d))?\}")
_SUFFIX = ".mcap"


class RecordingPlan:
    """Names and folder of the next recording, stored in the settings.

    ``participant`` and ``task`` are the last texts that the user entered.
    """

    def __init__(self, store: SettingsStore) -> None:
        self._store = store
        self.participant, self.task = store.value.participant, store.value.task

    @property
    def folder(self) -> Path:
        return sessions_folder(self._store.value)

    def set_folder(self, folder: Path) -> None:
        self._store.update(sessions_folder=str(folder))

    @property
    def template(self) -> str:
        return self._store.value.recording_name or USUAL

    def set_template(self, template: str) -> None:
        """Set the file name template (see `take_names`). Raises ConfigError if it is invalid."""
        check_template(template or USUAL)
        self._store.update(recording_name=template)

    @property
    def countdown(self) -> int:
        """Countdown before a recording, s; 0: none."""
        return self._store.value.countdown if self._store.value.countdown in COUNTDOWNS else 0

    @property
    def countdown_sound(self) -> bool:
        return self._store.value.countdown_sound

    def set_countdown(self, countdown: int, sound: bool) -> None:
        """``countdown``: one of `COUNTDOWNS`."""
        self._store.update(countdown=countdown, countdown_sound=sound)

    def request(self) -> RecordingRequest:
        """A request for a new file. Raises FileError if the folder cannot be created."""
        participant, task = self.participant.strip(), self.task.strip()
        self._store.update(participant=participant, task=task)
        return self.request_for(task)

    def request_for(self, task: str) -> RecordingRequest:
        """A `request` for another task, without changing the user's."""
        participant = self.participant.strip()
        try:
            self.folder.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            reason = error.strerror or str(error)
            raise FileError(
                notice("window.recording_folder", folder=self.folder, why=reason)
            ) from error
        path = recording_path(self.folder, participant, task, datetime.now(), self.template)
        return RecordingRequest(path, participant, task)


def free_bytes(folder: Path) -> int:
    """Space on the disk that ``folder`` is or will be on."""
    while not folder.exists() and folder != folder.parent:
        folder = folder.parent
    return shutil.disk_usage(folder).free


def size_text(size: float) -> str:
    for unit in ("B", "kB", "MB", "GB"):
        if size < 1000:
            return f"{size:.0f} {unit}" if unit == "B" else f"{local(size):.1f} {unit}"
        size /= 1000
    return f"{local(size):.1f} TB"


def duration_text(seconds: float) -> str:
    """Whole seconds, truncated after rounding to the hundredths that `position_text` shows."""
    whole = max(0, round(seconds * 100)) // 100
    hours, minutes = whole // 3600, whole // 60 % 60
    return f"{hours}:{minutes:02d}:{whole % 60:02d}" if hours else f"{minutes}:{whole % 60:02d}"


def position_text(seconds: float) -> str:
    """A position in a session to the hundredth: images are 17 ms apart."""
    hundredths = max(0, round(seconds * 100))
    return f"{duration_text(seconds)}.{hundredths % 100:02d}".replace(".", decimal())


def losses_text(values: Mapping[str, float]) -> str:
    """The losses in a recording's status."""
    lost = round(values.get("imu_lost", 0))
    thinned = round(values.get("pictures_thinned", 0))
    overflow = round(values.get("imu_overflow", 0) + values.get("messages_unrecorded", 0))
    out = [tr("{} packets").format(lost), tr("{} images not recorded").format(thinned)]
    if overflow:
        out.append(tr("{} messages discarded (system overloaded)").format(overflow))
    return ", ".join(out)


@dataclass(frozen=True)
class Disk:
    """Free space and a warning about it."""

    text: str
    warning: str
    full: bool


def disk(free: int, bytes_per_second: float) -> Disk:
    left = tr("{} free").format(size_text(free))
    if bytes_per_second > 0:
        lasts = duration_text(max(0, free - STOP_BYTES) / bytes_per_second)
        left = tr("{} free, about {} of recording").format(size_text(free), lasts)
    if free < STOP_BYTES:
        return Disk(
            left, tr("Less than 1 GB is left: recording is not possible on this disk."), True
        )
    if free < LOW_BYTES:
        return Disk(left, tr("Less than 5 GB is left on this disk."), False)
    return Disk(left, "", False)


class RateMeter:
    """Growth rate of a file or a count per second, over the last few measurements."""

    def __init__(self, looks: int = 8) -> None:
        self._looks: list[tuple[float, int]] = []
        self._keep = looks

    def add(self, t: float, size: int) -> float:
        self._looks = [*self._looks, (t, size)][-self._keep :]
        (t0, size0), (t1, size1) = self._looks[0], self._looks[-1]
        return (size1 - size0) / (t1 - t0) if t1 > t0 else 0.0


def check_template(template: str) -> None:
    """Raises ConfigError for a template without or with unknown placeholders."""
    known = ", ".join(f"{{{name}}}" for name in FIELDS)
    for found in _FIELD.finditer(template):
        if found[1] not in FIELDS:
            raise ConfigError(notice("window.unknown_field", known=known, field=found[0]))
    rest = _FIELD.sub("", template)
    if "{" in rest or "}" in rest or not template.strip():
        raise ConfigError(notice("window.bad_template", template=template, known=known))


def recording_path(
    folder: Path, participant: str, task: str, now: datetime, template: str = USUAL
) -> Path:
    """A new path in ``folder``. Raises ConfigError for an invalid template."""
    check_template(template)
    values = {
        "participant": name_part(participant),
        "task": name_part(task),
        "date": now.strftime("%Y-%m-%d"),
        "time": now.strftime("%H-%M-%S"),
    }
    named = _FIELD.sub(lambda m: m[0] if m[1] == "n" else values[m[1]], template)
    named = re.sub(r"_{2,}", "_", named).strip("_ ")
    if (count := _FIELD.search(named)) is None:
        return free_path(folder / f"{name_part(named) or 'recording'}{_SUFFIX}")
    before, after = _part(named[: count.start()]), _part(named[count.end() :])
    number = _next_number(folder, before, after)
    return free_path(folder / f"{before}{number:0{count[2] or 1}}{after}{_SUFFIX}")


def _part(text: str) -> str:
    """Text next to the number, which may be joined by a ``-``."""
    return re.sub(r"[^\w-]+", "-", _FIELD.sub("", text))


def _next_number(folder: Path, before: str, after: str) -> int:
    same = re.compile(re.escape(before) + r"(\d+)" + re.escape(after + _SUFFIX))
    names = (path.name for path in folder.glob(f"*{_SUFFIX}"))
    return 1 + max((int(m[1]) for m in map(same.fullmatch, names) if m), default=0)
