"""The command ``opensim-body``."""

from __future__ import annotations

import argparse
from pathlib import Path

from tracker.base.command import Command
from tracker.base.files import whole_files
from tracker.base.terminal import add_json, check_json, finish


def add_opensim_body(command: argparse.ArgumentParser) -> None:
    """Its arguments."""
    command.add_argument("session", type=Path, metavar="SESSION", help="a tracked session")
    command.add_argument(
        "--body", type=Path, required=True, metavar="BODY.osim", help="model of the body, OpenSim 4"
    )
    command.add_argument(
        "-o",
        "--output",
        type=Path,
        required=True,
        metavar="OUT.osim",
        help="the body with the hands; OUT.mot is written next to it",
    )
    command.add_argument(
        "--motion", type=Path, metavar="BODY.mot", help="coordinates of the body over time"
    )
    command.add_argument(
        "--offset",
        type=float,
        default=0.0,
        metavar="S",
        help="time in BODY.mot of the session's first estimate, s (default: 0)",
    )
    for side, usual in (("right", "hand_r"), ("left", "hand_l")):
        command.add_argument(
            f"--{side}",
            default=usual,
            metavar="SEGMENT",
            help=f"body segment of the {side} hand (default: {usual})",
        )
        command.add_argument(
            f"--place-{side}",
            type=float,
            nargs=6,
            metavar=("X", "Y", "Z", "RX", "RY", "RZ"),
            help=f"pose of the {side} dorsum in its segment, m and degrees (body-fixed x, y, z)",
        )
    add_json(command)


def opensim_body(args: argparse.Namespace) -> int:
    """Write the model and the motion."""
    import numpy as np

    from extensions.movement.motion_file import MotionCourse
    from extensions.movement.whole_body import DorsumPlacement, WholeBody, combined
    from tracker.session.export.run import sides_of
    from tracker.session.reader import SessionReader

    inputs = [path for path in (args.session, args.body, args.motion) if path is not None]
    check_json(args, inputs)
    body, hands, placed = WholeBody(args.body), {}, {}
    motion = MotionCourse.read(args.motion) if args.motion is not None else None
    own = body.defaults()
    for each in sides_of(args.session) or ("",):
        with SessionReader(args.session, side=each) as reader:
            side = reader.info.hand.side
            numbers = getattr(args, f"place_{side}")
            at = None if numbers is None else np.array(numbers)
            placed[side] = DorsumPlacement.of(side, getattr(args, side), at)
            hands[side] = body.attach(reader, placed[side])
    table = combined(hands, motion, own, args.offset)
    target = args.output.with_suffix(".mot")
    with whole_files(target, args.output, force=args.force, inputs=inputs) as (mot, osim):
        table.write(mot)
        body.write(osim)
    segments = {side: found.segment for side, found in placed.items()}
    result = {"segments": segments, "rows": len(table.t), "coordinates": table.names}
    lines = [f"{args.output}: {', '.join(f'{s} hand at {n}' for s, n in segments.items())}"]
    finish(args, result, [*lines, f"{target}: {len(table.t)} rows"], [*inputs, args.output, target])
    return 0


OPENSIM_BODY = Command(
    "opensim-body",
    "attach tracked hands to a whole-body OpenSim model",
    opensim_body,
    add=add_opensim_body,
)
