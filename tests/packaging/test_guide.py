"""The user guide: its commands run, its links lead somewhere, its words are the window's."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest

from app.__main__ import main

GUIDE = Path(__file__).parents[2] / "docs" / "guide"
PAGES = sorted(GUIDE.glob("*.md"))
BLOCK = re.compile(r"^```sh\n(.*?)^```", re.MULTILINE | re.DOTALL)
LINK = re.compile(r"\]\((?!https?:)([^)#]+)")


def commands(page: Path) -> list[str]:
    """Lines of the page's shell blocks."""
    return [line for block in BLOCK.findall(page.read_text("utf-8")) for line in block.split("\n")]


def run(line: str) -> int:
    """Exit status of a line that begins with ``glovetrack``."""
    program, *words = shlex.split(line)
    assert program == "glovetrack", f"{line!r} is no command of ours"
    try:
        return main(words)
    except SystemExit as end:  # argparse ends --help and --version so
        return int(end.code or 0)


@pytest.fixture(scope="module")
def session(tmp_path_factory: pytest.TempPathFactory) -> bytes:
    """Three seconds without images, made once for all pages."""
    path = tmp_path_factory.mktemp("guide") / "session.mcap"
    assert run(f"glovetrack simulate -o {path} --duration 3 --blobs-only") == 0
    return path.read_bytes()


@pytest.mark.parametrize(
    "page", [p for p in PAGES if BLOCK.search(p.read_text("utf-8"))], ids=lambda p: p.stem
)
def test_every_command_of_a_page_runs(
    page: Path, session: bytes, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    for line in filter(None, commands(page)):
        made = re.fullmatch(r"glovetrack simulate -o (\S+) --duration 3 --blobs-only", line)
        if made:
            Path(made[1]).write_bytes(session)
        else:
            assert run(line) == 0, line


@pytest.mark.parametrize("page", PAGES, ids=lambda p: p.stem)
def test_links_and_images_are_there(page: Path) -> None:
    targets = LINK.findall(page.read_text("utf-8"))
    assert targets
    assert [t for t in targets if not (page.parent / t).exists()] == []


def test_every_page_is_listed() -> None:
    listed = LINK.findall((GUIDE / "README.md").read_text("utf-8"))
    assert {GUIDE / name for name in listed} == set(PAGES) - {GUIDE / "README.md"}


def test_shortcuts_are_the_windows() -> None:
    """Each key that the guide names is one that the window knows."""
    root = GUIDE.parents[1] / "app"
    files = (
        *("window/window_commands.py", "panels/library/session_page.py"),
        "wizards/guided/dialog.py",
    )
    texts = [(root / name).read_text("utf-8") for name in files]
    known = {key for text in texts for key in re.findall(r'"([^"\n]{1,12})"', text)}
    known |= {key for text in texts for key in re.findall(r"Key_([A-Z])\b", text)}
    told = {
        key
        for page in PAGES
        for key in re.findall(
            r"`((?:Ctrl|Shift)\+\w+|F\d+|Space|[A-Z0-9])`", page.read_text("utf-8")
        )
    }
    assert {"Ctrl+D", "Space"} <= told
    assert told <= known


def test_export_formats_are_all_told() -> None:
    from tracker.session.export.options import FORMATS

    text = (GUIDE / "exporting.md").read_text("utf-8")
    table = "\n".join(line.split("|")[1] for line in text.split("\n") if line.startswith("| `"))
    assert set(re.findall(r"`([\w.]+)`", table)) == set(FORMATS)
