"""``glovetrack room align``: how a tracker of another system is fixed to the hand."""

from __future__ import annotations

import argparse
from dataclasses import field
from pathlib import Path

from tracker.base.arguments import argument, options
from tracker.base.command import Command
from tracker.base.registry import deferred
from tracker.base.terminal import force_option
from tracker.hand.names import SIDES

ROOM = Command[argparse.Namespace](
    "room", "align trackers of other systems (OptiTrack, SteamVR, VMC) with the hands"
)


@options
class RoomAlignArguments:
    """Arguments of ``glovetrack room align``."""

    session: Path = field(metadata=argument("recording of the movement"))
    out: Path = field(metadata=argument("the alignment file", "-o", "--out"))
    side: str = field(default="", metadata=argument("hand, in a recording of both", choices=SIDES))
    start: float = field(
        default=0.0, metadata=argument("beginning of the movement, s", metavar="S")
    )
    end: float = field(
        default=float("inf"), metadata=argument("end of the movement, s", metavar="S")
    )
    force: bool = force_option()


ALIGN = Command(
    "room align",
    "find how a tracker is fixed to the hand, from a recorded movement",
    deferred("extensions.room.command_runs:run_align"),
    options=RoomAlignArguments,
    description="The wearer turns the hand in all directions for 15 s while its wrist rests on a "
    "point. The recording must contain the glove and the tracker. An existing file is extended by "
    "the other hand; --force replaces it.",
)
