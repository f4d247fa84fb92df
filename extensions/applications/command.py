"""``glovetrack apps`` and ``vehicles``."""

from __future__ import annotations

import argparse
import math
from pathlib import Path
from typing import TYPE_CHECKING

from tracker.base.command import Command
from tracker.base.terminal import add_json

if TYPE_CHECKING:
    pass
from tracker.base.registry import deferred


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
    deferred("extensions.applications.command_runs:run_application"),
    add=add_apps,
)


VEHICLES = Command(
    "vehicles",
    "simulate vehicles that receive MAVLink over UDP",
    deferred("extensions.applications.command_runs:simulate_vehicles"),
    add=add_vehicles,
)
