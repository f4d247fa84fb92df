"""The page of wishes and their answers: every test that it names exists, and its figures agree."""

from __future__ import annotations

import ast
import re
from pathlib import Path

import pytest

from tracker.streaming.registry import stream_kinds
from tracker.streaming.remote.registry import door_kinds

ROOT = Path(__file__).parents[2]
PAGE = ROOT / "docs" / "integrations.md"
TEST = re.compile(r"`([\w/]+\.py)::(test_\w+)`")
ROWS = [line for line in PAGE.read_text("utf-8").splitlines() if TEST.search(line)]
NAMED = sorted({found for line in ROWS for found in TEST.findall(line)})


def names_of(path: Path) -> set[str]:
    tree = ast.parse(path.read_text("utf-8"))
    return {node.name for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)}


@pytest.mark.parametrize(("path", "name"), NAMED, ids=[name for _, name in NAMED])
def test_a_named_test_exists(path: str, name: str) -> None:
    assert name in names_of(ROOT / path)


def test_every_answer_has_a_test() -> None:
    lines = PAGE.read_text("utf-8").splitlines()
    heads = {k - 1 for k, line in enumerate(lines) if line.startswith("|---")}
    answers = [line for k, line in enumerate(lines) if line.startswith("| ") and k not in heads]
    assert answers == ROWS and len(heads) == 2 and len(ROWS) >= 18 + len(stream_kinds())


def test_every_stream_and_every_source_of_poses_has_a_row_in_the_documentation() -> None:
    streaming = (ROOT / "docs" / "streaming.md").read_text("utf-8")
    pages = streaming + (ROOT / "extensions" / "room" / "docs" / "room.md").read_text("utf-8")
    rows = re.findall(r"^\| [^|]* \| `(\w+)` \|", streaming, re.MULTILINE)
    assert set(rows) >= set(stream_kinds())
    for name in door_kinds():
        assert re.search(rf"`(--remote )?{name}`|--remote [\w,?:]*\b{name}\b", pages), name
