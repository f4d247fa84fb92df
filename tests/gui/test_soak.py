"""What `python -m app.tools.soak` would find, in short."""

import pytest

from app.tools import soak
from tracker.offline.simulate import SimulateOptions, simulate


@pytest.mark.long
def test_opening_and_closing_on_a_session_leaves_nothing(qapp, tmp_path, monkeypatch):
    path = tmp_path / "session.mcap"
    simulate(path, SimulateOptions(duration=1.0, fps=10.0, images=False))
    monkeypatch.setattr(soak, "_session", lambda folder: path)
    found = soak.cycle(qapp, 3, tmp_path)
    # Fewer than before where windows of earlier tests went meanwhile.
    assert max(found.threads_left, found.timers_left, found.windows_left) <= 0
    assert len(found.memory_mb) == 1 and found.memory_mb[0] > 50


def test_growth_is_reported_whatever_a_single_sample_shows():
    assert soak._slope([100.0, 101.0, 102.0, 180.0, 104.0]) == pytest.approx(1.0, abs=0.01)
    assert soak._slope([100.0]) == 0.0
