"""Segment, joint and keypoint names of `the conventions`, in their order."""

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
