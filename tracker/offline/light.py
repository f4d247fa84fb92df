"""``glovetrack light``: what the light of a recorded session costs markers."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracker.base.errors import FileError
from tracker.calibration.light_meter import LightMeter, LightReading
from tracker.glove import library
from tracker.messages import StereoFrame
from tracker.session.description import COLOURS
from tracker.session.reader import SessionReader
from tracker.vision.colours import parse_profile

EVERY = 1.0  # s between two images that are read
MOST = 20  # images


@dataclass(frozen=True)
class SessionLight:
    """Readings of some left images, and the advice that most of them got, one of each kind."""

    readings: tuple[LightReading, ...]
    advice: tuple[str, ...]

    def to_json(self) -> dict[str, Any]:
        """Means over the images; null where no marker was seen."""
        r = self.readings
        patches, found = sum(len(x.uv) for x in r), sum(int(x.found.sum()) for x in r)
        return {
            "images": len(r),
            "markers": patches,
            "found": found,
            "level": _mean([x.level for x in r]),
            "noise": _mean([x.noise for x in r]),
            "warmth": _mean([x.warmth for x in r]),
            "room": {hue: sum(x.room[hue] for x in r) / len(r) for hue in r[0].room},
            "advice": list(self.advice),
        }

    def lines(self) -> list[str]:
        """For people."""
        figures = self.to_json()
        told = self.advice or ("Nothing to change: the markers are clear.",)
        head = f"{figures['found']} of {figures['markers']} markers found in "
        return [head + f"{figures['images']} images, noise {figures['noise']:.1f} levels.", *told]


def _mean(values: list[float]) -> float | None:
    known = [v for v in values if np.isfinite(v)]
    return float(np.mean(known)) if known else None


def session_light(path: Path, colours: str = "") -> SessionLight:
    """Of a session with images. Raises FileError where there are none."""
    with SessionReader(path) as session:
        text = session.info.colours_text or library.text("colours", library.DEFAULT_COLOURS)
        text = library.text("colours", colours) if colours else text
        profile = parse_profile(text, colours or f"{path}, {COLOURS}")
        rig = session.info.rig
        meter = LightMeter(profile, rig.fx if rig is not None else 640.0)
        readings = tuple(meter.read(image) for image in _some_images(session))
    if not readings:
        raise FileError(f"{path} holds no images whose light could be read.")
    said = [a for r in readings for a in {a.kind: a for a in r.advice}.values()]
    most = [
        kind
        for kind in dict.fromkeys(a.kind for a in said)
        if sum(a.kind == kind for a in said) > len(readings) / 2
    ]
    return SessionLight(
        readings, tuple(next(str(a.notice) for a in said if a.kind == kind) for kind in most)
    )


def _some_images(session: SessionReader) -> Iterator[NDArray[np.uint8]]:
    """Left images a second apart."""
    last, count = -np.inf, 0
    for message in session.messages():
        if not isinstance(message, StereoFrame) or message.left is None:
            continue
        if message.t - last >= EVERY:
            last, count = message.t, count + 1
            yield message.left
        if count == MOST:
            return
