"""``glovetrack doctor``."""

from __future__ import annotations

import platform
from collections.abc import Sequence
from datetime import UTC, datetime
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

from tracker.base.command import UsageError
from tracker.base.files import check_target, write_whole
from tracker.base.notices import notice
from tracker.base.terminal import check_json, printable, write_json
from tracker.doctor.command import DoctorArguments
from tracker.doctor.finding import CHECKS, Result, Verdict, examine
from tracker.doctor.machine import Machine

PACKAGES = ("numpy", "opencv-python-headless", "pyserial", "numba", "PySide6-Essentials")


def run_doctor(args: DoctorArguments) -> int:
    check_json(args)
    if args.out is not None:
        check_target(args.out, args.force)
    known = CHECKS.all()
    unknown = [name for name in args.only or () if name not in known]
    if unknown:
        raise UsageError(notice("doctor.unknown_check", names=unknown, known=known))
    chosen = [known[name] for name in args.only or known]
    results = []
    for result in examine(Machine(args.folder, fps=args.fps), chosen):
        results.append(result)
        if args.json != "-":
            print(printable(result.finding.line), flush=True)
    is_ok = all(r.finding.verdict != Verdict.ERROR for r in results)
    if args.out is not None:
        write_whole(args.out, report_text(results), args.force)
    if args.json:
        json = {"ok": is_ok, "findings": [r.as_json() for r in results]}
        write_json(json, args.json, args.force)
    return 0 if is_ok else 1


def report_text(results: Sequence[Result]) -> str:
    """The report as text: versions, then a section per check. The home folder is abbreviated."""
    lines = [
        f"Glovetrack doctor, {datetime.now(UTC):%Y-%m-%d %H:%M} UTC",
        f"{platform.platform()}, Python {platform.python_version()}",
        ", ".join(f"{name} {_version(name)}" for name in PACKAGES),
    ]
    title = ""
    for result in results:
        if result.check.title != title:
            title = result.check.title
            lines += ["", title]
        lines.append(result.finding.line)
        figures = ", ".join(f"{k} {v:g}" for k, v in result.finding.values.items())
        lines += [f"         {figures}"] if figures else []
    return "\n".join(lines).replace(str(Path.home()), "~") + "\n"


def _version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return "not installed"
