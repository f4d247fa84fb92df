"""A recording in words: what it is begun without, and how it went."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from app.storage.session_tags import move_tags
from app.viewmodels.names import spoken
from app.viewmodels.recording import duration_text
from app.words import tr
from tracker.errors import FileError
from tracker.files import name_part
from tracker.messages import ImuSample, Status

SILENT = 1.0  # s without a word after which a device or an IMU is called silent
SLOW = 0.6  # of the images that the camera should give


@dataclass(frozen=True)
class TakeReport:
    """``problem``: the worst that is wrong with the file, empty where it is whole. ``duration`` s;
    ``tracked`` 0..1 of that time; None where the file does not tell; ``by_imus``: without a place,
    so that it says nothing. ``glove_silent`` and ``camera_silent``: s for which nothing came.
    """

    path: Path
    problem: str = ""
    duration: float = 0.0
    packets_lost: int | None = None
    tracked: float | None = None
    by_imus: bool = False
    glove_silent: float = 0.0
    camera_silent: float = 0.0


def report_text(report: TakeReport) -> str:
    """One line: whole, so long, so much lost, tracked so much of the time."""
    name = report.path.stem
    if report.problem:
        return tr("{} is not whole: {}").format(name, report.problem)
    parts = [duration_text(report.duration)]
    if report.packets_lost is not None:
        lost = report.packets_lost
        parts.append(packets_lost(lost))
    if report.glove_silent:
        parts.append(tr("nothing from the glove for {:.1f} s").format(report.glove_silent))
    if report.camera_silent:
        parts.append(tr("no image for {:.1f} s").format(report.camera_silent))
    if report.by_imus:
        parts.append(tr("by its IMUs alone"))
    elif report.tracked is None:
        parts.append(tr("not tracked"))
    else:
        parts.append(tr("tracked {:.0f} % of the time").format(100 * report.tracked))
    return tr("{} is whole: {}.").format(name, ", ".join(parts))


def packets_lost(count: int) -> str:
    if count == 0:
        return tr("no packets lost")
    return tr("1 packet lost") if count == 1 else tr("{} packets lost").format(count)


def missing_text(
    status: Status, samples: Sequence[ImuSample], imus: Sequence[str], image_rate: float
) -> str:
    """What a recording that begins now will lack; empty where everything comes.

    ``image_rate``: images a second that the camera should give; 0 where that is not known.
    """
    missing = [*_missing_images(status, image_rate), *_missing_imus(status, samples, imus)]
    return tr("This recording lacks something: {}.").format("; ".join(missing)) if missing else ""


def _missing_images(status: Status, wanted: float) -> list[str]:
    rate = status.values.get("frame_rate_hz", 0.0)
    if rate == 0:
        return [tr("no image comes from the camera")]
    if rate < SLOW * wanted:
        return [tr("{:.0f} images come a second instead of {:.0f}").format(rate, wanted)]
    return []


def _missing_imus(status: Status, samples: Sequence[ImuSample], imus: Sequence[str]) -> list[str]:
    lately = [s for s in samples if s.t_arrival > status.t - SILENT]
    if not lately:
        return [tr("no packet comes from the glove")]
    heard = np.any([s.valid for s in lately], axis=0)
    silent = [spoken(name) for name, ok in zip(imus, heard, strict=True) if not ok]
    if not silent:
        return []
    if len(silent) == 1:
        return [tr("the IMU {} cannot be heard").format(silent[0])]
    return [tr("the IMUs {} cannot be heard").format(", ".join(silent))]


def rename(path: Path, name: str) -> Path:
    """Give a session another name in its folder. Raises FileError where that cannot be."""
    stem = name_part(name.strip().removesuffix(path.suffix))
    target = path.with_name(f"{stem}{path.suffix}")
    if not stem:
        raise FileError(tr("{} needs a name with a letter or a digit in it.").format(path.name))
    if target == path:
        return path
    if target.exists():
        raise FileError(
            tr("{} is there already, so {} keeps its name.").format(target.name, path.name)
        )
    try:
        path.rename(target)
        move_tags(path, target)
    except OSError as error:
        reason = error.strerror or str(error)
        raise FileError(
            tr("{} cannot be named {}: {}.").format(path.name, target.name, reason)
        ) from error
    return target
