"""Descriptors of export formats for other programs."""

from __future__ import annotations

from tracker.session.export.formats import COMMON, ExportFormat, Writer

TRAJECTORY = ".joints.csv"
"""Suffix of the table next to a URDF file."""
_WHOLE_HAND = tuple(name for name in COMMON if name != "joints")
_IN_METRES = tuple(name for name in _WHOLE_HAND if name != "units")
_DRAWN = ("rate", "start", "stop", "anonymous", "every", "views")


def _c3d() -> Writer:
    from extensions.interchange.c3d import export_c3d

    return export_c3d


def _bvh() -> Writer:
    from extensions.interchange.bvh import export_bvh

    return export_bvh


def _glb() -> Writer:
    from extensions.interchange.glb import export_glb

    return export_glb


def _urdf() -> Writer:
    from extensions.interchange.urdf import export_urdf

    return export_urdf


def _mp4() -> Writer:
    from extensions.interchange.overlay import export_mp4

    return export_mp4


def _png() -> Writer:
    from extensions.interchange.overlay import export_png

    return export_png


C3D = ExportFormat("c3d", "Motion capture (C3D)", _c3d, order=40)
BVH = ExportFormat("bvh", "Animation skeleton (BVH)", _bvh, options=_WHOLE_HAND, order=90)
GLB = ExportFormat("glb", "Animated hand in 3D (glTF)", _glb, options=_IN_METRES, order=100)
URDF = ExportFormat(
    "urdf",
    "Robot model of the hand (URDF)",
    _urdf,
    options=_IN_METRES,
    beside=(TRAJECTORY,),
    order=110,
)
MP4 = ExportFormat("mp4", "Video with the hand drawn in (MP4)", _mp4, options=_DRAWN, order=120)
PNG = ExportFormat(
    "png",
    "Folder of images with the hand drawn in (PNG)",
    _png,
    options=_DRAWN,
    folder=True,
    order=130,
)
