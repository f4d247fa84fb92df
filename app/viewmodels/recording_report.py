"""Warnings before a recording, and the report after it."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import numpy as np

from app.storage.session_tags import move_tags
from app.viewmodels.names import display_name
from app.viewmodels.recording import duration_text
from app.words import local, tr
from tracker.base.errors import FileError
from tracker.base.files import name_part
from tracker.base.notices import notice
from tracker.messages import ImuSample, Status

SILENT = 1.0  # s without data after which a device or an IMU counts as not responding
SLOW = 0.6  # relative to the nominal frame rate


class HandReport(NamedTuple):
    """``tracked``: 0..1 of the time; None if unknown. ``glove_silent``: s without data from its
    glove."""

    side: str
    tracked: float | None = None
    glove_silent: float = 0.0


@dataclass(frozen=True)
class RecordingReport:
    """``problem``: the most serious problem of the file, empty if it is complete. ``duration`` s;
    ``by_imus``: without a position, so that the tracked time is meaningless. ``camera_silent``: s
    without images; ``cut_off``: interrupted, can be recovered."""

    path: Path
    problem: str = ""
    duration: float = 0.0
    packets_lost: int | None = None
    by_imus: bool = False
    camera_silent: float = 0.0
    hands: tuple[HandReport, ...] = ()  # the left one first
    cut_off: bool = False


def report_text(report: RecordingReport) -> str:
    """One line: completeness, duration, losses, and tracked time of each hand."""
    name = report.path.stem
    if report.cut_off:
        text = tr("{} was interrupted after {}. Its contents can be recovered.")
        return text.format(name, duration_text(report.duration))
    if report.problem:
        return tr("{} is damaged: {}").format(name, report.problem)
    parts = [duration_text(report.duration)]
    if report.packets_lost is not None:
        parts.append(packets_lost(report.packets_lost))
    if report.camera_silent:
        parts.append(tr("no image for {:.1f} s").format(local(report.camera_silent)))
    by_hand = {hand.side: ", ".join(_hand_parts(hand, report.by_imus)) for hand in report.hands}
    if len(by_hand) < 2:
        text = ", ".join([*parts, *by_hand.values()])
    else:
        text = "; ".join([", ".join(parts), *(of_hand(*each) for each in by_hand.items())])
    return tr("{} is complete: {}.").format(name, text)


def _hand_parts(hand: HandReport, by_imus: bool) -> list[str]:
    """Time without data from the hand's glove, if any, and tracked time."""
    parts = []
    if hand.glove_silent:
        parts.append(tr("nothing from the glove for {:.1f} s").format(local(hand.glove_silent)))
    if by_imus:
        parts.append(tr("IMUs only"))
    elif hand.tracked is None:
        parts.append(tr("not tracked"))
    else:
        parts.append(tr("tracked {:.0f} % of the time").format(100 * hand.tracked))
    return parts


def of_hand(side: str, words: str) -> str:
    """A text about one of two hands."""
    pattern = tr("left hand: {}") if side == "left" else tr("right hand: {}")
    return pattern.format(words)


def packets_lost(count: int) -> str:
    if count == 0:
        return tr("no packets lost")
    return tr("1 packet lost") if count == 1 else tr("{} packets lost").format(count)


class HandNow(NamedTuple):
    """The current state of a hand: its status, the newest packets of its glove, the names of
    IMUs."""

    side: str
    status: Status
    samples: Sequence[ImuSample]
    imus: Sequence[str]
    has_glove: bool = True


Missing = dict[str, str]
"""Data that a recording currently lacks: texts for each device, sensor and hand, by a key."""


def missing_now(hands: Sequence[HandNow], image_rate: float | None) -> Missing:
    """Data that do not arrive at this instant; empty if all do.

    ``image_rate``: nominal images per second of the camera; 0 if unknown, None without a camera.
    """
    missing = {} if image_rate is None else _missing_images(hands[0].status, image_rate)
    for hand in hands:
        if not hand.has_glove:
            continue
        for key, words in _missing_imus(hand).items():
            missing[f"{hand.side} {key}"] = of_hand(hand.side, words) if len(hands) > 1 else words
    return missing


def missing_text(missing: Missing) -> str:
    """One sentence; empty if nothing is missing."""
    if not missing:
        return ""
    return tr("This recording is incomplete: {}.").format("; ".join(missing.values()))


def _missing_images(status: Status, wanted: float) -> Missing:
    rate = status.values.get("frame_rate_hz", 0.0)
    if rate == 0:
        return {"camera": tr("no images from the camera")}
    if rate < SLOW * wanted:
        words = tr("{:.0f} of {:.0f} images per second from the camera")
        return {"camera_rate": words.format(rate, wanted)}
    return {}


def _missing_imus(hand: HandNow) -> Missing:
    recent = [s for s in hand.samples if s.t_arrival > hand.status.t - SILENT]
    if not recent:
        return {"glove": tr("no data from the glove")}
    responding = np.any([s.valid for s in recent], axis=0)
    silent = [display_name(name) for name, ok in zip(hand.imus, responding, strict=True) if not ok]
    if not silent:
        return {}
    if len(silent) == 1:
        return {f"IMU {silent[0]}": tr("no data from the IMU {}").format(silent[0])}
    names = ", ".join(silent)
    return {f"IMU {names}": tr("no data from the IMUs {}").format(names)}


class MissingWatch:
    """Reports missing data during a recording, and ignores short interruptions.

    A part is reported after it was missing in ``APPEAR`` checks in a row, or at once in the first
    check of a recording; the report ends after it was present in ``DISAPPEAR`` checks in a row.
    """

    APPEAR, DISAPPEAR = 2, 3

    def __init__(self) -> None:
        self._shown: Missing = {}
        self._looks: dict[
            str, int
        ] = {}  # number of consecutive checks in which a part differs from its report
        self._first = True

    def look(self, now: Missing) -> Missing:
        """The report after this check; ``now``: see `missing_now`."""
        for key in {*now, *self._shown}:
            if (key in now) == (key in self._shown):
                self._looks.pop(key, None)
                continue
            self._looks[key] = self._looks.get(key, 0) + 1
            needed = self.APPEAR if key in now else self.DISAPPEAR
            if self._looks[key] < needed and not (self._first and key in now):
                continue
            del self._looks[key]
            if key in now:
                self._shown[key] = now[key]
            else:
                del self._shown[key]
        for key in self._looks.keys() - now.keys() - self._shown.keys():
            del self._looks[key]
        self._first = False
        return dict(self._shown)


def rename(path: Path, name: str) -> Path:
    """Rename a session within its folder. Raises FileError if that is not possible."""
    stem = name_part(name.strip().removesuffix(path.suffix))
    target = path.with_name(f"{stem}{path.suffix}")
    if not stem:
        raise FileError(notice("rename.no_name", file=path.name))
    if target == path:
        return path
    if target.exists():
        raise FileError(notice("rename.exists", other=target.name, file=path.name))
    try:
        path.rename(target)
        move_tags(path, target)
    except OSError as error:
        reason = error.strerror or str(error)
        raise FileError(
            notice("rename.failed", file=path.name, other=target.name, why=reason)
        ) from error
    return target
