"""Writes firmware into a glove through its bootloader, with avrdude, and has it read back.

avrdude verifies what it wrote and fails if a byte differs.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

from tracker.base.errors import GlovetrackError
from tracker.base.notices import Notice, Severity, notice
from tracker.firmware.image import FirmwareImage

BOOTLOADERS = {"Optiboot": 115_200, "old Nano": 57_600}
"""Speeds (baud) at which bootloaders of Arduino boards are spoken to."""

TIMEOUT = 90.0  # s for all of it; 7 kB take about 4 s at 57600 baud, and as long to read back

NO_BOOTLOADER = "firmware.no_bootloader"
MEANINGS = (
    ("programmer is not responding", NO_BOOTLOADER),
    ("not in sync", NO_BOOTLOADER),
    ("Permission denied", "firmware.port_denied"),
    ("Device or resource busy", "firmware.port_busy"),
    ("No such file or directory", "firmware.port_absent"),
    ("verification mismatch", "firmware.not_verified"),
    ("content mismatch", "firmware.not_verified"),
    ("signature", "firmware.wrong_chip"),
)
"""What avrdude prints, and the code of the notice for it; the first that is found."""


class FlashError(GlovetrackError):
    """The firmware could not be written, or not as it should be."""


@dataclass(frozen=True)
class FlashJob:
    """An image for a port, spoken to at the bootloader's speed (baud)."""

    image: FirmwareImage
    port: str
    bootloader_baud: int = BOOTLOADERS["Optiboot"]


def avrdude_path() -> str | None:
    """Where avrdude is, None where it is not installed."""
    return shutil.which("avrdude")


def flash(job: FlashJob) -> None:
    """Write and verify; takes some seconds.

    Raises:
        FlashError: avrdude is missing or failed; the message contains its output.
    """
    program = avrdude_path()
    if program is None:
        raise FlashError(notice("firmware.no_avrdude"))
    with tempfile.TemporaryDirectory(prefix="glovetrack-firmware-") as folder:
        path = Path(folder) / "glove.hex"
        path.write_text(job.image.to_hex(), encoding="ascii")
        command = [
            program, "-q", "-p", "atmega328p", "-c", "arduino", "-P", job.port,
            "-b", str(job.bootloader_baud), "-D", "-U", f"flash:w:{path}:i",
        ]  # fmt: skip
        try:
            done = subprocess.run(
                command,
                stdin=subprocess.DEVNULL,
                capture_output=True,
                text=True,
                errors="replace",
                env=os.environ | {"LC_ALL": "C"},
                timeout=TIMEOUT,
                check=False,
            )
        except subprocess.TimeoutExpired as error:
            raise FlashError(_failed(MEANINGS[0][0], job)) from error
    if done.returncode != 0:
        raise FlashError(_failed(done.stderr + done.stdout, job))


def _failed(output: str, job: FlashJob) -> Notice:
    """What avrdude's output means, with the line that shows it."""
    lines = [line.strip() for line in output.splitlines() if line.strip()]
    signs = dict(MEANINGS)
    shown = next((x for x in lines if any(sign in x for sign in signs)), "")
    line = shown or (lines[-1] if lines else "")
    code = next((code for sign, code in MEANINGS if sign in output), "firmware.flash_failed")
    values: dict[str, object] = {"port": job.port, "output": line}
    if code == NO_BOOTLOADER:
        speeds = BOOTLOADERS.items()
        values["others"] = [name for name, baud in speeds if baud != job.bootloader_baud]
    return Notice(code, Severity.ERROR, values)
