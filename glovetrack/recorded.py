"""The hands, the sensor data and the events of a recorded session."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from glovetrack.hands import Hand, ImuSamples, OnlyHand
from glovetrack.session_file import SessionFile, Window
from tracker.base.clock import NS
from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.messages import EYES, Event, StereoFrame
from tracker.session.export.series import EstimateSeries, recorded_series, series_of
from tracker.session.notes import latest_versions
from tracker.session.reader import SessionReader


@dataclass(frozen=True)
class RecordedEvent:
    """Something that happened at ``t`` (s since the recording began). ``kind`` is ``note``,
    ``device``, ``tracking``, ``recording``, ``error``, ``pulse`` or ``gesture``.

    ``text`` is for people: the user's own for a note, English otherwise. Programs should compare
    ``code`` (such as ``camera.silent``), whose ``values`` are the parts of the text; both are empty
    for notes and in recordings before version 0.2."""

    t: float
    kind: str
    text: str
    data: Mapping[str, object] = field(default_factory=dict)
    code: str = ""
    values: Mapping[str, object] = field(default_factory=dict)

    @staticmethod
    def of(event: Event, t: float) -> RecordedEvent:
        """An event of the engine, at ``t`` s."""
        values = event.notice.values if event.notice is not None else {}
        data, shown = (MappingProxyType(dict(part)) for part in (event.data, values))
        return RecordedEvent(t, event.kind, event.text, data, event.code, shown)


@dataclass(frozen=True, eq=False)
class Image:
    """An image at ``t`` (s since the recording began): ``rgb`` (height, width, 3) uint8."""

    t: float
    rgb: NDArray[np.uint8]

    def __repr__(self) -> str:
        height, width = self.rgb.shape[:2]
        return f"<Image {width} x {height}, t = {self.t:.3f} s>"


class RecordedData(OnlyHand):
    """What a session file contains, or the part of it in ``window`` (s)."""

    def __init__(self, path: Path, window: Window | None, zero_ns: int | None = None) -> None:
        self.path = path
        self._file = SessionFile(path, window, zero_ns)

    @property
    def sides(self) -> tuple[str, ...]:
        """``("left", "right")``, or the one hand that was recorded."""
        return self._file.sides

    @cached_property
    def hands(self) -> Mapping[str, Hand]:
        """Each recorded hand by its side. Raises FileError if there are no estimates."""
        return MappingProxyType(
            {
                side: self._hand_of(side, recorded_series(self._file.of_side(side), segments=False))
                for side in self.sides
            }
        )

    @cached_property
    def truth(self) -> Mapping[str, Hand]:
        """The true motion of each hand of a simulated session; empty otherwise."""
        found = {}
        for side in self.sides:
            reader = self._file.of_side(side)
            true = sorted(reader.truth(), key=lambda m: m.t)
            if true:
                found[side] = self._hand_of(side, series_of(reader.info, true))
        return MappingProxyType(found)

    @property
    def hand(self) -> Hand:
        """The only hand. Raises ConfigError for a recording of both, whose hands are in `hands`."""
        if len(self.sides) != 1:
            raise ConfigError(notice("api.both_recorded", file=self.path.name))
        return self.hands[self.sides[0]]

    # ---- sensors and events

    def imu(self, name: str, side: str = "") -> ImuSamples:
        """Samples of one IMU. ``side`` is needed for a recording of both hands.

        Raises KeyError for an unknown name, FileError where nothing was recorded.
        """
        raw = self._file.raw_imu[self._file.side(side)]
        if name not in raw.names:
            raise KeyError(f"no IMU {name!r}; available: {', '.join(raw.names)}")
        i = raw.names.index(name)
        t = (raw.stamp_ns - self._file.zero_ns) / NS
        rows = self._file.rows(t)
        return ImuSamples(name, t[rows], raw.accel[rows, i], raw.gyro[rows, i], raw.valid[rows, i])

    def imu_names(self, side: str = "") -> tuple[str, ...]:
        """The IMUs of the glove."""
        return self._file.of_side(self._file.side(side)).info.glove.imu_names

    @cached_property
    def events(self) -> tuple[RecordedEvent, ...]:
        """Notes in their last wording, and what happened to devices and tracking."""
        found = [m for m in self._file.reader.messages([Event]) if isinstance(m, Event)]
        out = (RecordedEvent.of(e, self._file.seconds(e.t)) for e in latest_versions(found))
        return tuple(e for e in out if self._file.has(e.t))

    def images(self, camera: str = "left") -> Iterator[Image]:
        """Yields the images of the ``left`` or ``right`` camera, decoded one at a time.

        Raises ConfigError for another camera. Yields nothing for a recording without images.
        """
        if camera not in EYES:
            raise ConfigError(
                notice("option.choice", option="camera", known=("left", "right"), value=camera)
            )
        with SessionReader(self.path) as reader:
            for m in reader.messages([StereoFrame], *self._file.arrivals()):
                assert isinstance(m, StereoFrame)
                image = m.left if camera == "left" else m.right
                t = self._file.seconds(m.t)
                if image is not None and self._file.has(t):
                    yield Image(t, np.ascontiguousarray(image[..., ::-1]))

    def _hand_of(self, side: str, series: EstimateSeries) -> Hand:
        hand = Hand(side, series, self._file.zero_ns)
        return hand if self._file.window is None else hand.between(*self._file.window)
