"""When the light is measured again, and what the checklist shows of it."""

import dataclasses

import numpy as np
import pytest

from app.viewmodels.checklist import steps
from app.viewmodels.light import EVERY, KEPT, LightWatch
from app.viewmodels.states import GOOD, IDLE, WARN
from tests.gui.gui_fakes import ScriptedEngine, scripted_setup
from tests.gui.patience import settled
from tracker.base.notices import notice, warning
from tracker.calibration.light_meter import Advice, LightMeter
from tracker.glove import library
from tracker.vision.colours import parse_profile

pytestmark = pytest.mark.long

PROFILE = parse_profile(library.text("colours", library.DEFAULT_COLOURS))
GREY = np.full((120, 160, 3), 120, np.uint8)


def test_a_still_image_is_measured_once_and_a_live_one_every_second():
    watch = LightWatch()
    first = watch.work(GREY, PROFILE, 640.0, 10.0)
    assert first is not None
    watch.took(first())
    assert watch.work(GREY, PROFILE, 640.0, 20.0) is None  # the same image
    assert watch.work(GREY.copy(), PROFILE, 640.0, 10.0 + 0.5 * EVERY) is None
    assert watch.work(GREY.copy(), PROFILE, 640.0, 10.0 + EVERY) is not None
    assert watch.work(None, PROFILE, 640.0, None) is None
    other = dataclasses.replace(PROFILE, name="other")
    assert watch.work(GREY, other, 640.0, None) is not None


def a_reading(*advice: Advice):
    meter = LightMeter(PROFILE)
    return meter, dataclasses.replace(meter.read(GREY), advice=advice)


def test_a_moment_without_the_hand_keeps_the_last_result():
    watch, warm = LightWatch(), Advice("warm", warning("light.warm"))
    none = Advice("hand", notice("light.show_hand"))
    for t, problems, line in (
        (0.0, warm, "too warm"), (2.0, none, "too warm"), (3.0 + KEPT, none, "–"),
    ):  # fmt: skip
        assert watch.work(GREY.copy(), PROFILE, 640.0, t) is not None
        watch.took(a_reading(problems))
        assert watch.line() == line


@pytest.mark.parametrize(
    ("advice", "look"),
    [
        ((), GOOD),
        ((Advice("room", warning("light.room_has_hues", hues=["red"], spots=9)),), WARN),
        ((Advice("dark", warning("light.dark")),), IDLE),
    ],
)
def test_the_checklist_requires_light_and_marks_problems_of_the_background(window, advice, look):
    watch = LightWatch()
    watch.took(a_reading(*advice))
    window.host.adopt(scripted_setup(ScriptedEngine()))
    view = window.host.snapshot()
    step = next(s for s in steps(view, light=watch) if s.name == "Light")
    assert step.look(reachable=False) is look
    assert step.passes == (look is not IDLE)
    assert step.reason == (str(advice[0].notice) if advice else "the markers are clearly visible")
    assert step.command == ("show_colours" if advice else "")
    unread = next(s for s in steps(view) if s.name == "Light")
    assert not unread.done
    assert unread.reason == "Measuring the light…"  # images arrive already


@pytest.mark.styled
def test_another_text_for_the_light_does_not_move_the_layout(live, qtbot):
    live.show_panel("colours")
    chip, places = live.colours.light.chip, []
    for word in ("good", "colours in background, markers missed"):
        chip.show_state("", "●", word)
        settled(live, qtbot)
        places.append((live.colours.tools.geometry(), live.colours.light.geometry()))
    assert places[0] == places[1]
