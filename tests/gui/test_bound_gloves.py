"""A glove that was set up once is recognised by its number, on any port."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

import pytest

from app.engines import found_gloves
from app.engines.found_gloves import find_hand_gloves
from app.storage.bound_gloves import BoundGlove, as_bound, bound, with_bound
from app.storage.settings import AppSettings, SettingsStore
from app.wizards.glove.choice import ChoicePage
from app.wizards.glove.wizard import GloveSetup
from tracker.base.notices import plain
from tracker.sensors.discovery import PortReport
from tracker.sensors.protocol import Hello
from tracker.simulation.glove_device import GloveDeviceParams, SimulatedGlove

LEFT = BoundGlove("left", "vist-small-left", "reference-left", "Ada")


def hello(number: int) -> Hello:
    return Hello(glove_id=number, imu_count=7)


def settings() -> AppSettings:
    return AppSettings(gloves=with_bound(AppSettings(), 22, LEFT))


def test_a_left_glove_is_not_tracked_with_a_right_ones_files() -> None:
    used, message = as_bound(settings(), 22)
    assert (used.glove, used.hand) == (LEFT.glove, LEFT.hand)
    assert "Glove 22 (left hand)" in message and LEFT.glove in message


@pytest.mark.parametrize("number", [11, None])
def test_a_new_glove_or_one_without_a_number_uses_the_chosen_files(number: int | None) -> None:
    used, message = as_bound(settings(), number)
    assert used.glove == AppSettings().glove and message == ""


def test_nothing_is_reported_if_the_files_are_its_own() -> None:
    assert (
        as_bound(AppSettings(glove=LEFT.glove, hand=LEFT.hand, gloves=settings().gloves), 22)[1]
        == ""
    )


def test_bindings_survive_a_restart(tmp_path) -> None:
    store = SettingsStore(tmp_path / "window.json")
    store.update(gloves=with_bound(store.value, 22, LEFT))
    again = SettingsStore(tmp_path / "window.json")
    assert bound(again.value, 22) == LEFT


@pytest.mark.parametrize("entry", [{"22": "left"}, {"22": {"side": "left"}}, {"22": {"side": 1}}])
def test_a_damaged_entry_is_ignored(entry) -> None:
    assert bound(AppSettings(gloves=entry), 22) is None


def test_the_wizard_recalls_side_files_and_wearer_of_the_chosen_port(qtbot) -> None:
    known = replace(settings(), port="/dev/a")
    page = ChoicePage(known, ["Ada", "Bea"], with_session=False)
    qtbot.addWidget(page)
    page.show_ports([PortReport("/dev/a", hello(11)), PortReport("/dev/b", hello(22))], "/dev/a")
    assert page.glove_id() == 11 and page.side.currentData() == "right"
    page.ports.setCurrentIndex(page.ports.findData("/dev/b"))
    assert page.glove_id() == 22 and page.bound() == LEFT
    page.ports.setCurrentIndex(page.ports.findData("/dev/a"))
    assert page.side.currentData() == "left", "a new glove keeps what was shown last"


OFF_USB = {
    11: BoundGlove("right", "vist-small", "reference-right", port="/dev/rfcomm0"),
    22: replace(LEFT, port="/dev/rfcomm1"),
}


@pytest.fixture
def bluetooth(monkeypatch) -> set[str]:
    """Ports that answer, of two unlisted gloves."""
    there = {"/dev/rfcomm0", "/dev/rfcomm1"}
    numbers = {glove.port: number for number, glove in OFF_USB.items()}

    def find(paths, bauds):
        path = paths[0]
        greeting = hello(numbers[path]) if path in there else None
        return [PortReport(path, greeting, problem=None if greeting else plain("Silence."))]

    monkeypatch.setattr(found_gloves, "find_gloves", find)
    monkeypatch.setattr(found_gloves, "serial_ports", list)
    return there


def both_bound() -> AppSettings:
    settings = AppSettings(port="/dev/rfcomm1", both_hands=True)
    for number, glove in OFF_USB.items():
        settings = replace(settings, gloves=with_bound(settings, number, glove))
    return settings


def test_gloves_on_unlisted_ports_are_found_at_their_old_ports(bluetooth) -> None:
    found = find_hand_gloves(lambda _share, _text: None, both_bound()).gloves
    assert {g.side: g.report.path for g in found} == {
        "left": "/dev/rfcomm1",
        "right": "/dev/rfcomm0",
    }


def test_a_missing_glove_is_awaited_at_its_old_port(bluetooth) -> None:
    bluetooth.discard("/dev/rfcomm0")
    left, right = find_hand_gloves(lambda _share, _text: None, both_bound()).gloves
    assert left.report is not None and right.report is None
    assert (right.side, right.glove_id, right.port) == ("right", 11, "/dev/rfcomm0")


@pytest.fixture
def simulated_glove() -> Iterator[SimulatedGlove]:
    """Number 22, on an unlisted line."""
    params = GloveDeviceParams(glove_id=22)
    device = SimulatedGlove(iter(()), 7, params=params)
    yield device
    device.stop()


def test_a_glove_at_a_manually_chosen_port_is_bound_with_its_port(
    window, qtbot, store, simulated_glove, monkeypatch
) -> None:
    monkeypatch.setattr("app.wizards.glove.wizard.serial_ports", list)
    dialog = GloveSetup(window.host, store, window.tasks, window)
    dialog.show()
    dialog.choice.add_port(simulated_glove.path)
    dialog.choice.side.setCurrentIndex(dialog.choice.side.findData("left"))
    qtbot.waitUntil(lambda: dialog._feed.glove_id == 22)
    dialog._use()
    known = bound(store.value, 22)
    assert known is not None
    assert (known.side, known.glove, known.port) == ("left", LEFT.glove, simulated_glove.path)
