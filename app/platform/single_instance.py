"""One window per user: a second start passes its session file to the first one and ends.

The socket accepts only this user. `ask` sends requests to start, stop and annotate a
recording.

The name of the local socket is derived from the folder of the settings: each folder of settings has
its own window.
"""

from __future__ import annotations

import ctypes
import hashlib
import json
import logging
import math
import os
import secrets
import socket
import stat
import struct
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import platformdirs
from PySide6.QtCore import QObject, Signal
from PySide6.QtNetwork import QLocalServer, QLocalSocket

from tracker.base.errors import GlovetrackError
from tracker.base.files import disk_error
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
    """Accepts later starts; ``requested``: path of the session, or "" to show the window, and the
    time in s at which the replay is paused, or None.

    Raises ForeignSocket, or DiskError if no private socket can be created.

    ``answer`` handles requests in JSON and returns answers in JSON; empty before there is a window.
    """

    requested = Signal(str, object)

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
            path, remote_request = request.get("open"), request.get("remote")
            at = request.get("at")
        except (ValueError, AttributeError):
            socket.abort()
            return
        answer = self.answer(json.dumps(remote_request)) if isinstance(remote_request, dict) else ""
        if answer:
            socket.write(answer.encode() + b"\n")
            socket.flush()
        elif isinstance(path, str) and _is_time(at):
            socket.write(ANSWER)
            socket.flush()
            self.requested.emit(path, at)
        else:
            socket.abort()

    def close(self) -> None:
        for each in self._sockets:
            each.blockSignals(True)
            each.abort()
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


# ---- the path of the window's local socket, and the owner of the process at its other end
#
# All users may create names in the shared temporary folder, so the socket is in a folder that
# only this user can write to: `XDG_RUNTIME_DIR`, else a folder in the user's cache. Both ends
# also compare the user id of the other process with their own.
#
# Windows: pipes have no folders. The pipe's name contains a random text from a file in the user's
# own folder, which other users cannot read; Qt limits access to the pipe to its user; and both
# ends ask the system which user runs the process at the other end (`is_own_pipe`). This branch
# and that for macOS follow the systems' documentation; they have not been run there.

WINDOWS = sys.platform == "win32"
LONGEST_PATH = 100  # bytes; Linux takes 107, macOS 103
_SECRET = "pipe-name"
_SECRET_BYTES = 32
_SOL_LOCAL, _LOCAL_PEERCRED, _XUCRED_BYTES = 0, 1, 76  # sys/un.h and sys/ucred.h of macOS
_UCRED = "3i"  # pid, uid, gid of Linux


_QUERY_LIMITED, _TOKEN_QUERY, _TOKEN_USER = 0x1000, 0x0008, 1


class ForeignSocket(GlovetrackError):
    """The socket, or the folder for it, belongs to another user."""


def addresses(name: str) -> list[str]:
    """Addresses on which a window may listen, that of a new one first.

    There may be two: a script that is started by cron has no `XDG_RUNTIME_DIR`, but the window has.
    Raises ForeignSocket, or DiskError if no private folder can be created.
    """
    if WINDOWS:
        return [f"{name}-{_pipe_secret()}"]
    found = [str(folder / name) for folder in _runtime_folders() if _fits(folder / name)]
    return found or [str(_fallback(name) / name)]


def check_peer(descriptor: int, address: str) -> None:
    """Raises ForeignSocket unless the process at the other end of a socket is this user's."""
    if WINDOWS:
        if not is_own_pipe(descriptor):
            raise ForeignSocket(notice("window.foreign_pipe", address=address))
        return
    uid = _peer_uid(descriptor)
    if uid != os.getuid():
        raise ForeignSocket(
            notice("window.foreign_socket", address=address, uid="?" if uid is None else uid)
        )


def _runtime_folders() -> Iterator[Path]:
    """Folders that the system creates for a logged-in user and that only this user can access."""
    named = [os.environ.get("XDG_RUNTIME_DIR", ""), f"/run/user/{os.getuid()}"]
    for text in dict.fromkeys(named):
        if text.startswith("/") and _is_private(Path(text)):
            yield Path(text)


def _fallback(name: str) -> Path:
    """A folder of mode 0700 in the user's cache; in the temporary folder if that path is too long.

    Raises ForeignSocket, DiskError.
    """
    kept = platformdirs.user_cache_path("glovetrack", appauthor=False) / "run"
    if _fits(kept / name):
        return _made_private(kept)
    return _made_private(Path(tempfile.gettempdir()) / f"glovetrack-{os.getuid()}")


