"""Takes out of a built bundle what is there for nothing.

    python packaging/slimming.py BUNDLE

``BUNDLE`` is the folder with the program's libraries (``_internal``), after `stand_ins.py`:

- libraries in the wheels' own folders (``*.libs``) that nothing needs any more go;
- files that are there twice become links.

Needs readelf. Linux only; elsewhere nothing happens.
"""

from __future__ import annotations

import hashlib
import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))
from pruning import Needs, is_elf, needed_by, reachable

LINKED_FROM = 16_000  # bytes; links to smaller files save next to nothing


def remove_orphans(bundle: Path, needs: Needs = needed_by) -> None:
    """What wheels bring in a folder of their own only serves others, and goes with the last."""
    found = [path for path in _files(bundle) if is_elf(path)]
    served = [path for path in found if path.parent.suffix == ".libs"]
    roots = [path.name for path in found if path.parent.suffix != ".libs"]
    kept = reachable(roots, {path.name: str(path) for path in found}, needs)
    for path in served:
        if path.name not in kept:
            path.unlink()


def link_duplicates(bundle: Path) -> None:
    """The second of two equal files becomes a link to the first."""
    first: dict[bytes, Path] = {}
    for path in _files(bundle):
        if path.stat().st_size < LINKED_FROM:
            continue
        told = hashlib.sha256(path.read_bytes()).digest()
        original = first.setdefault(told, path)
        if original is not path:
            path.unlink()
            path.symlink_to(os.path.relpath(original, path.parent))


def _files(bundle: Path) -> list[Path]:
    return [p for p in sorted(bundle.rglob("*")) if p.is_file() and not p.is_symlink()]


def main(bundle: Path) -> int:
    """Slim a bundle; 0."""
    if sys.platform.startswith("linux"):
        remove_orphans(bundle)
        link_duplicates(bundle)
    return 0


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))
