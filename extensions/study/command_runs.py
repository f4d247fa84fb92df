"""``glovetrack study``: check, run, status, report, tables and export."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Iterator
from dataclasses import asdict, replace
from pathlib import Path

from extensions.study.command import (
    StudyCheckArguments,
    StudyExportArguments,
    StudyReportArguments,
    StudyRunArguments,
    StudyStatusArguments,
    StudyTablesArguments,
)
from extensions.study.conductor import Conductor, TrialPhase
from extensions.study.folder import Study, open_study, start_study
from extensions.study.overview import (
    lines_of_protocol,
    lines_of_status,
    protocol_as_json,
    status_as_json,
)
from extensions.study.progress import Progress, locked
from extensions.study.protocol import Protocol, load_protocol
from extensions.study.report import write_movement
from extensions.study.results import write_report
from extensions.study.schedule import ScheduleStep
from extensions.study.simulated import SimulatedStation
from extensions.study.verdict import TrialVerdict, judge
from tracker.base.command import UsageError
from tracker.base.errors import ConfigError
from tracker.base.files import check_folder_target, check_target, write_whole
from tracker.base.notices import failure, notice
from tracker.base.numeric_threads import one_numeric_thread
from tracker.base.terminal import (
    check_json,
    finish,
    printable,
    progress_line,
    stopped_by_signals,
)
from tracker.session.export.options import ExportOptions


def run_check(args: StudyCheckArguments) -> None:
    path = protocol_path(args.protocol)
    check_json(args, [path])
    protocol, _ = load_protocol(path)
    finish(args, protocol_as_json(protocol), lines_of_protocol(protocol), [path])


def run_study(args: StudyRunArguments) -> int:
    if args.headless and not args.simulated:
        raise UsageError(notice("option.requires", option="--headless", needed="--simulated"))
    path = protocol_path(args.protocol)
    protocol, _ = load_protocol(path)
    study = start_study(path, args.folder or Path(protocol.name))
    if args.participant:
        study.progress(args.participant)  # raises for an unknown one
    if not args.headless:
        from extensions.study.window.start import open_study_window  # deferred: Qt

        return open_study_window(study, args.participant, args.simulated)
    return _run_headless(study, protocol, args.participant)


def _run_headless(study: Study, protocol: Protocol, participant: str) -> int:
    chosen = (participant,) if participant else protocol.participants
    with one_numeric_thread(), stopped_by_signals():
        for label in chosen:
            run_headless(study.progress(label), lambda line: print(printable(line), flush=True))
    return 0


def run_status(args: StudyStatusArguments) -> None:
    check_json(args)
    study = open_study(args.source)
    finish(args, status_as_json(study), lines_of_status(study))


def run_tables(args: StudyTablesArguments) -> None:
    with _other_extension("evaluation"):
        from extensions.study import retrack, tables  # deferred: need another extension

    study = open_study(args.source)
    out = args.output or args.source / "tables.csv"
    check_json(args)
    check_target(out, args.force or args.output is None)
    names = tuple(n.strip() for n in args.variants.split(",") if n.strip())
    names = names or (tuple(retrack.variants()) if args.ablations else (retrack.RECORDED,))
    evaluated = tables.evaluate(
        study, retrack.chosen(names), args.processes, progress_line("tracking")
    )
    rows = tables.rows_of(evaluated)
    write_whole(out, tables.as_csv(rows), force=args.force or args.output is None)
    lines = [*tables.lines_of(rows), f"{out}: {len(rows)} rows"]
    finish(args, {"rows": [asdict(row) for row in rows]}, lines, [out])


def run_report(args: StudyReportArguments) -> None:
    study = open_study(args.source)
    folder = args.output or args.source / "report"
    if args.output is not None:
        check_folder_target(folder, args.force)
    print(write_report(study, folder))
    if args.movement:
        write_movement(study, folder / "movement.html")
        print(folder / "movement.html")


def run_export(args: StudyExportArguments) -> None:
    with _other_extension("movement"):
        from extensions.study.export import export_study  # deferred: needs another

    check_json(args)
    study = open_study(args.source)
    options = ExportOptions(anonymous=("time", "notes") if args.anonymous else ())
    count = export_study(study, args.output, options, args.force, progress_line("exporting"))
    result = {"recordings": count, "folder": str(args.output)}
    finish(args, result, [f"{args.output}: {count} recordings"], [args.output])


@contextlib.contextmanager
def _other_extension(name: str) -> Iterator[None]:
    """Imports of another extension, whose folder may have been removed."""
    try:
        yield
    except ModuleNotFoundError as error:
        raise ConfigError(failure("study.needs_extension", name=name)) from error


FOLDER = Path(__file__).parent / "protocols"


def names() -> list[str]:
    """Names of the examples."""
    return sorted(path.stem for path in FOLDER.glob("*.toml"))


def protocol_path(given: str) -> Path:
    """The path of a protocol file, or of an example by its name."""
    path = Path(given)
    if path.suffix or path.exists() or given not in names():
        return path
    return FOLDER / f"{given}.toml"


# ---- runs a study's trials with simulated participants, without a screen

TICK = 0.1  # s of simulated time
Say = Callable[[str], None]


def run_headless(progress: Progress, say: Say = lambda line: None) -> None:
    """Run the remaining steps of one participant.

    A trial without a good verdict is repeated, up to the protocol's number of tries. Rests are
    skipped. ``say`` gets a line for each event. Raises FileError if another program runs the
    participant.
    """
    with locked(progress):
        for step in progress.resume():
            say(f"{step.name}: was interrupted; it is repeated")
        Run(progress, say).run()


class Run:
    """The loop around a `Conductor`."""

    def __init__(self, progress: Progress, say: Say) -> None:
        self._progress, self._report_line = progress, say
        self._protocol: Protocol = progress.protocol
        self._station = SimulatedStation(self._protocol)
        self._conductor = Conductor(progress, self._station)
        self._t = 0.0

    def run(self) -> None:
        """Until the last step is over."""
        conductor = self._conductor
        while (step := conductor.step) is not None:
            match conductor.phase:
                case TrialPhase.READY:
                    self._get_ready(step)
                case TrialPhase.COUNTDOWN | TrialPhase.RUNNING:
                    self._move(step)
                case TrialPhase.CHECKING:
                    self._check(step)
                case TrialPhase.VERDICT:
                    self._decide(step)
                case _:
                    conductor.go_on(self._t)

    def _get_ready(self, step: ScheduleStep) -> None:
        self._station.prepare(step, self._conductor.progress.tries)
        self._t = 0.0
        self._conductor.go_on(self._t)

    def _move(self, step: ScheduleStep) -> None:
        self._t = round(self._t + TICK, 6)
        self._station.advance(self._t)
        conductor = self._conductor
        running = conductor.phase is TrialPhase.RUNNING and step.duration == 0
        if running and conductor.elapsed >= self._station.finishes_after(step):
            conductor.go_on(self._t)
        else:
            conductor.tick(self._t)

    def _check(self, step: ScheduleStep) -> None:
        self._conductor.recorded()
        path, limits = self._progress.path(step), self._protocol.limits
        if self._protocol.tasks[step.task].kind == "touch":  # simulated: estimates alone
            limits = replace(limits, packet_rate=0.0, image_rate=0.0, images_missed=1.0)
        self._conductor.judged(judge(path, step, limits))

    def _decide(self, step: ScheduleStep) -> None:
        conductor, verdict = self._conductor, self._conductor.verdict
        assert verdict is not None
        if verdict.is_good:
            self._report_line(f"{step.name}: accepted ({summary(verdict)})")
            conductor.go_on(self._t)
        elif conductor.progress.tries < self._protocol.tries:
            self._report_line(f"{step.name}: repeated. {_why(verdict)}")
            conductor.repeat(self._t)
        else:
            self._report_line(f"{step.name}: failed. {_why(verdict)}")
            conductor.give_up()


def summary(verdict: TrialVerdict) -> str:
    """Figures of a recording in a few words."""
    m = verdict.measured
    return (
        f"{m.duration:.1f} s, tracked {100 * m.tracked:.0f} %, measured {100 * m.measured:.0f} %, "
        f"{m.packets_lost} packets lost"
    )


def _why(verdict: TrialVerdict) -> str:
    return " ".join(str(finding) for finding in verdict.findings)
