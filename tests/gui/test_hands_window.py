"""Two hands in the window: replayed from a session, and with two gloves that are plugged in and
out."""

from __future__ import annotations

import time
from dataclasses import replace
from functools import partial

import numpy as np
import pytest
from PySide6.QtCore import Qt

from app.engines.protocols import RecordingRequest
from app.storage.bound_gloves import BoundGlove, with_bound
from app.storage.settings import AppSettings
from app.viewmodels.camera_overlay import Layers, overlay
from app.viewmodels.colours import hue_colours
from app.wizards.glove.feed import InstructedWearer
from tests.simulated_sessions import BOTH
from tracker.glove import library
from tracker.sensors.glove_port import GlovePort
from tracker.sensors.serial_line import UsbPort
from tracker.session.motion import read_take
from tracker.session.reader import SessionReader
from tracker.session.verify import is_ok, verify
from tracker.simulation.glove_device import GloveDeviceParams, SimulatedGlove

pytestmark = pytest.mark.long

BOUND = {
    11: BoundGlove("right", "vist-small", "reference-right"),
    22: BoundGlove("left", "vist-small-left", "reference-left"),
}


@pytest.fixture(scope="module")
def session(simulated_sessions):
    """Two simulated hands, tracked, with what the sensors gave."""
    return simulated_sessions.tracked(BOTH)


@pytest.fixture
def replay(window, session, qtbot):
    """Paused where both hands are tracked."""
    window.sources.open_session(session)
    qtbot.waitUntil(lambda: window.host.running)
    player = window.host.setup.player
    player.play(False)
    player.seek(2.0)
    qtbot.waitUntil(lambda: all(known(hand, 1.8) for hand in looks(window)))
    return window


def looks(window):
    view = window.host.snapshot()
    return view.hands if view is not None else ()


def known(hand, since: float) -> bool:
    t, start = hand.estimate, hand.setup.engine.start_t
    return t is not None and t.t - start > since and hand.frame is not None


def test_a_session_of_both_is_shown_completely(replay, qtbot):
    left, right = looks(replay)
    assert [left.setup.side, right.setup.side] == ["left", "right"]
    assert len(left.imu) > 5 and len(right.imu) > 5
    assert (left.imu[0].gyro != right.imu[0].gyro).all()
    qtbot.waitUntil(lambda: len(replay.hand._hands) == 2)
    qtbot.waitUntil(lambda: all(h.scene and h.skin for h in replay.hand._hands))
    for hand in replay.hand._hands:
        view = next(v for v in (left, right) if v.setup.side == hand.setup.side)
        assert abs(hand.scene.segment_p[0] - view.estimate.segment_p[0]).max() < 0.05
        qtbot.waitUntil(lambda drawn=hand.bodies._hand: drawn.shown)
    view = replay.host.snapshot()
    only = Layers(False, False, False, False, False, skeleton=True)
    colours = hue_colours(view.setup.profile)

    def bones(of):
        return sum(len(lines.ends) for lines in overlay(of, only, colours, False))

    alone = [bones(replace(h, others=())) for h in view.hands]
    assert bones(view) == sum(alone) and min(alone) > 15
    qtbot.waitUntil(lambda: replay.bar.other_hand.isVisible())
    assert replay.bar.tracking.text().startswith("Right: ")
    assert replay.bar.other_hand.text().startswith("Left: ")


def test_panels_of_one_hand_show_the_selected_one(replay, qtbot):
    assert replay.host.setup.side == "right"
    replay.run_command("hand_left")
    assert replay.host.setup.side == "left" and replay.host.setup.others[0].side == "right"
    assert replay.motion.model is not None
    assert replay.hand._hands[0].setup.side == "left"
    view = replay.host.snapshot()
    assert view.setup.side == "left" and view.estimate.t == view.hands[0].estimate.t
    replay.run_command("hand_right")
    assert replay.host.setup.side == "right"


ONE_HAND_PANELS = ("sensors", "motion", "calibration", "checklist", "applications", "robot")


@pytest.mark.parametrize("name", ONE_HAND_PANELS)
def test_a_panel_of_one_hand_names_it_and_can_switch(replay, qtbot, name):
    replay.show_panel(name)
    choice = replay.panels[name].hand_choice
    qtbot.waitUntil(choice.isVisible)
    left, right = choice._segments.buttons
    assert (left.text(), right.text()) == ("Left hand", "Right hand")
    assert right.isChecked() and not left.isChecked()
    qtbot.mouseClick(left, Qt.MouseButton.LeftButton)
    assert replay.host.setup.side == "left"
    for other in ONE_HAND_PANELS:  # all show the same hand
        buttons = replay.panels[other].hand_choice._segments.buttons
        assert [b.isChecked() for b in buttons] == [True, False], other
    qtbot.mouseClick(left, Qt.MouseButton.LeftButton)
    assert left.isChecked(), "one of both is always shown"


