"""The commands ``export``, ``info``, ``latency``, ``verify``, ``recover`` and ``compare``."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

from tracker.base.terminal import check_json, finish, printable, progress_line
from tracker.base.urgency import usable_cores
from tracker.base.workers import WorkerRequest, WorkItem, run_all, some_workers
from tracker.session.align import read_alignment
from tracker.session.commands import (
    CompareArguments,
    ExportArguments,
    InfoArguments,
    LatencyArguments,
    RecoverArguments,
    VerifyArguments,
)
from tracker.session.compare import compare
from tracker.session.edits import edit_of
from tracker.session.edits import lines as edit_lines
from tracker.session.export.formats import FORMATS
from tracker.session.export.options import (
    PERSONAL,
    DatasetOptions,
    ExportOptions,
)
from tracker.session.export.run import export, export_dataset, path_of_side
from tracker.session.latency import latencies_of, latency_table
from tracker.session.overview import session_summary, sessions_in
from tracker.session.reader import SessionReader
from tracker.session.recover import recover
from tracker.session.verify import FileFinding, is_ok, verify, verify_one


def run_export(args: ExportArguments) -> int:
    anonymous = () if args.anonymous is None else tuple(args.anonymous or PERSONAL)
    options = ExportOptions(
        rate=args.rate,
        axes=args.axes,
        units=args.units,
        start=args.start,
        stop=args.stop,
        joints=tuple(args.joints.split(",")) if args.joints else (),
        anonymous=anonymous,
        every=args.every,
        views=tuple(dict.fromkeys(args.views.split(","))),
        dataset=DatasetOptions(args.task or _ask_for_task(args), args.split, args.images),
    )
    check_json(args, args.files)
    if FORMATS.get(args.format).dataset is not None or len(args.files) > 1:
        pool = WorkerRequest(args.jobs, args.dask)
        progress = progress_line("exporting")
        report = export_dataset(args.files, args.format, args.output, options, progress, pool)
    else:
        report = export(args.files[0], args.format, args.output, options, force=args.force)
    made = [path_of_side(args.output, side) for side in report.get("hands", ())] or [args.output]
    lines = [*map(str, made), *report.get("said", ())]
    finish(args, report, lines, [*args.files, *made])
    return 0


def _ask_for_task(args: ExportArguments) -> str:
    """Asks the user at the terminal for the description of the task in a data set."""
    if FORMATS.get(args.format).dataset is None or args.split or not sys.stdin.isatty():
        return ""
    return input("Task in these sessions (Enter: use the tasks stored in them): ").strip()


def run_info(args: InfoArguments) -> int:
    check_json(args, [args.file])
    found = session_summary(args.file)
    lines = [f"{args.file}: {found['duration_s']:.2f} s, {found['integrity']}"]
    if found["version"]:
        lines.append(f"engine {found['engine']}, version {found['version']}")
    lines += edit_lines(map(edit_of, found["edits"]))
    lines += [
        f"  {name}  {t['count']}  {t['rate_hz']:g} Hz  {t['type']}"
        for name, t in found["topics"].items()
    ]
    if args.latency:
        found["latency"] = latencies_of(args.file)
        lines += [f"  {line}" for line in latency_table(found["latency"])]
    finish(args, found, lines, [args.file])
    return 0


def run_latency(args: LatencyArguments) -> int:
    check_json(args, [args.file])
    found = latencies_of(args.file)
    finish(args, {"latency": found}, latency_table(found), [args.file])
    return 0


def run_verify(args: VerifyArguments) -> int:
    paths = [path for path, _ in sessions_in(args.files)]
    check_json(args, paths)
    if len(paths) == 1:
        result, lines = _verify_result(paths[0], verify(paths[0]))
    else:
        result, lines = _verify_many(paths)
    finish(args, result, lines, paths)
    return 0 if result["ok"] else 1


def _verify_result(path: Path, findings: list[FileFinding]) -> tuple[dict[str, Any], list[str]]:
    """The result of `verify` as JSON or as text."""
    ok = is_ok(findings)
    lines = [f"{f.severity}: {f.where}: {f.what}" for f in findings]
    lines.append(f"{path} is {'intact' if ok else 'damaged'}.")
    return {"ok": ok, "findings": [f.to_json() for f in findings]}, lines


def _verify_many(paths: list[Path]) -> tuple[dict[str, Any], list[str]]:
    """In parallel, on all cores; a file that is not a session counts as damaged."""
    tasks = [WorkItem(verify_one, (path.absolute(),)) for path in paths]
    with some_workers(min(usable_cores(), len(paths))) as workers:
        outcomes = run_all(tasks, workers, lambda share: None)
    files, lines = {}, []
    for path, outcome in zip(paths, outcomes, strict=True):
        findings = [FileFinding("error", outcome.error, "file")] if outcome.error else outcome.value
        files[str(path)], verdict = _verify_result(path, findings)
        lines += verdict
    return {"ok": all(f["ok"] for f in files.values()), "files": files}, lines


def run_recover(args: RecoverArguments) -> int:
    check_json(args, [args.file])
    saved = recover(args.file, args.output, args.force)
    with SessionReader(saved.path) as reader:
        duration = reader.duration
    lines = [f"byte {d.offset}: {d.what}" for d in saved.damage]
    lines.append(f"Recovered {saved.messages} messages ({duration:.2f} s) to {saved.path}.")
    result = {
        "file": str(saved.path),
        "messages": saved.messages,
        "duration_s": duration,
        "damage": [
            {"offset": d.offset, "what": str(d.what), "code": d.what.code} for d in saved.damage
        ],
        "left_out": saved.left_out,
    }
    finish(args, result, lines, [args.file, saved.path])
    return 0


def _arithmetic_hint(made_on: list[str], identical: bool) -> list[str]:
    """A hint if two files that differ were computed with different arithmetic; else empty."""
    first, second = made_on
    if identical or first == second:
        return []
    unknown = "unknown computer"
    return [
        "computed with different arithmetic, which affects the last bits:",
        f"  {printable(first) or unknown}",
        f"  {printable(second) or unknown}",
    ]


def run_compare(args: CompareArguments) -> int:
    inputs = [args.first, args.second]
    check_json(args, inputs)
    shift = 0.0 if args.align is None else read_alignment(args.align).clocks_differ_s
    found = compare(args.first, args.second, args.figure, args.force, shift)
    lines = [
        f"{side}{each['compared']} instants compared; mean {each['mean_mm']:.3f} mm, "
        f"maximum {each['max_mm']:.3f} mm; angles {each['rms_deg']:.3f}° rms"
        for side, each in (
            ((f"{s} hand: ", h) for s, h in found["hands"].items())
            if "hands" in found
            else [("", found)]
        )
    ]
    lines.append("identical to the last bit" if found["identical"] else "not identical")
    if found["first_difference_s"] is not None:
        lines[-1] += f": first difference {found['first_difference_s']:.3f} s after the start"
    if found["differing"]:
        lines.append(f"differing: {', '.join(found['differing'])}")
    lines += _arithmetic_hint(found["made_on"], found["identical"])
    finish(args, found, lines, inputs)
    return 0
