"""Two takes on one time axis: parts of one session, so that what they must show is known."""

from __future__ import annotations

import shutil
from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import Qt

from app.panels.library.two_recordings_dialog import TwoRecordingsDialog
from app.viewmodels.two_recordings import (
    RecordingAngles,
    RecordingImages,
    TwoRecordings,
    between,
    figures_text,
    read_angles,
)
from tracker.messages import StereoFrame
from tracker.offline.crop import crop
from tracker.session.align import read_alignment
from tracker.session.reader import SessionReader
from tracker.session.writer import RecorderParams, SessionRecorder

pytestmark = pytest.mark.long

LATER = 0.3  # s that the second part begins after the first
JOINT = "index_mcp_flexion"


@pytest.fixture(scope="module")
def parts(tmp_path_factory, simulated_sessions):
    """0.5 to 2 s and 0.8 to 2.4 s of one tracked session."""
    folder = tmp_path_factory.mktemp("takes")
    tracked = simulated_sessions.tracked()
    crop(tracked, folder / "a.mcap", 0.5, 2.0)
    crop(tracked, folder / "b.mcap", 0.5 + LATER, 2.4)
    return folder / "a.mcap", folder / "b.mcap"


@pytest.fixture(scope="module")
def takes(parts):
    return TwoRecordings(*map(read_angles, parts))


def test_by_the_clock_two_parts_of_one_movement_are_the_same(takes):
    assert takes.by_clock == pytest.approx(LATER, abs=0.02)
    for name in takes.names:
        found = takes.figures(name, takes.by_clock)
        assert found is not None and found.common > 1.0
        assert found.largest < 1e-6  # times in s hold ns: 20 rad/s times that


def test_at_another_offset_they_differ_as_the_movement_does(takes):
    """Shifted by 0.1 s the difference is that of the first take with itself 0.1 s earlier."""
    t, angle, _, _ = takes.curves(JOINT, 0.0)
    expected = between(t - 0.1, t, angle) - angle
    found = takes.difference(JOINT, takes.by_clock + 0.1)
    both = np.isfinite(found) & np.isfinite(expected)
    assert both.sum() > 80
    np.testing.assert_allclose(found[both], expected[both], atol=1e-3)
    assert takes.figures(JOINT, 100.0) is None
    assert "no tracked instant in common" in figures_text(None)


def test_gaps_are_not_filled_in():
    known = np.array([0.0, 0.01, 0.02, 0.5, 0.51])
    out = between(np.array([-0.1, 0.005, 0.3, 0.505, 0.6]), known, np.arange(5.0))
    np.testing.assert_array_equal(np.isfinite(out), [False, True, False, True, False])


def test_curves_and_their_difference_are_interrupted_in_a_hole(takes):
    first = takes.first
    rows = (first.t < 0.5) | (first.t > 0.9)
    holed = TwoRecordings(replace(first, t=first.t[rows], angles=first.angles[rows]), takes.second)
    t, angle, _, _ = holed.curves(JOINT, takes.by_clock)
    inside = (t > 0.51) & (t < 0.89)
    assert inside.sum() == 1 and np.isnan(angle[inside]).all()
    assert np.isnan(holed.difference(JOINT, takes.by_clock)[inside]).all()
    whole, less = (x.figures(JOINT, takes.by_clock) for x in (takes, holed))
    assert whole.common - less.common == pytest.approx(0.4, abs=0.03)


@pytest.fixture
def beside(window, store, parts, tmp_path, qtbot):
    """The dialog that two selected sessions give."""
    folder = tmp_path / "sessions"
    folder.mkdir()
    for path in parts:
        shutil.copy2(path, folder / path.name)
    window.show_panel("library")
    table = window.library.table
    qtbot.waitUntil(lambda: table.rowCount() == 2)
    table.selectAll()
    window.run_command("beside")
    qtbot.waitUntil(lambda: window.findChild(TwoRecordingsDialog) is not None)
    qtbot.waitUntil(lambda: window.host.running)
    return window.findChild(TwoRecordingsDialog)


