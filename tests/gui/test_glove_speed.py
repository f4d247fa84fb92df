"""The speed of the glove's line: found, chosen in the set-up, given on the command line."""

from __future__ import annotations

import pytest

from app.engines import found_gloves
from app.engines.found_gloves import find_hand_gloves
from app.storage.settings import AppSettings
from app.wizards.glove.choice import ChoicePage
from tracker.base.errors import DeviceError
from tracker.base.notices import plain
from tracker.cli import build_parser
from tracker.sensors.discovery import PortReport
from tracker.sensors.protocol import BAUDS, Hello

SLOW = PortReport("/dev/ttyUSB3", Hello(7, 7), baud=115_200)


@pytest.fixture
def asked(monkeypatch):
    """The requests of the search for gloves; one answers at 115200 baud only."""
    calls = []

    def find(paths, bauds):
        calls.append((paths[0], bauds))
        return [
            SLOW if SLOW.baud in bauds else PortReport(paths[0], None, problem=plain("Silence."))
        ]

    monkeypatch.setattr(found_gloves, "find_gloves", find)
    monkeypatch.setattr(found_gloves, "serial_ports", lambda: ["/dev/ttyUSB3"])
    return calls


def test_both_speeds_are_tried_and_the_answering_one_is_used(asked):
    (found,) = find_hand_gloves(lambda _share, _text: None, AppSettings()).gloves
    assert found.report.baud == found.link().params.baud == 115_200
    assert asked == [("/dev/ttyUSB3", BAUDS)]


def test_a_chosen_speed_is_the_only_one_tried(asked):
    with pytest.raises(DeviceError, match="Silence"):
        find_hand_gloves(lambda _share, _text: None, AppSettings(baud=250_000))
    assert asked == [("/dev/ttyUSB3", (250_000,))]


def test_the_page_offers_both_and_shows_the_answering_one(qtbot):
    page = ChoicePage(AppSettings(port=SLOW.path), [], with_session=False)
    qtbot.addWidget(page)
    assert [page.speed.itemData(i) for i in range(page.speed.count())] == [0, *BAUDS]
    page.show_ports([SLOW], "/dev/ttyUSB3")
    assert "115200 baud" in page.ports.itemText(0)
    assert (page.port(), page.baud(), page.baud_of_port()) == ("/dev/ttyUSB3", 0, 115_200)
    with qtbot.waitSignal(page.changed):
        page.speed.setCurrentIndex(page.speed.findData(250_000))
    assert (page.baud(), page.baud_of_port()) == (250_000, 250_000)
    chosen = ChoicePage(AppSettings(baud=115_200), [], with_session=False)
    qtbot.addWidget(chosen)
    assert chosen.baud() == 115_200


def test_the_command_line_selects_for_one_run(window, store, monkeypatch):
    args = build_parser(["window"]).parse_args(["window", "--devices", "--baud", "115200"])
    assert args.devices and args.baud == 115_200
    with pytest.raises(SystemExit):
        build_parser(["window"]).parse_args(["window", "--baud", "9600"])
    used = []
    monkeypatch.setattr(
        "app.window.sources.hardware_factory", lambda s: used.append(s) or (lambda p: 1 / 0)
    )
    monkeypatch.setattr(window.sources, "_open", lambda text, factory: None)
    window.sources.open_devices()
    window.sources.baud = args.baud
    window.sources.open_devices()
    assert [s.baud for s in used] == [0, 115_200]
    assert store.value.baud == 0, "the next start is as it was"
