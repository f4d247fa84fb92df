"""One window per user: a second start passes its session file to the first one and ends.

The socket accepts only this user (`own_socket`). `ask` sends requests to start, stop and annotate a
recording.

The name of the local socket is derived from the folder of the settings: each folder of settings has
its own window.
"""

from __future__ import annotations

import hashlib
import json
import logging
import math
import time
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import platformdirs
from PySide6.QtCore import QObject, Signal
from PySide6.QtNetwork import QLocalServer, QLocalSocket

from app.platform.own_socket import ForeignSocket, addresses, check_peer
from tracker.base.errors import GlovetrackError
from tracker.base.notices import notice
from tracker.streaming.remote.request import is_reply

WAIT_MS = 2000
ASK_MS = 30_000  # a window that is opening devices on a loaded computer responds late
MOST_BYTES = 65536
ANSWER = b"taken\n"

_log = logging.getLogger(__name__)


def server_name() -> str:
    """The socket's name; the same for every start with the same settings."""
    folder = platformdirs.user_config_dir("glovetrack", appauthor=False)
    return "glovetrack-" + hashlib.sha256(folder.encode()).hexdigest()[:16]


def hand_over(session: Path | None, at: float | None = None, name: str | None = None) -> bool:
    """Pass ``session`` (None: only show the window), to be paused at ``at`` s if that is given, to
    the open window; False if there is none.

    Raises ForeignSocket if another user's program listens, GlovetrackError for an invalid answer.
    """
    request: dict[str, Any] = {"open": str(session.resolve()) if session is not None else ""}
    if at is not None:
        request["at"] = at
    answer = _converse(request, name, WAIT_MS)
    if answer not in (None, b"", ANSWER):
        raise GlovetrackError(notice("window.other_program"))
    return answer == ANSWER


def ask(words: dict[str, Any], name: str | None = None) -> str | None:
    """Send a request to the open window; its answer as JSON, None if no window is open.

    Raises ForeignSocket if another user's program listens, GlovetrackError for an invalid answer or
    if there is none within `ASK_MS`.
    """
    answer = _converse({"remote": words}, name, ASK_MS)
    if answer is None:
        return None
    if not answer:
        raise GlovetrackError(notice("window.no_answer", seconds=ASK_MS // 1000))
    if not is_reply(answer):
        raise GlovetrackError(notice("window.other_program"))
    return answer.decode("utf-8").strip()


def _converse(request: dict[str, Any], name: str | None, wait_ms: int) -> bytes | None:
    """Send one line to the open window; its answer, empty if it does not answer within ``wait_ms``;
    None if no window is open."""
    socket = _connected_to(name or server_name())
    if socket is None:
        return None
    socket.write(json.dumps(request).encode() + b"\n")
    answer, end = b"", time.monotonic() + wait_ms / 1000
    if socket.waitForBytesWritten(WAIT_MS):
        while not answer.endswith(b"\n") and len(answer) <= MOST_BYTES:
            left = int(1000 * (end - time.monotonic()))
            if left <= 0 or not socket.waitForReadyRead(left):
                break
            answer += bytes(socket.readAll().data())
    socket.disconnectFromServer()
    return answer


def _connected_to(name: str) -> QLocalSocket | None:
    """A connection to a window of this user; None if there is none. Raises ForeignSocket."""
    for address in addresses(name):
        socket = QLocalSocket()
        socket.connectToServer(address)
        if socket.waitForConnected(WAIT_MS):
            check_peer(int(socket.socketDescriptor()), address)
            return socket
    return None


class Instance(QObject):
    """Accepts later starts; ``asked``: path of the session, or "" to show the window, and the time
    in s at which the replay is paused, or None.

    Raises ForeignSocket, or DiskError if no private socket can be created.

    ``answer`` handles requests in JSON and returns answers in JSON; empty before there is a window.
    """

    asked = Signal(str, object)

    def __init__(self, name: str | None = None, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.answer: Callable[[str], str] = lambda _request: ""
        self._sockets: set[QLocalSocket] = set()
        self._server = QLocalServer(self)
        self._server.setSocketOptions(QLocalServer.SocketOption.UserAccessOption)
        self._server.newConnection.connect(self._connected)
        name = name or server_name()
        if not _is_served(name):  # otherwise Qt would remove the socket of an open window
            self._address = addresses(name)[0]
            QLocalServer.removeServer(self._address)  # left behind by a crash
            if not self._server.listen(self._address):
                _log.warning("%s: %s", self._address, self._server.errorString())

    @property
    def listening(self) -> bool:
        """False if another window was first: a demo may run next to it."""
        return self._server.isListening()

    def _connected(self) -> None:
        socket = self._server.nextPendingConnection()
        try:
            check_peer(int(socket.socketDescriptor()), self._address)
        except ForeignSocket as error:
            _log.warning("A connection was refused: %s", error)
            socket.abort()
            socket.deleteLater()
            return
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
            request = json.loads(bytes(socket.readLine().data()))
            path, wish = request.get("open"), request.get("remote")
            at = request.get("at")
        except (ValueError, AttributeError):
            socket.abort()
            return
        answer = self.answer(json.dumps(wish)) if isinstance(wish, dict) else ""
        if answer:
            socket.write(answer.encode() + b"\n")
            socket.flush()
        elif isinstance(path, str) and _is_time(at):
            socket.write(ANSWER)
            socket.flush()
            self.asked.emit(path, at)
        else:
            socket.abort()

    def close(self) -> None:
        for socket in self._sockets:
            socket.blockSignals(True)
            socket.abort()
        self._sockets.clear()
        self._server.close()


def _is_time(at: object) -> bool:
    """Whether it is a time of a session, or None."""
    return at is None or (isinstance(at, int | float) and math.isfinite(at))


def _is_served(name: str) -> bool:
    """Whether a window of this user listens at the address. Raises ForeignSocket."""
    socket = _connected_to(name)
    if socket is not None:
        socket.abort()
    return socket is not None
