"""The settings of the window: one small JSON file, versioned, replaced atomically.

A file of an earlier version is migrated step by step (`MIGRATIONS`) after a copy of it was made; a
file that cannot be read, or that a later version wrote, is renamed. `SettingsStore.notice` contains
a message about it.
"""

from __future__ import annotations

import dataclasses
import json
import logging
import shutil
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Protocol, TypeVar

import platformdirs

from app.words import error_text, tr
from tracker.base.config import UNKNOWN, from_dict
from tracker.base.errors import DataError
from tracker.base.files import free_path, write_with_folder
from tracker.base.notices import Notice, notice

VERSION = 4
_log = logging.getLogger(__name__)


@dataclass(frozen=True)
class AppSettings:
    """The user's settings; the defaults are for a first start."""

    version: int = VERSION
    language: str = "system"  # "system", "en" or the code of a language that is complete
    theme: str = "system"  # "system", "light" or "dark"
    geometry: str = ""  # base64 of QWidget.saveGeometry
    layout: dict[str, Any] = field(default_factory=dict)  # at the end of the program
    job: str = "watch"  # the current layout; empty: one of ``layouts``
    job_layouts: dict[str, Any] = field(
        default_factory=dict
    )  # customized versions of the standard layouts
    layouts: dict[str, Any] = field(default_factory=dict)  # named layouts
    sessions_folder: str = ""
    recent: list[str] = field(default_factory=list)  # sessions opened or recorded last
    recording: str = ""  # the file being written; checked at the next start after a crash
    library_columns: list[int] = field(default_factory=list)  # their widths, px
    export: dict[str, Any] = field(default_factory=dict)  # the last `ExportChoice`
    export_presets: dict[str, Any] = field(default_factory=dict)  # named ones
    export_folder: str = ""  # the last one
    participant: str = ""
    task: str = ""
    recording_name: str = ""  # template of file names; empty for the default
    countdown: int = 0  # s before a recording begins
    countdown_sound: bool = False
    guided_sound: bool = True  # beep when a guided pose has been held
    wearers: dict[str, Any] = field(default_factory=dict)  # by side: wearer of the glove
    demo_wearers: dict[str, Any] = field(default_factory=dict)  # by side, for the demo only
    pose_reset_key: str = "R"
    pose_reset_countdown: int = 3  # s
    pose_reset_sound: bool = True
    pose_reset_tap: bool = False  # two taps on the glove reset the pose, too
    engine: str = "chain"  # the tracking engine
    curves: str = ""  # selection of the sensors panel
    graphs: dict[str, Any] = field(
        default_factory=dict
    )  # of the graphs panel, including named layouts
    angle_unit: str = "deg"  # or "rad"; for the motion panel
    view_3d: str = "auto"  # "auto", "card" or "painted"
    card_trial: bool = False  # the GPU renderer has not yet drawn enough images to be trusted
    own_process: bool = True  # tracking runs in a process of its own
    both_hands: bool = False  # the other hand's glove is expected, too
    hand: str = "reference-right"
    glove: str = "vist-small"
    gloves: dict[str, Any] = field(default_factory=dict)  # `BoundGlove`s, by number
    port: str = ""
    baud: int = 0  # of the glove's line; 0: automatic
    glove_rate: int = 100  # packets per second requested from a glove
    camera: str = ""  # see `app.engines.camera_choice`
    camera_exchanged: bool = False  # left and right images are swapped
    camera_locks: str = ""  # see `tracker.sensors.camera_controls.locks_text`
    calibration: str = ""  # path of the stereo calibration
    streams: dict[str, Any] = field(default_factory=dict)  # table of `StreamSettings`
    remote: dict[str, Any] = field(default_factory=dict)  # table of `ConnectionSettings`
    haptics: dict[str, Any] = field(default_factory=dict)  # of `app.jobs.outputs.HapticRule`
    robot: dict[str, Any] = field(default_factory=dict)  # of `extensions.robot.settings`
    robot_fingers: dict[str, Any] = field(default_factory=dict)  # links as text, by robot hand
    robot_port: int = 0  # UDP port of its states; 0: not sent
    board: str = ""  # of the stereo calibration: kind, squares across and down, side in m


Migration = Callable[[dict[str, Any]], dict[str, Any]]


def _from_1(data: dict[str, Any]) -> dict[str, Any]:
    """Version 2 has other docks: the positions of version 1 would hide the new ones."""
    return {**data, "layout": ""}


def _from_2(data: dict[str, Any]) -> dict[str, Any]:
    """Version 3 stores layouts relative to the window, not in px."""
    return {**data, "layout": {}}


