"""Each extension's folder can be removed: the window and the command line start without it."""

import json
import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
EXTENSIONS = sorted(p.parent.name for p in (ROOT / "extensions").glob("*/__init__.py"))
PARTS = {
    "applications": {"panel applications"},
    "conformance": {"command conformance"},
    "movement": {"recordings report"},
    "openxr": {"panel openxr"},
    "reference": {
        "command reference_import", "command reference_accuracy",
        "recordings reference_accuracy_of",
    },
    "robot": {"panel robot"},
    "room": {"command room_tracker"},
    "study": {"command study"},
    "touch": {"command touch_test"},
}  # fmt: skip
"""What the window loses with each folder; nothing with the others."""
STARTS = """
import contextlib
import io
import json
import os
import sys
from pathlib import Path
from PySide6.QtWidgets import QApplication
from app.storage.settings import SettingsStore
from app.window import theme
from app.window.main_window import MainWindow

theme.style_sheet = lambda colours: ""  # half of the time of making a window

class Hidden:
    def __init__(self, name):
        self.name = name

    def find_spec(self, name, path=None, target=None):
        if name == self.name or name.startswith(self.name + "."):
            raise ModuleNotFoundError(f"No module named {name!r}", name=name)

def parts(folder):
    app = QApplication(["glovetrack"])
    window = MainWindow(SettingsStore(folder / "window.json"))
    window.show()
    window.layouts.show_first()
    app.processEvents()
    parts = [f"panel {name}" for name in window.panels]
    parts += [f"command {key}" for key in window.commands.actions]
    parts += [f"recordings {key}" for key in window.library.page.actions_of]
    window.close()
    return parts

def describe_commands():
    from tracker.cli import main

    for words in ([], ["track"], ["export"]):
        with contextlib.redirect_stdout(io.StringIO()) as text, contextlib.suppress(SystemExit):
            main([*words, "--help"])
        assert text.getvalue().startswith("usage: glovetrack"), words

assert not [name for name in sys.modules if name.startswith("extensions.")]
for extension in sys.argv[2:]:
    folder = Path(sys.argv[1]) / extension
    folder.mkdir()
    child = os.fork()
    if child == 0:
        sys.meta_path.insert(0, Hidden(f"extensions.{extension}"))
        (folder / "parts.json").write_text(json.dumps(parts(folder)))
        describe_commands()
        sys.stdout.flush()
        os._exit(0)
    assert os.waitpid(child, 0)[1] == 0, extension
"""


@pytest.fixture(scope="module")
def parts(tmp_path_factory) -> Callable[[str], set[str]]:
    """``parts(extension)``: panels and commands of a window whose process cannot import it.

    One process imports Qt and the core, which is half of the work and imports no extension, and
    forks one for each window."""
    folder = tmp_path_factory.mktemp("starts")
    done = subprocess.run(
        [sys.executable, "-c", STARTS, str(folder), "none", *EXTENSIONS],
        cwd=ROOT,
        env=os.environ | {"QT_QPA_PLATFORM": "offscreen", "HOME": str(folder)},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    return lambda name: {*json.loads((folder / name / "parts.json").read_text())}


@pytest.mark.parametrize("extension", EXTENSIONS)
def test_the_window_starts_without(extension, parts):
    lost = PARTS.get(extension, set())
    of_panels = {f"command dock_{part.removeprefix('panel ')}" for part in lost if "panel" in part}
    assert parts("none") - parts(extension) == lost | of_panels
