"""``glovetrack apps`` and ``vehicles``."""

from __future__ import annotations

import json
from collections.abc import Callable
from contextlib import ExitStack
from pathlib import Path
from typing import Any

from extensions.applications.command import AppsArguments, VehiclesArguments
from extensions.applications.registry import titles
from extensions.applications.runner import Outcome
from extensions.applications.session_run import Into, replay, run_into
from extensions.applications.sinks import network_sinks
from extensions.applications.sources import recorded, simulated, streamed
from extensions.applications.swarm.simulated_vehicles import VehicleSimulator
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.base.terminal import check_json, finish
from tracker.offline.simulate import SimulateOptions
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
    print(f"{simulator.fleet.asked} of them received a target position.")
    return 0


def _setting(text: str) -> tuple[str, Any]:
    key, equals, value = text.partition("=")
    if not equals:
        raise ConfigError(notice("applications.setting", text=text))
    try:
        return key, json.loads(value)
    except ValueError:
        return key, value  # a text
