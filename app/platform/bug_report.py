"""A bug report: one zip with diagnostic data, without personal data.

`Material` is collected in the window's thread; `write_bundle` does the slow rest in a job.
"""

from __future__ import annotations

import json
import platform
import sys
import zipfile
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass, field, replace
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from tempfile import TemporaryDirectory

import psutil
from PySide6.QtCore import qVersion

from app.platform.licences import parts
from app.storage.settings import AppSettings
from app.words import tr
from tracker import __version__
from tracker.base.clock import NS
from tracker.base.errors import GlovetrackError
from tracker.base.files import disk_error
from tracker.messages import Event, StereoFrame
from tracker.session.decode import MESSAGE_KINDS
from tracker.session.reader import SessionReader
from tracker.session.writer import RecorderParams, SessionRecorder

EXCERPT_S = 10.0
PERSONAL_SETTINGS = ("participant", "task", "recording_name", "sessions_folder")
SHORTEST_NAME = 3  # letters; shorter ones occur in too many words


@dataclass(frozen=True)
class Choice:
    """The parts that the user selected."""

    screenshot: bool = True
    session: bool = True
    images: bool = False  # camera images in the session excerpt
    personal: bool = False


@dataclass(frozen=True, eq=False)
class Material:
    """Data from the window. ``screenshot`` is a PNG; ``session_file`` the file whose last seconds
    are used; without one ``write_recent`` writes the data in memory to a path and returns True, or
    returns False."""

    log: str
    settings: AppSettings
    status: dict[str, object]
    machine: dict[str, str]
    log_folder: Path | None = None
    screenshot: bytes = b""
    session_file: Path | None = None
    write_recent: Callable[[Path], bool] = lambda _path: False
    names: tuple[str, ...] = field(default=())  # personal names to be removed from texts
    doctor: str = ""  # the report of `tracker.doctor`, if it was run


def contents(choice: Choice) -> list[str]:
    """The contents, as text."""
    out = [
        tr("the log of the window and of the program, and of a crash if there was one"),
        tr("versions of Glovetrack, its packages and the operating system; size of the machine"),
        tr("the window's settings")
        if choice.personal
        else tr("the window's settings, without participant, task and folders"),
        tr("current rates, latencies and losses"),
        tr("the last check of computer and devices, if one was run (Help menu)"),
    ]
    if choice.screenshot:
        whole = tr("an image of the window")
        masked = tr(
            "an image of the window, with the library, the recording panel and the log blacked out"
        )
        out.append(whole if choice.personal else masked)
    if choice.session:
        what = tr(
            "the last {} s of the session that is open: sensor data and tracking, without "
            "camera images"
        )
        if choice.images:
            what = tr(
                "the last {} s of the session that is open: sensor data and tracking, with "
                "camera images"
            )
        out.append(what.format(f"{EXCERPT_S:.0f}"))
    return out


def machine() -> dict[str, str]:
    """The computer and its software, without personal data."""
    packages = {p.name: p.version for p in parts()}
    return {
        "glovetrack": __version__,
        "python": sys.version,
        "bundle": str(bool(getattr(sys, "frozen", False))),
        "system": platform.platform(),
        "processor": f"{platform.machine()}, {psutil.cpu_count()} cores",
        "memory": f"{psutil.virtual_memory().total / 1e9:.1f} GB",
        "qt": qVersion(),
        **{f"package {name}": number for name, number in packages.items()},
        **_optional(("websockets", "pylsl")),
    }


def _optional(names: Sequence[str]) -> dict[str, str]:
    out = {}
    for name in names:
        try:
            out[f"package {name}"] = version(name)
        except PackageNotFoundError:
            out[f"package {name}"] = "not installed"
    return out


