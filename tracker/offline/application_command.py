"""``glovetrack apps``."""

from __future__ import annotations

import argparse
import json
import math
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tracker.errors import ConfigError
from tracker.terminal import add_json, check_json, finish

if TYPE_CHECKING:
    from collections.abc import Callable

    from tracker.applications.runner import Outcome

MOST_VEHICLES = 5000


def add_apps(parser: argparse.ArgumentParser) -> None:
    """Arguments of the command."""
    parser.add_argument("name", metavar="NAME", help="of an application; list shows all")
    parser.add_argument("source", type=Path, nargs="?", metavar="SESSION", help="its hand is used")
    parser.add_argument(
        "--hand", choices=("left", "right"), default="", help="of a session of both; else the right"
    )
    parser.add_argument("--simulate", type=float, metavar="S", help="a simulated hand for so long")
    parser.add_argument(
        "--motion", default="", help="of the simulated hand: a recording, or show:NAME"
    )
    parser.add_argument("--seed", type=int, default=0, help="of the simulated wearer")
    parser.add_argument("--on-truth", action="store_true", help="as if that hand were known")
    parser.add_argument(
        "--live", default="", metavar="ADDRESS", help="a stream: udp, udp:PORT or ws://HOST:PORT"
    )
    parser.add_argument("--glove", default="", help="name or file, of a simulated or live hand")
    parser.add_argument(
        "--set",
        action="append",
        default=[],
        metavar="KEY=VALUE",
        help="a setting; VALUE is JSON",
    )
    parser.add_argument("-o", "--out", type=Path, help="a new session with the events in it")
    parser.add_argument(
        "--page", type=int, metavar="PORT", help="show it in browsers of this machine, as it passes"
    )
    parser.add_argument(
        "--check", action="store_true", help="run again what SESSION holds, and compare"
    )
    add_json(parser)
    parser.set_defaults(func=_apps)


def _apps(args: argparse.Namespace) -> int:
    if args.name == "list":
        from tracker.applications.registry import titles

        print("\n".join(f"{name:<16}{title}" for name, title in titles().items()))
        return 0
    files = [path for path in (args.source, args.out) if path is not None]
    check_json(args, files)
    return _check(args, files) if args.check else _run(args, files)


def _run(args: argparse.Namespace, files: list[Path]) -> int:
    from tracker.applications.sinks import network_sinks
    from tracker.offline.applications import Into, run_into

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
        from tracker.offline.application_page import PacedPage
    except ImportError as error:
        raise ConfigError('The page needs: pip install "glovetrack[streams]".') from error
    page = PacedPage(args.page, paced=not args.live)
    stack.callback(page.close)
    print(f"The page is at {page.url}", flush=True)
    return page.look


def _check(args: argparse.Namespace, files: list[Path]) -> int:
    from tracker.offline.applications import replay

    if args.source is None:
        raise ConfigError("Tell the session that holds the application.")
    reports = [r for r in replay(args.source) if args.name in (r.application, "all")]
    lines = [line for report in reports for line in report.lines()]
    same = not any(report.differs for report in reports)
    lines.append("The events are those of the session." if same else "The events differ.")
    finish(args, {"runs": [r.to_json() for r in reports], "same": same}, lines, files)
    return 0 if same else 1


def _source(args: argparse.Namespace, stack: ExitStack) -> Any:
    from tracker.offline.application_sources import recorded, simulated, streamed
    from tracker.offline.simulate import SimulateOptions

    asked = [args.source is not None, args.simulate is not None, bool(args.live)]
    if sum(asked) != 1:
        raise ConfigError("Tell one of SESSION, --simulate and --live: where the hand comes from.")
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


def _vehicles(args: argparse.Namespace) -> int:
    from tracker.simulation.vehicles import VehicleSimulator

    if not 1 <= args.count <= MOST_VEHICLES:
        raise ConfigError(f"There can be 1 to {MOST_VEHICLES} vehicles, not {args.count}.")
    simulator = VehicleSimulator(args.count, args.port)
    print(f"{args.count} vehicles wait at 127.0.0.1:{simulator.port} for MAVLink.", flush=True)
    simulator.wait(args.seconds)
    simulator.close()
    print(f"{simulator.fleet.asked} of them were told where to be.")
    return 0


def _setting(text: str) -> tuple[str, Any]:
    key, equals, value = text.partition("=")
    if not equals:
        raise ConfigError(f"A setting is KEY=VALUE, not {text!r}.")
    try:
        return key, json.loads(value)
    except ValueError:
        return key, value  # a text


def add_commands(commands: Any) -> None:
    """Add ``apps`` to the sub-parsers of ``glovetrack``."""
    parser = commands.add_parser("apps", help="what a hand can do: touch, swarm, arm, place")
    add_apps(parser)
    vehicles = commands.add_parser("vehicles", help="simulated vehicles that take MAVLink by UDP")
    vehicles.add_argument("--count", type=int, default=200, metavar="N")
    vehicles.add_argument("--port", type=int, default=14550, help="of the first 250; then the next")
    vehicles.add_argument("--seconds", type=float, default=math.inf, help="then it ends")
    vehicles.set_defaults(func=_vehicles)
