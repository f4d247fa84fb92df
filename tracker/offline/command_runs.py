"""The commands ``simulate``, ``track``, ``crop``, ``light`` and ``colours``."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from tracker.base.errors import ConfigError, GlovetrackError
from tracker.base.files import make_folder
from tracker.base.notices import notice
from tracker.base.terminal import check_json, finish, progress_line
from tracker.base.urgency import usable_cores
from tracker.base.workers import (
    ALL_CORES,
    TaskOutcome,
    WorkerRequest,
    WorkItem,
    run_all,
    some_workers,
)
from tracker.offline.colours import check_session, fit_session, session_light
from tracker.offline.commands import (
    ColoursCheckArguments,
    ColoursFitArguments,
    CropArguments,
    LightArguments,
    SimulateArguments,
    TrackArguments,
)
from tracker.offline.crop import crop
from tracker.offline.options import LENSES_BY_NUMBER, USUAL, TrackOptions
from tracker.offline.simulate import simulate
from tracker.offline.track import track
from tracker.offline.track_report import TrackReport
from tracker.session.overview import sessions_in


def run_crop(args: CropArguments) -> int:
    check_json(args, [args.source])
    watch = progress_line("cropping")
    report = crop(args.source, args.out, args.start, args.stop, watch, args.force)
    line = f"{args.out}: {report['duration_s']:.2f} s of {args.source.name}"
    finish(args, report, [line], [args.source, args.out])
    return 0


def run_light(args: LightArguments) -> int:
    check_json(args, [args.file])
    light = session_light(args.file, args.colours)
    finish(args, light.to_json(), light.lines(), [args.file])
    return 0


def run_fit_colours(args: ColoursFitArguments) -> int:
    fit = fit_session(args.source, args.out, args.colours, args.force)
    before = fit.before
    print(
        f"Before: {before.found:.1f} markers, {before.clashing:.1f} other regions per image. Now:"
    )
    if fit.exchanged:
        print(notice("colours.exchanged_corrected", hues=fit.exchanged))
    print("\n".join(fit.after.lines()))
    return 0


def run_check_colours(args: ColoursCheckArguments) -> int:
    check_json(args, [args.source])
    found = check_session(args.source, args.colours)
    finish(args, found.to_json(), found.lines(), [args.source])
    return 0


def run_simulate(args: SimulateArguments) -> int:
    given = args.options.lenses
    options = replace(args.options, lenses=LENSES_BY_NUMBER.get(given, given))
    simulate(args.out, options, progress_line("simulating"), args.force)
    return 0


def run_track(args: TrackArguments) -> int:
    options = args.options
    if options.settings == "default":
        options = replace(options, settings=USUAL)
    jobs = plan(args.sources, args.out)
    if len(jobs) > 1 or args.dask or args.out.is_dir():
        return _track_many(args, jobs, options)
    (job,) = jobs
    check_json(args, [job.source])
    progress = progress_line("tracking")
    tracked = track(job.source, job.out, options, progress, force=args.force)
    report, warnings = tracked.to_json(), tracked.words
    finish(args, report, [_summary(report), *warnings], [job.source, job.out])
    return 0


def _track_many(args: TrackArguments, jobs: Sequence[BatchJob], options: TrackOptions) -> int:
    progress = progress_line(f"tracking {len(jobs)} sessions")
    files = [path for job in jobs for path in (job.source, job.out)]
    check_json(args, files)
    workers = WorkerRequest(args.jobs, args.dask)
    outcomes = track_all(jobs, options, progress, workers, args.force)
    finish(args, to_json(jobs, outcomes), table(jobs, outcomes).splitlines(), files)
    failed = sum(bool(o.error) for o in outcomes)
    if failed:
        raise GlovetrackError(notice("track.some_failed", failed=failed, count=len(jobs)))
    return 0


def _summary(report: dict[str, Any]) -> str:
    text = (
        f"{report['estimates']} estimates over {report['duration_s']:.1f} s in "
        f"{report['wall_s']:.1f} s, {report['frames']} images, lost for {report['lost_s']:.1f} s"
    )
    if "error_mm" in report:
        text += f", mean error {report['error_mm']['mean']:.1f} mm"
    if "error_deg" in report:
        text += f", mean joint angle error {report['error_deg']:.1f}°"
    return text + "."


# ---- ``glovetrack track`` on folders and many files: what becomes of what, and a table of
# results

HEAD = ("session", "duration", "mean error", "tracked", "seconds", "")


@dataclass(frozen=True)
class BatchJob:
    """One session and the file that its tracking goes into."""

    source: Path
    out: Path


def plan(sources: Sequence[Path], out: Path) -> list[BatchJob]:
    """One file goes to the file ``out``; several, or a folder, into the folder ``out``.

    Sessions with the same name get a number. Raises ConfigError if ``out`` is a file but must be a
    folder.
    """
    if len(sources) == 1 and not sources[0].is_dir() and not out.is_dir():
        return [BatchJob(sources[0], out)]
    if out.exists() and not out.is_dir():
        raise ConfigError(notice("track.out_is_file", path=out))
    taken: set[Path] = set()
    jobs = []
    for source, name in sessions_in(sources, leave_out=out):
        candidate, n = name, 1
        while candidate in taken:
            n += 1
            candidate = name.with_name(f"{name.stem}_{n}{name.suffix}")
        taken.add(candidate)
        jobs.append(BatchJob(source, out / candidate))
    return jobs


def track_all(
    jobs: Sequence[BatchJob],
    options: TrackOptions,
    progress: Callable[[float], None],
    pool: WorkerRequest = ALL_CORES,
    force: bool = False,
) -> list[TaskOutcome]:
    """Track every job, each in a process of its own; an outcome's value is a `TrackReport`.

    A file that exists already is an outcome's error unless ``force``.
    """
    for job in jobs:
        make_folder(job.out.parent)
    tasks = [
        WorkItem(
            _track_one, (j.source.absolute(), j.out.absolute(), options, force), _size(j.source)
        )
        for j in jobs
    ]
    with some_workers(min(pool.processes or usable_cores(), len(jobs)), pool.dask) as workers:
        return run_all(tasks, workers, progress)


def _size(path: Path) -> float:
    return float(path.stat().st_size) if path.is_file() else 1.0


def _track_one(
    source: Path,
    out: Path,
    options: TrackOptions,
    force: bool,
    progress: Callable[[float], None],
) -> TrackReport:
    # processes share the cores already, so each detects in one thread
    return track(source, out, options, progress, threads=1, force=force)


def table(jobs: Sequence[BatchJob], outcomes: Sequence[TaskOutcome]) -> str:
    """A line per session: length, error where the truth is known, share tracked, time it took."""
    rows = [HEAD, *(_row(j, o) for j, o in zip(jobs, outcomes, strict=True))]
    widths = [max(len(row[k]) for row in rows) for k in range(len(HEAD) - 1)]
    lines = []
    for row in rows:
        cells = [row[0].ljust(widths[0])]
        cells += [cell.rjust(width) for cell, width in zip(row[1:-1], widths[1:], strict=True)]
        lines.append("  ".join([*cells, row[-1]]).rstrip())
    return "\n".join(lines)


def _row(job: BatchJob, outcome: TaskOutcome) -> tuple[str, ...]:
    if outcome.error:
        return str(job.source), "–", "–", "–", "–", str(outcome.error)
    r: TrackReport = outcome.value
    error = f"{r.error_mm['mean']:.1f} mm" if r.error_mm else "–"
    tracked = f"{100 * (1 - r.lost_s / r.duration_s):.1f} %" if r.duration_s else "–"
    return str(job.source), f"{r.duration_s:.1f} s", error, tracked, f"{r.wall_s:.1f}", ""


def to_json(jobs: Sequence[BatchJob], outcomes: Sequence[TaskOutcome]) -> dict[str, Any]:
    """The same for programs."""
    rows = []
    for job, outcome in zip(jobs, outcomes, strict=True):
        result = {"error": str(outcome.error)} if outcome.error else outcome.value.to_json()
        rows.append({"source": str(job.source), "out": str(job.out), **result})
    return {"sessions": rows}
