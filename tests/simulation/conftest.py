"""The shipped hand and glove, for every test of the simulator."""

from pathlib import Path

import pytest

import resources
from tracker.glove.files import load_glove
from tracker.glove.model import GloveModel
from tracker.hand.files import load_hand
from tracker.hand.model import HandModel

RESOURCES = Path(resources.__file__).parent


@pytest.fixture(scope="session")
def hand() -> HandModel:
    return load_hand(RESOURCES / "hands" / "reference-right.toml")


@pytest.fixture(scope="session")
def left_hand() -> HandModel:
    return load_hand(RESOURCES / "hands" / "reference-left.toml")


@pytest.fixture(scope="session")
def glove(hand: HandModel) -> GloveModel:
    return load_glove(RESOURCES / "gloves" / "vist-small.toml", hand)
