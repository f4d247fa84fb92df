"""Guided measurement of the IMUs' axes: the glove rests in twelve positions, for two minutes."""

from __future__ import annotations

from collections.abc import Sequence
from functools import partial
from typing import NamedTuple

import numpy as np
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QPushButton, QWidget

from app.engines.engine import EngineSetup
from app.engines.engine_host import EngineHost
from app.jobs.own_gloves import save_own
from app.platform.tasks import JobProgress, TaskOwner
from app.storage.settings import SettingsStore
from app.viewmodels.guided_hand import DRAWN, MOVE, Shown
from app.viewmodels.names import display_name
from app.viewmodels.states import BAD, BLUISH_GREEN, GOOD, ORANGE, SKY
from app.wizards.leading.dialog import LeadingDialog
from app.wizards.leading.outcome import OutcomePage
from app.wizards.leading.page import LeadingPage, PoseStage
from app.words import error_text, local, mark, tr
from tracker.base.clock import monotonic
from tracker.base.errors import GlovetrackError
from tracker.calibration.imu_positions import POSITION_NAMES, ImuAxesRow, PositionGuide, orientation
from tracker.geometry import so3
from tracker.glove.imu_values import with_axes
from tracker.messages import Array, ImuSample
from tracker.simulation.posture_requests import PostureRequest
from tracker.simulation.postures import posture
from tracker.simulation.scenario import Simulation
from tracker.simulation.smooth import minimum_jerk

EYE = (-0.75, -0.55, 0.45)
"""Direction to the viewer of a right hand, in G: behind the wearer and to the right."""
FLAT = "flat"
FARTHER = 1.5
"""Than for guided poses: the hand is seen from its side, too."""


class PositionStage(PoseStage):
    """``pose`` is a name of `tracker.calibration.imu_positions`; up is up in the view.

    The wearer's hand is drawn as an outline with its own inclination.
    """

    def __init__(self, setup: EngineSetup, background: str, parent: QWidget | None = None) -> None:
        super().__init__(setup, background, parent)
        self._side = setup.side
        self._angles = posture(setup.hand, DRAWN[FLAT])
        self.pose = "palm_down"
        self.distance *= FARTHER
        self.view.setAccessibleName(self.tr("The position of the hand"))

    def shown(self, again: bool) -> Shown:
        there = orientation(self.pose, self._side)
        start = orientation(self.before or self.pose, self._side)
        share = float(minimum_jerk(np.array([(monotonic() - self._since) / MOVE]))[0])
        R_GB = start @ so3.exp(so3.log(start.T @ there) * share)
        middle = np.array([0.48 * self._hand.length, 0.0, -0.01])
        R, p = self._hand.forward(self._angles, R_GB, -R_GB @ middle)
        mirror = [1.0, -1.0 if self._side == "left" else 1.0, 1.0]
        return Shown(R, p, np.zeros(3), np.array(EYE) * mirror)

    def alignment(self, R_shown: Array, R_own: Array) -> Array:
        """(3, 3) the rotation about the vertical that turns ``R_own`` closest to ``R_shown``."""
        M = R_own @ R_shown.T
        return so3.rz(float(np.arctan2(M[0, 1] - M[1, 0], M[0, 0] + M[1, 1])))


