"""Remote control of the window: by its interfaces, by its own socket, by the command."""

from __future__ import annotations

import json
import socket
import subprocess
import sys
import threading
import time
import uuid
from pathlib import Path
from types import SimpleNamespace

import pytest
from PySide6.QtCore import QTimer
from PySide6.QtNetwork import QLocalSocket
from PySide6.QtWidgets import QApplication
from pythonosc.osc_message import OscMessage
from pythonosc.osc_message_builder import OscMessageBuilder

from app.jobs.remote import MOTOR_HZ
from app.platform.single_instance import Instance, addresses, ask
from app.storage.settings import SettingsStore
from app.widgets.options_dialog import OptionsDialog
from tests.gui.gui_fakes import ScriptedGlove, scripted_setup, with_glove
from tests.notices import shows
from tracker.base.clock import monotonic
from tracker.cli import main
from tracker.streaming.remote.client import ask as ask_over_udp

ROOT = Path(__file__).resolve().parents[2]
HERE = "127.0.0.1"


def open_at(window, qtbot, name: str) -> int:
    """Open an interface at a free port as a user does; the port."""
    kind = socket.SOCK_STREAM if name == "websocket" else socket.SOCK_DGRAM
    with socket.socket(socket.AF_INET, kind) as s:
        s.bind((HERE, 0))
        port = s.getsockname()[1]
    box = window.panels["streams"].remote
    box.ports[name].setValue(port)
    box.boxes[name].click()
    qtbot.waitUntil(lambda: window.remote.counts(name) is not None)
    return port


def meanwhile(qtbot, work):
    """The result of ``work`` in a thread while the window runs."""
    out = []
    thread = threading.Thread(target=lambda: out.append(work()))
    thread.start()
    qtbot.waitUntil(lambda: not thread.is_alive())
    return out[0]


def test_nothing_listens_by_default(window):
    assert not any(box.isChecked() for box in window.panels["streams"].remote.boxes.values())
    assert not [t for t in threading.enumerate() if "remote" in t.name]


def test_options_of_an_interface_are_edited_in_a_form(window, qtbot):
    box = window.panels["streams"].remote
    assert "udp" not in box.options, "it has a port only"
    seen = []

    def fill():
        dialog = window.findChild(OptionsDialog) or QApplication.activeModalWidget()
        seen.append(set(dialog.fields))
        dialog.fields["right"].setText("LHR-1")
        dialog.accept()

    QTimer.singleShot(0, fill)
    box.options["room"].click()
    assert seen and "alignment" in seen[0] and "port" not in seen[0]
    kind = window.remote.kinds["room"]
    assert window.remote.settings.options(kind).right == "LHR-1"
    assert window.store.value.remote == {"room_right": "LHR-1"}, "only what was changed"


def test_start_note_and_stop_by_udp_are_like_the_keys(window, engine, qtbot):
    recorders = []
    window.host.adopt(scripted_setup(engine, recorders))
    port = open_at(window, qtbot, "udp")

    def say(**words):
        return json.loads(meanwhile(qtbot, lambda: ask_over_udp(words, HERE, port)))

    started = say(do="start", id=1)
    path = window.host.recording.request.path
    assert started == {
        "ok": True, "do": "start", "text": f"Recording {path.name}.", "file": path.name, "id": 1,
    }  # fmt: skip
    assert window.commands.actions["record"].text() == "Stop &recording"
    again = say(do="start")
    assert (again["code"], again["values"]) == ("remote.recording_already", {"file": path.name})
    before = monotonic()
    assert say(do="note", text="the cup")["ok"]
    (note,) = window.host.notes.current.values()
    assert note.text == "the cup" and before <= note.t <= monotonic()
    status = say(do="status")
    assert status["recording"] is True
    assert status[f"tracking_{window.host.setup.side}"] == "tracking"
    stopped = say(do="stop")
    assert stopped["file"] == path.name and window.host.recording.request is None
    assert recorders[0].closed
    refused = say(do="stop")
    assert not refused["ok"] and refused["code"] == "remote.not_recording"
    window.panels["streams"].refresh(None)
    cells = window.panels["streams"].remote.cells["udp"]
    assert cells["sent"].text() == "6" and "127.0.0.1:" in cells["state"].toolTip()


