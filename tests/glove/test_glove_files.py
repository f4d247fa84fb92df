"""Glove files."""

import numpy as np
import pytest

from tests.fixtures import RESOURCES
from tests.notices import raises
from tracker.base.errors import FileError
from tracker.glove.files import parse_glove
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel

TEXT = (RESOURCES / "gloves" / "vist-small.toml").read_text()


def test_the_papers_glove(glove: GloveModel) -> None:
    assert len(glove.imus) == 7 and len(glove.markers) == 37
    assert set(glove.hues) == {"red", "yellow", "green", "blue"}
    assert {m.shape for m in glove.markers} == {"circle"}
    assert np.allclose(glove.marker_size, 0.012)


def test_markers_are_on_the_surface(hand: HandModel, glove: GloveModel) -> None:
    for m in glove.markers:
        segment = hand.segments[hand.index[m.segment]]
        depth = m.position @ m.normal
        assert segment.radius <= depth <= segment.radius + 0.003


@pytest.mark.parametrize(
    ("old", "new", "code"),
    [
        ("normal = [0.0, 0.0, 1]", "normal = [0.0, 0.0, 1.1]", "toml.norm"),
        ("id = 1\n", "id = 0\n", "glove.file_twice"),
        ("id = 36\n", "id = 40\n", "toml.ids"),
        ('segment = "dorsum"', 'segment = "elbow"', "toml.choice"),
        ('shape = "circle"', 'shape = "star"', "toml.choice"),
        ("position = [0.045", "position = [inf", "toml.finite"),
        ('side = "right"', 'side = "left"', "glove.file_side"),
        ("[keypoints.dorsum]", "[keypoints.wrist]", "glove.file_name_taken"),
    ],
)
def test_an_invalid_file_is_rejected(hand: HandModel, old: str, new: str, code: str) -> None:
    assert old in TEXT
    with raises(FileError, code, file="glove.toml"):
        parse_glove(TEXT.replace(old, new, 1), hand, "glove.toml")


def test_a_glove_may_be_empty(hand: HandModel) -> None:
    glove = parse_glove('schema = 1\nname = "bare"\nside = "right"\nhand = "x"\n', hand)
    assert glove.imus == () and glove.marker_position.shape == (0, 3)
