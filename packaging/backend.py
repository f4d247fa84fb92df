"""The build backend: setuptools, with all packages of a wheel under one name.

The public package `glovetrack` is the same in this tree and in a wheel. Its implementation is in
`app`, `extensions`, `tracker` and `resources` here. Installed under these names they would collide
with others in a shared environment, so a wheel has them as `glovetrack.app` and so on: the tree is
copied with that layout, the copy's import statements are changed to the full names, and setuptools
makes the wheel from the copy. `README.md` next to this file explains why. Of the strings in the
code only the names in `deferred("tracker.…:function")` are changed, so no other string may be a
module's name (use `__package__`). Compiled kernels in the tree,
and with them the compiled OpenXR layer, are included and make it a wheel for this platform
(`packaging/wheel.sh`); without kernels it is a pure Python wheel. An editable install, as the
Makefile makes it, does not change the tree.
"""

from __future__ import annotations

import ast
import os
import re
import shutil
import sysconfig
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from setuptools import build_meta
from setuptools.build_meta import (
    build_editable,
    build_sdist,
    get_requires_for_build_editable,
    get_requires_for_build_sdist,
    get_requires_for_build_wheel,
    prepare_metadata_for_build_editable,
    prepare_metadata_for_build_wheel,
)

__all__ = [
    "build_editable",
    "build_sdist",
    "build_wheel",
    "get_requires_for_build_editable",
    "get_requires_for_build_sdist",
    "get_requires_for_build_wheel",
    "prepare_metadata_for_build_editable",
    "prepare_metadata_for_build_wheel",
]

NAME = "glovetrack"
PACKAGES = ("app", "extensions", "tracker", "resources")
FOUND = 'include = ["app*", "extensions*", "glovetrack*", "resources*", "tracker*"]'
OPENXR_LAYER = "*glovetrack_openxr.*"
"""Its library in `extensions/openxr/layer`."""
NOT_INSTALLED = ("tests", "docs")
"""Folders of an extension that stay in the source tree."""
FOR_ONE_PLATFORM = """from setuptools import Distribution, setup


class WithCompiledKernels(Distribution):
    def has_ext_modules(self):
        return True


setup(distclass=WithCompiledKernels)
"""


def build_wheel(
    wheel_directory: str,
    config_settings: dict[str, str] | None = None,
    metadata_directory: str | None = None,
) -> str:
    """PEP 517's hook; the wheel's file name."""
    target = str(Path(wheel_directory).resolve())
    with tempfile.TemporaryDirectory() as folder:
        stage(Path.cwd(), Path(folder))
        add_compiled(Path.cwd(), Path(folder))
        with working_in(folder):
            return build_meta.build_wheel(target, config_settings)


def stage(source: Path, target: Path) -> None:
    """Copy the content of a wheel, in the layout in which it is installed."""
    for name in ("README.md", "LICENSE"):
        shutil.copy(source / name, target)
    project = (source / "pyproject.toml").read_text("utf-8")
    (target / "pyproject.toml").write_text(installed_project(project), "utf-8")
    hidden = shutil.ignore_patterns("__pycache__", "_compiled*", "_dispatch*", OPENXR_LAYER)
    shutil.copytree(source / NAME, target / NAME, ignore=hidden)
    for package in PACKAGES:
        shutil.copytree(source / package, target / NAME / package, ignore=hidden)
    for extension in (target / NAME / "extensions").iterdir():
        for part in NOT_INSTALLED:
            shutil.rmtree(extension / part, ignore_errors=True)
    for sources in ("src", "simulator"):  # users need the images only
        shutil.rmtree(target / NAME / "resources" / "firmware" / sources)
    shutil.copytree(source / "docs" / "guide", target / NAME / "resources" / "guide")
    for path in (target / NAME).rglob("*.py"):
        path.write_text(with_full_names(path.read_text("utf-8")), "utf-8")


def add_compiled(source: Path, target: Path) -> None:
    """Copy files that were compiled for this system: kernels, if there are some for this
    interpreter, and with them the OpenXR layer if it was built."""
    if not add_kernels(source, target):
        return
    folder = Path("extensions", "openxr", "layer")
    for path in (source / folder).glob(OPENXR_LAYER):
        shutil.copy(path, target / NAME / folder)
    (target / "setup.py").write_text(FOR_ONE_PLATFORM, "utf-8")


