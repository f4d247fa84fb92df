"""What is exported and how, as it is remembered and kept under a name."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from typing import Any

from app.words import mark
from tracker.session.export.options import (
    AXES_NAMES,
    DATASETS,
    FORMATS,
    PERSONAL,
    RATES,
    UNITS,
    DatasetOptions,
    ExportOptions,
)

WORDS = {
    "csv": mark("Table for spreadsheets and everything else (CSV)"),
    "parquet": mark("Table for Python and R (Parquet)"),
    "h5": mark("Arrays for MATLAB and Python (HDF5)"),
    "c3d": mark("Motion capture (C3D)"),
    "trc": mark("OpenSim markers (TRC)"),
    "mot": mark("OpenSim joint angles (MOT)"),
    "sto": mark("OpenSim orientations of the IMUs (STO)"),
    "osim": mark("OpenSim model of the hand as tracked (OSIM)"),
    "bvh": mark("Animation skeleton (BVH)"),
    "glb": mark("Animated hand in 3D (glTF)"),
    "urdf": mark("Robot model of the hand (URDF)"),
    "mp4": mark("Film with the hand drawn in (MP4)"),
    "png": mark("Folder of images with the hand drawn in (PNG)"),
    "mcap": mark("Session, whole or the chosen part (MCAP)"),
    "bids": mark("Data set for laboratories (Motion-BIDS, a folder)"),
    "imu.csv": mark("Raw samples of the IMUs (CSV)"),
    "imu.parquet": mark("Raw samples of the IMUs (Parquet)"),
    "isaac": mark("Hand record of NVIDIA's Isaac tools (MCAP)"),
    "lerobot": mark("Data set for robot learning (LeRobot, a folder)"),
}
"""What each format is for, by its name on the command line."""


@dataclass(frozen=True)
class ExportChoice:
    """``rate`` Hz, 0 as recorded; ``axes`` and ``units`` empty: as usual for the format; ``task``
    and ``split`` of data sets: see `DatasetOptions`."""

    formats: tuple[str, ...] = ("csv",)
    rate: float = 0.0
    axes: str = ""
    units: str = ""
    anonymous: bool = False
    task: str = ""
    split: bool = False

    @property
    def is_dataset(self) -> bool:
        """Whether one of the formats holds many sessions."""
        return any(form in DATASETS for form in self.formats)

    def options_of(self, form: str) -> ExportOptions:
        """Axes and units are of no concern to formats that have their own."""
        if form in DATASETS:
            return replace(self.options, axes=None, units=None)
        return self.options

    @property
    def options(self) -> ExportOptions:
        return ExportOptions(
            rate=self.rate or None,
            axes=self.axes or None,
            units=self.units or None,
            anonymous=PERSONAL if self.anonymous else (),
            dataset=DatasetOptions(self.task.strip(), self.split),
        )

    def as_dict(self) -> dict[str, Any]:
        """For the settings."""
        return {**asdict(self), "formats": list(self.formats)}


def choice_from(data: object) -> ExportChoice:
    """Of the settings; what another version or a hand has written there keeps its default."""
    found = data if isinstance(data, Mapping) else {}
    usual = ExportChoice()
    names = found.get("formats")
    known = [n for n in FORMATS if isinstance(names, list) and n in names]
    rate = found.get("rate")
    low, high = RATES
    return ExportChoice(
        formats=tuple(known) or usual.formats,
        rate=float(rate) if isinstance(rate, int | float) and low <= rate <= high else usual.rate,
        axes=_of(found.get("axes"), AXES_NAMES),
        units=_of(found.get("units"), tuple(UNITS)),
        anonymous=found.get("anonymous") is True,
        task=task if isinstance(task := found.get("task"), str) else "",
        split=found.get("split") is True,
    )


def _of(value: object, known: tuple[str, ...]) -> str:
    return value if isinstance(value, str) and value in known else ""
