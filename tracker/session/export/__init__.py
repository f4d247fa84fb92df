"""Exports: `export` picks the format, writes the file and a small JSON beside it."""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable
from dataclasses import asdict
from importlib import import_module
from pathlib import Path
from typing import Any

from tracker import __version__
from tracker.errors import ConfigError, FileError
from tracker.session.disk import disk_error
from tracker.session.export.motion import ExportOptions, Motion
from tracker.session.formats import FORMATS
from tracker.session.reader import SessionReader


def export(
    path_in: Path,
    format: str,
    path_out: Path,
    options: ExportOptions | None = None,
    watch: Callable[[float], None] = lambda share: None,
) -> dict[str, Any]:
    """Write ``path_in`` as ``format`` to ``path_out``; returns what the JSON beside it says.

    ``watch`` hears which share of the session has been read, once per pass over it, and may raise
    to end the export. Raises GlovetrackError in words. An unfinished output is removed.
    """
    if format not in FORMATS:
        raise ConfigError(f"There is no format {format!r}; there are {', '.join(FORMATS)}.")
    options = options or ExportOptions()
    path_in, path_out = Path(path_in), Path(path_out)
    if path_out.exists() and path_out.samefile(path_in):
        raise FileError(f"{path_out} is the session itself; choose another name.")
    write = getattr(import_module(f"tracker.session.export.{format}"), f"export_{format}")
    partial = path_out.with_name(f".{path_out.stem}.part{path_out.suffix}")
    try:
        with SessionReader(path_in, watch=watch) as reader:
            motion = write(reader, partial, options)
            report = _report(reader, format, path_out, options, motion)
        partial.replace(path_out)
        _sidecar(path_out).write_text(json.dumps(report, indent=2) + "\n", "utf-8")
    except OSError as error:
        raise disk_error(path_out, error) from error
    finally:
        partial.unlink(missing_ok=True)
    return report


def _sidecar(path: Path) -> Path:
    return path.with_name(path.name + ".json")


def _report(
    reader: SessionReader, format: str, path: Path, options: ExportOptions, motion: Motion | None
) -> dict[str, Any]:
    """What was done, to what, with which options."""
    info = reader.info
    report: dict[str, Any] = {
        "format": format,
        "file": path.name,
        "source": reader.path.name,
        "source_sha256": sha256(reader.path),
        "glovetrack": __version__,
        "options": asdict(options),
        "hand": info.hand.name,
        "glove": info.glove.name,
        "metadata": {k: v for k, v in info.metadata().items() if v and k not in options.anonymous},
    }
    if motion is not None:
        report |= {
            "rows": len(motion),
            "keypoints": list(motion.keypoint_names),
            "joints": list(motion.joint_names),
            "start_ns": int(motion.stamp_ns[0]) if len(motion) else None,
            **motion.notes,
        }
    return report


def sha256(path: Path) -> str:
    """Hex digest of a file, read in pieces."""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()


__all__ = ["FORMATS", "ExportOptions", "export", "sha256"]
