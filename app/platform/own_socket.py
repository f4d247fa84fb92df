"""The path of the window's local socket, and the owner of the process at its other end.

All users may create names in the shared temporary folder, so the socket is in a folder that only
this user can write to: `XDG_RUNTIME_DIR`, else a folder in the user's cache. Both ends also compare
the user id of the other process with their own.

Windows: pipes have no folders. The pipe's name contains a random text from a file in the user's own
folder, which other users cannot read; Qt limits access to the pipe to its user; and both ends ask
the system which user runs the process at the other end (`is_own_pipe`). This branch and that for
macOS follow the systems' documentation; they have not been run there.
"""

from __future__ import annotations

import ctypes
import os
import secrets
import socket
import stat
import struct
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import platformdirs

from tracker.base.errors import GlovetrackError
from tracker.base.files import disk_error
from tracker.base.notices import notice

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
