"""The notebook of the documentation runs from its first cell to its last, in a fresh process."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

NOTEBOOK = Path(__file__).resolve().parents[2] / "docs" / "examples" / "first_look.ipynb"
RUN = """
import ast, json, sys
import matplotlib
matplotlib.use("Agg")
space = {}
for cell in json.load(open(sys.argv[1], encoding="utf-8"))["cells"]:
    if cell["cell_type"] == "code":
        *before, last = ast.parse("".join(cell["source"])).body
        exec(compile(ast.Module(before, []), "cell", "exec"), space)
        if isinstance(last, ast.Expr):
            print(repr(eval(compile(ast.Expression(last.value), "cell", "eval"), space)))
        else:
            exec(compile(ast.Module([last], []), "cell", "exec"), space)
"""


def test_it_runs_and_shows_the_results_in_its_text(tmp_path: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-c", RUN, str(NOTEBOOK)],
        cwd=tmp_path,
        env=os.environ | {"PYTHONPATH": str(NOTEBOOK.parents[2])},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    assert "True False" in done.stdout, "tracked again identical, by another engine not"
    assert (tmp_path / "first_look.c3d").stat().st_size > 1000


def test_it_is_stored_without_outputs() -> None:
    cells = json.loads(NOTEBOOK.read_text("utf-8"))["cells"]
    assert len({c["id"] for c in cells}) == len(cells)
    assert all(c["outputs"] == [] for c in cells if c["cell_type"] == "code")
