"""Removes files that the program never loads from an environment: a third of its size.

    VENV/bin/python packaging/slim.py

Wheels cannot be installed in part, so they include tests, unused parts of Qt (half: QML, Designer,
their tools) and three quarters of VTK. The parts of VTK that are kept are those in `VTK` and the
libraries that they load, as reported by the system. `tests/packaging/test_slim.py` compares both
with what the window loads.
"""

from __future__ import annotations

import importlib
import shutil
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path

VTK = """
    ChartsCore CommonColor CommonCore CommonDataModel CommonExecutionModel CommonMath CommonMisc
    CommonSystem CommonTransforms FiltersCore FiltersGeneral FiltersGeometry FiltersHybrid
    FiltersPython FiltersSources IOCore IOImage ImagingCore ImagingMath ImagingSources
    InteractionStyle ParallelCore PythonContext2D RenderingAnnotation RenderingContext2D
    RenderingContextOpenGL2 RenderingCore RenderingFreeType RenderingHyperTreeGrid RenderingLabel
    RenderingMatplotlib RenderingOpenGL2 RenderingUI RenderingVolume RenderingVolumeOpenGL2
"""
"""Modules that the graphics card's 3D view, and pyvistaqt with it, import."""

UNUSED = [
    *(f"{name}/**/tests" for name in ("h5py", "llvmlite", "matplotlib", "numba", "numpy", "scipy")),
    "matplotlib/mpl-data/sample_data", "pyqtgraph/examples", "zstandard/_cffi*",
    *(f"PySide6/{name}" for name in (
        "assistant", "designer", "linguist", "qmlformat", "qmllint", "qmlls", "svgtoqml",
        "include", "typesystems", "glue", "doc", "libpyside6qml*",
    )),
    *(f"PySide6/Qt{name}.abi3.so" for name in (
        "Designer", "Help", "Qml", "Quick*", "Sql", "UiTools",
    )),
    *(f"PySide6/Qt/{name}" for name in ("qml", "metatypes", "libexec")),
    *(f"PySide6/Qt/lib/libQt6{name}*" for name in (
        "Designer", "EglFS", "EglFs", "Help", "Labs", "Lottie", "Qml[A-Z]", "Quick", "Sql",
        "UiTools", "WaylandCompositor", "WaylandEglCompositor",
    )),
    *(f"PySide6/Qt/plugins/{name}" for name in (
        "designer", "egldeviceintegrations", "qmllint", "qmltooling", "sqldrivers",
        "vectorimageformats", "wayland-graphics-integration-server",
        "platforminputcontexts/libqtvirtualkeyboard*",
        "platforms/libqeglfs*", "platforms/libqlinuxfb*", "platforms/libqvnc*",
        "platforms/libqvkkhr*",
    )),
    *(f"PySide6/Qt/translations/{name}" for name in ("[!q]*", "qt_*", "qtdeclarative_*")),
    "vtkmodules/*.pyi",
]  # fmt: skip
"""Patterns below the folder of packages."""


def main() -> None:
    packages = Path(importlib.import_module("numpy").__file__ or "").parents[1]
    unused = {path for pattern in UNUSED for path in packages.glob(pattern)}
    if sys.platform == "linux":
        unused |= set(unused_of_vtk(packages / "vtkmodules"))
    freed = sum(map(size, unused))
    for path in unused:
        if path.is_dir():
            shutil.rmtree(path, ignore_errors=True)  # one may be inside another
        else:
            path.unlink(missing_ok=True)
    print(f"Took {freed / 1e6:.0f} MB out of the environment that the program never loads")


def unused_of_vtk(folder: Path) -> Iterator[Path]:
    """VTK's libraries that are not loaded by those in `VTK`."""
    for name in VTK.split():
        importlib.import_module(f"vtkmodules.vtk{name}")
    used = set(mapped())
    return (path for path in folder.glob("*.so") if path.name not in used)


def mapped() -> Iterator[str]:
    """Names of the files that are mapped into this process."""
    lines = Path("/proc/self/maps").read_text("utf-8").splitlines()
    return (Path(line.split(maxsplit=5)[5]).name for line in lines if "/" in line)


def size(path: Path) -> int:
    """Bytes of a file or of all files in a folder."""
    files: Iterable[Path] = path.rglob("*") if path.is_dir() else (path,)
    return sum(f.stat().st_size for f in files if f.is_file())


if __name__ == "__main__":
    main()
