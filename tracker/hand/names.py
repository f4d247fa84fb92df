"""Segment, joint and keypoint names of `the conventions`, in their order."""

from __future__ import annotations

import itertools
from collections.abc import Sequence

SIDES = ("left", "right")
"""Sides of hands and gloves, in the order in which both hands are listed."""

MARKED_KEYPOINTS = ("thumb_tip", "index_tip", "middle_tip", "dorsum")
"""Joints measured by the markers of the glove, for which accuracy is stated (Lee et al. 2021)."""

FINGERS = ("index", "middle", "ring", "little")

SEGMENTS = (
    "dorsum",
    "thumb_metacarpal",
    "thumb_proximal",
    "thumb_distal",
    *(f"{f}_{part}" for f in FINGERS for part in ("proximal", "intermediate", "distal")),
)

CHAINS = {
    "thumb": ("thumb_metacarpal", "thumb_proximal", "thumb_distal"),
    **{f: (f"{f}_proximal", f"{f}_intermediate", f"{f}_distal") for f in FINGERS},
}

STIFF = {"thumb_proximal": ("abduction",)}
"""Free axes that hardly rotate, by the joint's child; default for hand files."""

FIST = dict.fromkeys(CHAINS["thumb"], 0.4) | {
    segment: 0.9 for finger in FINGERS for segment in CHAINS[finger]
}
"""Flexion in a fist as a share of the joint's upper limit, by its child; default for hand files."""

LENGTH_ALONG = ("dorsum", *CHAINS["middle"])
"""Segments along which the hand's length is measured, if present; default for hand files."""

# keypoint -> (segment it belongs to, whether it is that segment's tip)
KEYPOINTS: dict[str, tuple[str, bool]] = {
    "wrist": ("dorsum", False),
    "thumb_cmc": ("thumb_metacarpal", False),
    "thumb_mcp": ("thumb_proximal", False),
    "thumb_ip": ("thumb_distal", False),
    "thumb_tip": ("thumb_distal", True),
}
for _f in FINGERS:
    KEYPOINTS[f"{_f}_mcp"] = (f"{_f}_proximal", False)
    KEYPOINTS[f"{_f}_pip"] = (f"{_f}_intermediate", False)
    KEYPOINTS[f"{_f}_dip"] = (f"{_f}_distal", False)
    KEYPOINTS[f"{_f}_tip"] = (f"{_f}_distal", True)

AXES = ("abduction", "flexion", "twist")


def bones(keypoints: Sequence[str]) -> list[tuple[int, int]]:
    """Rows of ``keypoints`` connected by a bone: from the wrist along each finger to its tip.

    A missing keypoint is skipped, so its neighbours are connected.
    """
    row = {name: i for i, name in enumerate(keypoints)}
    out: list[tuple[int, int]] = []
    for finger in CHAINS:
        chain = [n for n in KEYPOINTS if n == "wrist" or n.startswith(f"{finger}_")]
        out += itertools.pairwise(row[n] for n in chain if n in row)
    return out
