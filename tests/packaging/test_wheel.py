"""The source distribution, and the wheel: the program and its resources under one name."""

from __future__ import annotations

import ast
import configparser
import os
import re
import runpy
import shutil
import subprocess
import sys
import tarfile
import tomllib
import zipfile
from pathlib import Path
from types import SimpleNamespace

import pytest

from tests.packaging.local_index import build

ROOT = Path(__file__).parents[2]
KINDS = (".toml", ".svg", ".png")
"""Resources that the program reads."""
NOT_PUBLISHED = (".ci/", ".git")
"""Files tracked by git but not in the source distribution: the repository's own set-up."""


def tracked(*folders: str) -> list[str]:
    if not (ROOT / ".git").exists() or shutil.which("git") is None:
        pytest.skip("needs a git checkout")
    listed = subprocess.run(
        ["git", "ls-files", *folders], cwd=ROOT, capture_output=True, text=True, check=True
    )
    return [name for name in listed.stdout.splitlines() if (ROOT / name).is_file()]


@pytest.fixture(scope="module")
def sources(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The unpacked source distribution of what git tracks."""
    folder = tmp_path_factory.mktemp("sdist")
    for name in tracked():
        (folder / "tree" / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / name, folder / "tree" / name)
    with tarfile.open(build("build_sdist", folder / "tree", folder / "made")) as archive:
        archive.extractall(folder, filter="data")
    (made,) = folder.glob("glovetrack-*")
    return made


@pytest.fixture(scope="module")
def wheel(sources: Path, tmp_path_factory: pytest.TempPathFactory) -> zipfile.ZipFile:
    """Built from the source distribution, as by an installer without a wheel for its system."""
    return zipfile.ZipFile(build("build_wheel", sources, tmp_path_factory.mktemp("wheel")))


def test_the_source_distribution_is_the_tree(sources: Path) -> None:
    """Distribution packagers run the tests and build the documentation from it."""
    found = {p.relative_to(sources).as_posix() for p in sources.rglob("*") if p.is_file()}
    wanted = {name for name in tracked() if not name.startswith(NOT_PUBLISHED)}
    assert {n for n in found if ".egg-info/" not in n} == wanted | {"PKG-INFO", "setup.cfg"}


def test_the_metadata_are_in_the_wheel(wheel: zipfile.ZipFile) -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    (name,) = (n for n in wheel.namelist() if n.endswith(".dist-info/METADATA"))
    lines = wheel.read(name).decode().splitlines()
    for line in ("Author: The Glovetrack maintainers", "License-Expression: Apache-2.0"):
        assert line in lines
    assert sum(line.startswith("Classifier: ") for line in lines) == len(project["classifiers"])
    assert sum(line.startswith("Project-URL: ") for line in lines) == len(project["urls"])


def test_it_has_every_module_and_every_resource(wheel: zipfile.ZipFile) -> None:
    wanted = {n for n in tracked("app", "extensions", "tracker") if n.endswith(".py")}
    wanted -= {n for n in wanted if n.split("/")[2:3] == ["tests"]}
    wanted |= {n for n in tracked("resources") if n.endswith(KINDS)}
    assert {f"glovetrack/{n}" for n in wanted} <= set(wheel.namelist())
    assert set(tracked("glovetrack")) <= set(wheel.namelist()), "the public package"


def test_data_files_of_the_engine_are_included(wheel: zipfile.ZipFile) -> None:
    data = {n for n in tracked("app", "tracker") if not n.endswith((".py", ".md"))}
    assert {f"glovetrack/{n}" for n in data} <= set(wheel.namelist())


def test_the_openxr_layer_can_be_compiled_from_it(wheel: zipfile.ZipFile) -> None:
    sources = {n for n in tracked("extensions/openxr/layer") if n.endswith((".cpp", ".h"))}
    assert sources and {f"glovetrack/{n}" for n in sources} <= set(wheel.namelist())


def test_the_examples_of_studies_are_included(wheel: zipfile.ZipFile) -> None:
    protocols = set(tracked("extensions/study/protocols"))
    assert protocols and {f"glovetrack/{n}" for n in protocols} <= set(wheel.namelist())


def test_only_one_name_is_installed(wheel: zipfile.ZipFile) -> None:
    tops = {name.partition("/")[0] for name in wheel.namelist()}
    assert {t for t in tops if not t.endswith(".dist-info")} == {"glovetrack"}


def test_the_command_and_the_licence_are_included(wheel: zipfile.ZipFile) -> None:
    (entries,) = (n for n in wheel.namelist() if n.endswith("/entry_points.txt"))
    assert "glovetrack = glovetrack.app.__main__:main" in wheel.read(entries).decode()
    assert any(n.endswith("/licenses/LICENSE") for n in wheel.namelist())


def test_entry_points_are_declared_by_their_installed_names(wheel: zipfile.ZipFile) -> None:
    (name,) = (n for n in wheel.namelist() if n.endswith("/entry_points.txt"))
    installed = configparser.ConfigParser(delimiters="=")
    installed.read_string(wheel.read(name).decode())
    declared = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    for group, declarations in declared["entry-points"].items():
        assert dict(installed[group]) == {n: f"glovetrack.{v}" for n, v in declarations.items()}


def test_another_project_can_import_it(wheel: zipfile.ZipFile, tmp_path: Path) -> None:
    """Next to a package of that project's own that is called app."""
    wheel.extractall(tmp_path / "site")
    (tmp_path / "app.py").write_text("OWN = True\n")
    code = (
        "import sys, app, glovetrack; from glovetrack.tracker.engine.settings import *; "
        "import glovetrack.tracker.cli as cli; assert app.OWN; "
        "assert not {'tracker', 'resources'} & set(sys.modules); "
        "print(glovetrack.__version__); cli.main(['simulate', '--help'])"
    )
    run = subprocess.run(
        [sys.executable, "-P", "-c", code],
        cwd=tmp_path,
        env={**os.environ, "PYTHONPATH": f"{tmp_path}{os.pathsep}{tmp_path / 'site'}"},
        capture_output=True,
        text=True,
    )
    assert run.returncode == 0, run.stderr
    assert "--blobs-only" in run.stdout, "a command of the registry"


def test_only_imports_and_deferred_ones_are_rewritten() -> None:
    backend = SimpleNamespace(**runpy.run_path(str(ROOT / "packaging" / "backend.py")))
    code = '''"""from tracker.x import y: prose stays."""
from __future__ import annotations
import tracker
import resources as r
if True:
    from tracker.fusion import (
        engine,
    )
import app.window.theme as theme
run = deferred("tracker.fusion.engine:run"), "tracker.fusion"
other = deferred("laboratory.engine:run")
'''
    assert (
        backend.with_full_names(code)
        == '''"""from tracker.x import y: prose stays."""
from __future__ import annotations
from glovetrack import tracker
import glovetrack.resources as r
if True:
    from glovetrack.tracker.fusion import (
        engine,
    )
import glovetrack.app.window.theme as theme
run = deferred("glovetrack.tracker.fusion.engine:run"), "tracker.fusion"
other = deferred("laboratory.engine:run")
'''
    )


def spelled(path: Path) -> list[str]:
    """Strings that are a module's name in this tree, except names of our tools (``prog``) and
    prefixes that are the same everywhere."""
    tree = ast.parse(path.read_text("utf-8"))
    mine = [k.value for n in ast.walk(tree) if isinstance(n, ast.Call) for k in n.keywords
            if k.arg == "prog"]  # fmt: skip
    mine += [a for n in ast.walk(tree) if isinstance(n, ast.Call) for a in n.args
             if isinstance(n.func, ast.Attribute) and n.func.attr == "removesuffix"]  # fmt: skip
    strings = [n for n in ast.walk(tree) if isinstance(n, ast.Constant) and n not in mine]
    values = [n.value for n in strings if isinstance(n.value, str)]
    return [
        v for v in values if re.fullmatch(r"(app|tracker|resources)(\.\w+)*\.?", v) and "." in v
    ]


@pytest.mark.long
def test_no_module_is_named_in_a_string() -> None:
    """In a wheel it has another name: for half a day no installed program could export."""
    folders = ("app", "extensions", "glovetrack", "tracker", "resources")
    files = [ROOT / n for n in tracked(*folders) if n.endswith(".py") and "/tests/" not in n]
    assert {path.name: names for path in files if (names := spelled(path))} == {}
