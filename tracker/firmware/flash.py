"""Writes firmware into a glove through its bootloader, with avrdude, and has it read back.

avrdude verifies what it wrote by itself and fails where a byte differs.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path

from tracker.base.errors import GlovetrackError
from tracker.firmware.image import FirmwareImage

BOOTLOADERS = {"Optiboot": 115_200, "old Nano": 57_600}
"""Speeds (baud) at which bootloaders of Arduino boards are spoken to."""

PATIENCE = 90.0  # s for all of it; 7 kB take about 4 s at 57600 baud, and as long to read back

WORDS = (
    ("programmer is not responding", "The board does not answer as a bootloader"),
    ("not in sync", "The board does not answer as a bootloader"),
    ("Permission denied", "You may not open the port (on Linux: join the group dialout)"),
    ("Device or resource busy", "Another program uses the port"),
    ("No such file or directory", "Nothing is plugged in at the port"),
    ("verification mismatch", "What was read back is not what was written"),
    ("content mismatch", "What was read back is not what was written"),
    ("signature", "The chip is not an ATmega328P"),
)
"""What avrdude prints, and what it means; the first that is found."""


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
        FlashError: avrdude is missing or failed; what it said is in the message.
    """
    program = avrdude_path()
    if program is None:
        raise FlashError(
            "avrdude writes the firmware, and it is not installed. On Debian: "
            "sudo apt-get install avrdude; on other systems see github.com/avrdudes/avrdude."
        )
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
                timeout=PATIENCE,
                check=False,
            )
        except subprocess.TimeoutExpired as error:
            raise FlashError(_words(WORDS[0][0], job)) from error
    if done.returncode != 0:
        raise FlashError(_words(done.stderr + done.stdout, job))


def _words(said: str, job: FlashJob) -> str:
    meaning = next((words for sign, words in WORDS if sign in said), "avrdude failed")
    hint = ""
    if "as a bootloader" in meaning:
        others = [name for name, baud in BOOTLOADERS.items() if baud != job.bootloader_baud]
        hint = f" Try the other kind ({', '.join(others)}), and press reset just before."
    lines = [line.strip() for line in said.splitlines() if line.strip()]
    said_by = next((x for x in lines if any(sign in x for sign, _ in WORDS)), "")
    told = f" (avrdude: {said_by or (lines[-1] if lines else 'nothing')})"
    return f"{job.port}: {meaning}.{hint}{told}"
