"""The udev rule that gives the person at the screen access to gloves and cameras (Linux)."""

from __future__ import annotations

import shutil
import subprocess
from importlib.resources import as_file

from resources import folder
from tracker.base.errors import DeviceError
from tracker.base.notices import notice
from tracker.doctor.permissions import RULES

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
