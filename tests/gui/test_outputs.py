"""Streams and haptics by clicks, received by independent sockets."""

import contextlib
import json
import re
import socket
from pathlib import Path

import pytest
from PySide6.QtCore import Qt

from app.jobs.connections import remembered
from app.jobs.outputs import HAPTICS, HapticRule
from app.storage.settings import SettingsStore
from app.viewmodels.streams import option_fields
from app.widgets.options_dialog import OptionsDialog
from app.window.main_window import MainWindow
from extensions.conformance.run import read_records
from tests.gui.gui_fakes import ScriptedEngine, ScriptedGlove, scripted_setup, with_glove
from tests.notices import shows
from tracker.base.errors import FileError
from tracker.streaming.registry import StreamSettings, stream_kinds


def sent(panel, name):
    """Number of messages shown as sent; -1 if the stream is off."""
    count = panel.cells[name]["sent"].text().partition(" ")[0]
    return int(count) if count.isdigit() else -1


@pytest.fixture
def listener():
    """A UDP port of this computer with a listener."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as server:
        server.bind(("127.0.0.1", 0))
        server.setblocking(False)
        yield server


def received(qtbot, listener) -> dict:
    """The next message, while the window runs."""
    got = []

    def look() -> bool:
        with contextlib.suppress(BlockingIOError):
            got.append(listener.recv(65536))
        return got != []

    qtbot.waitUntil(look)
    return json.loads(got[0])


@pytest.fixture
def glove():
    """Its motors accept every command."""
    return ScriptedGlove()


@pytest.fixture
def motors(glove):
    """Calls of the glove's motors: channel, amplitude, ms."""
    return glove.vibrated


@pytest.fixture
def panel(window, glove, qtbot):
    """The visible panel, with an engine whose glove has motors."""
    setup = scripted_setup(ScriptedEngine())
    window.host.adopt(with_glove(setup, glove))
    window.run_command("show_streams")
    return window.panels["streams"]


def test_by_default_nothing_is_sent_and_only_to_this_computer(panel, window):
    assert not any(box.isChecked() for box in panel.boxes.values())
    assert list(panel.boxes) == list(stream_kinds())
    assert panel.address.text() == "127.0.0.1"
    assert all(window.outputs.counts(name) is None for name in (*panel.boxes, HAPTICS))


def test_the_isaac_record_has_a_chosen_file_and_never_replaces_one(
    panel, window, tmp_path, monkeypatch, qtbot
):
    assert panel.files["isaac"].text() == "hands.mcap" and "isaac" not in panel.ports
    chosen = tmp_path / "new" / "take"
    monkeypatch.setattr(
        "app.panels.streams.QFileDialog.getSaveFileName",
        staticmethod(lambda *_args, **_more: (str(chosen), "")),
    )
    panel.files["isaac"].click()
    assert panel.files["isaac"].text() == "take.mcap"
    assert str(chosen.with_suffix(".mcap")) in panel.files["isaac"].toolTip()
    for name in ("take.mcap", "take_2.mcap"):
        panel.boxes["isaac"].click()
        qtbot.waitUntil(lambda: "sending" in panel.cells["isaac"]["state"].text())
        qtbot.waitUntil(lambda: sent(panel, "isaac") >= 1)
        panel.boxes["isaac"].click()
        path = chosen.parent / name
        qtbot.waitUntil(lambda path=path: _records(path) == ["right"])
    assert SettingsStore(window.store.path).value.streams["isaac_file"].endswith("take.mcap")


def _records(path: Path) -> list[str]:
    """Sides in a complete record; nothing for any other file."""
    try:
        return sorted({side for side, record in read_records(path) if record.joints is not None})
    except FileError:
        return []


def test_the_recipients_of_lab_streaming_layer_are_named_next_to_its_switch(panel):
    assert not panel.boxes["lsl"].isChecked()
    assert "listens on all addresses" in panel.reach.text()
    assert "listens on all addresses" in panel.boxes["lsl"].toolTip()
    assert panel.boxes["udp"].toolTip() == ""