def write_bundle(path: Path, material: Material, choice: Choice) -> list[str]:
    """Write the zip; returns messages about parts that could not be added.

    Raises FileError if ``path`` cannot be written.
    """
    clean = _cleaner(material, choice)
    problems: list[str] = []
    try:
        with (
            zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as out,
            TemporaryDirectory() as folder,
        ):
            for name, text in _texts(material, choice).items():
                out.writestr(name, clean(text))
            if choice.screenshot and material.screenshot:
                out.writestr("window.png", material.screenshot)
            if choice.session:
                excerpt = Path(folder) / "session.mcap"
                problems += _excerpt(material, choice, excerpt)
                if excerpt.is_file():
                    out.write(excerpt, "session.mcap", zipfile.ZIP_STORED)
            out.writestr("README.txt", _readme(choice, problems))
    except OSError as error:
        path.unlink(missing_ok=True)
        raise disk_error(path, error) from error
    return problems


def _readme(choice: Choice, problems: Sequence[str]) -> str:
    lines = [tr("Glovetrack bug report. Contents:"), *(f"- {c}" for c in contents(choice))]
    if problems:
        lines += ["", "Not included:", *(f"- {t}" for t in problems)]
    return "\n".join(lines) + "\n"


def _texts(material: Material, choice: Choice) -> dict[str, str]:
    """The text files, by name."""
    settings = asdict(material.settings)
    if not choice.personal:
        settings |= dict.fromkeys(PERSONAL_SETTINGS, "")
    out = {
        "log.txt": material.log,
        "settings.json": json.dumps(settings, indent=2, ensure_ascii=False),
        "status.json": json.dumps(material.status, indent=2, default=str),
        "versions.txt": "\n".join(f"{k}: {v}" for k, v in material.machine.items()) + "\n",
    }
    if material.doctor:
        out["doctor.txt"] = material.doctor
    if material.log_folder is not None:
        for path in sorted(material.log_folder.glob("*.log*")):
            out[f"logs/{path.name}"] = path.read_text("utf-8", "replace")
    return out


def _cleaner(material: Material, choice: Choice) -> Callable[[str], str]:
    """Removes names of people and of their folder from texts, unless they are allowed."""
    if choice.personal:
        return lambda text: text
    home = Path.home()
    names = [n for n in material.names if len(n) >= SHORTEST_NAME]

    def clean(text: str) -> str:
        text = text.replace(str(home), "~")
        for name in sorted(names, key=len, reverse=True):
            text = text.replace(name, "(left out)")
        return text

    return clean


def _excerpt(material: Material, choice: Choice, path: Path) -> list[str]:
    """The last seconds as a session file; returns messages about failures."""
    try:
        if material.session_file is not None:
            cut_tail(material.session_file, path, EXCERPT_S, choice.images, choice.personal)
        elif not material.write_recent(path):
            return ["the last seconds: no session is open"]
    except (GlovetrackError, OSError) as error:
        path.unlink(missing_ok=True)
        return [f"the last seconds: {error}"]
    return []


def cut_tail(source: Path, out: Path, duration: float, images: bool, personal: bool) -> None:
    """The last ``duration`` s of a session, finished or not, as a session of its own."""
    with SessionReader(source) as reader:
        info = reader.info
        if not personal:
            info = replace(info, participant="", notes="", extra={})
        start = max(reader.span_ns[1] - round(duration * NS), reader.span_ns[0])
        begin = reader.anchor.monotonic(start)
        info = replace(info, anchor=reader.anchor.at(begin))  # start of the file
        params = RecorderParams(images="jpeg" if images else "none", sync=False)
        with SessionRecorder(out, info, params) as recorder:
            for message in reader.messages(_kinds(images), start=begin):
                recorder.write(message)


def _kinds(images: bool) -> tuple[type, ...]:
    """The messages to copy; images are not even decompressed unless they are wanted. Events may
    contain text that a user wrote, and the log contains those of the program."""
    unwanted = (Event,) if images else (Event, StereoFrame)
    return tuple(k for k in MESSAGE_KINDS if k not in unwanted)
