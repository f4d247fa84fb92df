"""Settings from tables and TOML: values round-trip, and errors are named."""

from __future__ import annotations

import dataclasses
import tomllib
from dataclasses import dataclass, field

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.notices import raises
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
    ("text", "code", "values"),
    [
        ("colour = 1", "toml.setting", {"key": "colour"}),
        ("[inner]\nshape = 1", "toml.setting", {"key": "inner.shape"}),
        ("on = 1", "toml.type", {"key": "on", "type": "bool"}),
        ("count = true", "toml.type", {"key": "count", "type": "int"}),
        ("inner = 1", "toml.table", {"key": "inner"}),
        ("[inner]\nshare = 'much'", "toml.number", {"key": "inner.share"}),
        ("[inner]\nshare = nan", "toml.finite", {"key": "inner.share"}),
        ("[inner]\npoint = [1, inf]", "toml.finite", {"key": "inner.point"}),
        ("[inner]\nshare = 1" + 400 * "0", "toml.long_number", {"line": 2, "digits": 401}),
        ("count = " + 5000 * "1", "toml.long_number", {"line": 1, "digits": 5000}),
        ("count = " + 5000 * "[", "toml.deep", {"line": 1, "most": 16}),
        ("count =", "config.not_toml", {}),
    ],
)
def test_an_invalid_setting_is_named(text, code, values):
    with raises(ConfigError, code, file="s.toml", **values):
        from_toml(Outer, text, "s.toml")


def test_the_reader_decides_what_is_dropped():
    wrong = {"name": 3, "on": True, "new": 1, "inner": {"share": 1, "point": ["x"], "old": {}}}
    problems = []
    read = from_dict(Outer, wrong, lambda path, why: problems.append((path, why == UNKNOWN)))
    assert read == Outer(on=True, inner=Inner(share=1.0))
    assert problems == [("name", False), ("new", True), ("inner.point", False), ("inner.old", True)]
