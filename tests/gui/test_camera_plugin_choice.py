"""A plug-in's camera in the window's list."""

from __future__ import annotations

import importlib
import sys
from pathlib import Path

from app.wizards.camera import CameraSetup
from tests.fixtures import ROOT

EXAMPLE = ROOT / "docs" / "examples" / "glovetrack-folder-camera"


def test_it_is_listed_and_chosen(window, qtbot, tmp_path: Path, monkeypatch) -> None:
    about = tmp_path / "folder_camera-1.dist-info"
    about.mkdir()
    (about / "METADATA").write_text("Metadata-Version: 2.1\nName: folder-camera\nVersion: 1\n")
    entry = "[glovetrack.cameras]\nfolder = glovetrack_folder_camera:FolderDriver\n"
    (about / "entry_points.txt").write_text(entry)
    monkeypatch.syspath_prepend(str(tmp_path))
    monkeypatch.syspath_prepend(str(EXAMPLE))
    monkeypatch.setenv("GLOVETRACK_FOLDER_CAMERAS", str(tmp_path))
    importlib.invalidate_caches()
    dialog = CameraSetup(window.host, window.store, window.tasks)
    qtbot.addWidget(dialog)
    title = f"Folder {tmp_path.name} (folder://{tmp_path})"
    qtbot.waitUntil(lambda: dialog.left.findText(title) > 0)
    dialog.left.setCurrentIndex(dialog.left.findText(title))
    assert dialog.choice() == f"name:Folder {tmp_path.name}"
    dialog.use.click()
    assert window.store.value.camera == f"name:Folder {tmp_path.name}"
    sys.modules.pop("glovetrack_folder_camera", None)
