"""The layer is registered for one user: manifest, copy of the library, and the command's words."""

from __future__ import annotations

import json
import mmap
from pathlib import Path

import numpy as np
import pytest

from extensions.openxr.layout import READER, READERS_AT, Space
from extensions.openxr.library import DISABLE, LAYER
from extensions.openxr.memory import ELSEWHERE
from extensions.openxr.publisher import OpenXrPublisher, WorldPlacement
from extensions.openxr.registration import (
    ENABLED,
    LayerRegistration,
    Registered,
    WindowsRegistry,
    implicit_layers,
    user_registration,
)
from tests.notices import raises
from tests.streaming.conftest import MakeEstimate
from tracker import cli
from tracker.base.errors import FileError
from tracker.streaming.publisher import Names


class FakeRegistry:
    """The values of the current user's key, as Windows has them."""

    def __init__(self) -> None:
        self.values: dict[str, int] = {r"C:\other\layer.json": 0}

    def names(self) -> list[str]:
        return list(self.values)

    def set(self, name: str, value: int) -> None:
        self.values[name] = value

    def remove(self, name: str) -> None:
        del self.values[name]


@pytest.fixture
def registration(tmp_path: Path) -> LayerRegistration:
    library = tmp_path / "installed" / "liblayer.so"
    library.parent.mkdir()
    library.write_bytes(b"one")
    layers = implicit_layers({"XDG_DATA_HOME": str(tmp_path / "data")})
    return LayerRegistration(library, tmp_path / "data" / "glovetrack", layers / "layer.json")


def test_the_manifest_names_a_copy_of_the_library(registration: LayerRegistration) -> None:
    assert registration.state() == Registered.NO
    registration.register()
    assert registration.state() == Registered.YES
    layer = json.loads(registration.manifest.read_text())["api_layer"]
    assert layer["name"] == LAYER and layer["disable_environment"] == DISABLE
    assert Path(layer["library_path"]).read_bytes() == b"one"
    assert Path(layer["library_path"]) == registration.copy != registration.library
    assert registration.manifest.parts[-5:-1] == ("openxr", "1", "api_layers", "implicit.d")
    registration.unregister()
    registration.unregister()
    assert registration.state() == Registered.NO and not registration.copy.exists()


def test_another_version_and_a_missing_library_are_noticed(registration: LayerRegistration) -> None:
    registration.register()
    registration.library.write_bytes(b"two")
    assert registration.state() == Registered.OLD
    registration.register()
    assert registration.state() == Registered.YES and registration.copy.read_bytes() == b"two"
    registration.copy.unlink()
    assert registration.state() == Registered.BROKEN
    registration.register()
    registration.manifest.write_text("{")
    assert registration.state() == Registered.BROKEN


def test_an_installation_without_the_layer_says_so(registration: LayerRegistration) -> None:
    registration.library.unlink()
    with raises(FileError, "openxr.no_layer"):
        registration.register()
    assert registration.state() == Registered.NO


def test_a_folder_that_cannot_be_written_is_an_error(registration: LayerRegistration) -> None:
    registration.manifest.parent.parent.mkdir(parents=True)
    registration.manifest.parent.write_text("a file")
    with raises(FileError, "openxr.not_registered"):
        registration.register()


def test_windows_names_the_manifest_in_its_registry(registration: LayerRegistration) -> None:
    """Others' values stay."""
    registry = FakeRegistry()
    windows = LayerRegistration(
        registration.library, registration.folder, registration.folder / "layer.json", registry
    )
    windows.register()
    assert registry.values == {r"C:\other\layer.json": 0, str(windows.manifest): ENABLED}
    assert windows.state() == Registered.YES
    registry.remove(str(windows.manifest))
    assert windows.state() == Registered.NO, "the manifest alone is not found"
    windows.register()
    windows.unregister()
    assert registry.values == {r"C:\other\layer.json": 0} and not windows.manifest.exists()


def test_elsewhere_there_is_no_registry_of_windows() -> None:
    assert WindowsRegistry().names() == []


def run(capsys: pytest.CaptureFixture[str], words: str) -> tuple[int, str]:
    status = cli.main(["openxr", words])
    out = capsys.readouterr()
    return status, out.out + out.err


def test_the_command_registers_reports_and_unregisters(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    monkeypatch.setenv(ELSEWHERE, str(tmp_path / "memory"))
    library = tmp_path / "liblayer.so"
    library.write_bytes(b"one")
    made = user_registration(library)
    monkeypatch.setattr("extensions.openxr.registration.user_registration", lambda: made)
    assert run(capsys, "status") == (1, "layer: not registered\nstream: off\n")
    status, text = run(capsys, "register")
    assert status == 0 and str(made.manifest) in text and made.manifest.is_relative_to(tmp_path)
    assert run(capsys, "status") == (0, "layer: registered\nstream: off\n")
    assert run(capsys, "unregister") == (0, "The OpenXR layer is unregistered.\n")
    assert run(capsys, "unregister") == (0, "The OpenXR layer was not registered.\n")


def test_the_status_lists_what_is_sent_and_who_reads(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
    names: Names,
    make_estimate: MakeEstimate,
) -> None:
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path))
    memory = tmp_path / "memory"
    monkeypatch.setenv(ELSEWHERE, str(memory))
    placed = WorldPlacement(Space.LOCAL, (0.0, 0.0, 0.0), 0.0, 0.05)
    publisher = OpenXrPublisher(names.with_openxr(), placed)
    assert "estimates: none" in run(capsys, "status")[1]
    publisher.send(make_estimate())
    text = run(capsys, "status")[1]
    assert "estimates: right 1" in text and "none has read the hand" in text
    with memory.open("r+b") as file, mmap.mmap(file.fileno(), 0) as shared:
        entry = np.frombuffer(shared, READER, 1, READERS_AT)
        entry["process"], entry["name"], entry["readings"] = 77, b"Viewer", 9
        del entry
    assert "application: Viewer (process 77), last reading:" in run(capsys, "status")[1]
    publisher.close()