def add_kernels(source: Path, target: Path) -> bool:
    """Copy the library of compiled kernels; False if there is none for this interpreter.

    Kernels are looked up by full name, so the tables of the copy contain the installed names.
    """
    here, there = (root / "tracker" / "kernels" for root in (source, target / NAME))
    suffix = sysconfig.get_config_var("EXT_SUFFIX")
    dispatch = here / f"_dispatch{suffix}"
    parts = {p: p.with_name(p.stem + suffix) for p in here.glob("_compiled_*.txt")}
    parts = {table: module for table, module in parts.items() if module.exists()}
    if not (parts and dispatch.exists()):
        return False
    for path in (dispatch, *parts.values()):
        shutil.copy(path, there)
    for table in parts:
        lines = table.read_text("utf-8").splitlines(keepends=True)
        full = lines[:1] + [with_full_name(line) for line in lines[1:]]
        (there / table.name).write_text("".join(full), "utf-8")
    return True


def add_metadata(target: Path) -> None:
    """Write the metadata of a staged copy, so that its entry points are found without a wheel."""
    with working_in(str(target)):
        build_meta.prepare_metadata_for_build_wheel(str(target))


def with_full_name(line: str) -> str:
    """A table's line: symbol, fingerprint, name of the kernel, types."""
    symbol, made_of, name, types = line.split(" ", 3)
    return " ".join((symbol, made_of, f"{NAME}.{name}", types))


def installed_project(text: str) -> str:
    """pyproject.toml for the staged copy: its own names, and setuptools alone to build it."""
    changes = {
        'build-backend = "backend"\nbackend-path = ["packaging"]': (
            'build-backend = "setuptools.build_meta"'
        ),
        FOUND: f'include = ["{NAME}*"]',
        **{f"\n{p} = [": f'\n"{NAME}.{p}" = [' for p in PACKAGES},
    }
    for old, new in changes.items():
        if old not in text and not old.startswith("\n"):
            raise ValueError(f"pyproject.toml has no {old!r} any more: packaging/backend.py")
        text = text.replace(old, new)
    ours = "|".join(PACKAGES)
    entry_point = rf'^("?[\w.-]+"? = ")(?=(?:{ours})\.[\w.]+:\w+"$)'
    return re.sub(entry_point, rf"\1{NAME}.", text, flags=re.MULTILINE)


def with_full_names(code: str) -> str:
    """Python code whose imports and deferred functions have the installed names of our packages."""
    lines = code.splitlines(keepends=True)
    for node in ast.walk(ast.parse(code)):
        if isinstance(node, ast.ImportFrom) and node.level == 0 and _is_ours(node.module or ""):
            _replace(lines, node, f"from {node.module}", f"from {NAME}.{node.module}")
        elif isinstance(node, ast.Import):
            for alias in node.names:
                _rename_import(lines, node, alias)
        elif isinstance(node, ast.Call) and ast.unparse(node.func) == "deferred":
            (name,) = (each for each in node.args if isinstance(each, ast.Constant))
            if _is_ours(name.value):
                _replace(lines, name, f'"{name.value}"', f'"{NAME}.{name.value}"')
    return "".join(lines)


def _rename_import(lines: list[str], node: ast.Import, alias: ast.alias) -> None:
    if not _is_ours(alias.name):
        return
    if alias.asname:
        _replace(lines, node, f"import {alias.name}", f"import {NAME}.{alias.name}")
    elif "." in alias.name or len(node.names) > 1:
        raise ValueError(f"line {node.lineno}: write 'from … import …', not 'import {alias.name}'")
    else:
        _replace(lines, node, f"import {alias.name}", f"from {NAME} import {alias.name}")


def _is_ours(module: str) -> bool:
    return module.partition(".")[0] in PACKAGES


def _replace(lines: list[str], node: ast.stmt | ast.expr, old: str, new: str) -> None:
    line = lines[node.lineno - 1]
    start = len(line.encode()[: node.col_offset].decode())
    before, after = line[:start], line[start:]
    if not after.startswith(old):
        raise ValueError(f"line {node.lineno}: an import is written in an unusual way")
    lines[node.lineno - 1] = before + new + after[len(old) :]


@contextmanager
def working_in(folder: str) -> Iterator[None]:
    """Changes the working directory, whose project setuptools builds."""
    before = Path.cwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)
