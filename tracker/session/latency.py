"""Computes latencies from a glove's sample to the resulting outputs, from a session."""

from __future__ import annotations

from collections import defaultdict
from pathlib import Path

import numpy as np

from tracker.base.clock import NS
from tracker.messages import Event, ImuSample
from tracker.session.decode_robot import robot_names
from tracker.session.mcap.ordering import ordered
from tracker.session.reader import SessionReader
from tracker.session.ros import topics

PACKET, MOTOR = "packet", "motor"
Figures = dict[str, dict[str, float]]


def latencies_of(path: Path) -> Figures:
    """Returns ``count``, ``median_ms``, ``p99_ms`` and ``most_ms`` of a session by output.

    ``packet``: the host received a sample; ``motor``: a motor of the glove received a command
    (events of kind motor); ``robot NAME``: a robot's command was sent. All are measured from the
    instant of the sample. Raises FileError.
    """
    found: dict[str, list[float]] = defaultdict(list)
    with SessionReader(path) as reader:
        for message in reader.messages((ImuSample, Event)):
            if isinstance(message, ImuSample):
                found[PACKET].append(message.t_arrival - message.t)
            elif isinstance(message, Event) and message.kind == MOTOR:
                of = message.data.get("of")
                if isinstance(of, int | float):
                    found[MOTOR].append(message.t - of)
        for name in robot_names(reader):
            wanted = frozenset({topics.robot(name, "joint_commands")})
            late = [(m.log_time - m.publish_time) / NS for m in ordered(reader.source, wanted)]
            found[f"robot {name}"] = [s for s in late if s > 0]  # 0: driven by a recording
    return {what: _figures(1e3 * np.array(s)) for what, s in found.items() if s}


def _figures(ms: np.ndarray) -> dict[str, float]:
    return {
        "count": len(ms),
        "median_ms": float(np.median(ms)),
        "p99_ms": float(np.percentile(ms, 99)),
        "most_ms": float(ms.max()),
    }


def latency_lines(figures: Figures) -> list[str]:
    """Formats latencies as text."""
    lines = [
        f"  {what}: {f['median_ms']:.1f} ms after the sample (99 %: {f['p99_ms']:.1f}, "
        f"most {f['most_ms']:.1f}; {f['count']} times)"
        for what, f in figures.items()
    ]
    return lines or ["  no latency: the session contains no samples"]
