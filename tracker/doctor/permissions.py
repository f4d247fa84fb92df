"""Whether this user may open serial ports and cameras (Linux)."""

from __future__ import annotations

from collections.abc import Iterator

from tracker.base.notices import failure, notice, warning
from tracker.doctor.finding import Finding
from tracker.doctor.machine import Machine

RULES = "70-glovetrack.rules"
RULE_REMEDIES = ("doctor.join_group", "doctor.install_rule")
"""Codes of remedies that the rule is one of."""
RULE_FOLDERS = ("etc/udev/rules.d", "usr/lib/udev/rules.d", "lib/udev/rules.d")


def permissions(machine: Machine) -> Iterator[Finding]:
    """One finding per device file that this user may not open; one if all may be."""
    if not machine.is_linux:
        return
    has_rules = any((machine.root / folder / RULES).is_file() for folder in RULE_FOLDERS)
    devices = [(port.path, "dialout") for port in machine.usb_ports()]
    devices += [(str(path), "video") for path in sorted((machine.root / "dev").glob("video[0-9]*"))]
    refused = [(path, group) for path, group in devices if not machine.is_accessible(path)]
    for path, group in refused:
        remedy = notice("doctor.replug")
        if not has_rules:
            remedy = notice("doctor.join_group", group=group, rule=RULES)
        yield Finding(failure("doctor.refused", device=path), remedy)
    if devices and not refused:
        yield Finding(notice("doctor.allowed", devices=len(devices)))
        if not has_rules:  # the latency timer is 16 ms after each reconnection
            absent = warning("doctor.no_rule", rule=RULES)
            yield Finding(absent, notice("doctor.install_rule"))
