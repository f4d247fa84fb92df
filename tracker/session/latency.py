"""Latencies from a sample or an exposure to what follows from it, from a session."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from tracker.base.clock import NS
from tracker.messages import BlobFrame, Event, ImuSample, Status
from tracker.session.decode_robot import robot_names
from tracker.session.mcap.ordering import ordered
from tracker.session.reader import SessionReader
from tracker.session.ros import topics

PACKET, IMAGE, MOTOR = "packet", "image", "motor"
STAGES = {
    "imu": "pose after a packet",
    "total": "pose after an image",
    "screen": "screen",
    "stream": "stream",
}
"""Counters of `tracker.live.telemetry` that are reported, and the outputs' names for them."""
DESCRIPTIONS = {
    PACKET: "sample to arrival of its packet",
    IMAGE: "exposure to its markers",
    "pose after a packet": "arrival of a packet to its pose",
    "pose after an image": "arrival of an image to its pose",
    MOTOR: "sample to motor command",
    "screen": "sample to the window's screen",
    "stream": "sample to the streams",
}
Figures = dict[str, dict[str, float]]


def latencies_of(path: Path) -> Figures:
    """Returns ``count``, ``median_ms``, ``p99_ms`` and ``most_ms`` of a session by output.

    ``packet``: the computer received a sample; ``image``: the markers of an exposure were in the
    engine; ``motor``: a motor of the glove received a command (events of kind motor); ``robot
    NAME``: a robot's command was sent. All are measured from the instant of the sample or exposure.
    ``pose after a packet`` and ``pose after an image``: the estimate was made, from the arrival;
    computed from the live run's own figures, each of the seconds before it: ``count`` of them, the
    median of their medians, and of their 99th percentiles the median and the largest. ``screen``
    and ``stream``, likewise: the window had painted the estimate of a sample, and the streams had
    sent it, from the instant of the sample. Those of the left of two hands end in ``left``. Raises
    FileError.
    """
    found: Figures = {}
    with SessionReader(path) as reader:
        found |= {what: _figures(1e3 * np.array(s)) for what, s in _late(reader) if s}
        found |= _stages(reader)
        sides, main = reader.sides, reader.info.side
    for side in sides:
        if side != main:
            with SessionReader(path, side=side) as reader:
                found |= {f"{what} {side}": f for what, f in _stages(reader).items()}
    return found


def _late(reader: SessionReader) -> Iterator[tuple[str, list[float]]]:
    """Seconds by output."""
    found: dict[str, list[float]] = defaultdict(list)
    for message in reader.messages((ImuSample, BlobFrame, Event)):
        if isinstance(message, ImuSample):
            found[PACKET].append(message.t_arrival - message.t)
        elif isinstance(message, BlobFrame):
            found[IMAGE].append(message.t_arrival - message.t)
        elif isinstance(message, Event) and message.kind == MOTOR:
            of = message.data.get("of")
            if isinstance(of, int | float):
                found[MOTOR].append(message.t - of)
    for name in robot_names(reader):
        wanted = frozenset({topics.robot(name, "joint_commands")})
        late = [(m.log_time - m.publish_time) / NS for m in ordered(reader.source, wanted)]
        found[f"robot {name}"] = [s for s in late if s > 0]  # 0: driven by a recording
    yield from found.items()


def _stages(reader: SessionReader) -> Figures:
    """What the live run reported of itself."""
    values = [m.values for m in reader.messages((Status,)) if isinstance(m, Status)]
    found = {}
    for stage, what in STAGES.items():
        names = (f"latency_{stage}_ms", f"latency_{stage}_p99_ms")
        reported = np.array([[v[n] for n in names] for v in values if v.keys() >= set(names)])
        if len(reported):
            median, late = np.median(reported, axis=0)
            largest = reported[:, 1].max()
            found[what] = _row(len(reported), median, late, largest)
    return found


def _figures(ms: np.ndarray) -> dict[str, float]:
    return _row(len(ms), np.median(ms), np.percentile(ms, 99), ms.max())


def _row(count: int, median: float, p99: float, most: float) -> dict[str, float]:
    return {
        "count": count,
        "median_ms": float(median),
        "p99_ms": float(p99),
        "most_ms": float(most),
    }


def latency_table(figures: Figures) -> list[str]:
    """Lines of text: median, 99th percentile and largest of each output."""
    if not figures:
        return ["The session contains no samples and no images."]
    names = {what: described(what) for what in figures}
    width = max(map(len, names.values()))
    head = f"{'':{width}}  median     99 %      most   count"
    return [head] + [
        f"{names[what]:{width}}  {f['median_ms']:6.1f}  {f['p99_ms']:7.1f}  {f['most_ms']:8.1f}  "
        f"{f['count']:6}"
        for what, f in figures.items()
    ]


def described(what: str) -> str:
    """What is measured, in words."""
    if what.startswith("robot "):
        return f"sample to command of {what}"
    for name, words in DESCRIPTIONS.items():
        if what.startswith(name):
            return words + what.removeprefix(name).replace(" left", ", left hand")
    return what