APART = pytest.mark.parametrize("apart", [False, True], ids=["together", "apart"])
"""Streams in the window's process, and in their own as the program has them."""


@pytest.mark.long
@APART
def test_a_stream_is_switched_on_received_counted_and_off(panel, window, listener, qtbot, apart):
    window.outputs.apart = apart
    panel.ports["udp"].setValue(listener.getsockname()[1])
    panel.boxes["udp"].click()
    message = received(qtbot, listener)
    estimate = window.host.setup.engine.latest_estimate()
    assert message["keypoints"]["wrist"]["position"] == pytest.approx(
        estimate.keypoints[0].tolist(), abs=1e-6
    )
    qtbot.waitUntil(lambda: "sending" in panel.cells["udp"]["state"].text())
    qtbot.waitUntil(lambda: sent(panel, "udp") >= 1)
    assert re.fullmatch(r"\d+ \(\d+ Hz\)", panel.cells["udp"]["sent"].text())
    panel.boxes["udp"].click()
    qtbot.waitUntil(lambda: panel.cells["udp"]["sent"].text() == "–")
    qtbot.waitUntil(lambda: not window.tasks.tasks)


def test_enabled_streams_run_again_after_the_next_start(panel, window, store, listener, qtbot):
    port = listener.getsockname()[1]
    panel.ports["udp"].setValue(port)
    panel.boxes["udp"].click()
    received(qtbot, listener)
    window.close()
    with contextlib.suppress(BlockingIOError):
        while True:  # in transmission
            listener.recv(65536)
    again = MainWindow(SettingsStore(store.path))
    qtbot.addWidget(again)
    assert (
        again.panels["streams"].boxes["udp"].isChecked()
        and again.panels["streams"].ports["udp"].value() == port
    )
    qtbot.wait(100)
    with pytest.raises(BlockingIOError):  # nothing is sent before there is an engine
        listener.recv(65536)
    again.host.adopt(scripted_setup(ScriptedEngine()))
    qtbot.waitUntil(lambda: again.outputs.counts("udp") is not None)
    assert received(qtbot, listener)["schema"] == 2
    again.close()


def test_a_port_in_use_is_reported_and_the_rest_continues(panel, window, qtbot):
    pytest.importorskip("websockets")
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        panel.ports["websocket"].setValue(taken.getsockname()[1])
        panel.boxes["websocket"].click()
        state = panel.cells["websocket"]["state"]
        qtbot.waitUntil(lambda: "not open" in state.text())
        assert str(taken.getsockname()[1]) in state.toolTip()
        assert "WebSocket" in window.banner.text()
    assert window.host.running


def test_the_servers_clients_are_counted(panel, window, qtbot):
    client = pytest.importorskip("websockets.sync.client")
    panel.ports["websocket"].setValue(_free_port())
    panel.boxes["websocket"].click()
    cells = panel.cells["websocket"]
    qtbot.waitUntil(lambda: "no listeners" in cells["state"].text())
    with client.connect(f"ws://127.0.0.1:{panel.ports['websocket'].value()}/"):
        qtbot.waitUntil(lambda: cells["clients"].text() == "1")
    window.host.stop()
    qtbot.waitUntil(lambda: "waiting for tracking" in cells["state"].text())


def _free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return int(probe.getsockname()[1])


def test_closing_the_window_while_a_stream_opens_leaves_nothing(panel, window):
    panel.ports["udp"].setValue(9)
    panel.boxes["udp"].click()
    window.close()  # the fixtures look for threads


def test_each_motor_can_be_tested(panel, motors, qtbot):
    panel.amplitude.setValue(123)
    for channel in (0, 4):
        qtbot.mouseClick(panel.motors[channel], Qt.MouseButton.LeftButton)
    assert motors == [(0, 123, 300), (4, 123, 300)]


