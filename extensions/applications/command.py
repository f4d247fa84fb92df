"""``glovetrack apps`` and ``vehicles``."""

from __future__ import annotations

import argparse
import json
import math
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tracker.base.command import Command
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.base.terminal import add_json, check_json, finish

if TYPE_CHECKING:
    from collections.abc import Callable

    from extensions.applications.runner import Outcome

MOST_VEHICLES = 5000


def add_apps(parser: argparse.ArgumentParser) -> None:
    """Arguments of ``apps``."""
    parser.add_argument("name", metavar="NAME", help="application name; list prints all of them")
    parser.add_argument(
        "source", type=Path, nargs="?", metavar="SESSION", help="session to use as input"
    )
    parser.add_argument(
        "--hand",
        choices=("left", "right"),
        default="",
        help="hand to use in a session of both (default: right)",
    )
    parser.add_argument(
        "--simulate", type=float, metavar="S", help="use a simulated hand for this long"
    )
    parser.add_argument(
        "--motion",
        default="",
        help="motion of the simulated hand: a recording, or show:NAME for an application",
    )
    parser.add_argument("--seed", type=int, default=0, help="random seed of the simulated wearer")
    parser.add_argument(
        "--on-truth", action="store_true", help="use the simulator's truth instead of tracking it"
    )
    parser.add_argument(
        "--live",
        default="",
        metavar="ADDRESS",
        help="live stream to use as input: udp, udp:PORT or ws://HOST:PORT",
    )
    parser.add_argument(
        "--glove", default="", help="glove name or file, for a simulated or live hand"
    )
    parser.add_argument(
        "--set",
        action="append",
        default=[],
        metavar="KEY=VALUE",
        help="change a setting; VALUE is JSON",
    )
    parser.add_argument(
        "-o", "--out", type=Path, help="new session that includes the application's events"
    )
    parser.add_argument(
        "--page",
        type=int,
        metavar="PORT",
        help="show the application in a browser on this computer, in real time",
    )
    parser.add_argument(
        "--check",
        action="store_true",
        help="run the recorded application again and compare the events",
    )
    add_json(parser)


def run_application(args: argparse.Namespace) -> int:
    """``glovetrack apps``."""
    if args.name == "list":
        from extensions.applications.registry import titles

        print("\n".join(f"{name:<16}{title}" for name, title in titles().items()))
        return 0
    files = [path for path in (args.source, args.out) if path is not None]
    check_json(args, files)
    return _check(args, files) if args.check else _run(args, files)


def _run(args: argparse.Namespace, files: list[Path]) -> int:
    from extensions.applications.session_run import Into, run_into
    from extensions.applications.sinks import network_sinks

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


def _shown(args: argparse.Namespace) -> dict[str, Any]:
    """Settings that go with the motion of a simulated wearer who uses this application."""
    if args.simulate is None:
        return {}
    from tracker.simulation.shows import shown_application

    name, settings = shown_application(args.motion)
    return dict(settings) if name == args.name else {}


def _page(args: argparse.Namespace, stack: ExitStack) -> Callable[[str, Outcome], None]:
    """What shows each sample on a page, where one was asked for."""
    if args.page is None:
        return lambda title, outcome: None
    try:
        from extensions.applications.page import PacedPage
    except ImportError as error:
        raise ConfigError(notice("option.packages", option="--page", extra="streams")) from error
    page = PacedPage(args.page, paced=not args.live)
    stack.callback(page.close)
    print(f"The page is at {page.url}", flush=True)
    return page.look


def _check(args: argparse.Namespace, files: list[Path]) -> int:
    from extensions.applications.session_run import replay

    if args.source is None:
        raise ConfigError(notice("option.requires", option="--check", needed="SESSION"))
    reports = [r for r in replay(args.source) if args.name in (r.application, "all")]
    lines = [line for report in reports for line in report.lines()]
    same = not any(report.differs for report in reports)
    lines.append("The events match the session." if same else "The events differ.")
    finish(args, {"runs": [r.to_json() for r in reports], "same": same}, lines, files)
    return 0 if same else 1


def _source(args: argparse.Namespace, stack: ExitStack) -> Any:
    from extensions.applications.sources import recorded, simulated, streamed
    from tracker.offline.simulate import SimulateOptions

    asked = [args.source is not None, args.simulate is not None, bool(args.live)]
    if sum(asked) != 1:
        raise ConfigError(notice("option.exactly_one", options=("SESSION", "--simulate", "--live")))
    if args.source is not None:
        return stack.enter_context(recorded(args.source, args.hand))
    if args.live:
        return streamed(args.live, args.glove)
    options = SimulateOptions(
        glove=args.glove,
        motion=args.motion,
        seed=args.seed,
        duration=args.simulate,
        images=False,
    )
    return simulated(options, args.on_truth)


def simulate_vehicles(args: argparse.Namespace) -> int:
    """``glovetrack vehicles``."""
    from extensions.applications.swarm.simulated_vehicles import VehicleSimulator

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


def add_vehicles(vehicles: argparse.ArgumentParser) -> None:
    """Arguments of ``vehicles``."""
    vehicles.add_argument(
        "--count", type=int, default=200, metavar="N", help="number of vehicles (default: 200)"
    )
    vehicles.add_argument(
        "--port",
        type=int,
        default=14550,
        help="UDP port of the first 250 vehicles; each further 250 use the next port",
    )
    vehicles.add_argument(
        "--seconds",
        type=float,
        default=math.inf,
        help="stop after this time (default: run until interrupted)",
    )


APPS = Command(
    "apps",
    "run an application that the hand controls: touch, swarm, arm, place",
    run_application,
    add=add_apps,
)


VEHICLES = Command(
    "vehicles",
    "simulate vehicles that receive MAVLink over UDP",
    simulate_vehicles,
    add=add_vehicles,
)
