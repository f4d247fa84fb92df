"""``glovetrack room align``: how a tracker of another system is fixed to the hand."""

from __future__ import annotations

import math

from extensions.room import alignment_file
from extensions.room.alignment import solve
from extensions.room.command import RoomAlignArguments
from extensions.room.movement import recorded_movement
from tracker.base.files import check_target


def run_align(args: RoomAlignArguments) -> None:
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
