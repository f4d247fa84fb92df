"""Tracked, recorded and reloaded estimates for end-to-end tests of streams."""

from __future__ import annotations

from pathlib import Path

from tracker.cli import main
from tracker.messages import Estimate
from tracker.session.reader import SessionReader
from tracker.streaming.publisher import Names

__all__ = ["recorded_hand"]


def recorded_hand(folder: Path, seconds: float = 1.5) -> tuple[Names, list[Estimate]]:
    """A simulated session, tracked: its names and its estimates from the first tracked one on."""
    raw, tracked = folder / "raw.mcap", folder / "tracked.mcap"
    assert main(["simulate", "-o", str(raw), "--duration", str(seconds), "--blobs-only"]) == 0
    assert main(["track", str(raw), "-o", str(tracked)]) == 0
    with SessionReader(tracked) as reader:
        info = reader.info
        found = [m for m in reader.messages((Estimate,)) if isinstance(m, Estimate)]
    known = [e for e in found if e.keypoint_state.all()]
    return Names.of(info.hand, info.glove, anchor=info.anchor), known
