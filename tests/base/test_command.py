"""The registry of commands, and arguments from the fields of a dataclass."""

from __future__ import annotations

import argparse
import subprocess
import sys
from dataclasses import dataclass, field
from importlib.metadata import EntryPoint
from pathlib import Path
from typing import Literal

import pytest

from tests.notices import raises, shows
from tracker.base import registry
from tracker.base.arguments import INCLUDED, add_options, argument, options_of
from tracker.base.command import COMMANDS, Command, UsageError
from tracker.base.errors import ConfigError
from tracker.cli import main

ROOT = Path(__file__).parents[2]


@dataclass(frozen=True)
class Options:
    source: Path = field(metadata=argument("session", metavar="IN"))
    out: Path = field(metadata=argument("result", "-o", "--out"))
    sessions: tuple[Path, ...] = field(default=(), metadata=argument("more sessions"))
    per_second: float | None = field(default=None, metadata=argument("rate, Hz"))
    seed: int = field(default=3, metadata=argument("random seed"))
    side: Literal["left", "right"] = field(default="right", metadata=argument("hand"))
    guided: bool = field(default=True, metadata=argument("ignore guided poses"))
    smooth: bool = field(default=False, metadata=argument("smooth"))
    api_only: str = "not an argument"


def parsed(*words: str) -> Options:
    parser = argparse.ArgumentParser()
    add_options(parser, Options)
    return options_of(Options, parser.parse_args(words))


def test_fields_are_arguments_with_their_defaults() -> None:
    assert parsed("a.mcap", "-o", "b.mcap") == Options(Path("a.mcap"), Path("b.mcap"))


def test_fields_are_read_by_their_types() -> None:
    words = [
        "a.mcap",
        "--out",
        "b",
        "--sessions",
        "c",
        "d",
        "--per-second",
        "12.5",
        "--seed",
        "7",
        "--side",
        "left",
    ]
    found = parsed(*words, "--no-guided", "--smooth")
    sessions = (Path("c"), Path("d"))
    assert found == Options(
        Path("a.mcap"), Path("b"), sessions, 12.5, 7, "left", guided=False, smooth=True
    )


@pytest.mark.parametrize(
    "words", ["a.mcap", "-o b", "a -o b --side up", "a -o b --seed x", "a -o b --api-only x"]
)
def test_wrong_values_are_wrong_usage(words: str) -> None:
    with pytest.raises(SystemExit) as ended:
        parsed(*words.split())
    assert ended.value.code == 2


@dataclass(frozen=True)
class Whole:
    name: str = field(metadata=argument("its name"))
    options: Options = field(metadata=INCLUDED)
    colours: tuple[str, ...] = field(default=(), metadata=argument("one more", action="append"))
    unit: str = field(default="m", metadata=argument("of length", choices=lambda: ["m", "mm"]))
    jobs: int = field(default=1, metadata=argument("processes", group="many sessions"))


def test_options_of_another_dataclass_are_included_at_their_position() -> None:
    parser = argparse.ArgumentParser()
    add_options(parser, Whole)
    words = "left a.mcap -o b --seed 7 --colours red --colours blue --unit mm --jobs 2"
    found = options_of(Whole, parser.parse_args(words.split()))
    assert found.options == Options(Path("a.mcap"), Path("b"), seed=7)
    assert (found.colours, found.unit, found.jobs) == (("red", "blue"), "mm", 2)
    text = parser.format_help()
    order = ["name", "IN", "--out", "--smooth", "--colours", "many sessions:", "--jobs"]
    places = [text.index(f"  {word}" if word[0] != "m" else word) for word in order[:2]]
    places += [text.rindex(word) for word in order[2:]]
    assert places == sorted(places)


def test_every_command_has_a_dataclass_of_options() -> None:
    """Except the one whose sub-commands are words of a request."""
    others = [n for n in COMMANDS.names() if (c := COMMANDS.get(n)).run and c.add is not None]
    assert others == ["remote"]


# ---- the registry


def _work(options: Options) -> int:
    if options.seed == 0:
        raise UsageError("--seed 0 is reserved.")
    print(options.seed, options.source)
    return 4


def _missing(args: argparse.Namespace) -> None:
    raise ImportError("No module named 'mujoco'")


WORK = Command("evaluate mine", "do my work", _work, Options)
LACKS = Command("lacks", "need a package", _missing, extra="robot")


@pytest.fixture
def others(monkeypatch: pytest.MonkeyPatch) -> None:
    """Commands of another package, and one whose module was removed."""
    real = registry._entries
    more = {"evaluate.mine": f"{__name__}:WORK", "lacks": f"{__name__}:LACKS", "gone": "gone.x:Y"}
    entries = {name: EntryPoint(name, value, COMMANDS.group) for name, value in more.items()}

    def found(group: str, path: tuple[str, ...]) -> dict[str, EntryPoint]:
        return real(group, path) | (entries if group == COMMANDS.group else {})

    monkeypatch.setattr(registry, "_entries", found)


def test_another_package_adds_a_command_to_a_group(
    others: None, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["evaluate", "mine", "a.mcap", "-o", "b", "--seed", "5"]) == 4
    assert capsys.readouterr().out.split() == ["5", "a.mcap"]
    with pytest.raises(SystemExit):
        main(["evaluate", "--help"])
    text = capsys.readouterr().out
    assert "do my work" in text and "vist" in text


def test_a_usage_error_of_a_command_has_exit_status_2(
    others: None, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as ended:
        main(["evaluate", "mine", "a.mcap", "-o", "b", "--seed", "0"])
    assert ended.value.code == 2
    assert capsys.readouterr().err.splitlines()[-1].endswith("error: --seed 0 is reserved.")


def test_a_missing_package_is_named_with_its_extra(
    others: None, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["lacks"]) == 1
    assert shows(capsys.readouterr().err, "command.packages", extra="robot")


def test_a_command_whose_module_was_removed_is_absent(
    others: None, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["gone"]) == 1
    (line,) = capsys.readouterr().err.splitlines()
    assert shows(line, "part.not_loaded", name="gone")
    with pytest.raises(SystemExit) as ended:
        main(["--help"])
    assert ended.value.code == 0
    assert "gone" not in capsys.readouterr().out


def test_every_command_has_the_name_of_its_entry_point() -> None:
    for name in COMMANDS.names():
        assert COMMANDS.get(name).name == name.replace(".", " ")


def test_an_incomplete_installation_is_reported(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(registry, "_entries", lambda group, path: {})
    assert main(["info", "a.mcap"]) == 1
    assert shows(capsys.readouterr().err, "command.none")


def test_a_command_imports_no_other_command_s_modules() -> None:
    code = "import atexit, sys; atexit.register(lambda: print(*sys.modules)); "
    code += "from tracker.cli import main; main(sys.argv[1:])"
    result = subprocess.run(
        [sys.executable, "-c", code, "vehicles", "--help"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=True,
    )
    loaded = set(result.stdout.splitlines()[-1].split())
    assert "extensions.applications.command" in loaded
    others = {"tracker.offline.commands", "extensions.evaluation.commands", "numpy", "PySide6"}
    assert not others & loaded


def test_an_unknown_command_is_wrong_usage(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as ended:
        main(["trak"])
    assert ended.value.code == 2
    assert "invalid choice: 'trak'" in capsys.readouterr().err


def test_an_unknown_name_is_reported_with_those_that_exist() -> None:
    with raises(ConfigError, "part.unknown"):
        COMMANDS.get("nothing")
