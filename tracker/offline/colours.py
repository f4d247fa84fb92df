"""``glovetrack colours`` and ``glovetrack light``: the colours of a recording's markers.

The first fits a colour profile to the recording and measures how well a profile serves it, the
second measures how many markers its light costs.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tracker.base.errors import FileError
from tracker.base.files import check_target, write_with_folder
from tracker.base.notices import notice, warning
from tracker.calibration.light_meter import LightMeter, LightReading
from tracker.glove import library
from tracker.messages import ImuSample, StereoFrame
from tracker.offline.colours_fit import (
    ColourCheck,
    Sensed,
    SessionFit,
    WatchedGlove,
    check_with_names,
    exchanged_hues,
    fit_messages,
)
from tracker.offline.track import profile_of
from tracker.session.description import COLOURS, SessionInfo
from tracker.session.images import PackedFrame
from tracker.session.reader import SessionReader
from tracker.vision.colours import parse_profile, profile_to_toml

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
        advice = self.advice or ("Nothing to change: the markers are clear.",)
        head = f"{figures['found']} of {figures['markers']} markers found in "
        return [head + f"{figures['images']} images, noise {figures['noise']:.1f} levels.", *advice]


def _mean(values: list[float]) -> float | None:
    known = [v for v in values if np.isfinite(v)]
    return float(np.mean(known)) if known else None


def session_light(path: Path, colours: str = "") -> SessionLight:
    """Measures the light of a session, and finds hues whose names are exchanged. Raises FileError
    if it has no images."""
    with SessionReader(path) as session:
        text = session.info.colours_text or library.text("colours", library.DEFAULT_COLOURS)
        text = library.text("colours", colours) if colours else text
        profile = parse_profile(text, colours or f"{path}, {COLOURS}")
        rig = session.info.rig
        meter = LightMeter(profile, rig.fx if rig is not None else 640.0)
        readings = tuple(meter.read(image) for image in _some_images(session))
    if not readings:
        raise FileError(notice("light.no_images", path=path))
    advice = [a for r in readings for a in {a.kind: a for a in r.advice}.values()]
    most = [
        kind
        for kind in dict.fromkeys(a.kind for a in advice)
        if sum(a.kind == kind for a in advice) > len(readings) / 2
    ]
    words = [next(str(a.notice) for a in advice if a.kind == kind) for kind in most]
    return SessionLight(readings, (*_exchanged(path, colours), *words))


def _exchanged(path: Path, colours: str) -> list[str]:
    """The advice if names of hues are exchanged; without a camera calibration nothing is known."""
    with SessionReader(path) as session:
        if session.info.rig is None:
            return []
    info, messages = _read(path, colours, CHECKED_IMAGES)
    hues = exchanged_hues(messages, glove_of(info), profile_of(info))
    return [str(warning("colours.exchanged", hues=hues))] if hues else []


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


CHECKED_IMAGES = 3  # pairs, to find exchanged hues
MOST_IMAGES = 48  # pairs that are looked at, 260 MB at 720p
APART = 0.08  # s between two of them


def fit_session(source: Path, out: Path, colours: str = "", force: bool = False) -> SessionFit:
    """Fit to ``source`` and write the profile to ``out``, beginning with ``colours`` (name or
    file), else the session's own.

    Raises GlovetrackError where no hand is found for sure, or nothing better than before.
    """
    check_target(out, force, [source])
    info, messages = _read(source, colours)
    fit = fit_messages(messages, glove_of(info), profile_of(info))
    write_with_folder(out, profile_to_toml(replace(fit.profile, name=out.stem)), force)
    return fit


def check_session(source: Path, colours: str = "") -> ColourCheck:
    """How well ``colours`` (name or file), else the session's own, serve it."""
    info, messages = _read(source, colours)
    return check_with_names(messages, glove_of(info), profile_of(info))


def glove_of(info: SessionInfo) -> WatchedGlove:
    """Returns hand, glove and cameras of a session. Raises FileError if it has no cameras."""
    if info.rig is None:
        raise FileError(notice("colours.no_calibration"))
    return WatchedGlove(info.hand, info.glove, info.rig)


def _read(source: Path, colours: str, most: int = MOST_IMAGES) -> tuple[SessionInfo, list[Sensed]]:
    """The session with these colours, its packets and some of its images."""
    with SessionReader(source) as reader:
        info = replace(reader.info, rig=reader.rig())
        if colours:
            text = library.text("colours", colours)
            parse_profile(text, colours)
            info = replace(info, colours_text=text)
        messages: list[Sensed] = []
        last, images = float("-inf"), 0
        for message in reader.packed_messages((ImuSample, StereoFrame)):
            if isinstance(message, ImuSample):
                messages.append(message)
            elif isinstance(message, PackedFrame) and message.t - last >= APART:
                frame = message.unpack()
                if frame is not None:
                    messages.append(frame)
                    last, images = message.t, images + 1
            if images >= most:
                break
    if images == 0:
        raise FileError(notice("colours.no_images", path=source))
    return info, messages
