"""Errors of functions name their arguments, not the options of the command line."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import glovetrack


@pytest.mark.parametrize(
    ("options", "text"),
    [
        ({"duration": 0.2}, "duration must be between 1 s and 10 h."),
        ({"right_late": 3.0}, "right_late must be between 0 and 50 ms."),
        ({"light": "lamp"}, "light requires the scene desk, not plain."),
        ({"hands": "three"}, 'hands can be left, right or both, not "three".'),
    ],
)
def test_errors_name_arguments(options: dict[str, Any], text: str, tmp_path: Path) -> None:
    with pytest.raises(glovetrack.ConfigError) as caught:
        glovetrack.simulate(tmp_path / "a.mcap", options=glovetrack.SimulateOptions(**options))
    assert str(caught.value) == text


def test_a_name_that_contains_dashes_is_unchanged(tmp_path: Path) -> None:
    path = tmp_path / "hand--force.mcap"
    path.write_text("x")
    with pytest.raises(glovetrack.FileError) as caught:
        glovetrack.simulate(path)
    assert caught.value.notice.code == "file.exists_force"
    assert str(path) in str(caught.value) and "use force=True" in str(caught.value)
    assert path.read_text() == "x"


@pytest.mark.parametrize(
    ("options", "text"),
    [
        ({"duration": "x"}, "duration must be a number, not 'x'"),
        ({"duration": True}, "duration must be a number, not True"),
        ({"seed": 1.5}, "seed must be an integer, not 1.5"),
        ({"images": 1}, "images must be True or False, not 1"),
        ({"hands": None}, "hands must be a string, not None"),
    ],
)
def test_another_type_is_reported(options: dict[str, Any], text: str, tmp_path: Path) -> None:
    with pytest.raises(TypeError) as caught:
        glovetrack.simulate(tmp_path / "a.mcap", **options)
    assert str(caught.value) == text


def test_types_that_python_programs_use_are_accepted(tmp_path: Path) -> None:
    numbers = {"duration": np.float64(0.5), "seed": np.int64(3), "images": np.bool_(False)}
    with pytest.raises(glovetrack.ConfigError, match="duration"):  # its value, not its type
        glovetrack.simulate(tmp_path / "a.mcap", **numbers)
