"""What is taken out of a built bundle: orphans and second copies; what stands in for modules."""

from __future__ import annotations

import re
import runpy
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path
from types import SimpleNamespace

import pytest

PACKAGING = Path(__file__).parents[2] / "packaging"
slimming = SimpleNamespace(**runpy.run_path(str(PACKAGING / "slimming.py")))

USE = """
import os, runpy, sys, types
os.environ["QT_QPA_PLATFORM"] = "offscreen"
for name in sys.argv[2:]:
    module = types.ModuleType(name)
    exec(open(sys.argv[1]).read(), module.__dict__)
    sys.modules[name] = module
import pyqtgraph as pg, scipy.optimize, scipy.signal, scipy.stats
application = pg.mkQApp()
plot = pg.PlotWidget()
plot.plot([1.0, 2.0, 1.5])
assert not plot.grab().isNull()
assert abs(scipy.optimize.brentq(lambda x: x * x - 2, 0, 2) - 2**0.5) < 1e-9
try:
    sys.modules["scipy.optimize._highspy._core"].Highs()
except ImportError as error:
    print(error)
os._exit(0)
"""


def test_libraries_of_wheels_go_with_the_last_that_needs_them(tmp_path: Path) -> None:
    needs = {
        "module.so": ["libused.so"],
        "libused.so": ["libdeep.so"],
        "libgone.so": ["libdeep.so"],
    }
    for place in ("p/module.so", "p.libs/libused.so", "q.libs/libdeep.so", "q.libs/libgone.so"):
        (tmp_path / place).parent.mkdir(exist_ok=True)
        (tmp_path / place).write_bytes(b"\x7fELF")
    (tmp_path / "p.libs/words.txt").write_text("words")
    slimming.remove_orphans(tmp_path, lambda file: needs.get(Path(file).name, []))
    left = {p.name for p in tmp_path.rglob("*") if p.is_file()}
    assert left == {"module.so", "libused.so", "libdeep.so", "words.txt"}


def test_second_copies_become_links_that_move_along(tmp_path: Path) -> None:
    bundle = tmp_path / "bundle"
    for place in ("a.libs/one.so", "b.libs/one.so", "b.libs/small"):
        (bundle / place).parent.mkdir(parents=True, exist_ok=True)
        (bundle / place).write_bytes(b"library" * (10_000 if place.endswith(".so") else 1))
    (bundle / "a.libs/small").write_bytes(b"library")
    slimming.link_duplicates(bundle)
    moved = bundle.rename(tmp_path / "elsewhere")
    assert (moved / "b.libs/one.so").is_symlink()
    assert (moved / "b.libs/one.so").read_bytes() == b"library" * 10_000
    assert not any((moved / f"{k}.libs/small").is_symlink() for k in "ab")


def absent() -> list[str]:
    text = (PACKAGING / "glovetrack.spec").read_text("utf-8")
    words = re.search(r"^ABSENT = \[(.*?)\]", text, re.MULTILINE | re.DOTALL)
    assert words is not None
    return re.findall(r'"(.*?)"', words[1])


@pytest.mark.parametrize("name", absent())
def test_every_absent_module_is_one_that_there_is(name: str) -> None:
    assert find_spec(name) is not None


def test_plots_and_scipy_work_without_the_absent_modules() -> None:
    file = PACKAGING / "frozen" / "absent.py"
    made = subprocess.run(
        [sys.executable, "-c", USE, str(file), *absent()], capture_output=True, text=True
    )
    assert made.returncode == 0, made.stderr
    assert re.search(r"_highspy._core.Highs is not part of this bundle", made.stdout)
