"""A glove that was set up once is known again by its number, on any port."""

from __future__ import annotations

from dataclasses import replace

import pytest

from app.storage.bound_gloves import BoundGlove, as_bound, bound, with_bound
from app.storage.settings import AppSettings, SettingsStore
from app.wizards.glove.choice import ChoicePage
from tracker.sensors.discovery import PortReport
from tracker.sensors.protocol import Hello

LEFT = BoundGlove("left", "vist-small-left", "reference-left", "Ada")


def hello(number: int) -> Hello:
    return Hello(glove_id=number, imu_count=7)


def settings() -> AppSettings:
    return AppSettings(gloves=with_bound(AppSettings(), 22, LEFT))


def test_a_left_glove_is_not_tracked_with_a_right_ones_files() -> None:
    used, said = as_bound(settings(), 22)
    assert (used.glove, used.hand) == (LEFT.glove, LEFT.hand)
    assert "glove 22 of the left hand" in said and LEFT.glove in said


@pytest.mark.parametrize("number", [11, None])
def test_a_glove_that_is_new_or_tells_no_number_is_taken_as_chosen(number: int | None) -> None:
    used, said = as_bound(settings(), number)
    assert used.glove == AppSettings().glove and said == ""


def test_nothing_is_said_where_the_files_are_its_own() -> None:
    assert (
        as_bound(AppSettings(glove=LEFT.glove, hand=LEFT.hand, gloves=settings().gloves), 22)[1]
        == ""
    )


def test_what_was_bound_outlives_the_program(tmp_path) -> None:
    store = SettingsStore(tmp_path / "window.json")
    store.update(gloves=with_bound(store.value, 22, LEFT))
    again = SettingsStore(tmp_path / "window.json")
    assert bound(again.value, 22) == LEFT


@pytest.mark.parametrize("said", [{"22": "left"}, {"22": {"side": "left"}}, {"22": {"side": 1}}])
def test_a_damaged_entry_is_as_none(said) -> None:
    assert bound(AppSettings(gloves=said), 22) is None


def test_the_wizard_recalls_side_files_and_wearer_of_the_port_that_is_chosen(qtbot) -> None:
    known = replace(settings(), port="/dev/a")
    page = ChoicePage(known, ["Ada", "Bea"], with_session=False)
    qtbot.addWidget(page)
    page.show_ports([PortReport("/dev/a", hello(11)), PortReport("/dev/b", hello(22))], "/dev/a")
    assert page.glove_id() == 11 and page.side.currentData() == "right"
    page.ports.setCurrentIndex(page.ports.findData("/dev/b"))
    assert page.glove_id() == 22 and page.bound() == LEFT
    page.ports.setCurrentIndex(page.ports.findData("/dev/a"))
    assert page.side.currentData() == "left", "a new glove keeps what was shown last"
