"""Nothing is removed from an environment that the window loads."""

from __future__ import annotations

import os
import runpy
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

ROOT = Path(__file__).parents[2]
PACKAGES = Path(np.__file__).parents[1]
slim = SimpleNamespace(**runpy.run_path(str(ROOT / "packaging" / "slim.py")))
LOADED = """
import sys
from pathlib import Path
import pyvistaqt, app.widgets.view3d.gpu_view, app.window.main_window, app.engines.demo
from PySide6.QtWidgets import QApplication
QApplication([])
print(*(name for name in sys.modules if name.startswith("vtkmodules.vtk")))
maps = Path("/proc/self/maps").read_text().splitlines()
print(*{line.split(maxsplit=5)[5] for line in maps if "/" in line}, sep="|")
print(*(m.__file__ for m in sys.modules.values() if getattr(m, "__file__", None)), sep="|")
"""


@pytest.mark.long
@pytest.mark.skipif(sys.platform != "linux", reason="asks Linux what a process has loaded")
def test_nothing_that_the_window_loads_is_removed() -> None:
    result = subprocess.run(
        [sys.executable, "-c", LOADED],
        cwd=ROOT,
        env={**os.environ, "PYTHONPATH": str(ROOT), "QT_QPA_PLATFORM": "offscreen"},
        capture_output=True,
        text=True,
        check=True,
    )
    of_vtk, mapped, modules = result.stdout.splitlines()
    assert {name.removeprefix("vtkmodules.vtk") for name in of_vtk.split()} <= set(slim.VTK.split())
    files = {Path(name) for name in (*mapped.split("|"), *modules.split("|"))}
    loaded = {f for f in files if PACKAGES in f.parents}
    assert any("PySide6" in f.parts for f in loaded)
    taken = {path for pattern in slim.UNUSED for path in PACKAGES.glob(pattern)}
    assert [f for f in loaded if not taken.isdisjoint((f, *f.parents))] == []


def test_it_removes_folders_and_files_and_counts_them(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for name in (
        "scipy/io/tests/data/a.mat",
        "scipy/io/a.py",
        "PySide6/Qt/qml/x",
        "numpy/__init__.py",
    ):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_bytes(bytes(600_000))
    fake = SimpleNamespace(__file__=str(tmp_path / "numpy" / "__init__.py"))
    monkeypatch.setitem(sys.modules, "numpy", fake)
    monkeypatch.setitem(slim.main.__globals__, "unused_of_vtk", lambda _folder: ())
    slim.main()
    assert "Took 1 MB" in capsys.readouterr().out
    left = {str(p.relative_to(tmp_path)) for p in tmp_path.rglob("*") if p.is_file()}
    assert left == {"scipy/io/a.py", "numpy/__init__.py"}
