"""The guided measurement of the IMUs' axes: positions, their texts, and the texts of the result."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from app.viewmodels.names import spoken
from app.viewmodels.states import BAD, BLUISH_GREEN, GOOD, ORANGE, SKY
from app.words import local, mark, tr
from tracker.calibration.imu_positions import POSITION_NAMES, ImuAxesRow, PositionGuide
from tracker.messages import Array, ImuSample

POSITION_WORDS = {
    "palm_down": mark("Palm down, hand level"),
    "fingers_raised": mark("Palm down, fingers raised by 45°"),
    "fingers_up": mark("Fingers straight up"),
    "palm_up_raised": mark("Palm up, fingers raised by 45°"),
    "palm_up": mark("Palm up, hand level"),
    "thumb_up": mark("Hand on its edge, thumb up"),
    "thumb_up_raised": mark("Hand on its edge, thumb up, fingers raised by 45°"),
    "thumb_side_raised": mark("Palm down, thumb side raised by 45°"),
    "little_side_raised": mark("Palm down, little finger side raised by 45°"),
    "thumb_down": mark("Hand on its edge, thumb down"),
    "fingers_lowered": mark("Palm down, fingers lowered by 45°"),
    "fingers_down": mark("Fingers straight down"),
}


class PositionsRun:
    """Call ``look`` with the packets of the last seconds; ``guide`` is None before the start."""

    def __init__(self) -> None:
        self.guide: PositionGuide | None = None
        self._since = -np.inf

    def start(self, guide: PositionGuide, now: Sequence[ImuSample]) -> None:
        """Use packets that are newer than those of ``now``."""
        self.guide, self._since = guide, now[-1].t if now else -np.inf

    def look(self, recent: Sequence[ImuSample]) -> None:
        """Take the new ones of these packets, oldest first."""
        if self.guide is None:
            return
        for sample in recent:
            if sample.t > self._since:
                self.guide.add(sample)
                self._since = sample.t

    @property
    def is_running(self) -> bool:
        return self.guide is not None

    @property
    def is_done(self) -> bool:
        return self.guide is not None and not self.guide.asked

    def word(self) -> tuple[str, str]:
        """The state in a few words, and its colour."""
        guide = self.guide
        if guide is None:
            return "", SKY
        if guide.share:
            return tr("Hold still"), BLUISH_GREEN
        if guide.here:
            return tr("Measured. Next position"), SKY
        if guide.found.is_still:
            return tr("At rest in another position"), ORANGE
        return tr("Move there, then hold still"), SKY

    def chips(self) -> list[tuple[str, str]]:
        """(sign, number) of each position: held, current, pending."""
        guide = self.guide
        out = []
        for number, name in enumerate(POSITION_NAMES):
            sign = "○"
            if guide is not None and name in guide.held:
                sign = "✓"
            elif guide is not None and name == guide.asked:
                sign = "▶"
            out.append((sign, str(number + 1)))
        return out


class AxesWords(NamedTuple):
    """Rows of the table with the colour of each, a heading and a sentence; ``usable`` are the
    results that can be saved."""

    heading: str
    words: str
    rows: list[tuple[str, str, str, str]]
    colours: list[str]
    usable: list[ImuAxesRow]


def axes_words(found: Sequence[ImuAxesRow], file: str) -> AxesWords:
    """The texts of the result; ``file`` is the name of the file that *Save* writes."""
    usable = [row for row in found if row.is_usable]
    rows = [(spoken(r.name), _size(r, "accel"), _size(r, "gyro"), _verdict(r)) for r in found]
    colours = [GOOD.colour if r.is_usable else BAD.colour for r in found]
    heading = tr("{} of {} IMUs measured").format(len(usable), len(found))
    if not usable:
        words = tr("Repeat the positions, and hold each one still for two seconds.")
        return AxesWords(heading, words, rows, colours, usable)
    worst = max(max(_largest(r, "accel"), _largest(r, "gyro")) for r in usable)
    left = max(max(_sd(r, "accel"), _sd(r, "gyro")) for r in usable)
    words = tr(
        "Scale and axes deviate by up to {} %. With the corrections {} % remain (standard "
        "deviation). Save writes them to the glove file {} and uses them at once."
    ).format(f"{local(100 * worst):.1f}", f"{local(100 * left):.1f}", file)
    return AxesWords(heading, words, rows, colours, usable)


def _largest(row: ImuAxesRow, kind: str) -> float:
    """Of a correction's deviations from no correction."""
    assert row.result is not None
    matrix: Array = getattr(row.result.axes, kind)
    return float(np.abs(matrix - np.eye(3)).max())


def _sd(row: ImuAxesRow, kind: str) -> float:
    assert row.result is not None
    return float(getattr(row.result, f"{kind}_sd").max())


def _size(row: ImuAxesRow, kind: str) -> str:
    if row.result is None:
        return "–"
    values = (f"{local(100 * x):.1f}" for x in (_largest(row, kind), _sd(row, kind)))
    return tr("{} % ± {} %").format(*values)


def _verdict(row: ImuAxesRow) -> str:
    if row.is_usable:
        return f"{GOOD.sign} {tr('measured')}"
    if row.result is None:
        return f"{BAD.sign} {tr('too few rests')}"
    return (
        f"{BAD.sign} {tr('not accurate: it moved while at rest, or rested in too few positions')}"
    )
