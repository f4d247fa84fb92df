"""``glovetrack colours``: fit a colour profile to a recording, and say how well one serves it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from tracker.base.errors import FileError
from tracker.base.files import check_target, write_kept
from tracker.glove import library
from tracker.messages import ImuSample, StereoFrame
from tracker.offline.colours_fit import (
    ColourCheck,
    Sensed,
    SessionFit,
    WatchedGlove,
    check_messages,
    fit_messages,
)
from tracker.offline.track import profile_of
from tracker.session.description import SessionInfo
from tracker.session.images import PackedFrame
from tracker.session.reader import SessionReader
from tracker.vision.colours import parse_profile, profile_to_toml

MOST_IMAGES = 48  # pairs that are looked at, 260 MB at 720p
APART = 0.08  # s between two of them


def fit_session(source: Path, out: Path, colours: str = "", force: bool = False) -> SessionFit:
    """Fit to ``source`` and write the profile to ``out``, beginning with ``colours`` (name or
    file), else the session's own.

    Raises GlovetrackError where no hand is found for sure, or nothing better than before.
    """
    check_target(out, force, [source])
    info, messages = _read(source, colours)
    fit = fit_messages(messages, worn_in(info), profile_of(info))
    write_kept(out, profile_to_toml(replace(fit.profile, name=out.stem)), force)
    return fit


def check_session(source: Path, colours: str = "") -> ColourCheck:
    """How well ``colours`` (name or file), else the session's own, serve it."""
    info, messages = _read(source, colours)
    return check_messages(messages, worn_in(info), profile_of(info))


def worn_in(info: SessionInfo) -> WatchedGlove:
    """What a session says of hand, glove and cameras. Raises FileError where it has no cameras."""
    if info.rig is None:
        raise FileError("The session says nothing of its cameras: no hand can be found in it.")
    return WatchedGlove(info.hand, info.glove, info.rig)


def _read(source: Path, colours: str) -> tuple[SessionInfo, list[Sensed]]:
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
            if images >= MOST_IMAGES:
                break
    if images == 0:
        raise FileError(f"{source} holds no images to fit colours to.")
    return info, messages
