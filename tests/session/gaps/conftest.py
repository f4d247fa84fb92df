"""A swinging hand."""

import numpy as np
import pytest

from tests.session.gaps.hands import Swing, made
from tracker.session.description import SessionInfo


@pytest.fixture
def swing(session_info: SessionInfo) -> Swing:
    """There and back within a second."""
    return made(session_info, lambda t: 0.5 * np.sin(2 * np.pi * t))
