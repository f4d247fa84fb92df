"""The set-up list in the window: what is green, what is orange, and what remains done."""

from __future__ import annotations

import threading
from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from app.viewmodels.states import GOOD, IDLE, WARN
from tests.gui.gui_fakes import ScriptedEngine, frame_and_blobs, scripted_setup
from tracker.base.notices import warning
from tracker.calibration.light_meter import Advice, LightMeter
from tracker.messages import Status, Tracking


class Rig(ScriptedEngine):
    """A rig whose calibration, devices and blobs are set by a test."""

    def __init__(self) -> None:
        super().__init__()
        self.sd = 1.0  # of the calibration, in those at which it has settled
        self.bias_dps = 0.2
        self.unseen = ()  # hues that are not found
        self.now = 0.0  # s that the status is after the images and packets

    def calibration(self):
        c = super().calibration()
        return replace(
            c,
            scale_sd=np.full_like(c.scale, 0.01 * self.sd),
            mounting_sd=np.full_like(c.mounting, np.deg2rad(2.0) * self.sd),
            gyro_bias_sd=np.full_like(c.gyro_bias, np.deg2rad(self.bias_dps)),
        )

    def status(self) -> Status:
        status = super().status()
        image = frame_and_blobs(self.frame)[0]
        return replace(status, t=image.t_arrival + self.now)

    def latest_frame(self, t: float | None = None):
        frame, blobs, result = super().latest_frame(t)
        sides = []
        for side in (blobs.left, blobs.right):
            seen = [name not in self.unseen for name in blobs.hue_names]
            keep = np.array(seen)[side.hue]
            fields = {n: getattr(side, n)[keep] for n in ("uv", "size", "hue", "score")}
            sides.append(replace(side, **fields))
        return frame, replace(blobs, left=sides[0], right=sides[1]), result


@pytest.fixture
def rig() -> Rig:
    return Rig()


@pytest.fixture
def listed(window, rig, qtbot):
    """The visible list with a converged rig."""
    window.host.adopt(scripted_setup(rig))
    window.run_command("show_checklist")
    qtbot.waitUntil(lambda: shown(window, "Light").look is GOOD)
    return window


class Shown:
    """A row of the list as shown on the screen."""

    def __init__(self, row) -> None:
        looks = {look.sign: look for look in (GOOD, WARN, IDLE)}
        self.look, self.reason = looks[row._sign.text()], row._reason.text()
        self.button = row._button.text() if row._button.isVisible() else ""


def shown(window, name: str) -> Shown:
    return Shown(next(r for r in window.checklist._rows if r._name.text() == name))


def refreshed(window) -> None:
    window.checklist.refresh(window.host.snapshot())


def pass_time(window, rig, qtbot, seconds: float) -> None:
    """No packets and no images arrive for this time; the window updates its figures now and
    then."""
    rig.now = seconds
    arrive = seconds < 0.5
    qtbot.waitUntil(lambda: window.host.snapshot().images_arrive == arrive)
    refreshed(window)


def test_a_converged_calibration_remains_done_until_a_reset(listed, rig):
    assert shown(listed, "Calibration settled").look is GOOD
    assert listed.checklist.summary.text() == "Ready"
    rig.sd, rig.bias_dps = 1.6, 0.9
    refreshed(listed)
    assert shown(listed, "Calibration settled").look is GOOD
    assert shown(listed, "Measured at rest").reason == "gyroscope biases known to 0.9 °/s"
    assert listed.checklist.summary.text() == "Ready"
    rig.sd, rig.bias_dps = 5.0, 3.0
    refreshed(listed)
    assert shown(listed, "Calibration settled").button == "Hold poses"
    assert shown(listed, "Measured at rest").button == "Measure"
    assert listed.checklist.summary.text() == "8 of 10 done"
    rig.sd, rig.bias_dps = 1.6, 0.9  # converging, never done again
    refreshed(listed)
    assert listed.checklist.summary.text() == "8 of 10 done"


def test_a_lost_device_reopens_its_steps(listed, rig, qtbot):
    rig.sd = 1.6
    refreshed(listed)
    assert shown(listed, "Calibration settled").look is GOOD
    pass_time(listed, rig, qtbot, 5.0)
    for name in ("Light", "Colours tuned", "Hand in view", "Measured at rest"):
        assert shown(listed, name).look is not GOOD, name
    pass_time(listed, rig, qtbot, 0.0)
    assert shown(listed, "Calibration settled").look is not GOOD, "it has not settled since"


def test_a_short_interruption_reopens_nothing(listed, rig, qtbot):
    rig.sd = 1.6
    pass_time(listed, rig, qtbot, 1.5)
    assert shown(listed, "Glove found").look is WARN, "at once"
    for name in ("Light", "Colours tuned", "Hand in view", "Measured at rest"):
        assert shown(listed, name).look is GOOD, name
    pass_time(listed, rig, qtbot, 0.0)
    assert listed.checklist.summary.text() == "Ready"


