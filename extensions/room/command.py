"""``glovetrack room align``: how a tracker of another system is fixed to the hand."""

from __future__ import annotations

import argparse
from pathlib import Path

from tracker.base.command import Command
from tracker.base.registry import deferred
from tracker.base.terminal import add_force
from tracker.hand.names import SIDES


def _add(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("session", type=Path, help="recording of the movement")
    parser.add_argument("-o", "--out", type=Path, required=True, help="the alignment file")
    parser.add_argument("--side", choices=SIDES, default="", help="hand, in a recording of both")
    parser.add_argument(
        "--start", type=float, default=0.0, metavar="S", help="beginning of the movement, s"
    )
    parser.add_argument(
        "--end", type=float, default=float("inf"), metavar="S", help="end of the movement, s"
    )
    add_force(parser)


ROOM = Command[argparse.Namespace](
    "room", "align trackers of other systems (OptiTrack, SteamVR, VMC) with the hands"
)


ALIGN = Command[argparse.Namespace](
    "room align",
    "find how a tracker is fixed to the hand, from a recorded movement",
    deferred("extensions.room.command_runs:run_align"),
    add=_add,
    description="The wearer turns the hand in all directions for 15 s while its wrist rests on a "
    "point. The recording must contain the glove and the tracker. An existing file is extended by "
    "the other hand; --force replaces it.",
)
