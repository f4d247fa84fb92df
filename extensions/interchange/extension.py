"""Descriptors of export formats for other programs."""

from __future__ import annotations

from tracker.base.registry import deferred
from tracker.session.export.formats import COMMON, ExportFormat

TRAJECTORY = ".joints.csv"
"""Suffix of the table next to a URDF file."""
_WHOLE_HAND = tuple(name for name in COMMON if name != "joints")
_IN_METRES = tuple(name for name in _WHOLE_HAND if name != "units")
_DRAWN = ("rate", "start", "stop", "anonymous", "every", "views")


C3D = ExportFormat(
    "c3d", "Motion capture (C3D)", deferred("extensions.interchange.c3d:export_c3d").load, order=40
)
BVH = ExportFormat(
    "bvh",
    "Animation skeleton (BVH)",
    deferred("extensions.interchange.bvh:export_bvh").load,
    options=_WHOLE_HAND,
    order=90,
)
GLB = ExportFormat(
    "glb",
    "Animated hand in 3D (glTF)",
    deferred("extensions.interchange.glb:export_glb").load,
    options=_IN_METRES,
    order=100,
)
URDF = ExportFormat(
    "urdf",
    "Robot model of the hand (URDF)",
    deferred("extensions.interchange.urdf:export_urdf").load,
    options=_IN_METRES,
    beside=(TRAJECTORY,),
    order=110,
)
MP4 = ExportFormat(
    "mp4",
    "Video with the hand drawn in (MP4)",
    deferred("extensions.interchange.overlay:export_mp4").load,
    options=_DRAWN,
    order=120,
)
PNG = ExportFormat(
    "png",
    "Folder of images with the hand drawn in (PNG)",
    deferred("extensions.interchange.overlay:export_png").load,
    options=_DRAWN,
    folder=True,
    order=130,
)
