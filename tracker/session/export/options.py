"""Options of exports: axes, units, and the rest. Quick to import."""

from __future__ import annotations

from dataclasses import dataclass

from tracker.base.errors import ConfigError
from tracker.base.notices import notice

IMAGES = ENCODED, VIDEO, NONE = ("encoded", "video", "none")
"""For a data set: as recorded, as films by the system's ffmpeg, or left out."""
VIEWS = ("left", "right", "3d", "curves")
"""What films and drawn images show: the cameras, the hand in 3D, flexions over time."""
AXES_NAMES = ("z-up", "y-up", "ros", "opengl", "opensim", "blender", "unity", "unreal")
OPENXR = "openxr"
"""Instead of names of joints: OpenXR's 26, in OpenXR's world unless axes are given."""
UNITS = {"m": 1.0, "cm": 100.0, "mm": 1000.0}
"""How many of each make a metre."""
BONE_AXES = "x along the bone to its tip, z out of the back of the hand"
"""Axes that the orientation of a keypoint turns: of the bone that begins there."""
OPENXR_AXES = "-z along the bone to its tip, y out of the back of the hand"
RATES = (1.0, 2000.0)
"""Lowest and highest rate to resample to, Hz."""
PERSONAL = ("participant", "notes")
"""Metadata that an anonymous export leaves out."""
HIDEABLE = (*PERSONAL, "hand", "time")
"""What it can leave out if asked by name: the hand's name and when it was, too."""


@dataclass(frozen=True)
class DatasetOptions:
    """``task``: a description; by default the note that an episode begins with, or the session's
    notes. ``split``: an episode from each note to the next instead of one per session. ``images``:
    one of `IMAGES`. Raises ConfigError for another.
    """

    task: str = ""
    split: bool = False
    images: str = ENCODED

    def __post_init__(self) -> None:
        if self.images not in IMAGES:
            raise ConfigError(notice("export.images", known=IMAGES, value=self.images))


@dataclass(frozen=True)
class ExportOptions:
    """None: as in the session or the format. Raises ConfigError for invalid values.

    ``rate`` Hz; ``start``, ``stop`` s from the first estimate; ``joints`` keypoints and angles to
    export, or ("openxr",); ``anonymous`` fields to omit, of `HIDEABLE`; ``every`` n-th image is
    drawn, as ``views`` side by side; ``dataset`` for formats of many sessions.
    """

    rate: float | None = None
    axes: str | None = None
    units: str | None = None
    start: float | None = None
    stop: float | None = None
    joints: tuple[str, ...] = ()
    anonymous: tuple[str, ...] = ()
    every: int = 1
    views: tuple[str, ...] = VIEWS[:1]
    dataset: DatasetOptions = DatasetOptions()

    def __post_init__(self) -> None:
        low, high = RATES
        if self.rate is not None and not low <= self.rate <= high:
            raise ConfigError(notice("export.rate", rate_hz=self.rate, least_hz=low, most_hz=high))
        if self.every < 1:
            raise ConfigError(notice("export.every", every=self.every))
        if not self.views or not set(self.views) <= set(VIEWS):
            raise ConfigError(notice("export.views", known=VIEWS, value=", ".join(self.views)))
        if self.axes is not None and self.axes not in AXES_NAMES:
            raise ConfigError(notice("export.axes", known=AXES_NAMES, value=self.axes))
        if OPENXR in self.joints and len(self.joints) > 1:
            raise ConfigError(notice("export.joints"))
        if self.units is not None and self.units not in UNITS:
            raise ConfigError(notice("export.units", known=UNITS, value=self.units))
