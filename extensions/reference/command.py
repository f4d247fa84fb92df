"""The commands ``import-reference`` and ``accuracy``."""

from __future__ import annotations

import argparse
from pathlib import Path

from tracker.base.command import Command
from tracker.base.terminal import add_json, check_json, finish
from tracker.hand.names import SIDES


def add_import(command: argparse.ArgumentParser) -> None:
    """Arguments of ``import-reference``."""
    command.add_argument(
        "reference", type=Path, metavar="REFERENCE", help="C3D, TRC, TSV, CSV or BVH file"
    )
    command.add_argument("session", type=Path, metavar="SESSION", help="the tracked session")
    command.add_argument(
        "-o", "--output", type=Path, required=True, metavar="OUT.mcap", help="the new session"
    )
    command.add_argument(
        "--mapping", type=Path, metavar="TOML", help="names of points, columns of a CSV, unit"
    )
    command.add_argument(
        "--by",
        choices=("movement", "clock", "pulse"),
        default="movement",
        help="how to align the times",
    )
    command.add_argument(
        "--pulse", default="", metavar="NAME", help="name of the reference's events or channel"
    )
    command.add_argument(
        "--start", default="", metavar="TIME", help="clock time of the reference's start (ISO 8601)"
    )
    command.add_argument(
        "--no-drift", action="store_true", help="assume that both clocks have the same rate"
    )
    command.add_argument(
        "--register",
        choices=("offsets", "rigid", "none"),
        default="offsets",
        help="estimate the laboratory's frame and marker offsets, the frame alone, or nothing",
    )
    command.add_argument("--hand", choices=SIDES, default="", help="hand in a session of both")
    add_json(command)


def import_reference_command(args: argparse.Namespace) -> int:
    """Write the session with its reference, and report alignment and registration."""
    from extensions.reference.importing import ReferenceImportOptions, import_reference
    from extensions.reference.remarks import remarks

    files = [args.reference, args.session]
    check_json(args, files)
    options = ReferenceImportOptions(
        args.mapping,
        args.by,
        args.pulse,
        args.start,
        args.hand,
        not args.no_drift,
        args.register,
    )
    about = import_reference(args.reference, args.session, args.output, options, args.force)
    timing = about.timing
    lines = [f"{about.file}: {about.kind}, {len(about.keypoints)} keypoints, {about.rate:g} Hz."]
    line = f"Time: starts at {timing.offset:+.4f} s of the session, by {timing.by}"
    if timing.parts:
        line += f"; residual {1e3 * timing.residual:.2f} ms of {timing.parts} parts"
    if timing.drift_sd == timing.drift_sd:
        line += f"; drift {1e6 * timing.drift:+.1f} ± {1e6 * timing.drift_sd:.1f} ppm"
    lines.append(f"{line}.")
    lines.append(
        f"Registration: residual {1e3 * about.rigid.residual:.2f} mm rigid, "
        f"{1e3 * about.with_offsets.residual:.2f} mm with marker offsets."
    )
    lines += [str(remark) for remark in remarks(about, options.with_drift)]
    finish(args, about.as_json(), lines, [*files, args.output])
    return 0


def add_accuracy(command: argparse.ArgumentParser) -> None:
    """Arguments of ``accuracy``."""
    command.add_argument(
        "sessions",
        type=Path,
        nargs="+",
        metavar="SESSION",
        help="sessions with a reference, or folders of them",
    )
    command.add_argument(
        "-o", "--output", type=Path, required=True, metavar="REPORT.html", help="the HTML page"
    )
    command.add_argument(
        "--without-offsets", action="store_true", help="do not correct the markers' positions"
    )
    command.add_argument(
        "--anonymous", action="store_true", help="omit the names of recordings and participants"
    )
    add_json(command)


def accuracy_command(args: argparse.Namespace) -> int:
    """Write the page, and print the line that can be quoted."""
    from extensions.reference.accuracy import headline
    from extensions.reference.numbers import as_json
    from extensions.reference.report import write_report
    from tracker.session.overview import sessions_in

    paths = [path for path, _ in sessions_in(args.sessions)]
    check_json(args, paths)
    measured = write_report(
        paths, args.output, not args.without_offsets, args.anonymous, args.force
    )
    finish(args, as_json(measured), [headline(measured)], [*paths, args.output])
    return 0


IMPORT = Command(
    "import-reference",
    "add a motion-capture recording to a session as a reference",
    import_reference_command,
    add=add_import,
)


ACCURACY = Command(
    "accuracy",
    "report the accuracy of sessions against their references",
    accuracy_command,
    add=add_accuracy,
)
