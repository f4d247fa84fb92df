"""Names that the command line offers, apart from the code behind them, which is slow to import."""

FORMATS = ("csv", "parquet", "h5", "c3d", "trc", "mot", "bvh", "glb", "urdf", "mp4")
AXES_NAMES = ("z-up", "y-up", "opensim")
UNIT_NAMES = ("m", "cm", "mm")
PERSONAL = ("participant", "notes")
"""Metadata that an export can leave out."""
