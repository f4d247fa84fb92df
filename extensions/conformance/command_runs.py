"""The command ``conformance``."""

from __future__ import annotations

from pathlib import Path

from extensions.conformance.command import ConformanceArguments
from extensions.conformance.isaac.writer import write_records
from extensions.conformance.page import as_json, page
from extensions.conformance.run import TakeVerdict, judge, read_take, simulated_takes
from extensions.conformance.take import labels_path, take_of, write_labels
from tracker.base.errors import ConfigError
from tracker.base.files import check_target, make_folder, whole_files, write_with_folder
from tracker.base.notices import notice
from tracker.base.terminal import check_json, finish, progress_line

SIMULATED = "simulated"  # name of a simulated wearer's page in a folder


def check_conformance(args: ConformanceArguments) -> int:
    """Run the check; returns exit status 1 if a rule failed."""
    if args.simulate == (args.file is not None):
        raise ConfigError(notice("option.exactly_one", options=("SESSION", "--simulate")))
    sides = {"": (), "both": ("left", "right")}.get(args.hands, (args.hands,))
    inputs = [args.file] if args.file else []
    check_json(args, inputs)
    out = _page_path(args.output, args.file)
    for path in _outputs(out, args.simulate):
        check_target(path, args.force, inputs)
    if args.file is None:
        verdict = _simulated(args, sides or ("left", "right"), out)
    else:
        verdict = judge(args.file.name, *read_take(args.file, sides))
    if out is not None:
        write_with_folder(out, page(verdict), args.force)
    finish(args, as_json(verdict), _lines(verdict), [*inputs, *_outputs(out, args.simulate)])
    return 0 if verdict.ok else 1


def _page_path(output: Path | None, file: Path | None) -> Path | None:
    """``output``, or if that is a folder or has no suffix, a page in it with the session's name."""
    if output is None or (output.suffix and not output.is_dir()):
        return output
    return output / f"{file.stem if file is not None else SIMULATED}.html"


def _outputs(out: Path | None, simulated: bool) -> list[Path]:
    """The page and, for a simulated wearer, the record and its labels next to it."""
    if out is None:
        return []
    take = out.with_suffix(".mcap")
    return [out, labels_path(take), take] if simulated else [out]


def _simulated(args: ConformanceArguments, sides: tuple[str, ...], out: Path | None) -> TakeVerdict:
    """The verdict; record and labels are written next to the page ``out``, if any."""
    records, steps = simulated_takes(sides, args.seed, args.glove, progress_line("tracking"))
    takes = [take_of(side, found) for side, found in records.items()]
    if out is None:
        return judge(f"a simulated wearer, seed {args.seed}", takes, steps)
    _, *others = _outputs(out, True)
    make_folder(out.parent)
    with whole_files(*others, force=args.force) as (labels, record):
        write_records(record, records)
        write_labels(labels, record.name, steps, min(int(t.sample[0]) for t in takes))
    return judge(record.name, takes, steps)


def _lines(verdict: TakeVerdict) -> list[str]:
    lines = []
    for f in verdict.findings:
        if f.status != "pass":
            lines.append(f"{f.status}: {f.layer}, {f.side}: {f.rule}: {f.figure} ({f.limit})")
    passed = sum(f.status == "pass" for f in verdict.findings)
    return [*lines, f"{passed} of {len(verdict.findings)} rules passed."]