def test_a_note_has_its_arrival_time_even_if_the_window_was_busy(window, engine, qtbot):
    window.host.adopt(scripted_setup(engine))
    port = open_at(window, qtbot, "udp")
    window.run_command("record")
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as client:
        asked = window.remote.counts("udp").asked
        client.sendto(b"note late", (HERE, port))
        while window.remote.counts("udp").asked == asked:  # the window's thread is busy: no event
            time.sleep(0.001)
        arrived = monotonic()
        time.sleep(0.02)  # for twenty times the maximum timestamp error
        qtbot.waitUntil(lambda: bool(window.host.notes.current))
        (note,) = window.host.notes.current.values()
        assert note.t <= arrived + 0.001
        client.settimeout(60)
        assert json.loads(client.recv(9999))["ok"]


def test_the_reason_for_a_refused_recording_is_answered(window, engine, qtbot, tmp_path):
    port = open_at(window, qtbot, "udp")

    def start():
        return json.loads(meanwhile(qtbot, lambda: ask_over_udp({"do": "start"}, HERE, port)))

    assert start()["code"] == "remote.no_device"
    window.host.adopt(scripted_setup(engine))
    (tmp_path / "file").write_text("no folder")
    window.store.update(sessions_folder=str(tmp_path / "file" / "below"))
    answer = start()
    assert not answer["ok"] and shows(answer["error"], "window.recording_folder")
    assert shows(window.banner.text(), "window.recording_folder"), "as when the key is pressed"


def test_osc_and_web_socket_control_it_too(window, engine, qtbot):
    pytest.importorskip("websockets", reason="websockets is not installed (extra `streams`)")
    from websockets.sync.client import connect

    window.host.adopt(scripted_setup(engine))
    osc, web = open_at(window, qtbot, "osc"), open_at(window, qtbot, "websocket")

    def by_osc():
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as client:
            client.settimeout(60)
            client.sendto(OscMessageBuilder("/glovetrack/start").build().dgram, (HERE, osc))
            return OscMessage(client.recv(9999))

    def by_page():
        with connect(f"ws://{HERE}:{web}/") as page:
            page.send("stop")
            return json.loads(page.recv(timeout=60))

    answer = meanwhile(qtbot, by_osc)
    assert answer.params[:2] == ["start", 1]
    assert answer.params[3] == window.host.recording.request.path.name
    assert meanwhile(qtbot, by_page)["ok"] and window.host.recording.request is None


def test_a_finger_vibrates_at_a_limited_rate(window, engine, qtbot):
    glove = ScriptedGlove()
    buzzed = glove.vibrated
    window.host.adopt(with_glove(scripted_setup(engine), glove))
    line = json.dumps({"do": "vibrate", "finger": "middle", "amplitude": 90, "duration_ms": 40})
    began = monotonic()
    assert json.loads(window.remote.answers.answer_line(line))["ok"]
    assert buzzed == [(2, 90, 40)]
    answers = [json.loads(window.remote.answers.answer_line(line)) for _ in range(500)]
    refused = [answer for answer in answers if not answer["ok"]]
    assert len(buzzed) == 1 + len(answers) - len(refused)
    assert len(buzzed) <= MOTOR_HZ * (2 + monotonic() - began), "a burst, and what time has allowed"
    assert refused or monotonic() - began > 5
    for answer in refused:
        assert (answer["code"], answer["values"]) == ("remote.motor_limit", {"rate_hz": 50})
    window.host.stop()
    assert json.loads(window.remote.answers.answer_line(line))["code"] == "remote.no_motors"


def test_a_contact_vibrates_while_it_lasts_and_is_recorded(window, engine, qtbot):
    glove, recorded = ScriptedGlove(), []
    buzzed = glove.vibrated
    engine.record = recorded.append
    window.host.adopt(with_glove(scripted_setup(engine), glove))

    def say(strength: float) -> dict:
        contact = {"do": "contact", "finger": "thumb", "strength": strength, "object": "cup"}
        return json.loads(window.remote.answers.answer_line(json.dumps(contact)))

    assert say(1.0)["text"] == "The thumb touches cup."
    assert say(0.25)["ok"] and say(0.0)["text"] == "The thumb lets go of cup."
    assert [command[0] for command in buzzed] == [0, 0, 0]
    assert buzzed[0][1] == 255 > buzzed[1][1] > buzzed[2][1] == 0
    assert [(e.kind, e.data["phase"], e.data["object"]) for e in recorded] == [
        ("contact", "begin", "cup"),
        ("contact", "end", "cup"),
    ]
    say(1.0)  # and its end is not reported
    qtbot.waitUntil(lambda: len(recorded) == 4)
    assert recorded[-1].data["phase"] == "end"


