"""Parts that packages register as entry points."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from tests.notices import raises
from tracker.base.errors import ConfigError
from tracker.base.registry import Registry


def install(folder: Path, name: str, entries: dict[str, str], kind: str = "fruit") -> None:
    """A package's metadata in ``folder``, as written by pip."""
    about = folder / f"{name}-1.dist-info"
    about.mkdir(parents=True)
    (about / "METADATA").write_text(f"Metadata-Version: 2.1\nName: {name}\nVersion: 1\n")
    lines = "".join(f"{key} = {value}\n" for key, value in entries.items())
    (about / "entry_points.txt").write_text(f"[glovetrack.{kind}]\n{lines}")


@pytest.fixture
def registry(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Registry[str]:
    module = "APPLE = 'Apple'\nSTONE = 3\n"
    (tmp_path / "orchard_of_fruit.py").write_text(module)
    here = "orchard_of_fruit"
    install(tmp_path / "first", "aaa", {"apple": f"{here}:STONE", "zebra": f"{here}:APPLE"})
    install(
        tmp_path / "second",
        "glovetrack",
        {"apple": f"{here}:APPLE", "gone": "removed_folder:X", "stone": f"{here}:STONE"},
    )
    for folder in (tmp_path / "second", tmp_path / "first", tmp_path):
        monkeypatch.syspath_prepend(str(folder))
    yield Registry("fruit", "fruit", str)
    sys.modules.pop(here, None)


def test_our_own_parts_come_first_and_keep_their_names(registry: Registry[str]) -> None:
    assert registry.names() == ["apple", "gone", "stone", "zebra"]
    assert registry.get("apple") == "Apple"


def test_a_part_that_cannot_be_loaded_affects_no_others(
    registry: Registry[str], caplog: pytest.LogCaptureFixture
) -> None:
    assert list(registry.all()) == ["apple", "zebra"]
    assert "gone" in caplog.text and "stone" in caplog.text


@pytest.mark.parametrize(
    ("name", "code", "value"),
    [
        ("pear", "part.unknown", ("known", "apple, gone, stone, zebra")),
        ("gone", "part.not_loaded", ("why", "No module named 'removed_folder'")),
        ("stone", "part.wrong_type", ("entry", "orchard_of_fruit:STONE")),
    ],
)
def test_errors_name_the_part_and_the_cause(
    registry: Registry[str], name: str, code: str, value: tuple[str, str]
) -> None:
    with raises(ConfigError, code) as error:
        registry.get(name)
    assert value in error.value.notice.values.items()
    assert ("name", name) in error.value.notice.values.items()


def test_a_package_installed_while_the_program_runs_is_found(
    registry: Registry[str], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    install(tmp_path / "third", "zzz", {"fig": "orchard_of_fruit:APPLE"})
    monkeypatch.syspath_prepend(str(tmp_path / "third"))
    assert registry.names() == ["apple", "gone", "stone", "fig", "zebra"]
