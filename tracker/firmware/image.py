"""Firmware images: Intel HEX files that contain their version and the glove's number.

Eight letters in the image are followed by the version (three bytes), the protocol (one) and the
glove's number (four, least significant first); resources/firmware/src/link.c puts them there.
"""

from __future__ import annotations

from dataclasses import dataclass
from importlib.resources import as_file
from pathlib import Path

import resources
from tracker.base.errors import ConfigError, FileError
from tracker.base.files import read_bounded
from tracker.base.notices import notice

MAGIC = b"GLOVEIMG"
BAUDS = (250_000, 115_200)
"""Speeds of the port that there is an image for."""
FLASH_BYTES = 32768
MOST_BYTES = 1_000_000
"""For a file; an image that fills the chip takes 92,000."""
_DATA, _END = 0x00, 0x01
_RECORD_BYTES = 16
_LARGEST_ID = 2**32 - 1


@dataclass(frozen=True)
class FirmwareImage:
    """What is written into the chip, from address zero."""

    data: bytes

    @property
    def version(self) -> tuple[int, int, int]:
        """As in the glove's HELLO."""
        at = self._about
        return self.data[at], self.data[at + 1], self.data[at + 2]

    @property
    def glove_id(self) -> int:
        """The number that identifies this glove."""
        return int.from_bytes(self.data[self._about + 4 : self._about + 8], "little")

    def for_glove(self, glove_id: int) -> FirmwareImage:
        """The same for the glove of that number.

        Raises:
            ConfigError if it is not a number from 1 to 4294967295.
        """
        if not 1 <= glove_id <= _LARGEST_ID:
            raise ConfigError(notice("firmware.number", most=_LARGEST_ID, number=glove_id))
        at = self._about + 4
        return FirmwareImage(self.data[:at] + glove_id.to_bytes(4, "little") + self.data[at + 4 :])

    def to_hex(self) -> str:
        """Intel HEX."""
        lines = []
        for address in range(0, len(self.data), _RECORD_BYTES):
            part = self.data[address : address + _RECORD_BYTES]
            record = bytes([len(part), address >> 8, address & 0xFF, _DATA]) + part
            lines.append(f":{(record + bytes([-sum(record) & 0xFF])).hex().upper()}")
        return "\n".join([*lines, ":00000001FF", ""])

    @property
    def _about(self) -> int:
        return self.data.index(MAGIC) + len(MAGIC)


def shipped_image(baud: int = BAUDS[0]) -> FirmwareImage:
    """The included image for a port of this speed.

    Raises:
        ConfigError: there is none for it.
    """
    if baud not in BAUDS:
        raise ConfigError(notice("firmware.baud", bauds=BAUDS, baud=baud))
    with as_file(resources.folder("firmware") / "images" / f"glove-{baud}.hex") as path:
        return read_image(path)


def read_image(path: Path) -> FirmwareImage:
    """An Intel HEX file of the glove's firmware.

    Raises:
        ConfigError: it cannot be read, is damaged, or is not the glove's firmware.
    """
    data = bytearray()
    try:
        lines = read_bounded(path, MOST_BYTES, "the glove's firmware").decode("ascii").split()
    except (OSError, FileError, UnicodeDecodeError) as error:
        raise ConfigError(notice("firmware.not_readable", path=path, why=error)) from error
    for number, line in enumerate(lines, start=1):
        try:
            record = bytes.fromhex(line.removeprefix(":")) if line.startswith(":") else b""
        except ValueError:
            record = b""
        if len(record) < 5 or len(record) != record[0] + 5 or sum(record) & 0xFF:
            raise ConfigError(notice("firmware.line_damaged", path=path, line=number))
        if record[3] == _END:
            return _glove_image(path, bytes(data))
        address = record[1] << 8 | record[2]
        if record[3] != _DATA or address != len(data):
            raise ConfigError(notice("firmware.line_unknown", path=path, line=number))
        data += record[4:-1]
    raise ConfigError(notice("firmware.cut_off", path=path))


def _glove_image(path: Path, data: bytes) -> FirmwareImage:
    if data.count(MAGIC) != 1 or data.index(MAGIC) + len(MAGIC) + 8 > len(data):
        raise ConfigError(notice("firmware.not_glove", path=path))
    if len(data) > FLASH_BYTES:
        raise ConfigError(
            notice("firmware.too_large", path=path, size_bytes=len(data), chip_bytes=FLASH_BYTES)
        )
    return FirmwareImage(data)


def version_text(version: tuple[int, int, int]) -> str:
    """1.1.0"""
    return ".".join(map(str, version))
