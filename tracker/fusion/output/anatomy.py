"""How fingers bend that have neither sensors nor a synergy in the hand file: like their neighbours.

The spread about it is that of `INFERRED_DEG` (tracker/fusion/output/output.py).
"""

from __future__ import annotations

from tracker.hand.model import HandModel, Synergy
from tracker.hand.names import FINGERS

NEIGHBOURS = (
    ("ring", "middle"),
    ("little", "ring"),
    ("middle", "index"),
    ("index", "middle"),
    ("middle", "ring"),
    ("ring", "little"),
)
"""A finger and one that it follows, the closest couplings first."""
UNLOADED = 0.67
"""DIP relative to PIP flexion of a finger that touches nothing (Rijpkema & Girard 1991)."""


def anatomical_synergies(hand: HandModel) -> tuple[Synergy, ...]:
    """Couplings of the angles that none of the file's synergies infers, in order of preference."""
    inferred = {s.angle for s in hand.synergies}
    pairs = [
        (f"{finger}_{joint}_flexion", f"{other}_{joint}_flexion", 1.0)
        for finger, other in NEIGHBOURS
        for joint in ("mcp", "pip")
    ]
    pairs += [(f"{f}_dip_flexion", f"{f}_pip_flexion", UNLOADED) for f in FINGERS]
    return tuple(
        Synergy(angle, of, ratio, 0.0)
        for angle, of, ratio in pairs
        if angle not in inferred and angle in hand.angle_index and of in hand.angle_index
    )
