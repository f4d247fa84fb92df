"""Contacts reported by other programs: their begin and end, and the motor commands for them."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.notices import raises
from tracker.hand.names import CHAINS
from tracker.messages import Event
from tracker.streaming.remote.contacts import LASTS, MOST_CONTACTS, ContactBook, motor_of
from tracker.streaming.remote.request import Request, RequestError, parse


def touch(t: float, strength: float = 1.0, thing: str = "cup", finger: str = "index") -> Request:
    return Request("contact", t, finger=finger, strength=strength, object=thing)


def phases(events: list[Event]) -> list[tuple[float, object, object]]:
    return [(e.t, e.data["finger"], e.data["phase"]) for e in events]


def test_json_and_plain_text_describe_the_same_contact() -> None:
    line = b'{"do": "contact", "finger": "index", "strength": 0.5, "object": "cup"}'
    want = Request("contact", 1.0, finger="index", strength=0.5, object="cup")
    assert parse(line, 1.0) == want
    assert parse("contact thumb", 1.0) == Request("contact", 1.0, finger="thumb")


@pytest.mark.parametrize(
    ("line", "code"),
    [
        ('{"do": "contact"}', "request.finger_missing"),
        ('{"do": "contact", "finger": "index", "strength": 2}', "request.strength"),
        ('{"do": "contact", "finger": "index", "strength": NaN}', "request.strength"),
        ('{"do": "contact", "finger": "index", "strength": true}', "request.strength"),
        ('{"do": "contact", "finger": "index", "object": 3}', "request.text"),
        ('{"do": "contact", "finger": "index", "object": "' + "x" * 65 + '"}', "request.object"),
    ],
)
def test_an_invalid_contact_is_rejected(line: str, code: str) -> None:
    with raises(RequestError, code):
        parse(line, 0.0)


def test_a_repeated_contact_begins_once_and_ends_on_release() -> None:
    book = ContactBook()
    touches = [e for k in range(50) for e in book.tell(touch(0.02 * k, 0.3 + 0.01 * k))]
    assert phases(touches) == [(0.0, "index", "begin")]
    assert book.strength("index") == pytest.approx(0.79)
    assert phases(book.tell(touch(1.5, 0.0))) == [(1.5, "index", "end")]
    assert book.strength("index") == 0.0
    assert book.tell(touch(1.6, 0.0)) == []


def test_a_disconnected_client_leaves_no_contact() -> None:
    book = ContactBook()
    book.tell(touch(0.0))
    assert book.expired(LASTS) == []
    assert phases(book.expired(LASTS + 0.3)) == [(LASTS, "index", "end")]
    assert motor_of(1.0)[1] <= 1e3 * LASTS  # nor a running motor


def test_a_finger_on_two_objects_feels_the_stronger_until_it_leaves_both() -> None:
    book = ContactBook()
    book.tell(touch(0.0, 0.2, "cup"))
    book.tell(touch(0.0, 0.9, "spoon"))
    assert book.strength("index") == 0.9
    book.tell(touch(0.1, 0.0, "spoon"))
    assert book.strength("index") == 0.2
    assert book.strength("thumb") == 0.0


def test_a_motor_stops_at_once_and_unsupported_commands_are_not_sent() -> None:
    assert motor_of(0.0) == (0, 1)
    amplitudes = [motor_of(k / 100)[0] for k in range(1, 101)]
    assert amplitudes == sorted(amplitudes)
    assert amplitudes[0] > 0 and amplitudes[-1] == 255


@given(
    st.lists(
        st.tuples(
            st.sampled_from(tuple(CHAINS)), st.text(max_size=3), st.floats(0, 1), st.floats(0, 1)
        ),
        max_size=200,
    )
)
def test_every_begin_of_a_contact_has_exactly_one_end(touches: list) -> None:
    book, t, open_now = ContactBook(), 0.0, set()
    for finger, thing, strength, later in touches:
        t += later
        for event in book.tell(touch(t, strength, thing, finger)):
            key = event.data["finger"], event.data["object"]
            assert (key in open_now) == (event.data["phase"] == "end")
            open_now ^= {key}
    assert len(open_now) <= MOST_CONTACTS
    ended = {(e.data["finger"], e.data["object"]) for e in book.expired(t + LASTS + 1)}
    assert ended == open_now
