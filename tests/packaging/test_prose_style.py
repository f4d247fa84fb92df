"""The check of style: which text is prose, and that rules find what they are for."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from types import ModuleType

import pytest

ROOT = Path(__file__).parents[2]


@pytest.fixture(scope="module")
def style() -> ModuleType:
    spec = importlib.util.spec_from_file_location("style", ROOT / "packaging/prose/style.py")
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


SOURCE = '''"""A file that is no image."""
LIMIT = 3  # px, of now
"""Pauses in sight."""
text = "is no image, of now"


def f() -> None:
    """Returns `is no image`."""
'''


def test_docstrings_and_comments_are_checked_but_not_code(style: ModuleType) -> None:
    found = [line.text for line in style.prose_of("a.py", SOURCE)]
    assert found == ["A file that is no image.", "Pauses in sight.", "Returns .", "# px, of now"]


def test_rules_name_the_words_and_their_replacement(tmp_path: Path, style: ModuleType) -> None:
    path = tmp_path / "a.md"
    path.write_text("This is no file.\n```\nis no file\n```\nThere is no file. It goes on.\n")
    found = list(style.findings([str(path)], style.read_rules()))
    assert [line.removeprefix(f"{path}:").split(":")[0] for line in found] == ["1", "5"]
    assert "is no file" in found[0] and "continues" in found[1]


def test_other_kinds_of_rules_are_rejected(tmp_path: Path, style: ModuleType) -> None:
    (tmp_path / "a.yml").write_text("extends: occurrence\nmessage: x\n")
    with pytest.raises(ValueError, match="occurrence"):
        style.read_rules(tmp_path)
