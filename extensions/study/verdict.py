"""The verdict on a recorded trial: what was measured of it, and which requirements it misses."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from extensions.study.protocol import TrialLimits
from extensions.study.schedule import ScheduleStep
from tracker.base.errors import GlovetrackError
from tracker.base.notices import Notice, from_json, to_json, warning
from tracker.messages import BlobFrame, Estimate, ImuSample, Status, Validity
from tracker.session.overview import quality, session_summary
from tracker.session.reader import SessionReader
from tracker.session.ros import topics

NAN = float("nan")


@dataclass(frozen=True)
class MeasuredRecording:
    """For a recording, of the worse hand if there are two. ``duration`` s from the first packet to
    the last (without packets: of the file). ``tracked``: share of the time; ``measured``,
    ``inferred``, ``lost``: shares of all keypoints and instants. ``packet_rate``, ``image_rate``
    Hz; ``images`` pairs of images (or of their blobs); ``images_missed``: share of images that were
    not searched. NaN where unknown."""

    duration: float = 0.0
    tracked: float = NAN
    measured: float = NAN
    inferred: float = NAN
    lost: float = NAN
    packets: int = 0
    packets_lost: int = 0
    packet_rate: float = 0.0
    images: int = 0
    images_missed: float = NAN
    image_rate: float = 0.0


@dataclass(frozen=True)
class TrialVerdict:
    """``findings``: requirements that the recording misses; it is good without any."""

    measured: MeasuredRecording
    findings: tuple[Notice, ...] = ()

    @property
    def is_good(self) -> bool:
        return not self.findings

    def as_json(self) -> dict[str, Any]:
        """Plain values, as a progress file contains them."""
        numbers = {k: None if v != v else v for k, v in asdict(self.measured).items()}
        found = [to_json(f) for f in self.findings]
        return {"good": self.is_good, "measured": numbers, "findings": found}


def stored(record: Mapping[str, Any]) -> TrialVerdict:
    """The inverse of `TrialVerdict.as_json`."""
    numbers: dict[str, Any] = {k: NAN if v is None else v for k, v in record["measured"].items()}
    found = [from_json(f) for f in record["findings"]]
    return TrialVerdict(MeasuredRecording(**numbers), tuple(f for f in found if f is not None))


def judge(path: Path, step: ScheduleStep, limits: TrialLimits) -> TrialVerdict:
    """The verdict on a trial's recording; an unreadable one is a finding too."""
    try:
        measured = measure(path)
    except GlovetrackError as error:
        return TrialVerdict(MeasuredRecording(), (warning("study.unreadable", why=error),))
    findings = findings_of(measured, step.duration, limits)
    if session_summary(path)["integrity"] != "ok":
        findings.insert(0, warning("study.unfinished"))
    return TrialVerdict(measured, tuple(findings))


def measure(path: Path) -> MeasuredRecording:
    """Reads a recording. Raises FileError if it is not a session."""
    with SessionReader(path) as reader:
        sides = reader.sides or ("",)
        known = quality(reader)
        images = topics.image("left")
        pictures = int(session_summary(path)["topics"].get(images, {"count": 0})["count"])
    hands = [_hand(path, side, pictures) for side in sides]
    worse = min(hands, key=lambda h: (h.packet_rate, h.measured))
    tracked = NAN if known.tracked is None or known.by_imus else known.tracked
    lost = known.packets_lost or 0
    return replace(worse, tracked=tracked, packets_lost=lost)


def _hand(path: Path, side: str, pictures: int) -> MeasuredRecording:
    """``pictures``: number of recorded left images."""
    counts = np.zeros(3, np.int64)
    t: list[float] = []
    searched, missed = 0, NAN
    with SessionReader(path, side=side) as reader:
        for m in reader.messages((Estimate, ImuSample, BlobFrame, Status)):
            if isinstance(m, Estimate):
                counts += np.bincount(m.keypoint_state, minlength=3)[:3]
            elif isinstance(m, ImuSample):
                t.append(m.t)
            elif isinstance(m, BlobFrame):
                searched += 1
            elif isinstance(m, Status):
                missed = m.values.get("images_missed", missed)
        whole = reader.duration
    duration = t[-1] - t[0] if len(t) > 1 else whole
    images = pictures or searched
    if pictures:
        missed = max(pictures - searched, 0) / pictures
    of_all = counts / counts.sum() if counts.any() else np.full(3, NAN)
    return MeasuredRecording(
        duration=duration,
        measured=float(of_all[Validity.MEASURED]),
        inferred=float(of_all[Validity.INFERRED]),
        lost=float(of_all[Validity.LOST]),
        packets=len(t),
        packet_rate=max(len(t) - 1, 0) / duration if duration else 0.0,
        images=images,
        images_missed=missed,
        image_rate=images / whole if whole else 0.0,
    )


def findings_of(m: MeasuredRecording, planned: float, limits: TrialLimits) -> list[Notice]:
    """What is missing; ``planned`` duration in s, 0 for none."""
    least, lost = limits.duration * planned, m.packets_lost / max(m.packets + m.packets_lost, 1)
    required = (
        (m.duration < least, warning("study.short", duration_s=m.duration, least_s=least)),
        (
            m.tracked < limits.tracked,
            warning("study.untracked", **_percent(found=m.tracked, least=limits.tracked)),
        ),
        (
            m.measured < limits.measured,
            warning("study.unmeasured", **_percent(found=m.measured, least=limits.measured)),
        ),
        (
            lost > limits.packets_lost,
            warning("study.packets_lost", **_percent(found=lost, most=limits.packets_lost)),
        ),
        (
            m.packet_rate < limits.packet_rate,
            warning("study.packet_rate", found_hz=m.packet_rate, least_hz=limits.packet_rate),
        ),
        (
            m.images_missed > limits.images_missed,
            warning(
                "study.images_missed", **_percent(found=m.images_missed, most=limits.images_missed)
            ),
        ),
        (
            m.image_rate < limits.image_rate,
            warning("study.image_rate", found_hz=m.image_rate, least_hz=limits.image_rate),
        ),
    )
    return [finding for is_missing, finding in required if is_missing]


def _percent(**shares: float) -> dict[str, float]:
    return {f"{name}_percent": 100 * share for name, share in shares.items()}
