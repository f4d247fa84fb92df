"""Whether the process at the other end of a Windows named pipe is this user's.

GetNamedPipeServerProcessId and GetNamedPipeClientProcessId give the process, its token the security
identifier (SID) of its user. What cannot be found out counts as another user. This follows the
documentation of the system; it has not been run on Windows.
"""

from __future__ import annotations

import ctypes
import os
from typing import Any

_QUERY_LIMITED, _TOKEN_QUERY, _TOKEN_USER = 0x1000, 0x0008, 1


def is_own_pipe(handle: int) -> bool:
    """``handle`` is of either end of a connected pipe."""
    ours = _user_of(os.getpid())
    processes = _processes_of(handle) - {os.getpid()}
    return ours is not None and all(_user_of(process) == ours for process in processes)


def _processes_of(handle: int) -> set[int]:
    """Those of both ends; 0, which is no user's, where one is not known."""
    found = set()
    for name in ("GetNamedPipeServerProcessId", "GetNamedPipeClientProcessId"):
        number = ctypes.c_ulong(0)
        ok = getattr(_library("kernel32"), name)(ctypes.c_void_p(handle), ctypes.byref(number))
        found.add(int(number.value) if ok else 0)
    return found


def _user_of(process: int) -> bytes | None:
    """The SID of the user who runs a process; None where the system does not say."""
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
    sid = ctypes.c_void_p.from_buffer(data)  # TOKEN_USER begins with a pointer to it
    length = advapi.GetLengthSid(sid)
    return ctypes.string_at(sid.value or 0, length) if sid.value else None


def _library(name: str) -> Any:
    return getattr(ctypes, "WinDLL")(name, use_last_error=True)  # noqa: B009  only Windows has it
