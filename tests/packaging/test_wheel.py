"""The wheel that `pip install .` makes: it has the program and its resources, and nothing else."""

from __future__ import annotations

import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
KINDS = (".toml", ".svg", ".png")
"""Resources that the program reads."""


def tracked(*folders: str) -> list[str]:
    if not (ROOT / ".git").exists() or shutil.which("git") is None:
        pytest.skip("needs a git checkout")
    listed = subprocess.run(
        ["git", "ls-files", *folders], cwd=ROOT, capture_output=True, text=True, check=True
    )
    return [name for name in listed.stdout.splitlines() if (ROOT / name).is_file()]


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> zipfile.ZipFile:
    source, target = tmp_path_factory.mktemp("source"), tmp_path_factory.mktemp("wheel")
    for name in tracked("app", "tracker", "resources", "pyproject.toml", "README.md", "LICENSE"):
        (source / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / name, source / name)
    build = "import sys, setuptools.build_meta as b; print(b.build_wheel(sys.argv[1]))"
    made = subprocess.run(
        [sys.executable, "-c", build, str(target)], cwd=source, capture_output=True, text=True
    )
    assert made.returncode == 0, made.stderr
    return zipfile.ZipFile(next(target.glob("*.whl")))


def test_it_has_every_module_and_every_resource(wheel: zipfile.ZipFile) -> None:
    wanted = {n for n in tracked("app", "tracker") if n.endswith(".py")}
    wanted |= {n for n in tracked("resources") if n.endswith(KINDS)}
    assert wanted <= set(wheel.namelist())


def test_what_the_engine_reads_beside_its_modules_is_there(wheel: zipfile.ZipFile) -> None:
    data = {n for n in tracked("app", "tracker") if not n.endswith((".py", ".md"))}
    assert data <= set(wheel.namelist())


def test_nothing_else_is_installed(wheel: zipfile.ZipFile) -> None:
    tops = {name.partition("/")[0] for name in wheel.namelist()}
    assert {t for t in tops if not t.endswith(".dist-info")} == {"app", "tracker", "resources"}


def test_the_command_and_the_licence_travel_along(wheel: zipfile.ZipFile) -> None:
    (entries,) = (n for n in wheel.namelist() if n.endswith("/entry_points.txt"))
    assert "glovetrack = app.__main__:main" in wheel.read(entries).decode()
    assert any(n.endswith("/licenses/LICENSE") for n in wheel.namelist())
