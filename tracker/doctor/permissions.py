"""Whether this user may open serial ports and cameras (Linux)."""

from __future__ import annotations

from collections.abc import Iterator

from tracker.doctor.finding import Finding, error, ok, warning
from tracker.doctor.machine import Machine

RULES = "70-glovetrack.rules"
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
        again = "Unplug the device, then plug it in again." if has_rules else ""
        yield error(
            f"This user may not open {path}.",
            again
            or f"Add yourself to the group {group} (sudo usermod -aG {group} $USER) and log in "
            f"again, or install the udev rule {RULES} of the package.",
        )
    if devices and not refused:
        yield ok(f"This user may open all {len(devices)} device files.")
    if not has_rules:
        yield from _missing_rules(bool(devices), bool(refused))


def _missing_rules(has_devices: bool, has_refused: bool) -> Iterator[Finding]:
    """Without the rule, the adapter's latency timer stays at 16 ms after each reconnection."""
    if has_devices and not has_refused:
        yield warning(
            f"The udev rule {RULES} is not installed.",
            "Install the package, or copy the rule to /etc/udev/rules.d: it gives access to new "
            "devices and sets the latency timer of USB adapters.",
        )
