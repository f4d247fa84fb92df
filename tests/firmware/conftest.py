"""Builds the firmware and its simulator, once per speed of the port."""

from __future__ import annotations

import os
import shutil
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

FIRMWARE = Path(__file__).parents[2] / "resources" / "firmware"
NEEDED = {
    "gcc-avr": lambda: shutil.which("avr-gcc"),
    "avr-libc": lambda: Path("/usr/lib/avr/include/avr/io.h").exists(),
    "libsimavr-dev": lambda: Path("/usr/include/simavr/sim_avr.h").exists(),
    "libelf-dev": lambda: Path("/usr/include/libelf.h").exists(),
    "make": lambda: shutil.which("make"),
    "gcc": lambda: shutil.which("cc"),
}


@pytest.fixture(scope="session")
def build_firmware(tmp_path_factory: pytest.TempPathFactory) -> Callable[[int], Path]:
    """baud -> the folder of that build."""
    missing = [package for package, there in NEEDED.items() if not there()]
    if missing:
        reason = f"needs {', '.join(missing)}: `make test` as root installs them"
        # A continuous-integration run that skips these tests would not show that they fail.
        (pytest.fail if os.environ.get("CI") == "true" else pytest.skip)(reason)
    built: dict[int, Path] = {}

    def build(baud: int) -> Path:
        if baud not in built:
            folder = tmp_path_factory.mktemp(f"firmware{baud}")
            subprocess.run(
                [
                    "make",
                    "-s",
                    "-C",
                    str(FIRMWARE),
                    f"BUILD={folder}",
                    f"BAUD={baud}",
                    "GLOVE_ID=7",
                ],
                check=True,
            )
            built[baud] = folder
        return built[baud]

    return build


@pytest.fixture(scope="session")
def build(build_firmware: Callable[[int], Path]) -> Path:
    """The folder of the build for 250000 baud."""
    return build_firmware(250_000)