def test_contacts_and_vibration_work_by_osc_and_by_web_socket(window, engine, qtbot):
    pytest.importorskip("websockets", reason="websockets is not installed (extra `streams`)")
    from websockets.sync.client import connect

    glove = ScriptedGlove()
    buzzed = glove.vibrated
    window.host.adopt(with_glove(scripted_setup(engine), glove))
    osc, web = open_at(window, qtbot, "osc"), open_at(window, qtbot, "websocket")

    def by_osc():
        message = OscMessageBuilder("/glovetrack/contact")
        for value in ("index", 1.0, "cup"):
            message.add_arg(value)
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as client:
            client.settimeout(60)
            client.sendto(message.build().dgram, (HERE, osc))
            return OscMessage(client.recv(9999)).params

    def by_page():
        with connect(f"ws://{HERE}:{web}/") as page:
            page.send('{"do": "contact", "finger": "index", "strength": 0, "object": "cup"}')
            ended = json.loads(page.recv(timeout=60))
            page.send("vibrate little")
            return ended, json.loads(page.recv(timeout=60))

    assert meanwhile(qtbot, by_osc)[:3] == ["contact", 1, "The index touches cup."]
    ended, vibrated = meanwhile(qtbot, by_page)
    assert ended["text"] == "The index lets go of cup." and vibrated["ok"]
    assert buzzed == [(1, 255, 2000), (1, 0, 1), (4, 200, 80)]


def test_open_interfaces_are_restored_with_a_warning_if_external(window, qtbot, store):
    open_at(window, qtbot, "udp")
    assert SettingsStore(store.path).value.remote["udp"] is True
    box = window.panels["streams"].remote
    assert not box.opened.isVisibleTo(window.panels["streams"])
    box.address.setText("0.0.0.0")
    box.address.editingFinished.emit()
    assert box.opened.isVisibleTo(window.panels["streams"])
    qtbot.waitUntil(lambda: "0.0.0.0" in box.cells["udp"]["state"].toolTip())
    box.boxes["udp"].click()
    qtbot.waitUntil(lambda: not [t for t in threading.enumerate() if "remote" in t.name])


def test_a_port_in_use_is_reported_in_the_panel(window, qtbot):
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
        taken.bind((HERE, 0))
        window.remote.set_port("udp", taken.getsockname()[1])
        window.remote.switch("udp", True)
        qtbot.waitUntil(lambda: "udp" in window.remote.problems)
    cells = window.panels["streams"].remote.cells["udp"]
    assert "not open" in cells["state"].text() and shows(
        cells["state"].toolTip(), "remote.not_started"
    )


def test_the_command_line_opens_interfaces_for_one_run(window, qtbot):
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as s:
        s.bind((HERE, 0))
        port = s.getsockname()[1]
    window.remote.use(f"udp:{port}")
    qtbot.waitUntil(lambda: window.remote.counts("udp") is not None)
    assert window.panels["streams"].remote.boxes["udp"].isChecked()
    assert window.store.value.remote == {}, "the next start is as it was"


def said_to(qtbot, name: str, words: dict) -> bytes:
    """The answer of the local socket, which this thread serves too; empty if it disconnects."""
    socket = QLocalSocket()
    socket.connectToServer(addresses(name)[0])
    socket.write(json.dumps(words).encode() + b"\n")
    gone = QLocalSocket.LocalSocketState.UnconnectedState
    qtbot.waitUntil(lambda: socket.canReadLine() or socket.state() == gone)
    return bytes(socket.readAll().data())


