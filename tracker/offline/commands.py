"""The commands ``simulate``, ``track``, ``crop``, ``light`` and ``colours``."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tracker.base.arguments import add_options, options_of
from tracker.base.command import Command
from tracker.base.errors import GlovetrackError
from tracker.base.notices import notice
from tracker.base.terminal import add_force, add_json, check_json, finish, progress_line
from tracker.offline.options import LENSES_BY_NUMBER, USUAL, SimulateOptions, TrackOptions

if TYPE_CHECKING:
    from tracker.offline.batch import BatchJob


def _add_simulate(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("-o", "--out", type=Path, required=True, help="the new session (.mcap)")
    add_options(parser, SimulateOptions)
    add_force(parser)


def _add_track(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "sources", type=Path, nargs="+", metavar="IN", help="sessions or folders of sessions"
    )
    parser.add_argument(
        "-o",
        "--out",
        type=Path,
        required=True,
        help="the new session; for several inputs, a folder",
    )
    add_options(parser, TrackOptions)
    add_json(parser)
    parser.add_argument(
        "--jobs", type=int, metavar="N", help="number of worker processes (default: one per core)"
    )
    parser.add_argument("--dask", default="", metavar="ADDRESS", help="run on this Dask cluster")


def _add_crop(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("source", type=Path, metavar="IN", help="session file")
    parser.add_argument("-o", "--out", type=Path, required=True, help="the new session")
    parser.add_argument(
        "--start",
        type=float,
        default=0.0,
        metavar="S",
        help="start, in seconds from the beginning (default: 0)",
    )
    parser.add_argument(
        "--stop",
        type=float,
        default=None,
        metavar="S",
        help="end, in seconds from the beginning (default: the end)",
    )
    add_json(parser)


def _crop(args: argparse.Namespace) -> int:
    from tracker.offline.crop import crop

    check_json(args, [args.source])
    watch = progress_line("cropping")
    report = crop(args.source, args.out, args.start, args.stop, watch, args.force)
    line = f"{args.out}: {report['duration_s']:.2f} s of {args.source.name}"
    finish(args, report, [line], [args.source, args.out])
    return 0


def _add_light(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("file", type=Path, metavar="FILE", help="session with images")
    parser.add_argument(
        "--colours", default="", help="colour profile name or file (default: the session's profile)"
    )
    add_json(parser)


def _light(args: argparse.Namespace) -> int:
    from tracker.offline.colours import session_light

    check_json(args, [args.file])
    light = session_light(args.file, args.colours)
    finish(args, light.to_json(), light.lines(), [args.file])
    return 0


def _add_colours_fit(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "-o", "--out", type=Path, required=True, help="the new colour profile (.toml)"
    )
    _add_coloured(parser)
    add_force(parser)


def _add_colours_check(parser: argparse.ArgumentParser) -> None:
    _add_coloured(parser)
    add_json(parser)


def _add_coloured(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("source", type=Path, metavar="SESSION", help="session with images")
    parser.add_argument(
        "--colours", default="", help="colour profile name or file (default: the session's profile)"
    )


def _fit_colours(args: argparse.Namespace) -> int:
    from tracker.offline.colours import fit_session

    fit = fit_session(args.source, args.out, args.colours, args.force)
    before = fit.before
    print(
        f"Before: {before.found:.1f} markers, {before.clashing:.1f} other regions per image. Now:"
    )
    if fit.exchanged:
        print(notice("colours.exchanged_corrected", hues=fit.exchanged))
    print("\n".join(fit.after.lines()))
    return 0


def _check_colours(args: argparse.Namespace) -> int:
    from tracker.offline.colours import check_session

    check_json(args, [args.source])
    found = check_session(args.source, args.colours)
    finish(args, found.to_json(), found.lines(), [args.source])
    return 0


def _simulate(args: argparse.Namespace) -> int:
    from tracker.offline.simulate import simulate

    lenses = LENSES_BY_NUMBER.get(args.lenses, args.lenses)
    options = options_of(SimulateOptions, args, lenses=lenses)
    simulate(args.out, options, progress_line("simulating"), args.force)
    return 0


def _track(args: argparse.Namespace) -> int:
    from tracker.offline.batch import plan
    from tracker.offline.track import track

    settings = USUAL if args.settings == "default" else args.settings
    options = options_of(TrackOptions, args, settings=settings)
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


def _track_many(args: argparse.Namespace, jobs: Sequence[BatchJob], options: TrackOptions) -> int:
    from tracker.base.workers import WorkersAsked
    from tracker.offline.batch import table, to_json, track_all

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


SIMULATE = Command("simulate", "simulate a session with known truth", _simulate, add=_add_simulate)
TRACK = Command("track", "track a recorded session again", _track, add=_add_track)
CROP = Command("crop", "copy part of a session to a new session", _crop, add=_add_crop)
LIGHT = Command(
    "light",
    "assess the lighting of a recording and suggest improvements",
    _light,
    add=_add_light,
)
COLOURS = Command[argparse.Namespace]("colours", "fit colours to a recording, or check them")
COLOURS_FIT = Command(
    "colours fit", "fit colours to the images of a recording", _fit_colours, add=_add_colours_fit
)
COLOURS_CHECK = Command(
    "colours check",
    "report found, missed and conflicting markers of each hue",
    _check_colours,
    add=_add_colours_check,
)
