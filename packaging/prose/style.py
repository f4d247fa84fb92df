"""Checks the style of prose: docstrings, comments, Markdown and texts of the window.

    python packaging/prose/style.py

The rules (styles/Glovetrack/*.yml) have Vale's format, so that `vale docs README.md` applies them
as well (.vale.ini). Vale itself is a program that its package downloads when first run, which a
build without access to other servers cannot do; this reads the rules that the project uses:
substitutions and words that must not occur.
"""

from __future__ import annotations

import ast
import io
import re
import subprocess
import sys
import tokenize
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

import yaml

STYLES = Path(__file__).parent / "styles" / "Glovetrack"
SKIPPED = ("packaging/prose/", "resources/firmware/")
CODE = re.compile(r"``[^`]*``|`[^`]*`")


class Line(NamedTuple):
    path: str
    number: int
    text: str


class Rule(NamedTuple):
    pattern: re.Pattern[str]
    message: str


def read_rules(folder: Path = STYLES) -> list[Rule]:
    """The rules of all files. Raises ValueError for a kind of rule that is not implemented."""
    rules: list[Rule] = []
    for path in sorted(folder.glob("*.yml")):
        data = yaml.safe_load(path.read_text("utf-8"))
        if data["extends"] == "substitution":
            swap = data["swap"].items()
            pairs = [(found, data["message"].replace("%s", new, 1)) for found, new in swap]
        elif data["extends"] == "existence":
            pairs = [(found, data["message"]) for found in data["tokens"]]
        else:
            raise ValueError(f"{path}: rules of the kind {data['extends']} are not implemented")
        flags = re.IGNORECASE if data.get("ignorecase") else 0
        rules += [Rule(re.compile(rf"\b(?:{found})\b", flags), words) for found, words in pairs]
    return rules


def prose_of(path: str, text: str) -> Iterator[Line]:
    """The lines of prose in a file, without code."""
    if path.endswith(".md"):
        yield from _markdown(path, text)
    elif path.endswith(".ts"):
        sources = re.compile(r"<source>(.*?)</source>", re.DOTALL)
        for found in sources.finditer(text):
            yield Line(path, text.count("\n", 0, found.start()) + 1, found[1])
    else:
        yield from _docstrings(path, text)
        for token in tokenize.generate_tokens(io.StringIO(text).readline):
            if token.type == tokenize.COMMENT:
                yield Line(path, token.start[0], CODE.sub("", token.string))


def _markdown(path: str, text: str) -> Iterator[Line]:
    is_code = False
    for number, line in enumerate(text.splitlines(), 1):
        if line.strip().startswith("```"):
            is_code = not is_code
        elif not is_code:
            yield Line(path, number, CODE.sub("", line))


def _docstrings(path: str, text: str) -> Iterator[Line]:
    """Of modules, classes and functions, and those that follow an assignment."""
    parts = (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)
    for node in ast.walk(ast.parse(text)):
        for child in node.body if isinstance(node, parts) else ():
            if isinstance(child, ast.Expr) and isinstance(child.value, ast.Constant):
                value = child.value.value
                if isinstance(value, str):
                    lines = CODE.sub("", value).splitlines()
                    yield from (Line(path, child.lineno + k, w) for k, w in enumerate(lines))


def findings(files: list[str], rules: list[Rule]) -> Iterator[str]:
    """One line for each place that breaks a rule."""
    for path in files:
        for line in prose_of(path, Path(path).read_text("utf-8")):
            for rule in rules:
                if found := rule.pattern.search(line.text):
                    yield f"{path}:{line.number}: {rule.message.replace('%s', found[0])}"


def main() -> int:
    listed = subprocess.run(
        ["git", "ls-files", "--", "*.py", "*.md", "*.ts"],
        capture_output=True, text=True, check=True,
    ).stdout.splitlines()  # fmt: skip
    found = list(findings([p for p in listed if not p.startswith(SKIPPED)], read_rules()))
    print(*found, sep="\n", end="\n" if found else "")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
