"""Settings of the pose reset: its key, countdown and sound, and the double tap."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import Signal
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import (
    QCheckBox,
    QFormLayout,
    QKeySequenceEdit,
    QLabel,
    QPushButton,
    QSpinBox,
    QWidget,
)

from app.storage.settings import SettingsStore
from app.wizards.form_dialog import FormDialog, filler, labelled

LONGEST = 10  # s of the countdown


class PoseResetSettings(FormDialog):
    """``saved``: the settings were written. ``user_of`` returns the name of the command that uses a
    key."""

    saved = Signal()

    def __init__(
        self, store: SettingsStore, user_of: Callable[[str], str], parent: QWidget | None = None
    ) -> None:
        super().__init__("pose_reset", (460, 320), parent)
        self._store, self._user_of = store, user_of
        self.setWindowTitle(self.tr("Pose reset"))
        settings = store.value
        self.key = QKeySequenceEdit(QKeySequence(settings.pose_reset_key))
        self.key.setMaximumSequenceLength(1)
        self.key.setClearButtonEnabled(True)
        self.countdown = QSpinBox()
        self.countdown.setRange(0, LONGEST)
        self.countdown.setSuffix(self.tr(" s"))
        self.countdown.setValue(settings.pose_reset_countdown)
        self.sound = QCheckBox(self.tr("&Beep when it is done"))
        self.sound.setChecked(settings.pose_reset_sound)
        self.tap = QCheckBox(self.tr("&Double tap on the back of the glove"))
        self.tap.setToolTip(self.tr("Two quick taps, with the hand at rest before and after"))
        self.tap.setChecked(settings.pose_reset_tap)
        words = QLabel(
            self.tr(
                "Hold the hand flat and level, fingers straight ahead. The reset aligns the "
                "finger joints with that pose, and without a camera the heading, too."
            )
        )
        words.setWordWrap(True)
        self.problem = QLabel()
        self.problem.setWordWrap(True)
        self.save = QPushButton(self.tr("&Save"))
        self.save.clicked.connect(self._save)
        form = QFormLayout()
        form.addRow(labelled(self.tr("&Key"), self.key), self.key)
        form.addRow(labelled(self.tr("&Countdown"), self.countdown), self.countdown)
        form.addRow(self.sound)
        form.addRow(self.tap)
        self.lay_out((words, form, self.problem, filler()), self.save)

    def _save(self) -> None:
        key = self.key.keySequence().toString()
        user = self._user_of(key) if key else ""
        if user:
            words = self.tr("{} is already assigned to “{}”. Choose another key.")
            self.problem.setText(words.format(key, user))
            return
        self._store.update(
            pose_reset_key=key,
            pose_reset_countdown=self.countdown.value(),
            pose_reset_sound=self.sound.isChecked(),
            pose_reset_tap=self.tap.isChecked(),
        )
        self.saved.emit()
        self.close()