def _from_3(data: dict[str, Any]) -> dict[str, Any]:
    """Version 4 stores the names of wearers by side."""
    out = dict(data)
    for prefix in ("", "demo_"):
        right, left = out.pop(f"{prefix}wearer", ""), out.pop(f"{prefix}left_wearer", "")
        out[f"{prefix}wearers"] = {"left": left, "right": right}
    return out


MIGRATIONS: dict[int, Migration] = {1: _from_1, 2: _from_2, 3: _from_3}
"""From each version to the next."""


class SettingsStore:
    """Reads and writes `AppSettings`. ``notice``: a message about the file, or empty."""

    def __init__(self, path: Path | None = None) -> None:
        folder = Path(platformdirs.user_config_dir("glovetrack", appauthor=False))
        self.path = path or folder / "window.json"
        self.notice = ""
        self.value = self._read()

    def update(self, **changes: Any) -> None:
        """Change some fields and write the file. Raises FileError."""
        self.value = dataclasses.replace(self.value, **changes)
        write_with_folder(self.path, json.dumps(dataclasses.asdict(self.value), indent=2))

    def _read(self) -> AppSettings:
        if not self.path.exists():
            return AppSettings()
        try:
            data = json.loads(self.path.read_text("utf-8"))
            version = _version_of(data)
            if version < VERSION:
                self._back_up(version)
                data = migrated(data, version)
            return _settings_from(data)
        except (OSError, ValueError) as error:
            self._rename_unreadable(error)
            return AppSettings()

    def _back_up(self, version: int) -> None:
        """Copy the file of version ``version``, to allow downgrades."""
        copy = free_path(self.path.with_suffix(f".v{version}.json"))
        shutil.copy2(self.path, copy)
        _log.info("Settings of version %d are kept as %s.", version, copy)

    def _rename_unreadable(self, error: Exception) -> None:
        renamed_file = free_path(self.path.with_suffix(".unreadable.json"))
        self.path.replace(renamed_file)
        self.notice = tr(
            "The settings could not be read: {}. The window uses its defaults; the old settings "
            "are saved in {}."
        ).format(error_text(error), renamed_file)
        _log.warning("%s", self.notice)


S_co = TypeVar("S_co", covariant=True)


class SettingsOf(Protocol[S_co]):
    """The settings that a panel uses: it may read those of ``S_co``, a protocol with a property for
    each, and changes them by `update`. A `SettingsStore` is one for every part of `AppSettings`."""

    @property
    def value(self) -> S_co: ...

    def update(self, **changes: Any) -> None:
        """Change some fields and write the file. Raises FileError."""


class SettingsFileOf(SettingsOf[S_co], Protocol[S_co]):
    """With the ``path`` of their file, for a panel that has files beside it."""

    @property
    def path(self) -> Path: ...


class WearerSettings(Protocol):
    """The settings that `wearer_of` reads."""

    @property
    def wearers(self) -> dict[str, Any]: ...

    @property
    def demo_wearers(self) -> dict[str, Any]: ...


class FolderSettings(Protocol):
    """The settings that `sessions_folder` reads."""

    @property
    def sessions_folder(self) -> str: ...


def _version_of(data: Any) -> int:
    version = data.get("version") if isinstance(data, dict) else None
    if type(version) is not int or version < 1:
        raise DataError(notice("window.settings_no_version"))
    if version > VERSION:
        raise DataError(notice("window.settings_later"))
    return version


def migrated(data: dict[str, Any], version: int) -> dict[str, Any]:
    """Settings of ``version`` converted to the current version."""
    for step in range(version, VERSION):
        data = {**MIGRATIONS[step](data), "version": step + 1}
    return data


def _settings_from(data: dict[str, Any]) -> AppSettings:
    """Settings from JSON. Unknown keys are dropped; wrong types raise ValueError."""

    def on_problem(key: str, why: Notice) -> None:
        if why != UNKNOWN:
            raise ValueError(f"{key} {why}")

    return from_dict(AppSettings, data, on_problem)


def wearer_of(settings: WearerSettings, side: str, of_demo: bool = False) -> str:
    """The wearer of the glove on one side ("left" or "right"); empty if none is selected."""
    return str((settings.demo_wearers if of_demo else settings.wearers).get(side, ""))


def sessions_folder(settings: FolderSettings) -> Path:
    """The folder for recordings: the user's choice, else the documents folder."""
    if settings.sessions_folder:
        return Path(settings.sessions_folder)
    return Path(platformdirs.user_documents_dir()) / "Glovetrack"
