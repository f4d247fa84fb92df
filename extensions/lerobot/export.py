"""Exports sessions as a data set, in worker processes or on a cluster."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

from extensions.lerobot.data_file import FileJob, WrittenEpisode, file_jobs, write_file
from extensions.lerobot.film import check_program
from extensions.lerobot.layout import Layout
from extensions.lerobot.meta import LARGEST_DATA_MB, write_meta
from extensions.lerobot.plan import plan
from tracker import __version__
from tracker.base.errors import GlovetrackError
from tracker.base.files import check_target, sha256, whole_files
from tracker.base.urgency import usable_cores
from tracker.base.workers import (
    ALL_CORES,
    WorkersAsked,
    WorkItem,
    run_all,
    some_workers,
)
from tracker.session.export.options import VIDEO, ExportOptions
from tracker.session.export.sidecar import forget_orphan
from tracker.session.export.tables import arrow
from tracker.session.overview import sessions_in


def export_lerobot(
    sources: Sequence[Path],
    folder: Path,
    options: ExportOptions,
    watch: Callable[[float], None] = lambda share: None,
    asked: WorkersAsked = ALL_CORES,
) -> dict[str, Any]:
    """Export sessions, including those in folders, as the data set ``folder``, which must not
    exist.

    The folder appears only when it is complete. Returns the content of the JSON file next to it.
    Raises GlovetrackError.
    """
    _check(options)
    paths = [path.absolute() for path, _ in sessions_in(sources)]
    sidecar = folder.with_name(folder.name + ".json")
    check_target(folder, False, paths)
    forget_orphan(sidecar, folder)
    layout, episodes, tasks = plan(paths, options)
    with whole_files(sidecar, folder, inputs=paths) as (report_file, partial):
        partial.mkdir()
        largest = LARGEST_DATA_MB * 2**20
        jobs = file_jobs(partial.absolute(), layout, episodes, tasks, largest)
        written = _write(jobs, watch, asked)
        write_meta(partial, layout, written, tasks)
        report = _report(paths, folder, options, layout, written, tasks)
        report_file.write_text(json.dumps(report, indent=2) + "\n", "utf-8")
    return report


def _check(options: ExportOptions) -> None:
    if options.dataset.images == VIDEO:
        check_program()
    arrow()


def _write(
    jobs: Sequence[FileJob], watch: Callable[[float], None], asked: WorkersAsked
) -> list[WrittenEpisode]:
    if len(jobs) == 1 and not asked.dask:
        return write_file(jobs[0], watch)
    items = [WorkItem(write_file, (job,), sum(e.frames for e in job.episodes)) for job in jobs]
    with some_workers(min(asked.processes or usable_cores(), len(jobs)), asked.dask) as workers:
        outcomes = run_all(items, workers, watch)
    failed = [o.error for o in outcomes if o.error]
    if failed:
        raise GlovetrackError(failed[0])
    return [w for outcome in outcomes for w in outcome.value]


def _report(
    paths: Sequence[Path],
    folder: Path,
    options: ExportOptions,
    layout: Layout,
    written: Sequence[WrittenEpisode],
    tasks: tuple[str, ...],
) -> dict[str, Any]:
    hidden = "participant" in options.anonymous  # automatic file names contain it
    hashes = [sha256(path) for path in dict.fromkeys(paths)]
    return {
        "format": "lerobot",
        "file": folder.name,
        "glovetrack": __version__,
        "options": asdict(options),
        "fps": layout.fps,
        "frames": sum(w.episode.frames for w in written),
        "tasks": list(tasks),
        "episodes": [
            {
                **({} if hidden else {"source": w.episode.source.name}),
                "frames": w.episode.frames,
                "task": w.episode.task,
            }
            for w in written
        ],
        "sources": len(paths),
        "source_sha256": hashes[0] if len(hashes) == 1 else hashes,
    }
