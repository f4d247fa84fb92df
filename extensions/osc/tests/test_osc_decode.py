"""OSC messages of another library are read, and invalid ones are refused."""

from __future__ import annotations

import struct

import pytest
from hypothesis import given
from hypothesis import strategies as st
from pythonosc.osc_bundle_builder import IMMEDIATELY, OscBundleBuilder
from pythonosc.osc_message_builder import OscMessageBuilder

from extensions.osc.decode import OscError, message
from extensions.osc.encode import message as encode
from tests.notices import raises


def built(address: str, *values: object):
    builder = OscMessageBuilder(address)
    for value in values:
        builder.add_arg(value)
    return builder.build()


def test_a_foreign_librarys_message_is_read() -> None:
    data = built("/glovetrack/vibrate", "index", 200, 0.5, True, False).dgram
    assert message(data) == ("/glovetrack/vibrate", ["index", 200, 0.5, True, False])


def test_a_bundle_of_one_is_opened_and_one_of_two_refused() -> None:
    bundle = OscBundleBuilder(IMMEDIATELY)
    bundle.add_content(built("/a", "x"))
    assert message(bundle.build().dgram) == ("/a", ["x"])
    bundle.add_content(built("/b", "y"))
    with raises(OscError, "osc.several"):
        message(bundle.build().dgram)


@given(st.text(st.characters(codec="utf-8", exclude_characters="\0")), st.integers(-9, 9))
def test_what_we_write_is_what_we_read(text: str, number: int) -> None:
    assert message(encode("/x", text, number)) == ("/x", [text, number])


@given(st.binary(max_size=200))
def test_arbitrary_bytes_are_harmless(data: bytes) -> None:
    for candidate in (data, b"/a\0\0" + data, b"#bundle\0" + data):
        try:
            address, _ = message(candidate)
        except OscError:
            continue
        assert address.startswith("/")


@pytest.mark.parametrize(
    "data",
    [b"", b"/a", b"a\0\0\0", b"/a\0\0i\0\0\0", b"/a\0\0,i\0\0\0\0", b"/a\0\0,b\0\0\0\0\0\0"],
)
def test_truncated_and_unknown_messages_are_refused(data: bytes) -> None:
    with pytest.raises(OscError):
        message(data)


def test_a_bundle_inside_a_bundle_is_refused() -> None:
    inner = b"#bundle\0" + bytes(8)
    with pytest.raises(OscError):
        message(b"#bundle\0" + bytes(8) + struct.pack(">i", len(inner)) + inner)
