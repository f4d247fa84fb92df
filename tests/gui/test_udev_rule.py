"""The udev rule is shown where opening is denied, copied, and installed through pkexec."""

from __future__ import annotations

from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QPushButton

from app.window import doctor
from app.window.doctor import DoctorDialog
from app.window.udev_rule import TARGET, UdevRuleDialog, rule_text
from app.words import notice_text
from tracker.base.notices import failure, notice
from tracker.doctor.finding import Check, Finding
from tracker.doctor.permissions import RULES
from tracker.sensors.link_faults import not_opened


@pytest.fixture
def pkexec(tmp_path, monkeypatch) -> Path:
    """A fake that writes its arguments to ``asked``, and exits with the content of ``status``."""
    folder = tmp_path / "bin"
    folder.mkdir()
    fake = folder / "pkexec"
    (tmp_path / "status").write_text("0")
    fake.write_text(
        f'#!/bin/sh\nprintf "%s\\n" "$@" > {tmp_path}/asked\n'
        f'cp "$5" {tmp_path}/copied\nexit "$(cat {tmp_path}/status)"\n'
    )
    fake.chmod(0o755)
    monkeypatch.setenv("PATH", str(folder), prepend=":")
    return tmp_path


def click(qtbot, button) -> None:
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)


def test_a_denied_port_offers_the_rule_and_installs_it_when_asked(window, qtbot, pkexec):
    window.sources.show_device_message(notice_text(not_opened(PermissionError(13, "denied"))))
    offered = [b for b in window.messages.findChildren(QPushButton) if "rule" in b.text()]
    click(qtbot, offered[0])
    dialog = window.findChild(UdevRuleDialog)
    assert dialog.text.toPlainText() == rule_text()
    click(qtbot, dialog.copy)
    assert QGuiApplication.clipboard().text() == rule_text()
    assert not (pkexec / "asked").exists()  # never silently
    (pkexec / "status").write_text("126")  # the password dialog was closed
    click(qtbot, dialog.install)
    refused = notice_text(notice("doctor.rule_not_authorized"))
    qtbot.waitUntil(lambda: dialog.state.text() == refused)
    (pkexec / "status").write_text("0")
    click(qtbot, dialog.install)
    qtbot.waitUntil(lambda: "is installed" in dialog.state.text())
    asked = (pkexec / "asked").read_text().splitlines()
    assert asked[:2] == ["sh", "-c"] and asked[-1] == TARGET and "udevadm" in asked[2]
    assert (pkexec / "copied").read_text() == rule_text()
    dialog.close()


def test_the_doctor_offers_the_rule_where_it_is_a_remedy(window, qtbot, monkeypatch, tmp_path):
    monkeypatch.setenv("PATH", str(tmp_path))  # without pkexec
    remedy = notice("doctor.join_group", group="dialout", rule=RULES)
    refused = [Finding(failure("doctor.refused", device="/dev/ttyUSB0"), remedy)]
    check, examine = Check("a", "A", lambda machine: refused), doctor.examine
    monkeypatch.setattr(doctor, "examine", lambda machine: examine(machine, [check]))
    window.run_command("doctor")
    dialog = window.findChild(DoctorDialog)
    qtbot.waitUntil(dialog.save.isEnabled)
    click(qtbot, dialog.rule)
    shown = dialog.findChild(UdevRuleDialog)
    assert not shown.install.isEnabled()
    assert shown.state.text() == notice_text(notice("doctor.no_pkexec", target=TARGET))
