"""Settings from tables and TOML: values round-trip, and errors are named."""

from __future__ import annotations

import dataclasses
import tomllib
from dataclasses import dataclass, field

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tracker.base.config import UNKNOWN, from_dict, from_toml, to_toml
from tracker.base.errors import ConfigError
from tracker.engine.kinds import ENGINES
from tracker.engine.settings import Settings


@dataclass(frozen=True)
class Inner:
    share: float = 0.5
    point: tuple[float, ...] = ()


@dataclass(frozen=True)
class Outer:
    name: str = "usual"
    on: bool = False
    count: int = 3
    inner: Inner = field(default_factory=Inner)


numbers = st.floats(allow_nan=False, allow_infinity=False)


@given(st.text(), st.booleans(), st.integers(-(2**63), 2**63 - 1), numbers, st.lists(numbers))
def test_written_settings_are_read_back_equal(name, on, count, share, point):
    params = Outer(name, on, count, Inner(share, tuple(point)))
    assert from_toml(Outer, to_toml(params)) == params


def test_the_settings_of_a_session_are_read_back_equal():
    settings = dataclasses.replace(Settings(), engine="vist")
    text = to_toml(settings)
    assert from_toml(Settings, text) == settings
    assert tomllib.loads(text)["engine"] == "vist"
    assert Settings().engine in ENGINES.names()


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ("colour = 1", "s.toml: colour is not a setting."),
        ("[inner]\nshape = 1", "s.toml: inner.shape is not a setting."),
        ("on = 1", "s.toml: on must be a bool."),
        ("count = true", "s.toml: count must be a int."),
        ("inner = 1", "s.toml: inner must be a table."),
        ("[inner]\nshare = 'much'", "s.toml: inner.share must be a float."),
        ("[inner]\nshare = nan", "s.toml: inner.share must be a finite number."),
        ("[inner]\npoint = [1, inf]", "s.toml: inner.point must be a finite number."),
        ("[inner]\nshare = 1" + 400 * "0", "s.toml, line 2: share is a number of 401 digits."),
        ("count = " + 5000 * "1", "s.toml, line 1: count is a number of 5000 digits."),
        ("count = " + 5000 * "[", "s.toml, line 1: count is nested more than 16 deep."),
        ("count =", "s.toml is not valid TOML"),
    ],
)
def test_an_invalid_setting_is_named(text, complaint):
    with pytest.raises(ConfigError) as caught:
        from_toml(Outer, text, "s.toml")
    assert str(caught.value).startswith(complaint)


def test_the_reader_decides_what_is_dropped():
    wrong = {"name": 3, "on": True, "new": 1, "inner": {"share": 1, "point": ["x"], "old": {}}}
    problems = []
    read = from_dict(Outer, wrong, lambda path, why: problems.append((path, why == UNKNOWN)))
    assert read == Outer(on=True, inner=Inner(share=1.0))
    assert problems == [("name", False), ("new", True), ("inner.point", False), ("inner.old", True)]
