"""``python -m app.tools.translations``: lists the window's texts for translators.

Writes ``resources/translations/glovetrack_LANGUAGE.ts``, with what has been translated, and of
each language that is complete the ``.qm`` file that the window reads. PySide's ``lupdate`` files
words by class, which our catalogue does not ask for, and misses those of view-models.
"""

from __future__ import annotations

import argparse
import ast
import subprocess
import sys
import xml.etree.ElementTree as ET
from collections.abc import Iterator, Sequence
from pathlib import Path

from app.platform.translation import CONTEXT, translations_folder
from app.viewmodels.streams import option_fields
from tracker.base.catalogue import WORDS
from tracker.base.notices import GROUP as NOTICES
from tracker.base.notices import all_templates
from tracker.engine.kinds import ENGINES, engine_kinds
from tracker.session.export.formats import FORMATS, formats
from tracker.streaming.registry import STREAMS, stream_kinds
from tracker.streaming.remote.registry import DOORS, door_kinds

ROOT = Path(__file__).resolve().parents[2]
WINDOW = ("app", "extensions")
SAYS = ("tr", "mark", "translate")
"""Functions whose words are for the user; of ``translate`` the second argument."""

MARKED = (ast.Name, ast.Attribute, ast.Subscript)
"""Arguments of the plain ``tr`` that come from a table, where `mark` has listed them."""


def words_in(code: str) -> Iterator[tuple[str, int]]:
    """The words and their line. Raises ValueError where they are not written out."""
    for node in ast.walk(ast.parse(code)):
        if isinstance(node, ast.Call) and (name := _name(node.func)) in SAYS:
            at = 1 if name == "translate" else 0
            if name == "translate" and not _is_qt(node.func):
                continue
            word = node.args[at] if len(node.args) > at else None
            if isinstance(node.func, ast.Name) and _from_table(word):
                continue
            if not (isinstance(word, ast.Constant) and isinstance(word.value, str)):
                raise ValueError(f"line {node.lineno}: {ast.unparse(node)} holds no plain words")
            yield word.value, node.lineno


def _sources(root: Path, folders: Sequence[str]) -> Iterator[tuple[str, Path]]:
    """Each module's path from the root of the tree, tests left out."""
    for folder in folders:
        for path in sorted((root / folder).rglob("*.py")):
            inside = path.relative_to(root).as_posix()
            if "/tests/" not in inside:
                yield inside, path


def _from_table(word: ast.expr | None) -> bool:
    if isinstance(word, ast.Call):
        return isinstance(word.func, ast.Attribute) and word.func.attr == "get"
    return isinstance(word, MARKED)


def _name(function: ast.expr) -> str:
    if isinstance(function, ast.Attribute):
        return function.attr
    return function.id if isinstance(function, ast.Name) else ""


def _is_qt(function: ast.expr) -> bool:
    return isinstance(function, ast.Attribute) and _name(function.value) == "QCoreApplication"


def all_words(root: Path = ROOT) -> dict[str, str]:
    """Every text of the window and the first file with it, in the order of the files; then the
    templates of notices and the words that their values may be."""
    own = {"words.py", "translation.py", "translations.py"}
    found: dict[str, str] = {}
    for inside, path in _sources(root, WINDOW):
        if path.name not in own and (inside.startswith("app/") or "/window/" in inside):
            for text, _line in words_in(path.read_text("utf-8")):
                found.setdefault(text, inside)
    for engine in engine_kinds().values():
        for text in filter(None, (engine.title, engine.short)):
            found.setdefault(text, ENGINES.group)
    for kind in stream_kinds().values():
        helps = (each.help for each in option_fields(kind))
        for text in filter(None, (kind.title, kind.note, *helps)):
            found.setdefault(text, STREAMS.group)
    for door in door_kinds().values():
        for text in filter(None, (door.title, *door.fields.values())):
            found.setdefault(text, DOORS.group)
    for form in formats():
        found.setdefault(form.title, FORMATS.group)
    for text in (*all_templates().values(), *WORDS):
        found.setdefault(text, NOTICES)
    return found


def read(path: Path) -> dict[str, str]:
    """The finished translations of a ``.ts`` file."""
    if not path.exists():
        return {}
    messages = ET.parse(path).getroot().iter("message")
    done = {}
    for message in messages:
        target = message.find("translation")
        if target is not None and target.get("type") is None and target.text:
            done[message.findtext("source") or ""] = target.text
    return done


def write(path: Path, language: str, words: dict[str, str], done: dict[str, str]) -> None:
    """A ``.ts`` file with all ``words``; those not in ``done`` are unfinished."""
    root = ET.Element("TS", version="2.1", language=language, sourcelanguage="en")
    context = ET.SubElement(root, "context")
    ET.SubElement(context, "name").text = CONTEXT
    for text, place_of in words.items():
        message = ET.SubElement(context, "message")
        ET.SubElement(message, "location", filename=place_of)
        ET.SubElement(message, "source").text = text
        target = ET.SubElement(message, "translation")
        if text in done:
            target.text = done[text]
        else:
            target.set("type", "unfinished")
    ET.indent(root)
    path.parent.mkdir(parents=True, exist_ok=True)
    ET.ElementTree(root).write(path, "utf-8", xml_declaration=True)


def release(path: Path) -> Path:
    """The ``.qm`` file of a ``.ts`` file. Raises CalledProcessError."""
    target = path.with_suffix(".qm")
    tool = Path(sys.executable).with_name("pyside6-lrelease")
    subprocess.run([tool, path, "-qm", target], check=True, capture_output=True)
    return target


def main(argv: Sequence[str] | None = None) -> int:
    parser = argparse.ArgumentParser(prog="app.tools.translations")
    parser.add_argument("languages", nargs="*", default=["de"], help="language codes (default: de)")
    words = all_words()
    for language in parser.parse_args(argv).languages:
        path = translations_folder() / f"{CONTEXT}_{language}.ts"
        done = read(path)
        write(path, language, words, done)
        missing = words.keys() - done.keys()
        if not missing:
            release(path)
        print(f"{path.name}: {len(words) - len(missing)} of {len(words)} texts translated")
    return 0


if __name__ == "__main__":
    sys.exit(main())