class AxesPage(OutcomePage):
    """The result of each IMU."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        names = (
            self.tr("IMU"),
            self.tr("Accelerometer"),
            self.tr("Gyroscope"),
            self.tr("Result"),
        )
        self.name_columns(self.tr("Result"), names, wide=3)
        self.save = QPushButton(self.tr("&Save"))
        self.save.setDefault(True)
        self.discard = QPushButton(self.tr("&Discard"))
        self.lay_out(self.discard, self.save)

    def show_waiting(self) -> None:
        """Show that the result is being computed."""
        self.tell(self.tr("Evaluating the positions…"), "")
        self.enable(False)

    def show_result(self, found: AxesTexts) -> None:
        """Show the result."""
        self.tell(found.heading, found.words, found.rows, found.colours)
        self.enable(True)
        self.save.setEnabled(bool(found.usable))
        (self.save if found.usable else self.again_button).setFocus()


class PositionsPage(LeadingPage):
    """Shows the next position; `PositionsDialog` executes the requests."""

    def __init__(self, setup: EngineSetup, background: str, parent: QWidget | None = None) -> None:
        super().__init__(setup, background, parent, PositionStage(setup, background))
        self.word = self.label("word")
        self.sound.setToolTip(self.tr("Beep when a position has been measured"))
        self.finish = QPushButton(self.tr("&Finish"))
        self.finish.setToolTip(self.tr("Evaluate the positions measured so far, at least six"))
        self.finish.setAutoDefault(False)
        self.lay_out((self.words, self.word, self.notes), (self.stop, self.finish, self.start))

    def show_run(self, run: PositionsRun) -> None:
        """Show the state."""
        guide = run.guide
        name = guide.asked if guide is not None else POSITION_NAMES[0]
        if name and self.stage.pose != name:
            self.stage.show_pose(name)
        word, colour = run.word()
        self.stage.ring.show_share(guide.share if guide is not None else 0.0, colour)
        if guide is None:
            self.words.setText(self.tr("Rest the glove in twelve positions"))
            self.notes.setText(
                self.tr(
                    "Gravity shows how accurate scale and axes of the IMUs are. Wear the glove "
                    "and support the hand on a table, or fasten the glove to a box. Hold each "
                    "position still for two seconds. Any order is possible. It takes two minutes."
                )
            )
        elif name:
            self.words.setText(tr(POSITION_WORDS[name]))
            self.notes.setText("")
        self.word.setVisible(bool(word))
        self.word.setText(word)
        self.word.setStyleSheet(f"background: {colour}")
        self.show_chips(run.chips())
        self.start.setVisible(guide is None)
        self.finish.setVisible(guide is not None)
        self.finish.setEnabled(guide is not None and guide.is_enough)


class PositionsDialog(LeadingDialog):
    """``saved``: the glove's file was written, and the glove is to be opened again."""

    saved = Signal()

    def __init__(
        self,
        host: EngineHost,
        setup: EngineSetup,
        store: SettingsStore,
        tasks: TaskOwner,
        background: str,
        parent: QWidget | None = None,
    ) -> None:
        lead, outcome = PositionsPage(setup, background), AxesPage()
        super().__init__(host, store, (lead, outcome), parent)
        self.lead, self.outcome, self.run = lead, outcome, PositionsRun()
        self._setup, self._store, self._tasks = setup, store, tasks
        self._rows: list[ImuAxesRow] = []
        self._followed = ""
        self._held = 0
        self.setWindowTitle(self.tr("Accuracy of the IMUs"))
        self.setObjectName("imu_positions")
        self.due.connect(self._go_on)
        lead.start.clicked.connect(self.start)
        lead.finish.clicked.connect(self._finish)
        outcome.again.connect(self.start)
        outcome.discard.clicked.connect(self.reject)
        outcome.save.clicked.connect(self._save)
        self.begin()

    # --- the positions

    def start(self) -> None:
        """Start with the first position."""
        self.pages.setCurrentWidget(self.lead)
        self._followed, self._held = "", 0
        guide = PositionGuide(self._setup.glove)
        self.run.start(guide, self._setup.tracked.recent_imu())

    def _go_on(self) -> None:
        self.run.look(self._setup.tracked.recent_imu())
        guide = self.run.guide
        if guide is not None:
            if len(guide.held) > self._held:
                self.beep()
            self._held = len(guide.held)
            self._lead_wearer(guide.asked)
        if self.run.is_done:
            self._finish()
        else:
            self.lead.show_run(self.run)
            self.lead.stage.refresh(self._setup.tracked.latest_estimate(), again=False)

    def _lead_wearer(self, name: str) -> None:
        """Let a simulated wearer take the position."""
        wearer = self._setup.live.wearer if self._setup.live is not None else None
        if wearer is None or name == self._followed:
            return
        self._followed = name
        if name:
            wearer.follow(partial(rest_request, name), name)
        else:
            wearer.show("")

    # --- the result

    def _finish(self) -> None:
        guide = self.run.guide
        if guide is None:
            return
        self.pages.setCurrentWidget(self.outcome)
        self.outcome.show_waiting()

        def evaluate(_progress: JobProgress) -> list[ImuAxesRow]:
            return guide.result()

        title = self.tr("Evaluating the positions")
        self._tasks.run(title, evaluate, self._evaluated, failed=self._failed)

    def _evaluated(self, rows: list[ImuAxesRow]) -> None:
        self._rows = rows
        self.outcome.show_result(axes_texts(rows, self._setup.connection.own_file))

    def _failed(self, why: str) -> None:
        self.outcome.tell(self.tr("The result cannot be used"), why)
        self.outcome.again_button.setEnabled(True)

    def _save(self) -> None:
        axes = {r.name: r.result.axes for r in self._rows if r.is_usable and r.result is not None}
        try:
            save_own(self._store, self._setup, lambda text: with_axes(text, axes))
        except GlovetrackError as error:
            self._failed(error_text(error))
            return
        self.close()
        self.saved.emit()

    def done(self, result: int) -> None:
        """Let a simulated wearer continue."""
        wearer = self._setup.live.wearer if self._setup.live is not None else None
        if wearer is not None and self._followed:
            wearer.show("")
        super().done(result)


MOVE_S = 1.2


def rest_request(name: str, simulation: Simulation, t: float) -> list[PostureRequest]:
    """From ``t`` (s) on, the flat hand moves into the position and rests there."""
    hand = simulation.hand
    R_GB, p_GB = orientation(name, hand.side), simulation.motion.poses(np.zeros(1)).p_GB[0]
    place = (*R_GB.ravel().tolist(), *p_GB.tolist())
    return [PostureRequest(t, tuple(posture(hand, {}).tolist()), 0.0, place, MOVE_S)]


# ---- the guided measurement of the IMUs' axes: positions, their texts, and the texts of the
# result

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


class AxesTexts(NamedTuple):
    """Rows of the table with the colour of each, a heading and a sentence; ``usable`` are the
    results that can be saved."""

    heading: str
    words: str
    rows: list[tuple[str, str, str, str]]
    colours: list[str]
    usable: list[ImuAxesRow]


def axes_texts(found: Sequence[ImuAxesRow], file: str) -> AxesTexts:
    """The texts of the result; ``file`` is the name of the file that *Save* writes."""
    usable = [row for row in found if row.is_usable]
    rows = [(display_name(r.name), _size(r, "accel"), _size(r, "gyro"), _verdict(r)) for r in found]
    colours = [GOOD.colour if r.is_usable else BAD.colour for r in found]
    heading = tr("{} of {} IMUs measured").format(len(usable), len(found))
    if not usable:
        words = tr("Repeat the positions, and hold each one still for two seconds.")
        return AxesTexts(heading, words, rows, colours, usable)
    worst = max(max(_largest(r, "accel"), _largest(r, "gyro")) for r in usable)
    left = max(max(_sd(r, "accel"), _sd(r, "gyro")) for r in usable)
    words = tr(
        "Scale and axes deviate by up to {} %. With the corrections {} % remain (standard "
        "deviation). Save writes them to the glove file {} and uses them at once."
    ).format(f"{local(100 * worst):.1f}", f"{local(100 * left):.1f}", file)
    return AxesTexts(heading, words, rows, colours, usable)


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
