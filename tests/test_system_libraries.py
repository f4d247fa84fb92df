"""The script that finds missing system packages, on pretended machines."""

from __future__ import annotations

import os
import shutil
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
    """Stand-ins for ldconfig, id and apt-get, first in PATH; apt-get logs its arguments."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.asked = folder / "asked"
        self.command("apt-get", f'echo "$@" >>{self.asked}')
        self.rest: str | Path = os.environ["PATH"]
        # A font, so that this machine's own fonts do not matter.
        (folder / ".fonts").mkdir()
        (folder / ".fonts" / "some.ttf").touch()

    def command(self, name: str, body: str) -> None:
        path = self.folder / name
        path.write_text(f"#!/bin/sh\n{body}\n")
        path.chmod(0o755)

    def without_compilers(self) -> None:
        """Reduces PATH to the tools that the script itself uses."""
        self.rest = self.folder / "tools"
        self.rest.mkdir()
        for tool in ("bash", "find", "grep", "sh", "sort"):
            (self.rest / tool).symlink_to(shutil.which(tool) or tool)

    def run(
        self, libraries: tuple[str, ...], user: int, *groups: str
    ) -> subprocess.CompletedProcess[str]:
        self.command("ldconfig", "\n".join(f"echo '\t{name} (libc6) => x'" for name in libraries))
        self.command("id", f"echo {user}")
        environment = {"PATH": f"{self.folder}:{self.rest}", "HOME": str(self.folder)}
        return subprocess.run(
            [SCRIPT, *groups], env=environment, capture_output=True, text=True, check=False
        )


@pytest.fixture
def machine(tmp_path: Path) -> Machine:
    return Machine(tmp_path)


def test_without_rights_the_command_to_run_is_printed_and_the_check_fails(machine: Machine) -> None:
    done = machine.run(ESSENTIAL[1:], 1000)
    assert done.returncode == 1
    line = done.stderr.splitlines()[-1].split()
    assert line[:5] == ["sudo", "apt-get", "update", "&&", "sudo"]
    assert "libegl1" in line
    assert "libgl1" not in line
    assert not machine.asked.exists()


def test_commands_work_without_the_windows_libraries(machine: Machine) -> None:
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


def test_the_firmware_tests_name_their_packages_and_do_not_stop_a_user(machine: Machine) -> None:
    machine.without_compilers()
    done = machine.run(ESSENTIAL, 1000, "firmware-tests")
    assert done.returncode == 0
    assert "are skipped without them" in done.stderr
    assert {"gcc-avr", "avrdude", "gcc"} <= set(done.stderr.splitlines()[-1].split())


def test_root_gets_the_packages_of_the_firmware_tests(machine: Machine) -> None:
    machine.without_compilers()
    machine.run(ESSENTIAL, 0, "app", "firmware-tests")
    packages = machine.asked.read_text().splitlines()[-1].split()
    assert {"gcc-avr", "avrdude", "gcc"} <= set(packages)


def test_the_openxr_layer_needs_a_compiler_and_headers_and_its_tests_a_loader(
    machine: Machine,
) -> None:
    machine.without_compilers()
    assert machine.run(ESSENTIAL, 1000, "openxr").returncode == 1
    done = machine.run(ESSENTIAL, 1000, "openxr-tests")
    assert done.returncode == 0 and "libopenxr-loader1" in done.stderr


def test_an_unknown_group_is_wrong_usage(machine: Machine) -> None:
    assert machine.run(ESSENTIAL, 1000, "kitchen").returncode == 2
