"""Names that the command line offers, apart from the code behind them, which is slow to import."""

FORMATS = (
    *("csv", "parquet", "h5", "c3d", "trc", "mot", "sto", "bvh", "glb", "urdf"),
    *("mp4", "png", "mcap"),
)
WHOLE_HAND = ("bvh", "glb", "urdf")
"""Formats of a skeleton, which cannot leave out joints."""
FOLDERS = ("png",)
"""Formats of many files."""
AXES_NAMES = ("z-up", "y-up", "ros", "opengl", "opensim", "blender", "unity", "unreal")
UNIT_NAMES = ("m", "cm", "mm")
PERSONAL = ("participant", "notes")
"""Metadata that an anonymous export leaves out."""
HIDEABLE = (*PERSONAL, "hand", "time")
"""What it can leave out if asked by name: the hand's name and when it was, too."""
