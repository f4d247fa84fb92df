"""``glovetrack apps`` and ``vehicles``."""

from __future__ import annotations

import math
from dataclasses import field
from pathlib import Path
from typing import TYPE_CHECKING

from tracker.base.arguments import argument, options
from tracker.base.command import Command
from tracker.base.terminal import force_option, json_option

if TYPE_CHECKING:
    pass
from tracker.base.registry import deferred


@options
class AppsArguments:
    """Arguments of ``glovetrack apps``."""

    name: str = field(
        metadata=argument("application name; list prints all of them", metavar="NAME")
    )
    source: Path | None = field(
        default=None, metadata=argument("session to use as input", "SESSION")
    )
    hand: str = field(
        default="",
        metadata=argument(
            "hand to use in a session of both (default: right)", choices=("left", "right")
        ),
    )
    simulate: float | None = field(
        default=None, metadata=argument("use a simulated hand for this long", metavar="S")
    )
    motion: str = field(
        default="",
        metadata=argument(
            "motion of the simulated hand: a recording, or show:NAME for an application"
        ),
    )
    seed: int = field(default=0, metadata=argument("random seed of the simulated wearer"))
    on_truth: bool = field(
        default=False, metadata=argument("use the simulator's truth instead of tracking it")
    )
    live: str = field(
        default="",
        metadata=argument(
            "live stream to use as input: udp, udp:PORT or ws://HOST:PORT", metavar="ADDRESS"
        ),
    )
    glove: str = field(
        default="", metadata=argument("glove name or file, for a simulated or live hand")
    )
    set: tuple[str, ...] = field(
        default=(),
        metadata=argument("change a setting; VALUE is JSON", action="append", metavar="KEY=VALUE"),
    )
    out: Path | None = field(
        default=None,
        metadata=argument("new session that includes the application's events", "-o", "--out"),
    )
    page: int | None = field(
        default=None,
        metadata=argument(
            "show the application in a browser on this computer, in real time", metavar="PORT"
        ),
    )
    check: bool = field(
        default=False,
        metadata=argument("run the recorded application again and compare the events"),
    )
    json: str | None = json_option()
    force: bool = force_option()


APPS = Command(
    "apps",
    "run an application that the hand controls: touch, swarm, arm, place",
    deferred("extensions.applications.command_runs:run_application"),
    options=AppsArguments,
)


@options
class VehiclesArguments:
    """Arguments of ``glovetrack vehicles``."""

    count: int = field(
        default=200, metadata=argument("number of vehicles (default: 200)", metavar="N")
    )
    port: int = field(
        default=14550,
        metadata=argument("UDP port of the first 250 vehicles; each further 250 use the next port"),
    )
    seconds: float = field(
        default=math.inf, metadata=argument("stop after this time (default: run until interrupted)")
    )


VEHICLES = Command(
    "vehicles",
    "simulate vehicles that receive MAVLink over UDP",
    deferred("extensions.applications.command_runs:simulate_vehicles"),
    options=VehiclesArguments,
)
