"""A camera plug-in, installed as a user would and chosen in the window."""

from __future__ import annotations

import importlib
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from app.engines.camera_choice import choose
from app.storage.settings import AppSettings
from tests.fixtures import ROOT
from tests.notices import raises
from tracker.base.errors import DeviceError
from tracker.sensors.camera import StereoCamera
from tracker.sensors.camera_plugins import all_cameras, open_plugin, plugin_cameras
from tracker.sensors.image_input import CaptureFormat
from tracker.vision.rig import ideal_rig

EXAMPLE = ROOT / "docs" / "examples" / "glovetrack-folder-camera"
WANT = CaptureFormat(64, 48, 50.0)


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder into which pip has installed the example."""
    source, target = tmp_path_factory.mktemp("source"), tmp_path_factory.mktemp("site")
    for file in EXAMPLE.iterdir():
        if file.is_file():
            (source / file.name).write_bytes(file.read_bytes())
    options = ["--quiet", "--no-deps", "--no-build-isolation", "--no-index"]
    command = [sys.executable, "-m", "pip", "install", *options, "--target", target, source]
    subprocess.run(command, check=True, timeout=120)
    return target


@pytest.fixture
def folder(site: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """Three images in a folder that the installed plug-in knows."""
    monkeypatch.syspath_prepend(str(site))
    monkeypatch.setenv("GLOVETRACK_FOLDER_CAMERAS", str(tmp_path))
    rng = np.random.default_rng(1)
    for k in range(3):
        np.save(tmp_path / f"{k}.npy", rng.integers(30, 200, (2, 48, 64, 3), np.uint8))
    importlib.invalidate_caches()
    yield tmp_path
    sys.modules.pop("glovetrack_folder_camera", None)


@pytest.mark.long
def test_its_camera_is_listed_and_gives_images(folder: Path) -> None:
    (camera,) = [c for c in all_cameras() if c.path.startswith("folder://")]
    assert camera.name == f"Folder {folder.name}"
    t = [0.0]
    source = open_plugin(camera.path, WANT)
    stereo = StereoCamera(
        source, ideal_rig(64, 48), clock=lambda: t[0], sleep=lambda dt: t.append(t.pop() + dt)
    )
    frames = [f for f in (stereo.read(0.1) for _ in range(10)) if f is not None]
    assert len(frames) == 3
    left, right = np.load(folder / "1.npy")
    assert np.array_equal(frames[1].left, left) and np.array_equal(frames[1].right, right)
    assert stereo.drain_events()[-1].code == "camera.file_end"


@pytest.mark.parametrize("by_name", [True, False])
def test_the_window_opens_it_by_name_or_address(folder: Path, by_name: bool) -> None:
    text = f"name:Folder {folder.name}" if by_name else f"folder://{folder}"
    chosen = choose(AppSettings(camera=text), 64, 48, 50.0)
    chosen.source.open()
    pair = chosen.source.read()
    assert pair is not None and pair[0].shape == (48, 64, 3)
    chosen.source.close()


def test_a_faulty_plugin_is_reported(folder: Path, caplog) -> None:
    with raises(DeviceError, "camera.no_plugin"):
        open_plugin("realsense://1", WANT)
    (folder / "site").mkdir()
    with pytest.raises(DeviceError, match="site"):
        open_plugin(f"folder://{folder / 'site'}", WANT).open()
    module = sys.modules["glovetrack_folder_camera"]
    module.FolderDriver.cameras = lambda self: 1 / 0  # type: ignore[attr-defined]
    assert plugin_cameras() == []
    assert "The camera plug-in folder does not work: division by zero" in caplog.text