def test_a_fingertip_in_the_sphere_vibrates_its_motor(panel, window, motors, store, qtbot):
    qtbot.mouseClick(panel.place, Qt.MouseButton.LeftButton)
    panel.radius.setValue(10)
    panel.rule.click()
    qtbot.waitUntil(lambda: motors != [])
    assert motors[0][0] == 1  # the index finger's
    rule = remembered(HapticRule, SettingsStore(store.path).value.haptics)
    engine = window.host.setup.engine
    names = window.host.setup.glove.keypoint_names(window.host.setup.hand)
    tip = engine.latest_estimate().keypoints[names.index("index_tip")]
    assert rule == HapticRule(True, 0.01, tuple(tip.tolist()))
    panel.rule.click()
    qtbot.waitUntil(lambda: window.outputs.counts("haptics") is None)


def test_without_an_engine_there_is_no_position_for_the_sphere(window):
    window.panels["streams"].rule.click()
    assert not window.panels["streams"].rule.isChecked()
    assert "not placed" in window.banner.text()


def test_invalid_stored_settings_are_replaced_by_the_default():
    settings = StreamSettings({"udp": True, "udp_port": "9000", "host": 3, "new": 1, "vmc": 1})
    options = settings.options(stream_kinds()["udp"])
    assert (options.host, options.port) == ("127.0.0.1", 9750)
    assert settings.on == ["udp"]
    assert remembered(HapticRule, {"center": [1, 2.5, 3]}).center == (1.0, 2.5, 3.0)


@pytest.mark.long
@APART
def test_the_test_button_shows_whether_a_program_receives(panel, window, listener, qtbot, apart):
    """For UDP only a rejection is known; for a server the number of clients."""
    window.outputs.apart = apart
    panel.ports["udp"].setValue(listener.getsockname()[1])
    panel.tests["udp"].click()
    assert shows(panel.result.text(), "stream.test_off")
    panel.boxes["udp"].click()
    qtbot.waitUntil(lambda: sent(panel, "udp") > 0)
    panel.tests["udp"].click()
    qtbot.waitUntil(lambda: "UDP sends no answer" in panel.result.text())
    listener.close()
    panel.tests["udp"].click()
    qtbot.waitUntil(lambda: "port unreachable" in panel.result.text())
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    window.outputs.set_option("hts", "transport", "server")
    panel.ports["hts"].setValue(port)
    panel.boxes["hts"].click()
    qtbot.waitUntil(lambda: sent(panel, "hts") > 0)
    panel.tests["hts"].click()
    qtbot.waitUntil(lambda: "no program is connected" in panel.result.text())
    with socket.create_connection(("127.0.0.1", port)):
        qtbot.waitUntil(lambda: panel.cells["hts"]["clients"].text() == "1")
        panel.tests["hts"].click()
        qtbot.waitUntil(lambda: "received by 1" in panel.result.text())


def test_options_are_set_in_a_form_and_stored(panel, window, store, qtbot):
    kind = window.outputs.kinds["vmt"]
    options = option_fields(kind, window.outputs.settings.options(kind))
    dialog = OptionsDialog(kind.title, options, panel)
    qtbot.addWidget(dialog)
    assert list(dialog.fields) == ["right", "left", "controller", "trigger", "grip", "a", "b"]
    assert dialog.changed() == {}
    dialog.fields["right"].setValue(4)
    dialog.fields["controller"].click()
    dialog.fields["a"].setCurrentIndex(0)
    assert dialog.changed() == {"right": 4, "controller": True, "a": ""}
    for name, value in dialog.changed().items():
        window.outputs.set_option("vmt", name, value)
    assert SettingsStore(store.path).value.streams["vmt_right"] == 4
    assert set(panel.options) == {
        name for name, kind in window.outputs.kinds.items() if option_fields(kind)
    }
    assert "udp" in panel.options
