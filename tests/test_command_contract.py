"""The commands, options and JSON that other programs rely on.

Each entry is a line of the contract with them; options may be added, none may go.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import tracker.cli
from tracker.session.export.formats import FORMATS

OPTIONS = {
    "track": "-o --engine --hand --glove --colours --smooth --with-sensors --no-guided --wearer",
    "export": "--format -o --joints",
    "simulate": "-o --motion --seed --duration --fps --blobs-only --hands --lenses --scene --light "
    "--guided",
    "evaluate vist": "--json --guided",
    "evaluate inertial": "--json",
    "compare": "--json",
    "doctor": "-o --json",
    "info": "--json",
    "verify": "--json",
    "recover": "--json -o",
    "report": "-o --json",
    "conformance": "--simulated -o --json",
    "teleop": "--hand-model --json",
    "colours fit": "-o",
    "colours check": "--json",
    "remote start": "--json",
    "remote stop": "--json",
    "remote note": "--json",
    "window": "--wearer",
}
CHOICES = {
    ("simulate", "--hands"): "left right both",
    ("simulate", "--lenses"): "1 2 0",
    ("simulate", "--scene"): "plain painted photo desk",
    ("simulate", "--light"): "window lamp led dim",
}
FORMS = (
    "csv parquet h5 c3d trc mot bvh glb urdf mp4 isaac lerobot bids sto osim imu.csv imu.parquet"
)


def parsers() -> Iterator[tuple[str, argparse.ArgumentParser]]:
    yield from _below(tracker.cli.build_parser(), "")


def _below(
    parser: argparse.ArgumentParser, name: str
) -> Iterator[tuple[str, argparse.ArgumentParser]]:
    yield name, parser
    for action in parser._actions:
        if isinstance(action, argparse._SubParsersAction):
            for word, below in action.choices.items():
                yield from _below(below, f"{name} {word}".strip())


PARSERS = dict(parsers())


@pytest.mark.parametrize("command", OPTIONS)
def test_every_command_has_its_options(command: str) -> None:
    assert set(OPTIONS[command].split()) <= PARSERS[command]._option_string_actions.keys()


@pytest.mark.parametrize(("command", "option"), CHOICES)
def test_options_take_the_words_of_the_contract(command: str, option: str) -> None:
    choices = PARSERS[command]._option_string_actions[option].choices
    assert choices is not None
    assert set(CHOICES[command, option].split()) <= set(choices)


def test_there_are_the_window_s_commands_and_all_formats() -> None:
    assert {"window", "demo", "devices"} <= PARSERS.keys()
    assert set(FORMS.split()) <= set(FORMATS.names())


# ---- what they write


def run(*words: object, allowed: tuple[int, ...] = (0,)) -> None:
    argv = [str(word) for word in words]
    assert tracker.cli.main(argv) in allowed, argv


def run_json(folder: Path, *words: object, allowed: tuple[int, ...] = (0,)) -> dict[str, Any]:
    """The command's JSON, in a file as mktemp makes it."""
    out = folder / "result.json"
    out.unlink(missing_ok=True)
    out.touch()
    run(*words, "--json", out, allowed=allowed)
    found: dict[str, Any] = json.loads(out.read_text())
    return found


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """With a recording of each number of lenses, and one that is tracked."""
    path = tmp_path_factory.mktemp("sessions")
    for lenses in "012":
        words = ["--seed", 3, "--duration", 2, "--fps", 10, "--lenses", lenses]
        run("simulate", "-o", path / f"{lenses}.mcap", *words, "--hands", "right")
    run("track", path / "2.mcap", "-o", path / "tracked.mcap")
    return path


def test_track_and_info_and_verify(folder: Path) -> None:
    found = run_json(folder, "track", folder / "2.mcap", "-o", folder / "again.mcap")
    keys = {"duration_s", "wall_s", "estimates", "frames", "losses", "lost_s", "error_mm"}
    assert keys <= found.keys()
    about = run_json(folder, "info", folder / "again.mcap")
    keys = {"duration_s", "topics", "engine", "version", "simulated", "integrity"}
    assert keys <= about.keys()
    assert all({"type", "count", "rate_hz"} <= topic.keys() for topic in about["topics"].values())
    verdict = run_json(folder, "verify", folder / "again.mcap")
    assert verdict["ok"] is True
    assert all({"severity", "what", "where"} <= f.keys() for f in verdict["findings"])


def test_compare(folder: Path) -> None:
    found = run_json(folder, "compare", folder / "tracked.mcap", folder / "tracked.mcap")
    assert found["identical"] is True


def test_recover_reports_the_length_as_info_does(folder: Path) -> None:
    cut = folder / "cut.mcap"
    data = (folder / "2.mcap").read_bytes()
    cut.write_bytes(data[: len(data) * 2 // 3])
    found = run_json(folder, "recover", cut, "-o", folder / "whole.mcap")
    about = run_json(folder, "info", folder / "whole.mcap")
    assert 1.0 < found["duration_s"] == about["duration_s"] < 3.0


def test_report(folder: Path) -> None:
    found = run_json(folder, "report", folder / "tracked.mcap", "-o", folder / "report.html")
    (hand,) = found["hand"].values()
    keys = {"min_deg", "max_deg", "range_deg", "sd_deg", "peak_deg_s", "repetitions"}
    assert hand["angles"] and all(keys <= angle.keys() for angle in hand["angles"].values())
    for angle in hand["angles"].values():
        assert angle["range_deg"] == pytest.approx(angle["max_deg"] - angle["min_deg"])
    assert hand["aperture_mm"] and 0 < hand["measured_percent"] <= 100
    assert 0 <= hand["lost_percent"] < 100


@pytest.mark.long
def test_a_report_of_several_sessions(folder: Path) -> None:
    sessions = [folder / "tracked.mcap"] * 2
    found = run_json(folder, "report", *sessions, "-o", folder / "two.html")
    assert [set(session["hand"]) for session in found["sessions"]] == [{"right"}] * 2


def test_conformance_fills_a_folder(folder: Path) -> None:
    out = folder / "judged"
    words = ["conformance", folder / "tracked.mcap", "-o", out]
    found = run_json(folder, *words, allowed=(0, 1))
    assert isinstance(found["ok"], bool)
    keys = {"group", "name", "hand", "value", "limit", "ok"}
    assert found["checks"] and all(keys == check.keys() for check in found["checks"])
    assert len(found["checks"]) == len(found["findings"])
    assert [path.name for path in out.iterdir()] == ["tracked.html"]
    run(*words, allowed=(1,))  # which exists now


def test_colours_check(folder: Path) -> None:
    found = run_json(folder, "colours", "check", folder / "2.mcap")
    assert isinstance(found["ok"], bool)
    keys = {"found", "expected", "false_per_picture", "clash"}
    assert found["hues"] and all(hue.keys() == keys for hue in found["hues"].values())


def test_usage_is_2_and_failure_is_1(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as ended:
        tracker.cli.main(["track"])
    assert ended.value.code == 2
    capsys.readouterr()
    run("info", folder / "nowhere.mcap", allowed=(1,))
    lines = capsys.readouterr().err.splitlines()
    assert len(lines) == 1 and "nowhere.mcap" in lines[0]
