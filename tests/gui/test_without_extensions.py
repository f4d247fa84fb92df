"""Each extension's folder can be removed: the window starts without it."""

import json
import os
import subprocess
import sys
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
HIDE = """
import sys

class Hidden:
    def find_spec(self, name, path=None, target=None):
        if name == {name!r} or name.startswith({name!r} + "."):
            raise ModuleNotFoundError(f"No module named {{name!r}}", name=name)

sys.meta_path.insert(0, Hidden())
"""
WINDOW = """
import json
from pathlib import Path
from PySide6.QtWidgets import QApplication
app = QApplication(["glovetrack"])
from app.storage.settings import SettingsStore
from app.window.main_window import MainWindow
window = MainWindow(SettingsStore(Path(sys.argv[1]) / "window.json"))
window.show()
window.layouts.show_first()
app.processEvents()
parts = [f"panel {name}" for name in window.panels]
parts += [f"command {key}" for key in window.commands.actions]
parts += [f"recordings {key}" for key in window.library.page.actions_of]
window.close()
print(json.dumps(parts))
"""


def parts_without(extension: str, folder: Path) -> set[str]:
    """Panels and commands of a window whose process cannot import the extension."""
    code = HIDE.format(name=f"extensions.{extension}") + WINDOW
    done = subprocess.run(
        [sys.executable, "-c", code, str(folder)],
        cwd=ROOT,
        env=os.environ | {"QT_QPA_PLATFORM": "offscreen", "HOME": str(folder)},
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    return {*json.loads(done.stdout.splitlines()[-1])}


@pytest.fixture(scope="module")
def whole(tmp_path_factory) -> set[str]:
    return parts_without("none", tmp_path_factory.mktemp("whole"))


@pytest.mark.parametrize("extension", EXTENSIONS)
def test_the_window_starts_without(extension, whole, tmp_path):
    lost = PARTS.get(extension, set())
    of_panels = {f"command dock_{part.removeprefix('panel ')}" for part in lost if "panel" in part}
    assert whole - parts_without(extension, tmp_path) == lost | of_panels
