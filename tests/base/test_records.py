"""Permitted changes in a class that keep recordings readable."""

from dataclasses import dataclass, field
from typing import NamedTuple

import pytest

from tracker.base.records import RECORDS, record, record_of


@pytest.fixture(autouse=True)
def only_here(monkeypatch: pytest.MonkeyPatch) -> None:
    """Names in these tests are registered only there."""
    monkeypatch.setattr("tracker.base.records.RECORDS", dict(RECORDS))


def test_an_attribute_is_stored_by_its_first_name() -> None:
    @record("test.hand", fingers="digits")
    @dataclass
    class Hand:
        fingers: int

    known = record_of(Hand)
    assert known is not None and known.values(Hand(5)) == {"digits": 5}
    assert known.make({"digits": 4}) == Hand(4)


def test_a_new_field_has_its_default_in_old_recordings() -> None:
    @record("test.glove")
    @dataclass
    class Glove:
        imus: int
        seen: list[int] = field(default_factory=list)
        rate: float = 100.0

    known = record_of(Glove)
    assert known is not None and known.make({"imus": 7}) == Glove(7)
    with pytest.raises(ValueError, match="imus"):
        known.make({"rate": 50.0})


def test_only_removed_fields_are_ignored() -> None:
    @record("test.point", gone=("w",))
    class Point(NamedTuple):
        u: float
        v: float = 1.0

    known = record_of(Point)
    assert known is not None and known.make({"u": 2.0, "w": 9.0}) == Point(2.0, 1.0)
    with pytest.raises(ValueError, match=r"\bx$"):
        known.make({"u": 2.0, "x": 1.0})


def test_names_are_unique_and_must_exist() -> None:
    @dataclass
    class Other:
        t: float

    with pytest.raises(TypeError, match="camera_pose"):
        record("camera_pose")(Other)
    with pytest.raises(TypeError, match="other"):
        record("test.other", time="t")(Other)
