"""Writes MCAP files without compression, with one topic per hand."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import BinaryIO

from mcap.writer import CompressionType, Writer

from extensions.conformance.isaac.record import HandRecord, Stamps, encode
from extensions.conformance.isaac.schema import NAME, SE3, binary_schema
from extensions.conformance.isaac.tips import CHANNELS, collection, tip_records
from tracker import __version__
from tracker.hand.names import SIDES
from tracker.hand.openxr import OpenXrHand

ENCODING = "flatbuffer"


def topic(side: str) -> str:
    return f"hands/{side}_hand"


class IsaacWriter:
    """Writes records of both hands to an open file, which the caller closes.

    Both topics exist even with only one hand. Records of a hand must be in the order of their
    available times.
    """

    def __init__(self, file: BinaryIO) -> None:
        self._writer = Writer(file, compression=CompressionType.NONE)
        self._writer.start("", f"glovetrack {__version__}")
        schema = self._writer.register_schema(NAME, ENCODING, binary_schema())
        self._channels = {
            side: self._writer.register_channel(topic(side), ENCODING, schema) for side in SIDES
        }
        self._tips: dict[tuple[str, str], list[int]] = {}
        self._se3 = 0
        self._sequence = 0

    def write(self, side: str, record: HandRecord) -> None:
        """Add one record at its available time."""
        stamp = record.stamps.available
        self._writer.add_message(self._channels[side], stamp, encode(record), stamp, self._sequence)
        self._sequence += 1

    def write_tips(self, side: str, stamps: Stamps, hand: OpenXrHand) -> None:
        """Add the poses of wrist and fingertips as SE(3) trackers, at their available time."""
        for name, data in tip_records(hand, stamps).items():
            for channel in self._tip_channels(side, name):
                self._writer.add_message(
                    channel, stamps.available, data, stamps.available, self._sequence
                )
        self._sequence += 1

    def _tip_channels(self, side: str, name: str) -> list[int]:
        if (side, name) not in self._tips:
            if not self._tips:
                self._se3 = self._writer.register_schema(SE3, ENCODING, binary_schema(SE3))
            topics = [f"{collection(side, name)}/{channel}" for channel in CHANNELS]
            register = self._writer.register_channel
            self._tips[side, name] = [register(t, ENCODING, self._se3) for t in topics]
        return self._tips[side, name]

    def finish(self) -> None:
        """Write the index, without which most readers treat the file as truncated."""
        self._writer.finish()


def write_records(path: Path, hands: Mapping[str, Sequence[HandRecord]]) -> None:
    """Write a file with the records of each side in the order of their available times."""
    items = [(r.stamps.available, side, r) for side, records in hands.items() for r in records]
    with path.open("wb") as file:
        writer = IsaacWriter(file)
        for _, side, record in sorted(items, key=lambda item: item[:2]):
            writer.write(side, record)
        writer.finish()
