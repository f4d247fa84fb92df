"""The status bar: state of tracking, rates, latency, losses, and the running job."""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtCore import QElapsedTimer
from PySide6.QtWidgets import QProgressBar, QPushButton, QStatusBar, QToolTip, QWidget

from app.platform.tasks import RunningJob, TaskOwner
from app.viewmodels.states import GOOD, IDLE
from app.viewmodels.status import fields, hand_tip, tracking_look
from app.widgets.chip import Chip
from app.widgets.elided_label import ElidedLabel
from tracker.messages import Status

RATES = ("imu_rate_hz", "frame_rate_hz", "estimate_rate_hz")
"""Fields that are cut last: the rates are needed most."""
PROGRESS_MS = 100  # between two values of a job's progress
BETWEEN = 12  # px from one to the next
SHORTENED = ("shed", "latency", "losses")
"""Fields with a shorter text, in the order in which they are shortened."""
HIDDEN_FIRST = ("latency", "losses", "estimate_rate_hz", "frame_rate_hz", "imu_rate_hz")
"""Fields that are left out where there is too little room, in that order."""


class StatusBar(QStatusBar):
    def __init__(self, tasks: TaskOwner, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._tasks = tasks
        self.setSizeGripEnabled(False)
        # Of the hand that is shown, which matters most, and of the other one.
        self.tracking, self.other_hand = Chip(firm=True), Chip(firm=True)
        self.addWidget(self.tracking)
        self.addWidget(self.other_hand)
        self.other_hand.hide()
        self.chips = {f.key: Chip(firm=f.key in RATES) for f in fields(None)}
        for chip in self.chips.values():
            self.addWidget(chip)
        self._fields = {f.key: f for f in fields(None)}
        self._looks = [tracking_look(None, False)] * 2  # of the tracking: full, and short
        self.chips["shed"].hide()
        self.recording = Chip(firm=True)
        self._task_name = ElidedLabel()
        self._bar = QProgressBar()
        self._bar.setFixedWidth(140)
        self._cancel = QPushButton(self.tr("Cancel"))
        self._cancel.clicked.connect(self._cancel_task)
        for widget in (self.recording, self._task_name, self._bar, self._cancel):
            self.addPermanentWidget(widget)
        self._watched: RunningJob | None = None
        self._shown_at = QElapsedTimer()
        tasks.changed.connect(self._watch)
        self._watch()

    def show_status(
        self,
        status: Status | None,
        running: bool,
        has_place: bool = True,
        replayed: bool = False,
    ) -> None:
        """``replayed``: the status is from a session, not current."""
        self._looks = [
            tracking_look(status, running, has_place, replayed, brief) for brief in (False, True)
        ]
        self._show_tracking(brief=False)
        shown = status if running else None
        self._fields = {f.key: f for f in fields(shown, replayed and shown is not None)}
        self._make_room()

    def _show_tracking(self, brief: bool) -> None:
        look = self._looks[brief]
        self.tracking.show_state(look.colour, look.sign, look.word, self.tracking.toolTip())

    def _make_room(self) -> None:
        """Shorten texts where there is too little room; then leave out fields without a problem,
        the least important first."""
        texts = {key: field.full for key, field in self._fields.items() if field.full}
        others = (self.tracking, self.other_hand, self.recording, self._task_name)
        rest = (self._bar, self._cancel)
        taken = sum(w.sizeHint().width() + BETWEEN for w in (*others, *rest) if not w.isHidden())

        def is_full() -> bool:
            chips = sum(self.chips[key].width_with(text) + BETWEEN for key, text in texts.items())
            return taken + chips > self.width()

        if is_full() and self.other_hand.isHidden():
            taken -= self.tracking.sizeHint().width()
            self._show_tracking(brief=True)
            taken += self.tracking.sizeHint().width()
        for key in SHORTENED:
            if key in texts and self._fields[key].short and is_full():
                texts[key] = self._fields[key].short
        for key in HIDDEN_FIRST:
            if key in texts and self._fields[key].look in (GOOD, IDLE) and is_full():
                del texts[key]
        for key, chip in self.chips.items():
            if key in texts:
                look, tip = self._fields[key].look, self._fields[key].tip
                chip.show_state(look.colour, look.sign, texts[key], tip)
            chip.setVisible(key in texts)

    def show_hands(
        self,
        hands: Mapping[str, Status | None],
        running: bool,
        has_place: bool = True,
        replayed: bool = False,
    ) -> None:
        """Show each of two hands by its name, that of the panels first; after `show_status`."""
        self.other_hand.setVisible(len(hands) > 1)
        if len(hands) < 2:
            return
        names = {"left": self.tr("Left"), "right": self.tr("Right")}
        for chip, (side, status) in zip(
            (self.tracking, self.other_hand), hands.items(), strict=True
        ):
            look = tracking_look(status, running, has_place, replayed)
            chip.show_state(look.colour, look.sign, f"{names[side]}: {look.word}", hand_tip(status))
        self._make_room()

    def show_rate(self, rate_hz: float) -> None:
        """Show the refresh rate of the window in the tooltip."""
        self.tracking.setToolTip(
            self.tr("The window is refreshed {} times a second").format(round(rate_hz))
        )

    def show_latencies(self) -> None:
        """Show the tooltip of the latency: the latency of each stage."""
        chip = self.chips["latency"]
        QToolTip.showText(chip.mapToGlobal(chip.rect().topLeft()), chip.toolTip(), chip)

    def show_recording(self, text: str, colour: str) -> None:
        self.recording.setVisible(bool(text))
        self.recording.show_state(colour, "●", text)

    def _watch(self) -> None:
        """Show the newest running job, or nothing."""
        self._watched = self._tasks.tasks[-1] if self._tasks.tasks else None
        for widget in (self._task_name, self._bar, self._cancel):
            widget.setVisible(self._watched is not None)
        if self._watched is not None:
            self._task_name.setText(self._watched.title)
            self._bar.setRange(0, 0)
            self._shown_at.invalidate()
            self._watched.progressed.connect(self._progressed)

    def _progressed(self, fraction: float, text: str) -> None:
        if self.sender() is not self._watched or self._watched is None:
            return
        if self._shown_at.isValid() and self._shown_at.elapsed() < PROGRESS_MS:
            return  # each value repaints the window at once
        self._shown_at.start()
        self._bar.setRange(0, 0 if fraction < 0 else 100)
        self._bar.setValue(round(100 * max(0.0, fraction)))
        self._task_name.setText(f"{self._watched.title}: {text}" if text else self._watched.title)

    def _cancel_task(self) -> None:
        if self._watched is not None:
            self._watched.cancel()
