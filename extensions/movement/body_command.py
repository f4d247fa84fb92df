"""The command ``opensim-body``."""

from __future__ import annotations

import numpy as np

from extensions.movement.commands import OpensimBodyArguments
from extensions.movement.motion_file import MotionCourse
from extensions.movement.whole_body import DorsumPlacement, WholeBody, combined
from tracker.base.files import whole_files
from tracker.base.terminal import check_json, finish
from tracker.session.export.run import sides_of
from tracker.session.reader import SessionReader


def opensim_body(args: OpensimBodyArguments) -> int:
    """Write the model and the motion."""
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
