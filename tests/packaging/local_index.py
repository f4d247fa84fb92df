"""A package index on this computer: the program's wheel and stand-ins for its requirements.

A stand-in has the name and version of an installed package and no content. One of them adds the
test environment's folder to the import path, so that a program installed from the index runs
without a download of its dependencies, 0.7 GB.
"""

from __future__ import annotations

import functools
import os
import re
import subprocess
import sys
import tomllib
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from importlib.metadata import version
from pathlib import Path
from threading import Thread

from packaging.requirements import Requirement

ROOT = Path(__file__).parents[2]
WHEEL = "Wheel-Version: 1.0\nGenerator: test\nRoot-Is-Purelib: true\nTag: py3-none-any\n"
BACKEND = "import sys; sys.path.insert(0, 'packaging'); import backend; "
WITH_PATH = "numpy"
"""The stand-in that adds the test environment's packages."""


def build(hook: str, source: Path, out: Path) -> Path:
    """The result of the build backend for a project's folder."""
    out.mkdir(parents=True, exist_ok=True)
    command = [sys.executable, "-c", f"{BACKEND}backend.{hook}(sys.argv[1])", str(out)]
    done = subprocess.run(command, cwd=source, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    (made,) = out.iterdir()
    return made


def add_requirements(simple: Path) -> None:
    """A stand-in for each direct requirement, in the folder of an index (PEP 503)."""
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))["project"]
    for name in (Requirement(text).name for text in project["dependencies"]):
        _add_stand_in(simple, name)


def _add_stand_in(simple: Path, name: str) -> None:
    number, full = version(name), re.sub(r"[-_.]+", "_", name).lower()
    folder, info = simple / full.replace("_", "-"), f"{full}-{number}.dist-info"
    files = {
        f"{info}/METADATA": f"Metadata-Version: 2.1\nName: {name}\nVersion: {number}\n",
        f"{info}/WHEEL": WHEEL,
    }
    if name == WITH_PATH:
        packages = [path for path in sys.path if path.endswith("site-packages")]
        files["test_environment.pth"] = "\n".join(packages)
    files[f"{info}/RECORD"] = "".join(f"{path},,\n" for path in (*files, f"{info}/RECORD"))
    folder.mkdir()
    with zipfile.ZipFile(folder / f"{full}-{number}-py3-none-any.whl", "w") as wheel:
        for path, text in files.items():
            wheel.writestr(path, text)


class _Quiet(SimpleHTTPRequestHandler):
    def log_message(self, *_: object) -> None:
        """Nothing: requests are not part of a test's output."""


@contextmanager
def served(folder: Path) -> Iterator[str]:
    """The address of ``folder``; its listings are the pages of an index."""
    serve = functools.partial(_Quiet, directory=str(folder))
    with ThreadingHTTPServer(("127.0.0.1", 0), serve) as server:
        Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}/"
        server.shutdown()


def user_environment(home: Path, index: str) -> dict[str, str]:
    """The environment of a new user without a screen, with only ``index``; kernels are cached as
    usual."""
    ours = ("PIP_", "PIPX_", "UV_", "PYTHON", "XDG_", "QT_", "DISPLAY", "WAYLAND", "VIRTUAL_ENV")
    cache = os.environ.get("XDG_CACHE_HOME", str(Path.home() / ".cache"))
    return {name: text for name, text in os.environ.items() if not name.startswith(ours)} | {
        "HOME": str(home),
        "XDG_CACHE_HOME": cache,
        "PIP_CONFIG_FILE": os.devnull,
        "PIP_INDEX_URL": index,
        "PIPX_HOME": str(home / "pipx"),
        "PIPX_BIN_DIR": str(home / "bin"),
        "UV_DEFAULT_INDEX": index,
        "UV_NO_CONFIG": "1",
        "UV_CACHE_DIR": str(home / "uv"),
        "UV_PYTHON_DOWNLOADS": "never",
    }
