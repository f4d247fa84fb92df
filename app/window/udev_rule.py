"""Shows the udev rule for gloves and cameras, copies it, and installs it on request."""

from __future__ import annotations

import shutil
import subprocess
from importlib.resources import as_file

from PySide6.QtCore import Qt
from PySide6.QtGui import QFontDatabase, QGuiApplication
from PySide6.QtWidgets import (
    QDialog,
    QDialogButtonBox,
    QLabel,
    QPlainTextEdit,
    QVBoxLayout,
    QWidget,
)

from app.platform.tasks import JobProgress, TaskOwner
from app.words import notice_text
from resources import folder
from tracker.base.errors import DeviceError
from tracker.base.notices import notice
from tracker.doctor.permissions import RULES

SIZE = (760, 420)


def show_rule(tasks: TaskOwner, parent: QWidget) -> UdevRuleDialog:
    """Open the dialog."""
    dialog = UdevRuleDialog(tasks, parent)
    dialog.show()
    return dialog


class UdevRuleDialog(QDialog):
    """Nothing is changed before *Install…* is chosen; the system then asks for a password."""

    def __init__(self, tasks: TaskOwner, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(self.tr("Access to gloves and cameras"))
        self.setObjectName("udev_rule")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.resize(*SIZE)
        self._tasks = tasks
        words = QLabel(
            self.tr(
                "With this udev rule, the person at the screen may use USB serial adapters and "
                "cameras. It belongs in {}."
            ).format(TARGET)
        )
        words.setWordWrap(True)
        self.text = QPlainTextEdit(rule_text())
        self.text.setReadOnly(True)
        self.text.setFont(QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont))
        self.text.setAccessibleName(self.tr("The udev rule"))
        self.state = QLabel()
        self.state.setWordWrap(True)
        self._make_buttons()
        column = QVBoxLayout(self)
        for widget in (words, self.text, self.state, self.buttons):
            column.addWidget(widget)
        if not can_install():
            self.install.setEnabled(False)
            self.state.setText(notice_text(notice("doctor.no_pkexec", target=TARGET)))

    def _make_buttons(self) -> None:
        self.buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close)
        action = QDialogButtonBox.ButtonRole.ActionRole
        self.copy = self.buttons.addButton(self.tr("&Copy"), action)
        self.install = self.buttons.addButton(self.tr("&Install…"), action)
        self.install.setToolTip(self.tr("The system asks for an administrator's password"))
        self.copy.clicked.connect(self._copy)
        self.install.clicked.connect(self._install)
        self.buttons.rejected.connect(self.close)

    def _copy(self) -> None:
        QGuiApplication.clipboard().setText(self.text.toPlainText())
        self.state.setText(self.tr("The rule is in the clipboard."))

    def _install(self) -> None:
        self.install.setEnabled(False)
        self.state.setText(self.tr("Waiting for the administrator's password…"))

        def job(_progress: JobProgress) -> None:
            install_rule()

        title = self.tr("Installing the udev rule")
        self._tasks.run(title, job, self._installed, failed=self._failed)

    def _installed(self, _result: object) -> None:
        self.state.setText(
            self.tr("The rule is installed. Unplug the devices, then plug them in again.")
        )

    def _failed(self, why: str) -> None:
        self.state.setText(why)
        self.install.setEnabled(True)


# ---- the udev rule that gives the person at the screen access to gloves and cameras (Linux)

TARGET = f"/etc/udev/rules.d/{RULES}"
PKEXEC = "pkexec"
DISMISSED = (126, 127)
"""Exit statuses of pkexec without an authorization."""
SCRIPT = 'install -m 644 "$1" "$2" && udevadm control --reload && udevadm trigger'


def rule_text() -> str:
    """The text of the rule."""
    return (folder("udev") / RULES).read_text("utf-8")


def can_install() -> bool:
    """Whether pkexec is there, which asks for the administrator's password."""
    return shutil.which(PKEXEC) is not None


def install_rule() -> None:
    """Install the rule after pkexec has asked for a password.

    Raises DeviceError if that is impossible or was refused.
    """
    path = shutil.which(PKEXEC)
    if path is None:
        raise DeviceError(notice("doctor.no_pkexec", target=TARGET))
    with as_file(folder("udev") / RULES) as rule:
        command = [path, "sh", "-c", SCRIPT, "sh", str(rule.resolve()), TARGET]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode in DISMISSED:
        raise DeviceError(notice("doctor.rule_not_authorized"))
    if done.returncode != 0:
        why = done.stderr.strip() or f"exit status {done.returncode}"
        raise DeviceError(notice("doctor.rule_failed", why=why))
