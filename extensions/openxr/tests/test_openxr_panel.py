"""The panel *OpenXR* in the window: registration, placement and the test by clicks."""

from __future__ import annotations

import dataclasses
import mmap
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from app.viewmodels.states import BAD, GOOD, WARN
from app.window.main_window import MainWindow
from extensions.openxr.layout import HEADER, READER, READERS_AT, Space
from extensions.openxr.library import LIBRARY_NAME
from extensions.openxr.memory import ELSEWHERE, attach
from extensions.openxr.publisher import WorldPlacement
from extensions.openxr.readers import Link, Reader, read_link
from extensions.openxr.registration import LayerRegistration, Registered
from extensions.openxr.tests.scene import world_in
from extensions.openxr.window.panel import OpenXrPanel, stream_text, test_result
from tests.gui.gui_fakes import ScriptedEngine, scripted_setup
from tests.notices import shows

verdict = test_result
del test_result  # pytest would collect it
S = 1_000_000_000
VIEWER = Reader(7, "Viewer", 10 * S, 90, 90)
LINK = Link(True, (0, 5), (VIEWER,), 10 * S)

PATIENCE_MS = 60_000  # on a loaded computer


@pytest.fixture
def memory(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv(ELSEWHERE, str(tmp_path / "memory"))
    return tmp_path / "memory"


@pytest.fixture
def registration(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> LayerRegistration:
    """For a user with a folder of this test's own."""
    library = tmp_path / "installed" / LIBRARY_NAME
    library.parent.mkdir()
    library.write_bytes(b"a library")
    made = LayerRegistration(library, tmp_path / "data", tmp_path / "layers" / "layer.json")
    monkeypatch.setattr("extensions.openxr.window.panel.user_registration", lambda: made)
    return made


@pytest.fixture
def panel(
    memory: Path, registration: LayerRegistration, window: MainWindow, qtbot
) -> Iterator[OpenXrPanel]:
    made = OpenXrPanel(window.host, window.outputs, lambda: registration)
    qtbot.addWidget(made)
    yield made


def test_the_window_has_the_panel(window: MainWindow) -> None:
    window.run_command("show_openxr")
    assert window.panels["openxr"].isVisible()


def test_the_layer_is_registered_by_a_button(panel: OpenXrPanel, registration) -> None:
    assert "not registered" in panel.layer.text() and not panel.unregister.isEnabled()
    panel.register.click()
    assert registration.state() == Registered.YES
    assert "is registered" in panel.layer.text() and not panel.register.isEnabled()
    panel.unregister.click()
    assert registration.state() == Registered.NO and panel.register.isEnabled()


def test_why_the_layer_cannot_be_registered_is_reported(
    panel: OpenXrPanel, registration, window: MainWindow
) -> None:
    registration.library.unlink()
    errors: list[str] = []
    window.host.error.connect(errors.append)
    panel.register.click()
    assert shows(errors[0], "openxr.no_layer")


def test_the_placement_is_what_the_stream_sends(
    panel: OpenXrPanel, window: MainWindow, memory: Path, qtbot
) -> None:
    window.host.adopt(scripted_setup(ScriptedEngine()))
    panel.box.click()
    qtbot.waitUntil(lambda: read_link() is not None, timeout=PATIENCE_MS)
    panel.numbers["y"].setValue(-0.6)
    panel.numbers["yaw"].setValue(90)
    panel.space.setCurrentIndex(1)
    panel.space.activated.emit(1)

    def sent() -> tuple[int, list[float], list[float]]:
        """Space, position and orientation; a stream that is opened again has no memory between."""
        shared = attach(str(memory))
        if shared is None:
            return 0, [], []
        header = np.frombuffer(shared, HEADER, 1)[0].copy()
        return int(header["space"]), header["position"].tolist(), header["orientation"].tolist()

    expected = (
        3,
        pytest.approx([0.0, -0.6, -0.25]),
        pytest.approx([0, 0.7071068, 0, 0.7071068]),
    )
    qtbot.waitUntil(lambda: sent() == expected, timeout=PATIENCE_MS)
    panel.box.click()
    qtbot.waitUntil(lambda: not memory.exists(), timeout=PATIENCE_MS)


@pytest.mark.long
def test_the_test_reports_an_application_that_reads(
    panel: OpenXrPanel, window: MainWindow, memory: Path, qtbot
) -> None:
    """The entry is one that a layer would write; `test_openxr_layer` has real ones."""
    window.host.adopt(scripted_setup(ScriptedEngine()))
    panel.register.click()
    panel.test.click()
    qtbot.waitUntil(lambda: "Nothing is sent" in panel.result.text(), timeout=PATIENCE_MS)
    panel.box.click()
    qtbot.waitUntil(lambda: read_link() is not None, timeout=PATIENCE_MS)
    panel.test.click()
    qtbot.waitUntil(
        lambda: "No application has read the hand" in panel.result.text(), timeout=PATIENCE_MS
    )
    panel.test.click()
    with memory.open("r+b") as file, mmap.mmap(file.fileno(), 0) as shared:
        entry = np.frombuffer(shared, READER, 1, READERS_AT)
        link = read_link()
        assert link is not None
        entry["process"], entry["name"] = 7, b"<Viewer>"
        entry["last"], entry["readings"], entry["active"] = link.now_ns + 60 * S, 90, 90
        del entry
    qtbot.waitUntil(lambda: "reads the hand" in panel.result.text(), timeout=PATIENCE_MS)
    assert "&lt;Viewer&gt;" in panel.result.text()
    panel.refresh(None)
    assert "read by &lt;Viewer&gt;" in panel.stream.text()
    panel.box.click()
    qtbot.waitUntil(lambda: not memory.exists(), timeout=PATIENCE_MS)


def test_a_button_places_the_hand_in_front_of_the_headset(
    panel: OpenXrPanel, window: MainWindow
) -> None:
    reported: list[str] = []
    window.host.error.connect(reported.append)
    panel.in_front.click()
    assert "not tracked" in reported[0]
    engine = ScriptedEngine()
    setup = scripted_setup(engine)
    window.host.adopt(setup)
    panel.numbers["yaw"].setValue(90)
    estimate = setup.tracked.latest_estimate()
    assert estimate is not None
    panel.in_front.click()
    wrist = estimate.keypoints[setup.hand.keypoint_names.index("wrist")]
    there = WorldPlacement(Space.LOCAL, tuple(panel.numbers[n].value() for n in "xyz"), 90.0, 0.05)
    R, p = world_in("local", there, 0.0)
    found = R.apply([-wrist[1], wrist[2], -wrist[0]]) + p
    assert found.tolist() == pytest.approx([0.0, -0.3, -0.4], abs=0.01)


def test_the_verdict_follows_the_counts() -> None:
    later = dataclasses.replace(VIEWER, last_ns=12 * S, readings=270, active=270)
    after = dataclasses.replace(LINK, readers=(later,), now_ns=12 * S)
    good = verdict(Registered.YES, True, LINK, after, 2.0)
    assert good.look == GOOD and good.text == "Viewer reads the hand 90 times per second."
    lost = dataclasses.replace(LINK, readers=(dataclasses.replace(later, active=90),))
    assert "but the hand is lost" in verdict(Registered.YES, True, LINK, lost, 2.0).text
    ended = dataclasses.replace(LINK, now_ns=40 * S)
    assert verdict(Registered.YES, True, LINK, ended, 1.0).look == WARN
    assert "Viewer, 30 s ago" in verdict(Registered.YES, True, LINK, ended, 1.0).text
    assert verdict(Registered.YES, True, None, None, 1.0).look == BAD
    assert "not registered" in verdict(Registered.NO, True, LINK, after, 2.0).text


def test_the_state_of_the_stream_is_named() -> None:
    assert stream_text(False, LINK).text == "The hand is not sent."
    assert "as soon as tracking runs" in stream_text(True, None).text
    assert "read by Viewer" in stream_text(True, LINK).text
    idle = dataclasses.replace(LINK, now_ns=20 * S)
    assert "No application reads it now" in stream_text(True, idle).text
