"""``glovetrack apps`` and ``vehicles``."""

from __future__ import annotations

import json
from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from extensions.applications.command import AppsArguments, VehiclesArguments
from extensions.applications.registry import titles
from extensions.applications.runner import BEGINS, ENDS, KIND, SETTING, ApplicationRunner, Outcome
from extensions.applications.sinks import network_sinks
from extensions.applications.sources import HandSource, recorded, simulated, streamed
from extensions.applications.stage import CommandSink
from extensions.applications.swarm.simulated_vehicles import VehicleSimulator
from tracker.base.clock import monotonic
from tracker.base.errors import ConfigError, FileError
from tracker.base.files import check_target
from tracker.base.notices import notice
from tracker.base.terminal import check_json, finish
from tracker.messages import Estimate, Event
from tracker.offline.simulate import SimulateOptions
from tracker.session.images import PackedFrame
from tracker.session.writer import SessionRecorder, new_session
from tracker.simulation.shows import shown_application

MOST_VEHICLES = 5000


def run_application(args: AppsArguments) -> int:
    """``glovetrack apps``."""
    if args.name == "list":
        print("\n".join(f"{name:<16}{title}" for name, title in titles().items()))
        return 0
    files = [path for path in (args.source, args.out) if path is not None]
    check_json(args, files)
    return _check(args, files) if args.check else _run(args, files)


def _run(args: AppsArguments, files: list[Path]) -> int:
    settings = _shown(args) | dict(_setting(text) for text in args.set)
    with ExitStack() as stack:
        source = _source(args, stack)
        inputs = [args.source] if args.source is not None else []
        sinks = network_sinks()
        for sink in sinks:
            stack.callback(sink.close)
        into = Into(args.out, inputs, args.force)
        look = _page(args, stack)
        report = run_into(args.name, source, into, settings, sinks, look)
    finish(args, report.to_json(), report.lines(), files)
    return 0


def _shown(args: AppsArguments) -> dict[str, Any]:
    """Settings that go with the motion of a simulated wearer who uses this application."""
    if args.simulate is None:
        return {}
    name, settings = shown_application(args.motion)
    return dict(settings) if name == args.name else {}


def _page(args: AppsArguments, stack: ExitStack) -> Callable[[str, Outcome], None]:
    """What shows each sample on a page, where one was asked for."""
    if args.page is None:
        return lambda title, outcome: None
    try:
        from extensions.applications.page import PacedPage  # deferred: needs an extra
    except ImportError as error:
        raise ConfigError(notice("option.packages", option="--page", extra="streams")) from error
    page = PacedPage(args.page, paced=not args.live)
    stack.callback(page.close)
    print(f"The page is at {page.url}", flush=True)
    return page.look


def _check(args: AppsArguments, files: list[Path]) -> int:
    if args.source is None:
        raise ConfigError(notice("option.requires", option="--check", needed="SESSION"))
    reports = [r for r in replay(args.source) if args.name in (r.application, "all")]
    lines = [line for report in reports for line in report.lines()]
    same = not any(report.differs for report in reports)
    lines.append("The events match the session." if same else "The events differ.")
    finish(args, {"runs": [r.to_json() for r in reports], "same": same}, lines, files)
    return 0 if same else 1


def _source(args: AppsArguments, stack: ExitStack) -> Any:
    asked = [args.source is not None, args.simulate is not None, bool(args.live)]
    if sum(asked) != 1:
        raise ConfigError(notice("option.exactly_one", options=("SESSION", "--simulate", "--live")))
    if args.source is not None:
        return stack.enter_context(recorded(args.source, args.hand))
    if args.simulate is None:
        return streamed(args.live, args.glove)
    options = SimulateOptions(
        glove=args.glove,
        motion=args.motion,
        seed=args.seed,
        duration=args.simulate,
        images=False,
    )
    return simulated(options, args.on_truth)


def simulate_vehicles(args: VehiclesArguments) -> int:
    """``glovetrack vehicles``."""
    if not 1 <= args.count <= MOST_VEHICLES:
        raise ConfigError(notice("option.range", option="--count", low=1, high=MOST_VEHICLES))
    simulator = VehicleSimulator(args.count, args.port)
    print(f"{args.count} vehicles listen for MAVLink on 127.0.0.1:{simulator.port}.", flush=True)
    simulator.wait(args.seconds)
    simulator.close()
    print(f"{simulator.fleet.requested} of them received a target position.")
    return 0


def _setting(text: str) -> tuple[str, Any]:
    key, equals, value = text.partition("=")
    if not equals:
        raise ConfigError(notice("applications.setting", text=text))
    try:
        return key, json.loads(value)
    except ValueError:
        return key, value  # a text


# ---- runs an application without a window; its events are printed, recorded or compared


@dataclass
class ApplicationReport:
    """Result of a run. ``took`` (s) per sample; ``differs``: the first event that differs from the
    session, empty if all are equal or none was compared."""

    application: str
    samples: int = 0
    primitives: int = 0  # of the last drawing
    commands: int = 0
    events: list[Event] = field(default_factory=list)
    took: list[float] = field(default_factory=list)
    differs: str = ""

    def to_json(self) -> dict[str, Any]:
        ms = 1e3 * np.array(self.took or [0.0])
        return {
            "application": self.application,
            "samples": self.samples,
            "commands": self.commands,
            "primitives": self.primitives,
            "events": dict(Counter(str(e.data["what"]) for e in self.events)),
            "step_ms": {"median": float(np.median(ms)), "p99": float(np.percentile(ms, 99))},
            "differs": self.differs,
        }

    def lines(self) -> list[str]:
        data = self.to_json()
        counts = ", ".join(f"{n} {k}" for k, n in data["events"].items()) or "none"
        step = data["step_ms"]
        out = [
            f"{self.application}: {self.samples} samples, {self.commands} commands",
            f"events: {counts}",
            f"a step takes {step['median']:.2f} ms (median), {step['p99']:.2f} ms (99 %)",
        ]
        return [*out, self.differs] if self.differs else out


