"""Published metadata are consistent, and users' tools can install from an index."""

from __future__ import annotations

import re
import subprocess
import sys
import tomllib
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from tests.packaging.local_index import add_requirements, build, served, user_environment

pytestmark = pytest.mark.long

ROOT = Path(__file__).parents[2]


def project() -> dict[str, Any]:
    return tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]


def test_addresses_version_and_descriptions_agree() -> None:
    site = (ROOT / "mkdocs.yml").read_text("utf-8")
    citation = (ROOT / "CITATION.cff").read_text("utf-8")
    project_data, declared = project(), project()["urls"]
    assert f"site_url: {declared['Documentation']}\n" in site
    assert f"site_description: {project_data['description']}\n" in site
    for line in (
        f"title: {project_data['name'].title()}",
        f"abstract: {project_data['description']}",
        f"  - name: {project_data['authors'][0]['name']}",
        f"version: {project_data['version']}",
        f"license: {project_data['license']}",
        f"url: {declared['Homepage']}",
    ):
        assert line in citation.splitlines()
    (words,) = re.findall(r"^keywords:\n((?:  - .+\n)+)", citation, re.MULTILINE)
    assert [w.removeprefix("  - ") for w in words.splitlines()] == project_data["keywords"]


@pytest.fixture(scope="module")
def index(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """The address of an index with this program's wheel, including the kernels compiled here."""
    simple = tmp_path_factory.mktemp("index") / "simple"
    simple.mkdir()
    build("build_wheel", ROOT, simple / "glovetrack")
    add_requirements(simple)
    with served(simple.parent) as address:
        yield f"{address}simple/"


def run(environment: dict[str, str], *words: str | Path, cwd: Path) -> str:
    done = subprocess.run(
        [str(word) for word in words], cwd=cwd, env=environment, capture_output=True, text=True
    )
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


def test_pipx_installs_the_program(index: str, tmp_path: Path) -> None:
    pytest.importorskip("pipx")
    environment = user_environment(tmp_path, index)
    pipx = (sys.executable, "-m", "pipx", "install", "--python", sys.executable)
    run(environment, *pipx, "--pip-args=--no-compile", "glovetrack", cwd=tmp_path)
    program = tmp_path / "bin" / "glovetrack"
    assert (
        run(environment, program, "--version", cwd=tmp_path)
        == f"glovetrack {project()['version']}\n"
    )


@pytest.mark.timeout(300)
def test_uvx_runs_the_demo(index: str, tmp_path: Path) -> None:
    """Which simulates, tracks, records and exports by the installed program."""
    uv = pytest.importorskip("uv").find_uv_bin()
    environment, out = user_environment(tmp_path, index), tmp_path / "demo"
    demo = ("demo", "--lenses", "none", "--headless-report", "1", "--out", out)
    uvx = (uv, "tool", "run", "--python", sys.executable, "glovetrack")
    assert "estimates" in run(environment, *uvx, *demo, cwd=tmp_path)
    assert {"session.mcap", "session.csv", "window.png"} <= {p.name for p in out.iterdir()}
