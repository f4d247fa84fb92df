"""``glovetrack import``: raw IMUs of other programs as a session, which can be tracked."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from tracker.base.clock import NS, ClockAnchor
from tracker.base.errors import ConfigError, FileError
from tracker.base.files import check_target
from tracker.glove import library
from tracker.offline.imports.matlab import read_matlab
from tracker.offline.imports.samples import ImportedSamples, doubts, in_order
from tracker.offline.imports.table import read_table
from tracker.offline.imports.together import ImportedPackets, chosen, together
from tracker.session.description import describe
from tracker.session.writer import new_session

FOLDERS_FILE = "Inertial.csv"
"""What x-IMU3's program writes in a folder for each IMU."""
ENGINE = "inertial"
"""What such a session is tracked with unless told: it has no images."""


@dataclass(frozen=True)
class ImportOptions:
    """``imus``: IMU of the glove to that of the files; glove and hand by name or file."""

    glove: str = ""
    hand: str = ""
    imus: dict[str, str] = field(default_factory=dict)


def import_imus(
    sources: list[Path], out: Path, options: ImportOptions | None = None, force: bool = False
) -> dict[str, Any]:
    """Write a session of the samples in ``sources``; what became of them.

    Raises ConfigError and FileError in words.
    """
    options = options or ImportOptions()
    paths = [path for source in sources for path in _files(source)]
    check_target(out, force, paths)
    read = [in_order(_read(path), path.name) for path in paths]
    files = [samples for samples, _ in read]
    names = [name for samples in files for name in samples.names]
    twice = {name for name in names if names.count(name) > 1}
    if twice:
        raise ConfigError(f"{', '.join(sorted(twice))} is in more than one of the files.")
    texts = library.texts(options.glove or library.DEFAULT_GLOVE, options.hand or None)
    _, glove = library.load(options.glove or library.DEFAULT_GLOVE, options.hand or None)
    wanted = chosen(names, glove.imu_names, options.imus)
    packets = together(files, glove.imu_names, wanted)
    anchor = ClockAnchor(packets.began_ns or _began(paths[0], packets), 0)
    extra = {"source": ", ".join(p.name for p in paths)[:1000], "imported": "raw samples of IMUs"}
    settings = f'engine = "{ENGINE}"\n'
    info = describe(*texts, anchor, engine=ENGINE, settings_text=settings, extra=extra)
    with new_session(out, info, force, paths) as recorder:
        for sample in packets.samples():
            recorder.write(sample)
    report = _report(packets, wanted, files, sum(lost for _, lost in read))
    rows = [glove.imu_names.index(imu) for imu in wanted]
    missing = ~np.isfinite(packets.gyro[:, rows]).all(axis=2)
    return report | {"missing": dict(zip(wanted, missing.sum(axis=0).tolist(), strict=True))}


def _files(source: Path) -> list[Path]:
    """The file itself; of a folder all `FOLDERS_FILE` in it and in its folders."""
    if not source.is_dir():
        return [source]
    found = sorted(source.glob(FOLDERS_FILE)) + sorted(source.glob(f"*/{FOLDERS_FILE}"))
    if not found:
        raise FileError(f"There is no {FOLDERS_FILE} in {source} or its folders.")
    return found


def _read(path: Path) -> ImportedSamples:
    """By its ending; an IMU that has no name is named as its file, or as the folder of it."""
    own = path.parent.name if path.name == FOLDERS_FILE else path.stem
    if path.suffix.lower() == ".mat":
        return read_matlab(path, own)
    if path.suffix.lower() in (".csv", ".txt"):
        return read_table(path, own)
    raise FileError(f"{path} is neither .csv nor .mat.")


def _began(path: Path, packets: ImportedPackets) -> int:
    """Where the file tells no time of day, its last change is taken for its end."""
    return path.stat().st_mtime_ns - round(float(packets.t[-1] - packets.t[0]) * NS)


def _report(
    packets: ImportedPackets, wanted: dict[str, str], files: list[ImportedSamples], left_out: int
) -> dict[str, Any]:
    used = [f for f in files if set(f.names) & set(wanted.values())]
    return {
        "packets": len(packets.t),
        "duration_s": float(packets.t[-1] - packets.t[0]),
        "rate_hz": 1.0 / float(np.median(np.diff(packets.t))),
        "recorded_hz": [f.rate for f in used],
        "imus": wanted,
        "left_out": left_out,
        "doubts": [text for f in used for text in doubts(f, set(wanted.values()))],
    }
