"""Export options, as stored in the settings and in presets."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any

from tracker.session.export.formats import FORMATS, formats
from tracker.session.export.options import (
    AXES_NAMES,
    PERSONAL,
    RATES,
    UNITS,
    DatasetOptions,
    ExportOptions,
)


@dataclass(frozen=True)
class ExportChoice:
    """``rate`` Hz, 0 as recorded; ``axes`` and ``units`` empty: default of the format; ``task`` and
    ``split`` of data sets: see `DatasetOptions`."""

    formats: tuple[str, ...] = ("csv",)
    rate: float = 0.0
    axes: str = ""
    units: str = ""
    anonymous: bool = False
    task: str = ""
    split: bool = False

    @property
    def is_dataset(self) -> bool:
        """Whether one of the formats contains many sessions."""
        return any(FORMATS.get(form).dataset is not None for form in self.formats)

    def options_of(self, form: str) -> ExportOptions:
        """The options for one of the formats; see `ExportFormat.without_unused`."""
        return FORMATS.get(form).without_unused(self.options)

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
        """As stored in the settings."""
        return {**asdict(self), "formats": list(self.formats)}


def choice_from(data: object) -> ExportChoice:
    """The options from the settings; invalid or unknown entries are replaced by defaults."""
    found = data if isinstance(data, Mapping) else {}
    usual = ExportChoice()
    names = found.get("formats")
    listed = names if isinstance(names, list) else []
    known = [kind.name for kind in formats() if kind.name in listed]
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