def test_the_second_hand_goes_along_with_the_first(beside, window, qtbot):
    player, engine = window.host.setup.player, window.host.setup.engine
    assert player.path.name == "a.mcap"
    window.run_command("play") if player.playing else None
    player.seek(0.9)

    def difference() -> float:
        hand, estimate = player.reference("right"), engine.hands.moments["right"].latest_estimate()
        if hand is None or estimate is None or abs(player.position - 0.9) > 0.1:
            return np.nan
        return float(np.nanmax(np.abs(hand.keypoints - estimate.keypoints)))

    qtbot.waitUntil(lambda: difference() < 1e-9)
    beside.offset.setValue(LATER + 0.4)
    qtbot.waitUntil(lambda: difference() > 1e-3)
    qtbot.mouseClick(beside.clock_button, Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: difference() < 1e-9)


def test_curves_line_and_offset_go_together(beside, window, qtbot):
    assert "differ by 0.0°" in beside.figures.text()
    beside.begin.setValue(0.0)  # as by the mouse
    assert beside.offset.value() == 0.0
    assert "differ by 0.0°" not in beside.figures.text()
    assert beside.curves[1].getData()[0][0] == pytest.approx(0.0, abs=0.05)
    window.host.setup.player.play(False)
    beside.cursor_line.setValue(0.7)
    qtbot.waitUntil(lambda: window.host.setup.player.position == pytest.approx(0.7, abs=0.1))
    beside.close()
    qtbot.wait(50)
    window.library.refresh(None)  # nothing follows a closed dialog


def test_images_of_a_take_are_those_of_the_instant(parts, tmp_path):
    path = tmp_path / "images.mcap"
    with SessionReader(parts[0]) as reader:
        info = replace(reader.info, rig=None)
    begin = info.anchor.monotonic_ns * 1e-9
    with SessionRecorder(path, info, RecorderParams(sync=False)) as recorder:
        for k in range(5):
            t, image = begin + 0.1 * k, np.full((48, 64, 3), 40 * k, np.uint8)
            recorder.write(StereoFrame(t, t, image, image, index=k))
    images = RecordingImages(path)
    grey = [images.at(p).mean() / 40 for p in (0.0, 0.19, 0.2, 0.25, 0.45)]
    np.testing.assert_allclose(grey, [0, 1, 2, 2, 4], atol=0.1)  # JPEG keeps a plain image well
    assert images.at(2.0) is None  # long after the last one
    images.close()


def test_images_of_both_takes_follow_position_and_offset(beside, window, monkeypatch, qtbot):
    asked = {0: np.nan, 1: np.nan}  # s in each take, the latest
    for k, source in enumerate(beside.images._sources):
        monkeypatch.setattr(source, "at", lambda p, k=k: asked.update({k: p}))
    player = window.host.setup.player
    player.play(False)
    beside.set_offset(0.25)
    player.seek(0.9)
    qtbot.waitUntil(lambda: abs(asked[0] - player.position) < 1e-6)
    assert asked[0] == pytest.approx(0.9, abs=0.1)
    qtbot.waitUntil(lambda: asked[1] == pytest.approx(asked[0] - 0.25))


def test_by_movement_the_offset_is_found_and_kept_for_the_next_time(tmp_path):
    rng = np.random.default_rng(5)
    waves = rng.uniform(0.2, 2.0, (12, 1)), rng.uniform(0, 7, (12, 1))
    t = np.arange(1500) / 100
    names = tuple(f"joint_{k}" for k in range(12))

    def take(name: str, since: float) -> RecordingAngles:
        angles = np.sin(2 * np.pi * waves[0] * (t + since) + waves[1]).T
        return RecordingAngles(tmp_path / name, 0.0, 10**18, 15.0, names, t, angles)

    pair = TwoRecordings(take("a.mcap", 0.0), take("b.mcap", 2.34))
    found = pair.by_movement()
    assert found.offset == pytest.approx(2.34, abs=0.003) and found.correlation > 0.95
    assert pair.kept is None
    assert pair.save(found.offset) == tmp_path / "b.aligned.json"
    assert pair.kept == pytest.approx(2.34, abs=0.003)
    assert replace(pair, first=take("c.mcap", 0.0)).kept is None, "it is of another pair"
    assert read_alignment(tmp_path / "b.aligned.json").clocks_differ_s == pytest.approx(
        2.34, abs=0.003
    )


def test_the_dialog_seeks_by_movement_and_keeps(beside):
    before = beside.offset.value()
    beside.movement_button.click()
    assert beside.offset.value() == before, "the parts are too short to be sure of"
    assert beside.figures.text().startswith("The ")
    beside.set_offset(0.25)
    beside.store_button.click()
    assert beside.figures.text() == "Saved to b.aligned.json."
    assert beside.takes.kept == 0.25