def run(
    name: str,
    source: HandSource,
    settings: Mapping[str, Any] | None = None,
    sinks: Sequence[CommandSink] = (),
    recorder: SessionRecorder | None = None,
    look: Callable[[str, Outcome], None] = lambda title, outcome: None,
) -> ApplicationReport:
    """Feed the application with the complete source; ``look`` receives its title and the result of
    each sample. Raises ConfigError, FileError."""
    runner = ApplicationRunner(name, source.info.hand, source.info.glove, settings)
    report, last = ApplicationReport(name), 0.0
    for message in source.messages:
        if isinstance(message, Event) and message.kind == KIND:
            continue  # of an earlier run
        if recorder is not None:
            if isinstance(message, PackedFrame):
                recorder.write_packed(message)
            else:
                recorder.write(message)
        if isinstance(message, Estimate):
            last = message.t
            for event in _feed(runner, message, report, sinks, look):
                if recorder is not None:
                    recorder.write(event)
    if report.samples and recorder is not None:
        recorder.write(runner.ended(last))
    return report


def _feed(
    runner: ApplicationRunner,
    estimate: Estimate,
    report: ApplicationReport,
    sinks: Sequence[CommandSink] = (),
    look: Callable[[str, Outcome], None] = lambda title, outcome: None,
) -> list[Event]:
    events: list[Event] = []
    before = monotonic()
    for outcome in runner.feed(estimate):
        now = monotonic()
        report.took.append(now - before)
        for sink in sinks:
            sink.take(outcome.commands, outcome.t)
        report.samples += 1
        report.commands += len(outcome.commands)
        report.primitives = len(outcome.drawing)
        events += outcome.events
        look(runner.application.title, outcome)
        before = monotonic()
    report.events += events
    return events


@dataclass(frozen=True)
class Into:
    """Output of a run: a new session (None: none) made from ``inputs``; ``force`` overwrites."""

    out: Path | None = None
    inputs: Sequence[Path] = ()
    force: bool = False


def run_into(
    name: str,
    source: HandSource,
    into: Into,
    settings: Mapping[str, Any] | None = None,
    sinks: Sequence[CommandSink] = (),
    look: Callable[[str, Outcome], None] = lambda title, outcome: None,
) -> ApplicationReport:
    """`run` into a new session, which is written completely or not at all."""
    with ExitStack() as stack:
        recorder = None
        if into.out is not None:
            check_target(into.out, into.force, into.inputs)
            new = new_session(into.out, source.info, into.force, into.inputs)
            recorder = stack.enter_context(new)
        return run(name, source, settings, sinks, recorder, look)


def replay(path: Path) -> list[ApplicationReport]:
    """Run all applications of a session again with their settings and changes of these.

    Raises FileError if the session contains none.
    """
    with recorded(path) as source:
        recorded_events = [m for m in source.messages if isinstance(m, Event) and m.kind == KIND]
    runs = []
    for side in dict.fromkeys(str(e.data["hand"]) for e in recorded_events):
        events = [e for e in recorded_events if e.data["hand"] == side]
        begun = [i for i, e in enumerate(events) if e.data["what"] == BEGINS]
        runs += [events[i:j] for i, j in zip(begun, [*begun[1:], len(events)], strict=True)]
    if not runs:
        raise FileError(notice("applications.none_recorded", path=path))
    return [_again(path, run) for run in runs]


def _again(path: Path, events: Sequence[Event]) -> ApplicationReport:
    """Repeat the run that starts with the first of ``events``."""
    first, name = events[0], str(events[0].data["application"])
    settings: Any = first.data["settings"]
    changes = [e for e in events if e.data["what"] == SETTING]
    wanted = [e for e in events if e.data["what"] != ENDS and e.data["application"] == name]
    report = ApplicationReport(name)
    with recorded(path, str(first.data["hand"])) as source:
        runner = ApplicationRunner(name, source.info.hand, source.info.glove, settings)
        for message in source.messages:
            if not isinstance(message, Estimate) or message.t < first.t:
                continue
            while changes and changes[0].t <= message.t:
                change = changes.pop(0)
                runner.set(str(change.data["key"]), change.data["value"])
            _feed(runner, message, report)
            if message.t >= wanted[-1].t and len(report.events) >= len(wanted):
                break
    report.differs = difference(wanted, report.events[: len(wanted)])
    return report


def difference(wanted: Sequence[Event], found: Sequence[Event]) -> str:
    """Description of the first event that differs from ``wanted``; empty if all are equal."""
    for i, event in enumerate(wanted):
        if i >= len(found) or (found[i].t, found[i].data) != (event.t, event.data):
            again = found[i].data if i < len(found) else "nothing"
            return f"At {event.t:.3f} s the session holds {event.data}, and now it is {again}."
    return ""
