"""Finds the kernels that Python calls: only these get an entry in the library.

A kernel called only by kernels is compiled into them. Determined from the source, without importing
it, so no list has to be maintained.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path
from typing import TypeGuard

from tracker.kernels.fingerprint import OURS
from tracker.kernels.signature import INSTALLED_IN

ROOT = Path(__file__).parents[2]


def kernels(root: Path = ROOT) -> list[str]:
    """``package.module.function`` of all kernels of the product, in order."""
    return sorted(_all(list(_sources(root))))


def exported(root: Path = ROOT) -> list[str]:
    """Those of them that are used outside of kernels, in order."""
    sources = list(_sources(root))
    all_kernels = _all(sources)
    named = set[str]()
    for module, source in sources:
        if _may_name(all_kernels, source):
            named |= _named(module, ast.parse(source))
    return sorted(all_kernels & named)


def _all(sources: list[tuple[str, bytes]]) -> set[str]:
    """Full names of the kernels of these modules."""
    may_hold = [(module, source) for module, source in sources if b"@kernel" in source]
    return {name for module, source in may_hold for name in _defined(module, ast.parse(source))}


def _may_name(all_kernels: set[str], source: bytes) -> bool:
    """Whether the source contains a kernel's name and its module's: most sources do not, and
    parsing them all would take seconds."""
    words = {word.decode() for word in re.findall(rb"[A-Za-z_]\w*", source)}
    split = (name.rsplit(".", 2)[1:] for name in all_kernels)
    return b"@kernel" in source or any(words.issuperset(pair) for pair in split)


def _sources(root: Path) -> Iterator[tuple[str, bytes]]:
    """Each module's full name and its source."""
    for package in OURS:
        folder = root / package.removeprefix(INSTALLED_IN)
        for path in sorted(folder.rglob("*.py")):
            parts = path.relative_to(root).with_suffix("").parts
            if "tests" in parts:
                continue
            module = ".".join(parts[:-1] if parts[-1] == "__init__" else parts)
            yield f"{INSTALLED_IN}{module}", path.read_bytes()


def _defined(module: str, tree: ast.Module) -> list[str]:
    return [f"{module}.{node.name}" for node in tree.body if is_kernel(node)]


def is_kernel(node: ast.AST) -> TypeGuard[ast.FunctionDef]:
    """Whether it is a function under ``@kernel`` or ``@kernel(...)``."""
    if not isinstance(node, ast.FunctionDef):
        return False
    made_by = [d.func if isinstance(d, ast.Call) else d for d in node.decorator_list]
    return any(isinstance(d, ast.Name) and d.id == "kernel" for d in made_by)


def _named(module: str, tree: ast.Module) -> set[str]:
    """Full names of all names used outside of kernels, whether they are kernels or not."""
    outside = [n for part in tree.body if not is_kernel(part) for n in ast.walk(part)]
    meant = _imported(tree)
    found = set()
    for node in outside:
        if isinstance(node, ast.Name):
            found.add(meant.get(node.id, f"{module}.{node.id}"))
        elif isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name):
            found.add(f"{meant.get(node.value.id, node.value.id)}.{node.attr}")
    return found


def _imported(tree: ast.Module) -> dict[str, str]:
    """The full name behind each imported name."""
    meant: dict[str, str] = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.ImportFrom) and node.module:
            meant |= {a.asname or a.name: f"{node.module}.{a.name}" for a in node.names}
        elif isinstance(node, ast.Import):
            meant |= {a.asname: a.name for a in node.names if a.asname}
    return meant