def test_the_windows_own_socket_accepts_requests_and_still_opens_sessions(window, engine, qtbot):
    name = f"glovetrack-test-{uuid.uuid4().hex}"
    instance = Instance(name)
    try:
        assert said_to(qtbot, name, {"remote": {"do": "status"}}) == b"", "no window yet"
        instance.answer = window.remote.answers.answer_line
        window.host.adopt(scripted_setup(engine))
        answer = json.loads(said_to(qtbot, name, {"remote": {"do": "start"}}))
        assert answer["file"] == str(window.host.recording.request.path)
        wrong = json.loads(said_to(qtbot, name, {"remote": {"do": "explode"}}))
        assert not wrong["ok"] and wrong["code"] == "request.unknown"
        assert said_to(qtbot, name, {"open": ""}) == b"taken\n"
        assert ask({"do": "status"}, name + "x") is None
    finally:
        instance.close()


FIRST = """
import sys
sys.path.insert(0, {tests!r})
from tests.gui.gui_fakes import ScriptedEngine, scripted_setup
from app.window.main_window import MainWindow
from app.window.sources import Sources

Sources.open_devices = lambda self: self._host.adopt(scripted_setup(ScriptedEngine()))
from app.__main__ import main
sys.exit(main(["devices"]))
"""


@pytest.mark.long
@pytest.mark.timeout(180)
def test_the_command_controls_the_window_of_another_process(tmp_path, monkeypatch, capsys):
    """Start, note, stop as a lab's script does; the window is a process of its own."""
    for name, value in {
        "PYTHONPATH": str(ROOT),
        "HOME": str(tmp_path),
        **{f"XDG_{k}_HOME": str(tmp_path / k) for k in ("CONFIG", "STATE", "DATA", "CACHE")},
    }.items():
        monkeypatch.setenv(name, value)

    def remote(*words: str) -> SimpleNamespace:
        """In this process: the last one below starts the program."""
        capsys.readouterr()
        status = main(["remote", *words])
        return SimpleNamespace(returncode=status, **capsys.readouterr()._asdict())

    alone = remote("start")
    assert alone.returncode == 1 and shows(alone.err, "window.none")
    script = FIRST.format(tests=str(ROOT / "tests" / "gui"))
    with subprocess.Popen([sys.executable, "-c", script]) as first:
        try:
            deadline = time.monotonic() + 60
            while not (
                (status := remote("status", "--json", "-")).returncode == 0
                and json.loads(status.out)["running"]
            ):
                assert first.poll() is None and time.monotonic() < deadline
                time.sleep(0.1)
            started = remote("start")
            assert started.returncode == 0 and "Recording " in started.out
            path = Path(started.out.splitlines()[-1])
            assert path.exists()
            assert shows(remote("start").err, "remote.recording_already")
            assert "Noted in" in remote("note", "the cup is taken").out
            stopped = json.loads(remote("stop", "--json", "-").out)
            assert stopped["ok"] and stopped["file"] == str(path)
            last = subprocess.run([sys.executable, "-m", "app", "remote", "stop"], cwd=ROOT)
            assert last.returncode == 1
        finally:
            first.terminate()
            first.wait(60)


@pytest.mark.parametrize("words", [[], ["dance"], ["note"], ["stop", "--to", "host:x"]])
def test_wrong_usage_is_reported_as_by_every_command(words):
    with pytest.raises(SystemExit) as ended:
        main(["remote", *words])
    assert ended.value.code == 2


def test_the_pose_of_a_tracker_reaches_the_hand_of_its_side(window, engine, qtbot):
    from pythonosc.udp_client import SimpleUDPClient

    placed = []
    engine.place = placed.append
    window.host.adopt(scripted_setup(engine, []))
    kind = window.remote.kinds["room"]
    assert kind.options().right == ""
    window.remote.settings = window.remote.settings.changed(room_right="any", room_left="any")
    port = open_at(window, qtbot, "room")
    with SimpleUDPClient(HERE, port) as client:
        client.send_message("/glovetrack/wrist", ["T", 0.1, 0.2, 1.3, 0.0, 0.0, 0.0, 1.0])
        qtbot.waitUntil(lambda: bool(placed))
    (pose,) = placed
    assert pose.side == window.host.setup.side and pose.p_GT.tolist() == pytest.approx(
        [0.1, 0.2, 1.3]
    )
    counts = window.remote.counts("room")
    assert (counts.asked, counts.refused) == (2, 1), "there is no other hand"
