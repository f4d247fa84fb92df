"""Typical sequences: devices connected late, an invalid file, reviewing a take and returning."""

import threading
from dataclasses import replace
from types import SimpleNamespace

import pytest
from PySide6.QtCore import QPoint, QRect

from app.engines.protocols import RecordingRequest
from app.jobs.plugged import Newcomers, PlugWatch, plugged_in
from app.storage.settings import AppSettings
from tests.gui.gui_fakes import ScriptedEngine, scripted_setup
from tracker.base.errors import DeviceError, FileError


def test_a_new_device_is_reported_once_it_is_stable_and_again_after_removal():
    newcomers = Newcomers()
    there = ["ttyUSB0"]
    assert newcomers.look(there) == []
    assert newcomers.look([*there, "ttyUSB1"]) == []
    assert newcomers.look([*there, "ttyUSB1"]) == ["ttyUSB1"]
    assert newcomers.look([*there, "ttyUSB1"]) == []
    assert newcomers.look(there) == []
    newcomers.look([*there, "ttyUSB1"])
    assert newcomers.look([*there, "ttyUSB1"]) == ["ttyUSB1"]
    newcomers.forget()
    assert newcomers.look(["another"]) == newcomers.look(["another"]) == []


def test_manually_chosen_ports_and_cameras_are_checked_directly(tmp_path, monkeypatch):
    monkeypatch.setattr("app.jobs.plugged.serial_ports", lambda: ["/dev/ttyUSB0"])
    monkeypatch.setattr("app.jobs.plugged.all_cameras", lambda: [SimpleNamespace(name="ZED")])
    glove, film = tmp_path / "glove0", tmp_path / "film.avi"
    settings = AppSettings(port=str(glove), camera=f"two:{film}")
    assert plugged_in(settings) == {"/dev/ttyUSB0", "ZED"}
    glove.touch()
    film.touch()
    assert plugged_in(settings) == {"/dev/ttyUSB0", "ZED", str(glove), str(film)}


def test_a_watch_reports_new_devices_until_it_stops(qtbot, store):
    there: set[str] = set()
    watch = PlugWatch(SimpleNamespace(opening=False), store, look=lambda _s: frozenset(there))
    watch._timer.setInterval(10)
    arrivals: list[list[str]] = []
    watch.came.connect(arrivals.append)
    with qtbot.waitSignal(watch._timer.timeout):
        watch.begin()
    qtbot.waitUntil(lambda: watch._newcomers._known is not None)
    there.add("glove")
    qtbot.waitUntil(lambda: arrivals == [["glove"]])
    watch.rest()
    assert not watch._timer.isActive()
    watch.shut_down()


@pytest.fixture
def searches(window, monkeypatch):
    """Titles of what the window has started to open; nothing is opened."""
    begun: list[str] = []
    monkeypatch.setattr(window.host, "open", lambda title, *_a, **_k: begun.append(title))
    return begun


def test_a_slow_search_is_not_discarded_for_the_next_one(qtbot, store):
    """Each takes longer than the time between two."""
    there: set[str] = set()
    searched = threading.Event()

    def look(_settings):
        threading.Event().wait(0.1)
        searched.set()
        return frozenset(there)

    watch = PlugWatch(SimpleNamespace(opening=False), store, look=look)
    watch._timer.setInterval(5)
    arrivals: list[list[str]] = []
    watch.came.connect(arrivals.append)
    watch.begin()
    qtbot.waitUntil(lambda: searched.is_set() and watch._newcomers._known is not None)
    there.add("ttyUSB1")
    qtbot.waitUntil(lambda: arrivals == [["ttyUSB1"]])
    watch.shut_down()


def test_a_new_device_is_opened_at_once_if_nothing_is_open(window, searches):
    window.sources.plugged.came.emit(["/dev/ttyUSB0"])
    assert searches == ["Looking for glove and camera"]


def test_half_a_rig_continues_and_offers_the_new_device(live, searches):
    live.sources.plugged.came.emit(["/dev/ttyUSB0"])
    assert searches == [] and "/dev/ttyUSB0" in live.banner.text()
    live.banner.buttons[0].click()
    assert searches == ["Looking for glove and camera"]


def test_it_watches_only_while_something_is_missing(window, qtbot):
    def missing(_progress):
        raise DeviceError("No glove was found.")

    watch = window.sources.plugged
    window.sources.looking_for_devices = True
    window.host.open("Looking", missing)
    qtbot.waitUntil(lambda: watch._timer.isActive())
    window.host.adopt(scripted_setup(ScriptedEngine()))
    assert not watch._timer.isActive()


def test_an_unreadable_file_leaves_the_open_one_unchanged(live, qtbot):
    def bad(_progress):
        raise FileError("bad.mcap is no session.")

    setup = live.host.setup
    live.host.open("Opening bad.mcap", bad, keep=True)
    qtbot.waitUntil(lambda: "bad.mcap is no session" in live.banner.text())
    assert live.host.setup is setup and live.host.running and not live.host.opening


def test_a_recording_started_while_a_file_is_being_opened_continues(live, qtbot, tmp_path):
    let, built = threading.Event(), []

    def slow(_progress):
        let.wait(60.0)
        built.append(scripted_setup(ScriptedEngine()))
        return built[0]

    setup = live.host.setup
    live.host.open("Opening take.mcap", slow, keep=True)
    assert live.host.recording.begin(RecordingRequest(tmp_path / "now.mcap", "", ""))
    let.set()
    qtbot.waitUntil(lambda: "take.mcap was not opened" in live.banner.text())
    assert live.host.recording.request is not None
    assert live.host.setup is setup and live.host.running and not live.host.opening
    assert (built[0].engine.started, built[0].engine.stopped) == (0, 1)
    live.host.recording.end()


def test_from_a_take_one_returns_to_the_live_devices(window, searches):
    window.sources.open_demo()
    assert not window.sources.can_go_live
    take = replace(scripted_setup(ScriptedEngine()), player=SimpleNamespace())
    window.host._setup = take
    assert window.sources.can_go_live
    window.sources.go_live()
    assert searches == ["Starting the demo"] * 2
    window.host._setup = None


@pytest.mark.styled
def test_a_message_never_covers_the_transport(live, qtbot):
    transport = live.library.transport
    live.layouts.choose("look")
    live.show_panel("library")
    transport.setVisible(True)
    live.messages.show_message("Something that stands there for a while.")
    qtbot.waitUntil(lambda: transport.height() > 20 and live.banner.isVisible())

    def apart() -> bool:
        place = QRect(transport.mapTo(live, QPoint(0, 0)), transport.size())
        return not place.intersects(live.messages.geometry())

    qtbot.waitUntil(apart)
    live.resize(live.width(), live.height() - 60)
    qtbot.waitUntil(apart)
