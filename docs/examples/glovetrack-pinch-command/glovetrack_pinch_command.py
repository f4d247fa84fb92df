"""``glovetrack pinches SESSION``: count how often the thumb and a finger pinch in a recording."""

from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

from glovetrack.commands import Command, UsageError, argument


@dataclass(frozen=True)
class PinchOptions:
    session: Path = field(metadata=argument("recording with estimates", metavar="SESSION"))
    finger: Literal["index", "middle", "ring", "little"] = field(
        default="index", metadata=argument("finger that meets the thumb (default: index)")
    )
    closer_mm: float = field(
        default=25.0,
        metadata=argument("distance of the fingertips in a pinch (default: 25)", metavar="MM"),
    )


def count_pinches(options: PinchOptions) -> None:
    """Print the number of pinches and their total duration."""
    if options.closer_mm <= 0:
        raise UsageError("--closer-mm must be greater than 0.")
    import numpy as np  # here, so that `glovetrack --help` stays fast

    import glovetrack

    rec = glovetrack.open(options.session)
    tips = rec.keypoints["thumb_tip"], rec.keypoints[f"{options.finger}_tip"]  # (N, 3) m
    pinched = np.linalg.norm(tips[0] - tips[1], axis=1) < options.closer_mm / 1000
    count = int(np.sum(pinched[1:] & ~pinched[:-1]))
    seconds = float(np.sum(np.diff(rec.t)[pinched[1:]]))
    print(f"{options.session.name}: {count} pinches, {seconds:.1f} s in total")


PINCHES = Command(
    "pinches", "count pinches of the thumb and a finger", count_pinches, options=PinchOptions
)