def test_motion_measures_the_take_of_the_hand_that_is_shown(replay, session, qtbot):
    for side in ("left", "right"):
        replay.host.show_hand(side)
        qtbot.waitUntil(lambda: replay.motion.model.take is not None)
        with SessionReader(session, side=side) as reader:
            own = read_take(reader)
        shown = replay.motion.model.take
        assert np.array_equal(shown.angles, own.angles, equal_nan=True), side


def test_one_hand_needs_no_selector(live):
    assert all(live.panels[name].hand_choice.isHidden() for name in ONE_HAND_PANELS)


@pytest.fixture
def gloves():
    """Two worn gloves on pseudo-terminals, by their numbers."""
    made = {}
    for number, known_as in BOUND.items():
        hand, glove = library.load(known_as.glove, known_as.hand)
        made[number] = SimulatedGlove(
            InstructedWearer(hand, glove).samples(),
            len(glove.imus),
            time.monotonic(),
            GloveDeviceParams(glove_id=number),
        )
    yield made
    for device in made.values():
        device.stop()


@pytest.fixture
def two_gloves(window, qtbot, store, gloves, monkeypatch):
    """The window with two known gloves plugged in as USB adapters of one kind, and no camera."""
    plugged = set(gloves)

    def ports() -> list[UsbPort]:
        return [UsbPort(gloves[n].path, 1, 2, None) for n in sorted(plugged)]

    monkeypatch.setattr("app.engines.camera_choice.all_cameras", list)
    monkeypatch.setattr("app.engines.found_gloves.serial_ports", lambda: [p.path for p in ports()])
    monkeypatch.setattr("app.engines.found_gloves.GlovePort", partial(GlovePort, ports=ports))
    settings = AppSettings()
    for number, known_as in BOUND.items():
        settings = AppSettings(gloves=with_bound(settings, number, known_as))
    store.update(port="", camera="", calibration="", gloves=settings.gloves)
    return plugged


def opened(window, qtbot):
    window.sources.open_devices()
    qtbot.waitUntil(lambda: window.host.running)


def newest(window, side: str) -> float:
    """Time (s) of the last packet of that hand's glove."""
    hand = next((hand for hand in looks(window) if hand.setup.side == side), None)
    return hand.imu[-1].t if hand is not None and hand.imu else 0.0


def goes_on(window, qtbot, side: str) -> None:
    """Waits for new packets of that glove."""
    since = newest(window, side)
    qtbot.waitUntil(lambda: newest(window, side) > since + 0.3, timeout=90_000)


def log_count(window, text: str) -> int:
    """Number of log entries with a text."""
    items = (window.log.list.item(i).text() for i in range(window.log.list.count()))
    return sum(text in item for item in items)


def test_gloves_are_unplugged_and_plugged_in_any_order(window, qtbot, gloves, two_gloves, tmp_path):
    opened(window, qtbot)
    sides = {hand.setup.connection.number: hand.setup.side for hand in looks(window)}
    assert sides == {11: "right", 22: "left"}
    assert window.store.value.both_hands
    for side in ("left", "right"):
        goes_on(window, qtbot, side)
    path = tmp_path / "both.mcap"
    assert window.host.recording.begin(RecordingRequest(path, "", ""))
    for number, side, other in ((22, "left", "right"), (11, "right", "left")):
        two_gloves.discard(number)
        gloves[number].unplug()
        away = f"{side.capitalize()} glove: The glove was unplugged"
        qtbot.waitUntil(lambda text=away: log_count(window, text) == 1, timeout=90_000)
        goes_on(window, qtbot, other)
        gloves[number].plug()
        two_gloves.add(number)
        goes_on(window, qtbot, side)
    window.host.stop()
    window.host.recording.wait()
    assert is_ok(verify(path))


def test_two_gloves_without_a_camera_have_not_lost_a_position(window, qtbot, two_gloves):
    opened(window, qtbot)
    for chip in (window.bar.tracking, window.bar.other_hand):
        qtbot.waitUntil(lambda chip=chip: "Position unknown" in chip.text())


def test_the_other_hands_glove_is_connected_when_plugged_in(
    window, qtbot, gloves, two_gloves, store
):
    store.update(both_hands=True)
    two_gloves.discard(22)
    opened(window, qtbot)
    goes_on(window, qtbot, "right")
    assert newest(window, "left") == 0.0
    two_gloves.add(22)
    goes_on(window, qtbot, "left")
    goes_on(window, qtbot, "right")
