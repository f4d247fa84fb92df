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

QUICK = (
    SHORT.replace("countdown = 1.5", "countdown = 0.5")
    .replace(
        "\nduration = 6.0\npractice_duration = 2.0", "\nduration = 5.0\npractice_duration = 1.0"
    )
    .replace("cue_every = 2.0", "cue_every = 1.7")
    .replace("longest = 8.0", "longest = 5.0")
)
"""The same with times as short as the evaluation allows, for studies whose trials are simulated."""


def write_protocol(folder: Path, text: str = SHORT) -> Path:
    """A protocol file in ``folder``."""
    path = folder / "protocol.toml"
    path.write_text(text, "utf-8")
    return path
