"""Another user of the computer can neither take the window's socket nor use it."""

from __future__ import annotations

import os
import subprocess
import sys
import uuid
from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtNetwork import QLocalSocket

from app.platform import single_instance
from app.platform.single_instance import ForeignSocket, Instance, addresses, ask, hand_over
from tests.notices import raises, shows
from tracker.base.errors import GlovetrackError
from tracker.cli import main
from tracker.streaming.remote.request import Reply, is_reply

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="sockets of Unix")
as_root = pytest.mark.skipif(
    not hasattr(os, "getuid") or os.getuid() != 0, reason="only root can be a second user"
)
NOBODY = 65534
ROOT = Path(__file__).resolve().parents[2]

LISTEN = """
import os, socket, sys
path, uid = sys.argv[1], int(sys.argv[2])
os.setgid(uid); os.setuid(uid)
line = socket.socket(socket.AF_UNIX); line.bind(path); os.chmod(path, 0o777); line.listen()
print("listens", flush=True)
while True:
    end, _ = line.accept()
    try:
        end.recv(999); end.sendall(sys.argv[3].encode() + b"\\n")
    except OSError:
        pass  # the other end left without an answer
    end.close()
"""
CONNECT = """
import os, socket, sys
os.setgid(65534); os.setuid(65534)
line = socket.socket(socket.AF_UNIX); line.settimeout(60)
try:
    line.connect(sys.argv[1])
    line.sendall(b'{"open": "/etc/passwd"}\\n')
    print("answer", line.recv(99))
except OSError as error:
    print(type(error).__name__)
"""


@pytest.fixture
def shared(monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """A temporary folder writable by everyone, and no other place for the socket."""
    import tempfile

    with tempfile.TemporaryDirectory(dir="/tmp") as name:
        Path(name).chmod(0o1777)
        monkeypatch.setenv("TMPDIR", name)
        monkeypatch.setattr(tempfile, "tempdir", None)
        monkeypatch.setenv("XDG_RUNTIME_DIR", name)  # not private: not used
        monkeypatch.setenv("XDG_CACHE_HOME", f"{name}/{'long' * 25}")
        yield Path(name)


@pytest.fixture
def name() -> str:
    return f"glovetrack-test-{uuid.uuid4().hex[:12]}"


class Stranger:
    """A program that listens at ``path`` as the user ``uid``."""

    def __init__(self, path: Path, uid: int, answer: str) -> None:
        command = [sys.executable, "-c", LISTEN, str(path), str(uid), answer]
        self._process = subprocess.Popen(command, stdout=subprocess.PIPE, text=True)
        assert self._process.stdout is not None
        assert self._process.stdout.readline() == "listens\n"

    def end(self) -> None:
        self._process.kill()
        self._process.communicate()


def no_login_folder(monkeypatch: pytest.MonkeyPatch) -> None:
    """As without a login session: /run/user/UID is missing."""
    monkeypatch.setattr(single_instance, "_runtime_folders", lambda: iter(()))


def test_the_socket_is_in_a_private_folder_of_the_user(tmp_path, monkeypatch, name):
    run = tmp_path / "r"
    run.mkdir(mode=0o700)
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(run))
    if len(str(run / name)) <= single_instance.LONGEST_PATH:
        assert addresses(name)[0] == str(run / name)
    run.chmod(0o755)
    assert str(run / name) not in addresses(name), "others can enter it"
    run.chmod(0o700)
    (tmp_path / "l").symlink_to(run)
    monkeypatch.setenv("XDG_RUNTIME_DIR", str(tmp_path / "l"))
    assert str(tmp_path / "l" / name) not in addresses(name), "a link may be turned elsewhere"


def test_without_a_login_it_is_in_the_cache_or_in_a_private_temporary_folder(
    shared, monkeypatch, name
):
    no_login_folder(monkeypatch)
    folder = Path(addresses(name)[0]).parent
    assert folder == shared / f"glovetrack-{os.getuid()}" and folder.stat().st_mode & 0o777 == 0o700
    monkeypatch.setenv("XDG_CACHE_HOME", str(shared / "c"))
    folder = Path(addresses(name)[0]).parent
    assert folder == shared / "c" / "glovetrack" / "run" and folder.stat().st_mode & 0o777 == 0o700


