"""The commands ``simulate``, ``track``, ``crop``, ``light`` and ``colours``."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from tracker.base.errors import GlovetrackError
from tracker.base.notices import notice
from tracker.base.terminal import check_json, finish, progress_line
from tracker.base.workers import WorkersAsked
from tracker.offline.batch import BatchJob, plan, table, to_json, track_all
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
    workers = WorkersAsked(args.jobs, args.dask)
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