def test_a_hand_that_leaves_is_to_be_checked_and_colours_are_not_evaluated(listed, rig):
    rig.tracking, rig.unseen = Tracking.SEARCHING, ("red", "yellow", "green", "blue")
    listed.checklist._hue_seen.clear()
    refreshed(listed)
    hand = shown(listed, "Hand in view")
    assert hand.look is WARN and hand.reason == "The hand was tracked but is not in view now."
    assert shown(listed, "Colours tuned").look is GOOD
    assert listed.checklist.summary.text() == "Ready, 1 to check"


def test_a_missing_hue_on_a_tracked_hand_is_orange(listed, rig):
    rig.unseen = ("red",)
    listed.checklist._hue_seen.clear()
    refreshed(listed)
    step = shown(listed, "Colours tuned")
    assert step.look is WARN and step.reason.startswith("Not seen: red")
    assert step.button == "Tune colours"
    assert listed.checklist.summary.text() == "Ready, 1 to check"


def reading(found: int, of: int, *advice: Advice):
    meter = LightMeter(scripted_setup(ScriptedEngine()).profile)
    grey = meter.read(np.full((120, 160, 3), 120, np.uint8))
    what = warning("light.markers_missed", missed=of - found, expected=of)
    missed = Advice("missed", what)
    return meter, replace(
        grey,
        uv=np.zeros((of, 2)),
        hue=np.zeros(of, np.int64),
        found=np.arange(of) < found,
        advice=(*advice, *([missed] if found < of else [])),
    )


@pytest.mark.long
@pytest.mark.parametrize(
    ("found", "light", "colours"),
    [(9, GOOD, GOOD), (10, GOOD, GOOD), (6, WARN, GOOD), (1, WARN, WARN)],
)
def test_missed_markers_are_not_green(listed, monkeypatch, found, light, colours):
    """Few are missed in any light: those at an edge, or at a grazing angle."""
    monkeypatch.setattr(listed.checklist.light, "work", lambda *_: None)
    listed.checklist.light.took(reading(found, 10))
    refreshed(listed)
    assert shown(listed, "Light").look is light
    step = shown(listed, "Colours tuned")
    assert step.look is colours
    if light is WARN:
        assert shown(listed, "Light").reason.startswith(f"{10 - found} of 10 markers")
    if colours is WARN:
        assert step.reason == "9 of 10 markers are not found with these colours."


def test_colours_that_miss_most_markers_are_not_done_from_the_start(window, rig, monkeypatch):
    window.host.adopt(scripted_setup(rig))
    monkeypatch.setattr(window.checklist.light, "work", lambda *_: None)
    window.checklist.light.took(reading(1, 9))
    refreshed(window)
    assert shown(window, "Colours tuned").look is WARN
    assert window.checklist.summary.text() == "8 of 10 done"


def test_the_light_of_a_removed_camera_is_discarded(listed, rig, qtbot):
    pass_time(listed, rig, qtbot, 5.0)
    assert listed.checklist.light.reading is None
    assert shown(listed, "Light").reason == "Waiting for images."
    pass_time(listed, rig, qtbot, 0.0)
    assert shown(listed, "Light").reason == "Measuring the light…"


def test_a_slow_measurement_of_the_light_is_not_discarded_for_the_next_one(
    listed, qtbot, monkeypatch
):
    """On a computer that takes longer than the time between two."""
    asked, go = [], threading.Event()

    def slow():
        go.wait(60)
        return reading(9, 9)

    def work(*_):
        asked.append(1)
        return slow

    panel = listed.checklist
    panel.light = SimpleNamespace(work=work, took=asked.append, reading=None)
    for _ in range(3):
        panel._read_light(listed.host.snapshot())
    assert asked == [1]
    go.set()
    qtbot.waitUntil(lambda: len(asked) >= 2)
    assert isinstance(asked[1], tuple), "its result, not another measurement"


@pytest.mark.styled
def test_a_reason_without_a_button_takes_the_whole_width(listed, rig, qtbot):
    """On a small screen it was as narrow as next to the widest button of all."""
    row = next(r for r in listed.checklist._rows if r._name.text() == "Calibration settled")
    assert row._button.isHidden()
    rig.sd = 5.0
    alone = row._reason.geometry()
    refreshed(listed)
    qtbot.waitUntil(lambda: row._button.isVisible() and row._reason.width() < alone.width())
    assert row._reason.geometry().right() < row._button.geometry().left()
    rig.sd = 1.0
    refreshed(listed)
    qtbot.waitUntil(lambda: row._reason.width() == alone.width())


@pytest.mark.styled
def test_in_a_narrow_panel_buttons_are_below_their_reasons(listed, rig, qtbot):
    """At 150 % in German a sentence occupied six lines of one word each."""
    rig.sd = 5.0
    refreshed(listed)
    panel = listed.checklist
    area = panel.parentWidget().parentWidget()  # it scrolls, and sets the panel's width
    row = next(r for r in panel._rows if r._name.text() == "Calibration settled")
    below = lambda: row._button.geometry().top() >= row._reason.geometry().bottom()  # noqa: E731
    for width, expected in ((900, False), (350, True), (900, False)):
        area.setFixedWidth(width)
        qtbot.waitUntil(lambda want=expected: below() == want)
        assert row._reason.width() > 150
