"""Exports sessions as a data set, in worker processes or on a cluster."""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any

from extensions.lerobot.data_file import (
    CHUNK,
    DATA_PATH,
    VIDEO_PATH,
    FileJob,
    WrittenEpisode,
    file_jobs,
    write_file,
)
from extensions.lerobot.film import check_program
from extensions.lerobot.layout import CODEBASE, VALID, Layout
from extensions.lerobot.plan import plan
from extensions.lerobot.stats import together
from tracker import __version__
from tracker.base.errors import GlovetrackError
from tracker.base.files import check_target, sha256, whole_files
from tracker.base.urgency import usable_cores
from tracker.base.workers import (
    ALL_CORES,
    WorkerRequest,
    WorkItem,
    run_all,
    some_workers,
)
from tracker.session.export.axes import AXES
from tracker.session.export.openxr import WORLD
from tracker.session.export.options import OPENXR_AXES, VIDEO, ExportOptions
from tracker.session.export.sidecar import forget_orphan
from tracker.session.export.tables import arrow
from tracker.session.overview import sessions_in


def export_lerobot(
    sources: Sequence[Path],
    folder: Path,
    options: ExportOptions,
    watch: Callable[[float], None] = lambda share: None,
    pool: WorkerRequest = ALL_CORES,
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
        written = _write(jobs, watch, pool)
        write_meta(partial, layout, written, tasks)
        report = _report(paths, folder, options, layout, written, tasks)
        report_file.write_text(json.dumps(report, indent=2) + "\n", "utf-8")
    return report


def _check(options: ExportOptions) -> None:
    if options.dataset.images == VIDEO:
        check_program()
    arrow()


def _write(
    jobs: Sequence[FileJob], watch: Callable[[float], None], pool: WorkerRequest
) -> list[WrittenEpisode]:
    if len(jobs) == 1 and not pool.dask:
        return write_file(jobs[0], watch)
    items = [WorkItem(write_file, (job,), sum(e.frames for e in job.episodes)) for job in jobs]
    with some_workers(min(pool.processes or usable_cores(), len(jobs)), pool.dask) as workers:
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


LARGEST_DATA_MB, LARGEST_VIDEO_MB = 100, 200
EPISODES_PATH = "meta/episodes/chunk-000/file-000.parquet"


def write_meta(
    folder: Path, layout: Layout, written: Sequence[WrittenEpisode], tasks: tuple[str, ...]
) -> None:
    """Write all metadata. The data files must exist."""
    (folder / EPISODES_PATH).parent.mkdir(parents=True)
    meta = folder / "meta"
    _json(meta / "info.json", _info(layout, written, tasks))
    all_stats = together([w.stats for w in written])
    _json(meta / "stats.json", {key: stats.to_json() for key, stats in all_stats.items()})
    _write_tasks(meta / "tasks.parquet", tasks)
    _write_episodes(folder / EPISODES_PATH, layout, written)
    _json(meta / "glovetrack.json", _own(layout, written))


def _info(
    layout: Layout, written: Sequence[WrittenEpisode], tasks: tuple[str, ...]
) -> dict[str, Any]:
    return {
        "codebase_version": CODEBASE,
        "robot_type": "glovetrack",
        "total_episodes": len(written),
        "total_frames": sum(w.episode.frames for w in written),
        "total_tasks": len(tasks),
        "chunks_size": CHUNK,
        "data_files_size_in_mb": LARGEST_DATA_MB,
        "video_files_size_in_mb": LARGEST_VIDEO_MB,
        "fps": layout.fps,
        "splits": {"train": f"0:{len(written)}"},
        "data_path": DATA_PATH,
        "video_path": VIDEO_PATH if layout.video else None,
        "features": layout.features(),
    }


def _write_tasks(path: Path, tasks: tuple[str, ...]) -> None:
    """Tasks with the text as the pandas index, as LeRobot expects it."""
    pa, pq = arrow()
    table = pa.table({"task_index": pa.array(range(len(tasks)), pa.int64()), "task": list(tasks)})
    kinds = (("task_index", "int64", "int64"), ("task", "unicode", "object"))
    columns = [
        {"name": n, "field_name": n, "pandas_type": p, "numpy_type": k, "metadata": None}
        for n, p, k in kinds
    ]
    pandas = {"index_columns": ["task"], "column_indexes": [], "columns": columns,
            "pandas_version": "2.0.0", "creator": {"library": "glovetrack",
                                                   "version": __version__}}  # fmt: skip
    pq.write_table(table.replace_schema_metadata({"pandas": json.dumps(pandas)}), path)


def _write_episodes(path: Path, layout: Layout, written: Sequence[WrittenEpisode]) -> None:
    pa, pq = arrow()
    rows = [_row(layout, w) for w in written]
    columns = {name: [row[name] for row in rows] for name in rows[0]}
    pq.write_table(pa.table(columns), path)


def _row(layout: Layout, w: WrittenEpisode) -> dict[str, Any]:
    e = w.episode
    chunk, file = w.file // CHUNK, w.file % CHUNK
    row: dict[str, Any] = {
        "episode_index": e.number,
        "tasks": [e.task],
        "length": e.frames,
        "data/chunk_index": chunk,
        "data/file_index": file,
        "dataset_from_index": e.first,
        "dataset_to_index": e.first + e.frames,
    }
    for camera in layout.cameras if layout.video else ():
        row |= {
            f"videos/{camera.key}/chunk_index": chunk,
            f"videos/{camera.key}/file_index": file,
            f"videos/{camera.key}/from_timestamp": w.film_start,
            f"videos/{camera.key}/to_timestamp": w.film_start + e.frames / layout.fps,
        }
    for key, stats in w.stats.items():
        row |= {f"stats/{key}/{name}": value for name, value in stats.to_json().items()}
    return row | {"meta/episodes/chunk_index": 0, "meta/episodes/file_index": 0}


def _own(layout: Layout, written: Sequence[WrittenEpisode]) -> dict[str, Any]:
    """Metadata that LeRobot's own files cannot contain."""
    return {
        "glovetrack": __version__,
        "world": AXES[WORLD].description,
        "joint_axes": OPENXR_AXES,
        "units": "m, rad; quaternions x, y, z, w of one sign along an episode",
        "lost": f"keeps its last value; {VALID} is 0 there",
        "action": "joints of the robot" if layout.robot else "the next frame's state",
        "episodes": [
            {
                "lost_share": round(w.lost, 6),
                "image_gap_s": round(w.image_gap, 6) if layout.cameras else None,
            }
            for w in written
        ],
    }


def _json(path: Path, value: dict[str, Any]) -> None:
    path.write_text(json.dumps(value, indent=2) + "\n", "utf-8")
