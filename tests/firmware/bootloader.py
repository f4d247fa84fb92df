"""An Arduino's bootloader on a pseudo terminal: the STK500 protocol, version 1, as Optiboot has it.

Atmel's application note AVR061 describes it. Pages are stored as written, so that a test can
compare what a programmer left in the flash.
"""

from __future__ import annotations

import os
import select
import threading
import tty

OK, IN_SYNC, END = 0x10, 0x14, 0x20
ATMEGA328P = bytes([0x1E, 0x95, 0x0F])
ANSWERS = {  # command -> (bytes that follow it before END, its answer)
    0x30: (0, b""),  # get synchronised
    0x41: (1, b"\x03"),  # a parameter
    0x42: (20, b""),  # the device
    0x45: (5, b""),  # more of it
    0x50: (0, b""),  # begin programming
    0x51: (0, b""),  # end programming
    0x56: (4, b"\x00"),  # any SPI command
    0x75: (0, ATMEGA328P),  # the signature
}
LOAD_ADDRESS, WRITE_PAGE, READ_PAGE = 0x55, 0x64, 0x74


class Bootloader:
    """Answers until it is closed; ``spoils`` is an address whose byte it cannot store."""

    def __init__(self, spoils: int | None = None) -> None:
        self.flash = bytearray(b"\xff" * 32768)
        self._spoils, self._address = spoils, 0
        self._host, device = os.openpty()
        tty.setraw(device)
        self.port = os.ttyname(device)
        self._device = device
        self._pipe, self._ends = os.pipe()
        self._thread = threading.Thread(target=self._serve)
        self._thread.start()

    def close(self) -> None:
        os.write(self._ends, b"x")
        self._thread.join(10)
        for descriptor in (self._host, self._device, self._pipe, self._ends):
            os.close(descriptor)

    def _serve(self) -> None:
        while (command := self._read(1)) is not None:
            answer = self._answer(command[0])
            if answer is None:
                return
            os.write(self._host, bytes([IN_SYNC]) + answer + bytes([OK]))

    def _answer(self, command: int) -> bytes | None:
        if command in ANSWERS:
            count, answer = ANSWERS[command]
            return answer if self._read(count + 1) is not None else None
        if command == LOAD_ADDRESS:
            words = self._read(3)
            if words is None:
                return None
            self._address = 2 * (words[0] | words[1] << 8)
            return b""
        head = self._read(3)
        if head is None:
            return None
        size = head[0] << 8 | head[1]
        if command == READ_PAGE:
            self._read(1)
            return bytes(self.flash[self._address : self._address + size])
        page = self._read(size + 1)
        if page is None or command != WRITE_PAGE:
            return None
        self.flash[self._address : self._address + size] = page[:size]
        if self._spoils is not None:
            self.flash[self._spoils] ^= 0x01
        return b""

    def _read(self, count: int) -> bytes | None:
        """That many bytes; None when it is closed."""
        out = b""
        while len(out) < count:
            ready, _, _ = select.select([self._host, self._pipe], [], [])
            if self._pipe in ready:
                return None
            out += os.read(self._host, count - len(out))
        return out
