"""The script that finds missing system packages, on pretended machines."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[1] / "packaging" / "system_libraries.sh"
ESSENTIAL = (
    *("libEGL.so.1", "libEGL_mesa.so.0", "libGL.so.1", "libGLX_mesa.so.0", "libX11.so.6"),
    *("libdbus-1.so.3", "libfontconfig.so.1", "libglib-2.0.so.0", "libstdc++.so.6"),
    "libxkbcommon.so.0",
)


class Machine:
    """Stand-ins for ldconfig, id and apt-get, first in PATH; apt-get notes what it is told."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.asked = folder / "asked"
        self.command("apt-get", f'echo "$@" >>{self.asked}')
        # A font, so that the pages of this machine's own do not matter.
        (folder / ".fonts").mkdir()
        (folder / ".fonts" / "some.ttf").touch()

    def command(self, name: str, body: str) -> None:
        path = self.folder / name
        path.write_text(f"#!/bin/sh\n{body}\n")
        path.chmod(0o755)

    def run(
        self, libraries: tuple[str, ...], user: int, *groups: str
    ) -> subprocess.CompletedProcess[str]:
        self.command("ldconfig", "\n".join(f"echo '\t{name} (libc6) => x'" for name in libraries))
        self.command("id", f"echo {user}")
        environment = {"PATH": f"{self.folder}:{os.environ['PATH']}", "HOME": str(self.folder)}
        return subprocess.run(
            [SCRIPT, *groups], env=environment, capture_output=True, text=True, check=False
        )


@pytest.fixture
def machine(tmp_path: Path) -> Machine:
    return Machine(tmp_path)


def test_a_user_is_told_the_line_to_run_and_cannot_go_on(machine: Machine) -> None:
    done = machine.run(ESSENTIAL[1:], 1000)
    assert done.returncode == 1
    line = done.stderr.splitlines()[-1].split()
    assert line[:5] == ["sudo", "apt-get", "update", "&&", "sudo"]
    assert "libegl1" in line
    assert "libgl1" not in line
    assert not machine.asked.exists()


def test_without_what_only_a_window_needs_work_goes_on(machine: Machine) -> None:
    done = machine.run(ESSENTIAL, 1000)
    assert done.returncode == 0
    assert "libxcb-cursor0" in done.stderr
    assert "libegl1" not in done.stderr


def test_root_gets_what_is_missing_and_no_more(machine: Machine) -> None:
    machine.run(ESSENTIAL[:-1], 0)
    update, install = machine.asked.read_text().splitlines()
    assert update.startswith("update")
    assert install.startswith("install -y")
    assert "libxkbcommon0" in install.split()
    assert not {"libegl1", "libgl1", "fonts-dejavu-core"} & set(install.split())


def test_an_installation_in_vain_is_a_failure(machine: Machine) -> None:
    machine.command("apt-get", "exit 100")
    done = machine.run((), 0)
    assert done.returncode == 1
    assert "libegl1" in done.stderr


def test_an_unknown_group_is_wrong_usage(machine: Machine) -> None:
    assert machine.run(ESSENTIAL, 1000, "kitchen").returncode == 2
