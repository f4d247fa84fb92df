"""The commands ``import-reference`` and ``accuracy``."""

from __future__ import annotations

from extensions.reference.accuracy import headline
from extensions.reference.command import AccuracyArguments, ImportReferenceArguments
from extensions.reference.importing import ReferenceImportOptions, import_reference
from extensions.reference.numbers import as_json
from extensions.reference.remarks import remarks
from extensions.reference.report import write_report
from tracker.base.terminal import check_json, finish
from tracker.session.overview import sessions_in


def import_reference_command(args: ImportReferenceArguments) -> int:
    """Write the session with its reference, and report alignment and registration."""
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


def accuracy_command(args: AccuracyArguments) -> int:
    """Write the page, and print the line that can be quoted."""
    paths = [path for path, _ in sessions_in(args.sessions)]
    check_json(args, paths)
    measured = write_report(
        paths, args.output, not args.without_offsets, args.anonymous, args.force
    )
    finish(args, as_json(measured), [headline(measured)], [*paths, args.output])
    return 0
