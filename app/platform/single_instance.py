"""One window per user: a second start hands its session file to the first one and ends.

By the same socket, which is open to this user alone, `ask` has the window start, stop and note.

The name of the local socket is made from the folder of the settings: who has other settings has
another window.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import platformdirs
from PySide6.QtCore import QObject, Signal
from PySide6.QtNetwork import QLocalServer, QLocalSocket

WAIT_MS = 2000
ASK_MS = 10_000  # a window that opens devices is busy for seconds
MOST_BYTES = 65536
ANSWER = b"taken\n"


def server_name() -> str:
    """The socket's name; the same for every start with the same settings."""
    folder = platformdirs.user_config_dir("glovetrack", appauthor=False)
    return "glovetrack-" + hashlib.sha256(folder.encode()).hexdigest()[:16]


def hand_over(session: Path | None, name: str | None = None) -> bool:
    """Give ``session`` (None: only show yourself) to the window that is open; False if none is."""
    said = {"open": str(session.resolve()) if session is not None else ""}
    return _converse(said, name, WAIT_MS) == ANSWER


def ask(words: dict[str, Any], name: str | None = None) -> str | None:
    """Have the window that is open do something; its answer as JSON, None where none answers."""
    answer = _converse({"remote": words}, name, ASK_MS)
    return answer.decode("utf-8").strip() if answer else None


def _converse(said: dict[str, Any], name: str | None, wait_ms: int) -> bytes:
    """Say one line to the window that is open; its answer, empty where there is none."""
    socket = QLocalSocket()
    socket.connectToServer(name or server_name())
    if not socket.waitForConnected(WAIT_MS):
        return b""
    socket.write(json.dumps(said).encode() + b"\n")
    answer = b""
    if socket.waitForBytesWritten(WAIT_MS):
        while not answer.endswith(b"\n") and socket.waitForReadyRead(wait_ms):
            answer += bytes(socket.readAll().data())
    socket.disconnectFromServer()
    return answer


class Instance(QObject):
    """Listens for later starts; ``asked`` has the session's path, or "" for the window alone.

    ``answer``, once there is a window, does what is asked as JSON and answers as JSON.
    """

    asked = Signal(str)
    answer: Callable[[str], str] | None = None

    def __init__(self, name: str | None = None, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._sockets: set[QLocalSocket] = set()
        self._server = QLocalServer(self)
        self._server.setSocketOptions(QLocalServer.SocketOption.UserAccessOption)
        self._server.newConnection.connect(self._connected)
        name = name or server_name()
        if not _is_served(name):  # Qt would take the name away from who has it
            QLocalServer.removeServer(name)  # left by a crash
            self._server.listen(name)

    @property
    def listening(self) -> bool:
        """False where another window was first: a demo may run beside it."""
        return self._server.isListening()

    def _connected(self) -> None:
        socket = self._server.nextPendingConnection()
        self._sockets.add(socket)
        socket.readyRead.connect(partial(self._read, socket))
        socket.disconnected.connect(partial(self._forget, socket))
        if socket.canReadLine():
            self._read(socket)

    def _forget(self, socket: QLocalSocket) -> None:
        self._sockets.discard(socket)
        socket.deleteLater()

    def _read(self, socket: QLocalSocket) -> None:
        if socket.bytesAvailable() > MOST_BYTES:
            socket.abort()
            return
        if not socket.canReadLine():
            return
        try:
            said = json.loads(bytes(socket.readLine().data()))
            path, wish = said.get("open"), said.get("remote")
        except (ValueError, AttributeError):
            socket.abort()
            return
        if isinstance(wish, dict) and self.answer is not None:
            socket.write(self.answer(json.dumps(wish)).encode() + b"\n")
            socket.flush()
        elif isinstance(path, str):
            socket.write(ANSWER)
            socket.flush()
            self.asked.emit(path)
        else:
            socket.abort()

    def close(self) -> None:
        for socket in self._sockets:
            socket.blockSignals(True)
            socket.abort()
        self._sockets.clear()
        self._server.close()


def _is_served(name: str) -> bool:
    """Whether somebody takes connections there."""
    socket = QLocalSocket()
    socket.connectToServer(name)
    served = socket.waitForConnected(WAIT_MS)
    socket.abort()
    return bool(served)
