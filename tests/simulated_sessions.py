"""Simulated sessions that tests of several modules read: each is made once for a whole test run."""

from __future__ import annotations

from dataclasses import asdict
from hashlib import sha256
from pathlib import Path

from tests.made_once import made_once
from tracker.offline.options import TrackOptions
from tracker.offline.simulate import SimulateOptions, simulate
from tracker.offline.track import track

SHORT = SimulateOptions(seed=3, duration=3.0, fps=30, images=False)
"""One hand, as most tests need it."""
BOTH = SimulateOptions(hands="both", seed=3, duration=2.0, fps=30.0, images=False)


class SimulatedSessions:
    """Sessions in ``folder``, which all of a test run's processes share; a test that changes one
    copies it."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder

    def simulated(self, options: SimulateOptions = SHORT) -> Path:
        """As `simulate` writes it: sensors and the truth."""
        made = made_once(
            self._folder / _name("simulated", options),
            lambda folder: simulate(folder / "simulated.mcap", options),
        )
        return made / "simulated.mcap"

    def tracked(self, options: SimulateOptions = SHORT, by: TrackOptions | None = None) -> Path:
        """That, tracked by ``by``; `chain`'s estimates with the sensors if it is None."""
        by = by or TrackOptions("chain", with_sensors=True)
        source = self.simulated(options)
        made = made_once(
            self._folder / _name("tracked", options, by),
            lambda folder: track(source, folder / "tracked.mcap", by),
        )
        return made / "tracked.mcap"


def _name(kind: str, *options: SimulateOptions | TrackOptions) -> str:
    text = repr([asdict(each) for each in options])
    return f"{kind}-{sha256(text.encode()).hexdigest()[:16]}"
