"""Protocols and studies for tests."""

from __future__ import annotations

from pathlib import Path

SHORT = """
[study]
name = "short"
title = "A short study"
seed = 3
participants = 2
countdown = 1.5
rest = 5.0
rest_between_conditions = 10.0

[conditions.free]
title = "Free hand"
tasks = ["postures"]
practice = 1

[conditions.timed]
title = "Timed"
tasks = ["pegs"]

[tasks.postures]
title = "Postures"
instruction = "Copy each posture."
duration = 6.0
practice_duration = 2.0
cue_every = 2.0
cues = ["Fist", "Flat hand", "Point"]

[tasks.pegs]
title = "Pegs"
instruction = "Put the pegs into the holes."
duration = 0.0
longest = 8.0
"""


def write_protocol(folder: Path, text: str = SHORT) -> Path:
    """A protocol file in ``folder``."""
    path = folder / "protocol.toml"
    path.write_text(text, "utf-8")
    return path
