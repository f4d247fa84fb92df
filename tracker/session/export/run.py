"""Exports a session: selects the format, writes the file and a JSON file that describes it."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

import numpy as np

from tracker import __version__
from tracker.base.files import check_target, sha256, whole_files
from tracker.base.workers import ALL_CORES, WorkerRequest
from tracker.messages import Validity
from tracker.session.edits import WORD, edits_text
from tracker.session.export.formats import FORMATS, ExportFormat
from tracker.session.export.options import ExportOptions
from tracker.session.export.series import EstimateSeries
from tracker.session.export.sidecar import OTHER_FILES, forget_orphan
from tracker.session.reader import SessionReader


def export(
    path_in: Path,
    format: str,
    path_out: Path,
    options: ExportOptions | None = None,
    watch: Callable[[float], None] = lambda share: None,
    force: bool = False,
) -> dict[str, Any]:
    """Exports ``path_in`` as ``format`` to ``path_out``; returns the content of its JSON file.

    In a session of both hands, a format for one hand gives a file for each, ``path_out`` with
    ``_left`` and ``_right`` at the end of its name; the result then contains both, by side, as
    ``hands``. A file and its JSON file are complete or absent. Existing files are replaced only
    with ``force``, the session itself never. ``watch`` is called with the share of the session that
    has been read, per pass over it, and may raise to stop the export. Raises GlovetrackError.
    """
    kind = FORMATS.get(format)
    options = options or ExportOptions()
    kind.check(options)
    path_in, path_out = Path(path_in), Path(path_out)
    if kind.dataset is not None:
        return export_dataset([path_in], format, path_out, options, watch)
    sides = sides_of(path_in)
    if not sides or kind.both_hands:
        return _export_one(path_in, kind, path_out, options, watch, force)
    paths = {side: path_of_side(path_out, side) for side in sides}
    for path in paths.values():
        check_target(path, force and not kind.folder, [path_in])
    found = {
        side: _export_one(path_in, kind, path, options, watch, force, side)
        for side, path in paths.items()
    }
    return {"format": format, "file": path_out.name, "hands": found}


def export_dataset(
    sources: Sequence[Path],
    format: str,
    path_out: Path,
    options: ExportOptions,
    watch: Callable[[float], None] = lambda share: None,
    pool: WorkerRequest = ALL_CORES,
) -> dict[str, Any]:
    """Write several sessions, and all sessions in given folders, as one data set.

    Raises GlovetrackError: ConfigError for a format that is not of data sets; an existing folder is
    never added to.
    """
    kind = FORMATS.get(format)
    write = kind.load_dataset()
    kind.check(options)
    return write(sources, path_out, options, watch, pool)


def sides_of(path: Path) -> tuple[str, ...]:
    """Left and right for a session of both hands; empty for any other."""
    with SessionReader(path) as reader:
        return reader.sides


def path_of_side(path: Path, side: str) -> Path:
    """``out.csv`` as ``out_left.csv``."""
    return path.with_name(f"{path.stem}_{side}{path.suffix}")


def _export_one(
    path_in: Path,
    kind: ExportFormat,
    path_out: Path,
    options: ExportOptions,
    watch: Callable[[float], None],
    force: bool,
    side: str = "",
) -> dict[str, Any]:
    sidecar = path_out.with_name(path_out.name + ".json")
    write = kind.load()
    check_target(path_out, force and not kind.folder, [path_in])
    others = [path_out.with_suffix(ending) for ending in kind.beside]
    forget_orphan(sidecar, path_out)
    names = (sidecar, *others, path_out)
    with whole_files(*names, force=force, inputs=[path_in]) as (described, *parts, partial):
        with SessionReader(path_in, watch=watch, side=side) as reader:
            series = write(reader, partial, options)
            report = _report(reader, kind.name, path_out, options, series)
            if len(reader.source.left_out):
                report["left_out"] = reader.source.left_out.by_topic()
        if parts:
            report[OTHER_FILES] = {part.name: sha256(part) for part in parts}
        described.write_text(json.dumps(report, indent=2) + "\n", "utf-8")
    return report


def _report(
    reader: SessionReader,
    format: str,
    path: Path,
    options: ExportOptions,
    series: EstimateSeries | None,
) -> dict[str, Any]:
    """The content of the JSON file: source, options and result of an export."""
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
        "metadata": {k: v for k, v in info.metadata().items() if v},
    }
    if series is not None:
        report |= {
            "rows": len(series),
            "keypoints": list(series.keypoint_names),
            "joints": list(series.joint_names),
            "start_ns": int(series.stamp_ns[0]) if len(series) else None,
            "certainty": _state_shares(series),
            **series.notes,
        }
    if reader.edits:
        report["edits"] = json.loads(edits_text(reader.edits))["edits"]
    return _redacted(report, options.anonymous)


def _state_shares(series: EstimateSeries) -> dict[str, dict[str, float | None]]:
    """Returns for each keypoint the shares of rows in which it was measured, inferred and lost, and
    the mean sd (m) unless lost, which a BVH, a TRC or a URDF cannot contain. In an edited session
    also the interpolated share, which is part of the inferred one."""
    out: dict[str, dict[str, float | None]] = {}
    filled = None if series.point_filled is None else series.interpolated
    for k, name in enumerate(series.keypoint_names if len(series) else ()):
        state, sd = series.state[:, k], series.sd[:, k]
        known = (state != Validity.LOST) & np.isfinite(sd)
        out[name] = {s.name.lower(): round(float((state == s).mean()), 6) for s in Validity}
        if filled is not None:
            out[name][WORD] = round(float(filled[:, k].mean()), 6)
        out[name]["sd_m"] = round(float(sd[known].mean()), 6) if known.any() else None
    return out


def _redacted(report: dict[str, Any], anonymous: tuple[str, ...]) -> dict[str, Any]:
    """Removes values that must not be published, and values from which they follow."""
    top, inside = set(), set(anonymous)
    if "participant" in anonymous:  # automatic file names contain it
        top.add("source")
        inside.add("source")
        for edit in report.get("edits", ()):
            edit |= {"who": "", "source": ""}
    if "hand" in anonymous:
        top.add("hand")
    if "time" in anonymous:
        top.add("start_ns")
        inside |= {"wall_clock_ns", "monotonic_ns"}
    public = {k: v for k, v in report.items() if k not in top}
    return public | {"metadata": {k: v for k, v in report["metadata"].items() if k not in inside}}
