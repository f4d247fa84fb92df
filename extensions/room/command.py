"""``glovetrack room align``: how a tracker of another system is fixed to the hand.

Functions import what they need, so that ``glovetrack --help`` is fast.
"""

from __future__ import annotations

import argparse
import math
from pathlib import Path

from tracker.base.command import Command
from tracker.base.files import check_target
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


def _align(args: argparse.Namespace) -> None:
    from extensions.room import alignment_file
    from extensions.room.alignment import solve
    from extensions.room.movement import recorded_movement

    add = args.out.exists() and not args.force
    known = alignment_file.read(args.out) if add else {}
    check_target(args.out, force=True, inputs=[args.session])
    side, moved = recorded_movement(args.session, args.side, args.start, args.end)
    if side in known:
        check_target(args.out, force=False, inputs=[args.session])
    found = solve(moved)
    alignment_file.write(args.out, {**known, side: found}, force=True)
    x, y, z = 1e3 * found.p_BT
    heading = math.degrees(-found.yaw)
    print(f"{side} hand: tracker at {x:.1f}, {y:.1f}, {z:.1f} mm from the wrist")
    print(f"rotations agree within {math.degrees(found.rotation_rms):.1f}° (rms)")
    print(f"wrist at rest within {1e3 * found.position_rms:.1f} mm (rms)")
    print(f"delay of the poses {1e3 * found.delay:.0f} ms, heading in the room {heading:.0f}°")
    print(f"{args.out}: to be used as --remote room?alignment={args.out}")


ROOM = Command[argparse.Namespace](
    "room", "align trackers of other systems (OptiTrack, SteamVR, VMC) with the hands"
)
ALIGN = Command[argparse.Namespace](
    "room align",
    "find how a tracker is fixed to the hand, from a recorded movement",
    _align,
    add=_add,
    description="The wearer turns the hand in all directions for 15 s while its wrist rests on a "
    "point. The recording must contain the glove and the tracker. An existing file is extended by "
    "the other hand; --force replaces it.",
)
