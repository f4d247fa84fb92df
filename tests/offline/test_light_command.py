"""``glovetrack light`` on a simulated session in a dim room."""

import argparse
import json

import pytest

from tests.notices import raises, shows
from tracker.base.errors import FileError
from tracker.cli import build_parser
from tracker.offline.simulate import SimulateOptions, simulate


def light(*words: str) -> argparse.Namespace:
    line = ["light", *words]
    return build_parser(line).parse_args(line)


@pytest.mark.long
def test_a_dim_room_is_reported(tmp_path, capsys):
    path = tmp_path / "dim.mcap"
    simulate(path, SimulateOptions(scene="desk", light="dim", seed=2, duration=1.5, fps=5))
    args = light(str(path), "--json", str(tmp_path / "light.json"))
    assert args.command.start(args) == 0
    data = json.loads((tmp_path / "light.json").read_text())
    assert data["images"] == 2
    assert 0 < data["found"] <= data["markers"]
    assert data["noise"] > 2.9
    assert any(shows(words, "light.noisy") for words in data["advice"])
    assert shows(capsys.readouterr().out, "light.noisy")


def test_a_session_without_images_is_reported(tmp_path):
    path = tmp_path / "blobs.mcap"
    simulate(path, SimulateOptions(images=False, duration=1.0, fps=10))
    args = light(str(path))
    with raises(FileError, "light.no_images"):
        args.command.start(args)
