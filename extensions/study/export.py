"""The data set of a study: accepted trials as Motion-BIDS, one session per condition."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

from extensions.movement.bids import Entities, Scan, add_recording, write_scans, write_top
from extensions.study.folder import Study
from tracker.base.files import check_folder_target, make_folder
from tracker.session.export.options import ExportOptions
from tracker.session.reader import SessionReader


def export_study(
    study: Study,
    out: Path,
    options: ExportOptions | None = None,
    force: bool = False,
    progress: Callable[[float], None] = lambda share: None,
) -> int:
    """Write the data set to the new folder ``out``; returns the number of recordings.

    Conditions are ``ses-``, tasks ``task-``, trials ``run-``; of a session of both hands the right
    one is exported. The protocol and all verdicts are in ``code``. Raises ConfigError without
    accepted trials, FileError for a folder that is not empty.
    """
    check_folder_target(out, force)
    accepted, options = study.accepted(), options or ExportOptions()
    make_folder(out)
    scans: dict[tuple[str, str], list[Scan]] = {}
    sides: dict[str, str] = {}
    for k, one in enumerate(accepted):
        progress(k / len(accepted))
        step, task = one.step, study.protocol.tasks[one.step.task]
        entities = Entities(step.participant, step.condition, step.task, step.run, task.instruction)
        with SessionReader(one.path) as reader:
            side = "right" if "right" in reader.sides else ""
        with SessionReader(one.path, side=side) as reader:
            found = add_recording(reader, out, entities, options)
            sides[step.participant] = reader.info.side
        scans.setdefault((step.participant, step.condition), []).extend(found)
    for (participant, condition), rows in scans.items():
        write_scans(out, Entities(participant, condition), rows)
    write_top(out, sides, study.protocol.title, _conditions(study))
    _write_protocol(study, out)
    return len(accepted)


def _conditions(study: Study) -> str:
    """A paragraph of the README."""
    titles = [f"`ses-{c.name}`: {c.title}" for c in study.protocol.conditions.values()]
    return "Sessions are the conditions of the study: " + "; ".join(titles) + "."


def _write_protocol(study: Study, out: Path) -> None:
    """The protocol with which the data were recorded, and the seed of its order."""
    code = out / "code"
    make_folder(code)
    stored = (study.folder / "protocol" / "protocol.toml").read_text("utf-8")
    (code / "protocol.toml").write_text(stored, "utf-8")
    verdicts = {
        progress.participant: {
            step.name: progress.entry(step).tries[-1].verdict
            for step in progress.trials
            if progress.entry(step).tries
        }
        for progress in study.all_progress()
    }
    (code / "verdicts.json").write_text(json.dumps(verdicts, indent=1) + "\n", "utf-8")