@pytest.mark.parametrize("squatted", ["link", "file", "open"])
def test_a_squatted_folder_is_reported(shared, monkeypatch, name, squatted, capsys):
    no_login_folder(monkeypatch)
    folder = shared / f"glovetrack-{os.getuid()}"
    if squatted == "link":
        (shared / "other").mkdir(mode=0o700)
        folder.symlink_to(shared / "other")
    elif squatted == "file":
        folder.write_text("")
    else:
        folder.mkdir()
        folder.chmod(0o777)
    with raises(ForeignSocket, "window.socket_folder"):
        hand_over(None, name=name)
    assert main(["remote", "start"]) == 1
    assert shows(capsys.readouterr().err, "window.socket_folder")


@as_root
def test_a_folder_of_another_user_is_an_error_and_not_exit_0(shared, name):
    folder = shared / f"glovetrack-{os.getuid()}"
    folder.mkdir(mode=0o700)
    os.chown(folder, NOBODY, NOBODY)
    started = subprocess.run(
        [sys.executable, "-m", "app"],
        cwd=ROOT,
        env={**os.environ, "QT_QPA_PLATFORM": "offscreen"},
        capture_output=True,
        text=True,
        check=False,
        timeout=120,
    )
    if Path(f"/run/user/{os.getuid()}").exists():
        pytest.skip("this user is logged in and has a folder of the system's")
    assert started.returncode == 1 and shows(started.stderr, "window.socket_folder")
    assert "Traceback" not in started.stderr


@as_root
def test_another_users_listener_is_rejected(shared, monkeypatch, name, capsys):
    no_login_folder(monkeypatch)
    address = addresses(name)[0]
    stranger = Stranger(shared / "s", NOBODY, '{"ok": true, "do": "start", "text": "Trust me."}')
    try:
        (shared / "s").rename(address)
        for approach in (lambda: hand_over(None, name=name), lambda: ask({"do": "start"}, name)):
            with raises(ForeignSocket, "window.foreign_socket"):
                approach()
        with pytest.raises(ForeignSocket):
            Instance(name)
        monkeypatch.setattr("app.platform.single_instance.server_name", lambda: name)
        assert main(["remote", "start"]) == 1
        assert "Trust me" not in "".join(capsys.readouterr())
    finally:
        stranger.end()


@as_root
def test_another_user_cannot_connect_to_the_window(shared, monkeypatch, name, qtbot):
    no_login_folder(monkeypatch)
    instance, asked = Instance(name), []
    instance.requested.connect(lambda path, _at: asked.append(path))
    address = Path(addresses(name)[0])
    try:
        for opened in (False, True):  # even if the folder is made accessible later
            if opened:
                address.parent.chmod(0o755)
                address.chmod(0o777)
            command = [sys.executable, "-c", CONNECT, str(address)]
            with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as other:
                qtbot.waitUntil(lambda p=other: p.poll() is not None)
                output = other.communicate()[0]
            assert "taken" not in output
            assert ("PermissionError" in output) != opened
        assert asked == []
    finally:
        instance.close()


def test_an_answer_of_another_format_is_rejected(shared, monkeypatch, name):
    no_login_folder(monkeypatch)
    stranger = Stranger(Path(addresses(name)[0]), os.getuid(), "\x1b[2J I am the window")
    try:
        for approach in (lambda: hand_over(None, name=name), lambda: ask({"do": "start"}, name)):
            with raises(GlovetrackError, "window.other_program"):
                approach()
    finally:
        stranger.end()


def test_the_grammar_of_answers():
    for reply in (
        Reply(True, "start", "Recording a.", Path("a.mcap")),
        Reply(False, "", "What?"),
        Reply(True, "status", "Idle.", None, {"running": False, "duration_s": 1.5}, 7),
    ):
        assert is_reply(reply.as_json() + "\n") and is_reply(reply.as_json(True).encode())
    for wrong in (
        "", "x", "[]", "{}", '{"ok": 1, "do": "", "text": ""}',
        '{"ok": true, "do": "x", "text": ""}',
        '{"ok": true, "do": "", "error": ""}', '{"ok": true, "do": "", "text": "", "file": 3}',
        '{"ok": true, "do": "", "text": "", "more": {}}', "{" * 20_000, b"\xff",
        '{"ok": true, "do": "",\n "text": ""}',
    ):  # fmt: skip
        assert not is_reply(wrong), wrong


def test_the_socket_serves_its_own_user(name, qtbot):
    instance, asked = Instance(name), []
    instance.requested.connect(lambda path, _at: asked.append(path))
    try:
        socket = QLocalSocket()
        socket.connectToServer(addresses(name)[0])
        socket.write(b'{"open": ""}\n')
        qtbot.waitUntil(lambda: asked == [""])
    finally:
        instance.close()