def _fits(path: Path) -> bool:
    return len(os.fsencode(path)) <= LONGEST_PATH


def _is_private(folder: Path) -> bool:
    """Whether it is a folder, not a link, that only this user can access."""
    try:
        found = folder.lstat()
    except OSError:
        return False
    own = stat.S_ISDIR(found.st_mode) and found.st_uid == os.getuid()
    return own and not stat.S_IMODE(found.st_mode) & 0o077


def _made_private(folder: Path) -> Path:
    try:
        folder.parent.mkdir(parents=True, exist_ok=True)
        folder.mkdir(mode=0o700, exist_ok=True)
    except FileExistsError:
        pass  # a file or a link, rejected below
    except OSError as error:
        raise disk_error(folder, error) from error
    if not _is_private(folder):
        raise ForeignSocket(notice("window.socket_folder", folder=folder))
    return folder


def _peer_uid(descriptor: int) -> int | None:
    """The user id of the process at the other end; None if unknown."""
    with socket.socket(fileno=os.dup(descriptor)) as line:
        try:
            if hasattr(socket, "SO_PEERCRED"):
                size = struct.calcsize(_UCRED)
                found = line.getsockopt(socket.SOL_SOCKET, socket.SO_PEERCRED, size)
                return int(struct.unpack(_UCRED, found)[1])
            found = line.getsockopt(_SOL_LOCAL, _LOCAL_PEERCRED, _XUCRED_BYTES)
            return int(struct.unpack_from("II", found)[1])
        except (OSError, struct.error):
            return None


def _pipe_secret() -> str:
    """A random text that only this user can read; created by the first window."""
    path = platformdirs.user_data_path("glovetrack", appauthor=False) / _SECRET
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.exists():
            part = path.with_name(f"{_SECRET}.{secrets.token_hex(8)}")
            with os.fdopen(os.open(part, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600), "w") as file:
                file.write(secrets.token_hex(_SECRET_BYTES))
            part.replace(path)
        return path.read_text("ascii").strip()
    except (OSError, UnicodeError) as error:
        raise GlovetrackError(notice("window.file_not_usable", path=path, why=error)) from error


def is_own_pipe(handle: int) -> bool:
    """``handle``: either end of a connected pipe."""
    ours = _user_of(os.getpid())
    processes = _processes_of(handle) - {os.getpid()}
    return ours is not None and all(_user_of(process) == ours for process in processes)


def _processes_of(handle: int) -> set[int]:
    """The processes of both ends; 0, which has no user, for an unknown one."""
    found = set()
    for name in ("GetNamedPipeServerProcessId", "GetNamedPipeClientProcessId"):
        number = ctypes.c_ulong(0)
        ok = getattr(_library("kernel32"), name)(ctypes.c_void_p(handle), ctypes.byref(number))
        found.add(int(number.value) if ok else 0)
    return found


def _user_of(process: int) -> bytes | None:
    """The SID of the user who runs a process; None if unknown."""
    kernel, advapi = _library("kernel32"), _library("advapi32")
    kernel.OpenProcess.restype = ctypes.c_void_p
    opened = kernel.OpenProcess(_QUERY_LIMITED, False, process)
    if not opened:
        return None
    token = ctypes.c_void_p()
    try:
        if not advapi.OpenProcessToken(ctypes.c_void_p(opened), _TOKEN_QUERY, ctypes.byref(token)):
            return None
        return _sid(advapi, token)
    finally:
        for each in (token.value, opened):
            if each:
                kernel.CloseHandle(ctypes.c_void_p(each))


def _sid(advapi: Any, token: ctypes.c_void_p) -> bytes | None:
    size = ctypes.c_ulong(0)
    advapi.GetTokenInformation(token, _TOKEN_USER, None, 0, ctypes.byref(size))
    data = ctypes.create_string_buffer(size.value)
    if not advapi.GetTokenInformation(token, _TOKEN_USER, data, size, ctypes.byref(size)):
        return None
    sid = ctypes.c_void_p.from_buffer(data)  # TOKEN_USER begins with a pointer to the SID
    length = advapi.GetLengthSid(sid)
    return ctypes.string_at(sid.value or 0, length) if sid.value else None


def _library(name: str) -> Any:
    return getattr(ctypes, "WinDLL")(name, use_last_error=True)  # noqa: B009  only Windows has it
