"""An invalid file on the command line is named in the message, with the line."""

from __future__ import annotations

from pathlib import Path

import pytest

from resources import folder
from tracker.cli import main
from tracker.offline.simulate import SimulateOptions, simulate


@pytest.fixture(scope="module")
def session(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("sessions") / "in.mcap"
    simulate(path, SimulateOptions(duration=1.0, fps=10))
    return path


COMMANDS = [
    ("track", ["track", "SESSION", "-o", "OUT"], ("--glove", "--hand", "--colours")),
    ("simulate", ["simulate", "-o", "OUT", "--duration", "1"], ("--glove", "--hand")),
    ("light", ["light", "SESSION"], ("--colours",)),
    ("colours check", ["colours", "check", "SESSION"], ("--colours",)),
    ("colours fit", ["colours", "fit", "SESSION", "-o", "OUT"], ("--colours",)),
    ("print", ["print", "markers", "-o", "OUT"], ("--glove",)),
    ("apps", ["apps", "touch", "--simulate", "1"], ("--glove",)),
    ("conformance", ["conformance", "--simulate"], ("--glove",)),
]
CASES = [(words, option) for _, words, options in COMMANDS for option in options]
SHIPPED = {
    "--glove": ("gloves", "vist-small.toml"),
    "--hand": ("hands", "reference-right.toml"),
    "--colours": ("colours", "fabric-default.toml"),
}


@pytest.mark.parametrize(("words", "option"), CASES)
def test_an_invalid_file_is_named_with_its_line(
    words: list[str],
    option: str,
    session: Path,
    tmp_path: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    kind, name = SHIPPED[option]
    lines = (folder(kind) / name).read_text("utf-8").splitlines()
    k = next(k for k, line in enumerate(lines) if "=" in line and line[0].isalpha() and k > 1)
    lines.insert(k, "nonsense = 1")
    wrong = tmp_path / f"my{name}"
    wrong.write_text("\n".join(lines))
    known = {"SESSION": str(session), "OUT": str(tmp_path / "out.mcap")}
    assert main([*(known.get(w, w) for w in words), option, str(wrong)]) == 1
    output = capsys.readouterr().err
    assert wrong.name in output and session.name not in output
    assert f"line {k + 1}" in output
