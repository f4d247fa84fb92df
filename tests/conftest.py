"""Fixtures that many rooms share."""

import os
from pathlib import Path

import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from crash_traces import register as register_crash_traces

import tracker  # noqa: F401  (pins BLAS before numpy is imported)
from tracker.glove.files import load_glove
from tracker.glove.model import GloveModel
from tracker.hand.files import load_hand
from tracker.hand.model import HandModel

ROOT = Path(__file__).resolve().parents[1]
RESOURCES = ROOT / "resources"


def pytest_configure(config: pytest.Config) -> None:
    register_crash_traces(config)


@pytest.fixture(scope="session")
def data_folder() -> Path:
    """Real recordings and pictures; the test is skipped where they are absent."""
    folder = Path(os.environ.get("GLOVETRACK_DATA", ROOT.parent / "shared" / "data"))
    if not folder.is_dir():
        pytest.skip(f"no recordings at {folder} (set GLOVETRACK_DATA)")
    return folder


@pytest.fixture(scope="session")
def hand() -> HandModel:
    return load_hand(RESOURCES / "hands" / "reference-right.toml")


@pytest.fixture(scope="session")
def glove(hand: HandModel) -> GloveModel:
    return load_glove(RESOURCES / "gloves" / "vist-small.toml", hand)


@pytest.fixture(scope="session")
def distal_glove(hand: HandModel) -> GloveModel:
    return load_glove(RESOURCES / "gloves" / "vist-small-distal.toml", hand)
