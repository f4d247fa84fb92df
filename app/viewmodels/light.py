"""The light meter: one line, recommendations, and missed markers."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from app.viewmodels.states import GOOD, IDLE, WARN, StateLook
from app.widgets.image_shapes import Ring
from app.words import local, mark, notice_text, tr
from tracker.calibration.light_meter import LightMeter, LightReading
from tracker.vision.colours import ColourProfile

Image = NDArray[np.uint8]
EVERY = 1.0  # s of images between two measurements
KEPT = 10.0  # s for which a measurement is valid while no hand is visible
MISSED_COLOUR = "#FF4FD8"
SHORT = {
    "clipped": mark("too bright"),
    "dark": mark("too dark"),
    "noisy": mark("noisy"),
    "warm": mark("too warm"),
    "cold": mark("too cold"),
    "near": mark("hues too similar"),
    "room": mark("colours in background"),
    "missed": mark("markers missed"),
}


class LightWatch:
    """The newest measurement of the displayed images, and when to repeat it."""

    def __init__(self) -> None:
        self.reading: LightReading | None = None
        self._meter: LightMeter | None = None
        self._image: Image | None = None
        self._profile: ColourProfile | None = None
        self._requested_at = self._read_at = -np.inf
        self._read: Image | None = None  # the measured image

    def work(
        self, image: Image | None, profile: ColourProfile, fx: float, t: float | None
    ) -> Callable[[], tuple[LightMeter, LightReading]] | None:
        """A measurement for a background thread; None if it is not due.

        ``t`` (s) is the exposure time of a live image, None for a stored or frozen one.
        """
        early = image is self._image or (t is not None and 0 <= t - self._requested_at < EVERY)
        if image is None or (early and profile == self._profile):
            return None
        self._image, self._profile, self._requested_at = image, profile, -np.inf if t is None else t
        known = self._meter
        if known is not None and known.profile != profile:
            known = None

        def read() -> tuple[LightMeter, LightReading]:
            ready = known or LightMeter(profile, fx)
            return ready, ready.read(image)

        return read

    def took(self, answer: tuple[LightMeter, LightReading]) -> None:
        """Use the result of `work`. Live images without a hand are ignored."""
        self._meter, reading = answer
        has_hand = all(a.kind != "hand" for a in reading.advice)
        is_kept = not np.isfinite(self._requested_at)
        if has_hand or is_kept or self.reading is None or self._requested_at - self._read_at > KEPT:
            self.reading, self._read_at, self._read = reading, self._requested_at, self._image

    def is_of(self, image: Image | None) -> bool:
        """Whether the measurement belongs to this image."""
        return image is not None and image is self._read

    # ---- displayed data

    @property
    def look(self) -> StateLook:
        if self.reading is None or self._without_hand:
            return IDLE
        return WARN if self.reading.advice else GOOD

    @property
    def _without_hand(self) -> bool:
        return self.reading is not None and any(a.kind == "hand" for a in self.reading.advice)

    def line(self) -> str:
        """The state of the light in a few words."""
        if self.reading is None or self._without_hand:
            return "–"
        problems = [tr(SHORT[a.kind]) for a in self.reading.advice if a.kind in SHORT]
        return ", ".join(problems) or tr("good")

    def sentences(self) -> list[str]:
        """Recommendations with measured values."""
        r = self.reading
        if r is None:
            return [tr("No image has been measured yet.")]
        words = [notice_text(a.notice) for a in r.advice] or [
            tr("Nothing to change: the markers are clearly visible.")
        ]
        figures = [tr("noise {:.1f} levels").format(local(r.noise))]
        if len(r.uv):
            found = int(r.found.sum())
            figures = [
                tr("{} of {} markers found").format(found, len(r.uv)),
                tr("brightness {:.0f} of 255").format(r.level),
                *figures,
            ]
        if np.isfinite(r.warmth):
            figures.append(tr("red-to-blue ratio on the cloth {:.1f}").format(local(r.warmth)))
        return [*words, ", ".join(figures) + "."]

    def rings(self, step: int) -> list[Ring]:
        """Rings around markers that are missed with these colours, in an image ``step`` times
        smaller."""
        if self.reading is None:
            return []
        at = self.reading.missed / step
        return [Ring(float(u), float(v), 16 / step, MISSED_COLOUR, 2.0, dashed=True) for u, v in at]
