"""Who is at the other end of a Windows pipe, asked of a system that answers as documented."""

from __future__ import annotations

import ctypes
import os
from typing import Any

import pytest

from app.platform import single_instance
from app.platform.single_instance import is_own_pipe

SIDS = {1: ctypes.create_string_buffer(b"S-own", 5), 2: ctypes.create_string_buffer(b"S-oth", 5)}
OWN, OTHER, HIDDEN, SECOND_OWN = os.getpid(), 7, 8, 9
USERS = {OWN: 1, SECOND_OWN: 1, OTHER: 2}  # of processes; that of HIDDEN may not be opened


class System:
    """kernel32 and advapi32; a pipe's handle is its server's process, its client is this one."""

    def __init__(self) -> None:
        self.open = 0

        class Called:
            restype: Any = None

            def __call__(_, access: int, inherit: bool, process: int) -> int:
                return self._opened(process)

        self.OpenProcess = Called()

    def _opened(self, process: int) -> int:
        self.open += process in USERS
        return process if process in USERS else 0

    def GetNamedPipeServerProcessId(self, handle: Any, number: Any) -> int:
        number._obj.value = handle.value or 0
        return int(bool(handle.value))

    def GetNamedPipeClientProcessId(self, handle: Any, number: Any) -> int:
        number._obj.value = OWN
        return 1

    def OpenProcessToken(self, process: Any, access: int, token: Any) -> int:
        self.open += 1
        token._obj.value = process.value
        return 1

    def GetTokenInformation(self, token: Any, kind: int, data: Any, room: Any, size: Any) -> int:
        assert kind == 1
        size._obj.value = 16
        if data is None:
            return 0
        address = ctypes.addressof(SIDS[USERS[token.value]])
        ctypes.memmove(data, ctypes.byref(ctypes.c_void_p(address)), ctypes.sizeof(ctypes.c_void_p))
        return 1

    def GetLengthSid(self, sid: Any) -> int:
        return 5

    def CloseHandle(self, handle: Any) -> int:
        self.open -= 1
        return 1


@pytest.mark.parametrize(
    ("server", "own"),
    [(OWN, True), (SECOND_OWN, True), (OTHER, False), (HIDDEN, False), (0, False)],
    ids=["this process", "another of this user", "another user's", "hidden", "none"],
)
def test_only_a_pipe_of_this_user_is_accepted(
    server: int, own: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    system = System()
    monkeypatch.setattr(single_instance, "_library", lambda name: system)
    assert is_own_pipe(server) == own
    assert system.open == 0, "no handle is left open"
