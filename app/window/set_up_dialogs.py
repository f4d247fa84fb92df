"""Opens the set-up dialogs and applies their results."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtWidgets import QDialog, QWidget

from app.engines.engine_host import EngineHost
from app.platform.tasks import TaskOwner
from app.storage.settings import SettingsStore
from app.window import theme
from app.wizards.camera import CameraSetup
from app.wizards.firmware import FirmwareSetup
from app.words import error_text
from tracker.base.errors import ConfigError, GlovetrackError
from tracker.calibration.stereo.board import BoardSpec
from tracker.calibration.stereo.files import load_rig
from tracker.calibration.still import StillPose
from tracker.engine.kinds import learns_wearer
from tracker.fusion.wearer_learning import take_gyro_bias
from tracker.glove import library
from tracker.sensors.camera_controls import Locks, locks_text
from tracker.sensors.camera_plugins import all_cameras
from tracker.sensors.image_input import CameraName

if TYPE_CHECKING:
    from app.wizards.stereo.wizard import StereoWizard

from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import (
    QCheckBox,
    QFormLayout,
    QKeySequenceEdit,
    QLabel,
    QPushButton,
    QSpinBox,
)

from app.wizards.form_dialog import FormDialog, filler, labelled


class SetUpDialogs(QObject):
    """At most one dialog of each kind is open; ``restart`` asks to open glove and camera again."""

    error = Signal(str)
    restart = Signal()
    reopen = Signal()  # the devices or the demo that are open, with changed files
    changed = Signal()  # stored data of the devices
    learned = Signal()  # from guided poses, to be saved
    pose_reset_changed = Signal()  # its settings

    def __init__(
        self, host: EngineHost, store: SettingsStore, tasks: TaskOwner, window: QWidget
    ) -> None:
        super().__init__(window)
        self._host, self._store, self._tasks = host, store, tasks
        self._window = window
        self.dialogs: dict[str, QDialog] = {}

    # --- stereo calibration

    def open_stereo(self) -> None:
        """Open the camera calibration, once the cameras are listed in the background."""
        if not self._raise("stereo"):
            self._tasks.run(
                self.tr("Looking for cameras"), lambda _progress: all_cameras(), self._open_stereo
            )

    def _open_stereo(self, cameras: list[CameraName]) -> None:
        if self._raise("stereo"):
            return
        from app.wizards.stereo.image_choices import image_choices  # deferred: loads every engine
        from app.wizards.stereo.wizard import StereoWizard  # deferred: with the line above

        wizard = StereoWizard(
            self._tasks,
            image_choices(self._host, self._store.value, cameras),
            library.user_folder("cameras"),
            board_from(self._store.value.board),
            self._window,
        )
        self.show_stereo(wizard)

    def show_stereo(self, wizard: StereoWizard) -> None:
        """Show it, and use its results."""
        wizard.finished_with.connect(self._calibrated)
        wizard.board_used.connect(lambda spec: self._store.update(board=board_text(spec)))
        self.show_dialog("stereo", wizard)

    def _calibrated(self, path: Path, real: bool) -> None:
        """Use the calibration, unless it is of the simulated camera."""
        if real and self.set_calibration(path):
            self._restart_devices()

    def set_calibration(self, path: Path) -> bool:
        """Store the camera's calibration file if it can be read; returns whether it can."""
        try:
            load_rig(path)
        except GlovetrackError as error:
            self.error.emit(error_text(error))
            return False
        self._store.update(calibration=str(path))
        self.changed.emit()
        return True

    # --- glove

    def open_glove(self) -> None:
        """Open the glove set-up: port, files, biases at rest, wiggle test."""
        if self._raise("glove"):
            return
        from app.wizards.glove.wizard import GloveSetup  # deferred: takes 0.1 s

        dialog = GloveSetup(self._host, self._store, self._tasks, self._window)
        dialog.chosen.connect(self._restart_devices)
        dialog.measured.connect(self.take_bias)
        self.show_dialog("glove", dialog)

    def open_firmware(self) -> None:
        """Open the firmware dialog: versions, and flashing."""
        if not self._raise("firmware"):
            self.show_dialog("firmware", FirmwareSetup(self._host, self._tasks, self._window))

    def take_bias(self, pose: StillPose) -> None:
        """Give the measured gyro biases to the engine, if it estimates them."""
        bias = np.array([i.gyro_bias for i in pose.imus])
        sd = np.array([i.gyro_bias_sd for i in pose.imus])
        self._host.command(partial(take_gyro_bias, bias=bias, sd=sd))

    # --- camera

    def open_camera(self) -> None:
        """Open the camera set-up: which camera, and which of its controls are locked."""
        if self._raise("camera"):
            return
        dialog = CameraSetup(self._host, self._store, self._tasks, self._window)
        dialog.chosen.connect(self._restart_devices)
        self.show_dialog("camera", dialog)

    def lock_camera(self) -> None:
        """Lock the values that the camera's automatic controls have now."""
        setup = self._host.setup
        if setup is None or setup.camera.controls is None:
            return
        found = {c.name: c.value for c in setup.camera.controls.controls() if c.available}
        self._store.update(camera_locks=locks_text(Locks(**found)))
        setup.camera.controls.request_locks(Locks(**found))

    # --- the wearer

    def open_guided(self) -> None:
        """Open the guided calibration, in which the wearer holds poses."""
        setup = self._host.setup
        if self._raise("guided") or setup is None or setup.live is None or not self._host.running:
            return
        if not learns_wearer(self._store.value.engine):
            self.error.emit(
                self.tr("Only the engine chain learns from poses. Choose it in the Tracking menu.")
            )
            return
        from app.wizards.guided.dialog import GuidedDialog  # deferred: loads SciPy

        scene = theme.colours(self._store.value.theme).scene
        dialog = GuidedDialog(self._host, setup, setup.live, self._store, scene, self._window)
        dialog.kept.connect(self.learned)
        self.show_dialog("guided", dialog)

    def open_positions(self) -> None:
        """Open the guided measurement of the axes of the glove's IMUs."""
        setup = self._host.setup
        if self._raise("imu_positions") or setup is None or not self._host.running:
            return
        if setup.live is None or not setup.connection.present:
            return
        from app.wizards.positions import PositionsDialog  # deferred: loads SciPy

        scene = theme.colours(self._store.value.theme).scene
        dialog = PositionsDialog(self._host, setup, self._store, self._tasks, scene, self._window)
        dialog.saved.connect(self.reopen)
        self.show_dialog("imu_positions", dialog)

    def open_pose_reset(self, user_of: Callable[[str], str]) -> None:
        """Key, countdown, sound and double tap; ``user_of`` names the command that uses a key."""
        if self._raise("pose_reset"):
            return
        dialog = PoseResetSettings(self._store, user_of, self._window)
        dialog.saved.connect(self.pose_reset_changed)
        self.show_dialog("pose_reset", dialog)

    # --- all

    def _restart_devices(self) -> None:
        """Open the chosen devices, unless the demo or a session is open."""
        setup = self._host.setup
        self.changed.emit()
        if setup is None or (not setup.simulated and setup.player is None):
            self.restart.emit()

    def _raise(self, name: str) -> bool:
        dialog = self.dialogs.get(name)
        if dialog is None:
            return False
        dialog.raise_()
        dialog.activateWindow()
        return True

    def show_once(self, name: str, make: Callable[[], QDialog]) -> None:
        """Make and show a dialog, or bring the open one of that name to the front."""
        if not self._raise(name):
            self.show_dialog(name, make())

    def show_dialog(self, name: str, dialog: QDialog) -> None:
        """Show a dialog until it, or the window, is closed."""
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.dialogs[name] = dialog
        dialog.finished.connect(lambda _result: self.dialogs.pop(name, None))
        dialog.show()

    def shut_down(self) -> None:
        """Close all open dialogs; their jobs end with the window's."""
        for dialog in list(self.dialogs.values()):
            dialog.close()
            if dialog.isVisible():  # it ignored the close
                dialog.done(int(QDialog.DialogCode.Rejected))


def board_text(spec: BoardSpec) -> str:
    """The text for the settings."""
    return f"{spec.kind} {spec.columns} {spec.rows} {spec.square!r}"


def board_from(text: str) -> BoardSpec:
    """The board of the settings; the default where there is none, or an invalid one."""
    try:
        kind, columns, rows, square = text.split()
        return BoardSpec(kind, int(columns), int(rows), float(square))
    except (ValueError, ConfigError):
        return BoardSpec()


# ---- settings of the pose reset: its key, countdown and sound, and the double tap

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
