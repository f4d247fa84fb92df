"""Finds times without messages from a device of a session.

A glove that was disconnected has not lost packets by its counter, which restarts.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from tracker.session.ros import topics

SILENT = 1.0  # s without a message after which a device counts as not responding
IMAGES = ("compressed", "blobs")  # the ends of their topics' names
PAUSED = 2.5  # s without a status (one a second): the recording was paused


def silences(log_times: Mapping[str, Sequence[int]], span_ns: tuple[int, int]) -> dict[str, float]:
    """Returns seconds without messages by device (``/glove/right``, ``/camera``).

    ``log_times``: ns, by topic. A device does not respond while none of its topics has a message,
    also at the session's ends; a device without topics is not part of the session.
    """
    devices: dict[str, list[Sequence[int]]] = {}
    for topic, times in log_times.items():
        device = _device(topic)
        if device:
            devices.setdefault(device, []).append(times)
    pauses = _pauses(log_times.get(topics.STATUS, ()))
    found = {name: _silence(times, span_ns, pauses) for name, times in devices.items()}
    return {name: seconds for name, seconds in found.items() if seconds > 0.0}


def _device(topic: str) -> str:
    """The device of a sensor's topic; empty for other topics."""
    parts = topic.split("/")
    if topic.startswith("/glove/") and "imu" in parts:
        return "/".join(parts[:3])
    return "/camera" if topic.startswith("/camera/") and parts[-1] in IMAGES else ""


def _pauses(status: Sequence[int]) -> np.ndarray:
    """(n, 2) ns from a status to the next, if that is late."""
    t = np.sort(np.asarray(status, np.int64))
    late = np.diff(t) > PAUSED * 1e9
    return np.column_stack((t[:-1][late], t[1:][late])) if len(t) else np.empty((0, 2), np.int64)


def _silence(times: list[Sequence[int]], span_ns: tuple[int, int], pauses: np.ndarray) -> float:
    """Returns the seconds in gaps longer than `SILENT`, without pauses."""
    t = np.unique(np.concatenate([np.asarray(ts, np.int64) for ts in times]))
    edges = np.concatenate(([span_ns[0]], t, [span_ns[1]]))
    late = np.diff(edges) > SILENT * 1e9
    total = 0.0
    for a, b in zip(edges[:-1][late], edges[1:][late], strict=True):
        of_pauses = np.minimum(pauses[:, 1], b) - np.maximum(pauses[:, 0], a)
        rest = float(b - a - of_pauses.clip(0).sum()) / 1e9
        total += rest if rest > SILENT else 0.0
    return total
