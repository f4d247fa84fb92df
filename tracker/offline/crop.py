"""Copies a part of a session to a new session, which gives the same results as the whole.

A filter that starts in the middle has no information on the wearer and on the position of the hand.
So the whole is tracked up to the part's first message, and the state of the engine then is attached
to the part, as for a recording that begins while the hand is tracked.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from tracker.base.clock import NS
from tracker.base.errors import ConfigError, GlovetrackError
from tracker.base.files import check_target, whole_file
from tracker.base.notices import notice
from tracker.messages import ImuSample
from tracker.offline.track import state_at
from tracker.session import engine_state
from tracker.session.export.mcap import copy_part
from tracker.session.export.options import ExportOptions
from tracker.session.mcap.input import FOREVER
from tracker.session.reader import SessionReader


def crop(
    source: Path,
    out: Path,
    start: float = 0.0,
    stop: float | None = None,
    progress: Callable[[float], None] = lambda share: None,
    force: bool = False,
    with_state: bool = True,
) -> dict[str, Any]:
    """Copies ``start`` to ``stop``, s from the session's first measurement; returns a summary.

    Without ``with_state`` it is quick, but tracking the part again starts without knowledge.

    The new file is complete or absent; ``source`` does not change. ``engine_state`` in the result:
    whether the part can be tracked again bit for bit. Raises ConfigError for an invalid part.
    """
    check_target(out, force, [source])
    with SessionReader(source) as reader:
        begin, end = _span(reader, start, stop)
        state = _state(reader, begin, progress) if start > 0 and with_state else None
        with whole_file(out, force, [source]) as part:
            copy_part(reader, part, (begin if start > 0 else 0, end), ExportOptions(), state)
    progress(1.0)
    with SessionReader(out) as made:
        duration = made.duration
    return {
        "file": str(out),
        "start_s": start,
        "duration_s": duration,
        "engine_state": state is not None or start == 0,
    }


def _span(reader: SessionReader, start: float, stop: float | None) -> tuple[int, int]:
    """Log times in ns."""
    first, last = reader.span_ns
    if not (0 <= start < (reader.duration if stop is None else stop)) or start > reader.duration:
        raise ConfigError(notice("crop.range", duration_s=reader.duration, file=reader.path.name))
    end = FOREVER if stop is None else first + round(stop * NS)
    return first + round(start * NS), end if end <= last else FOREVER


def _state(reader: SessionReader, begin: int, progress: Callable[[float], None]) -> bytes | None:
    """Returns the engine's state at ``begin`` (ns); None for a session that cannot be tracked."""
    if next(iter(reader.messages((ImuSample,))), None) is None:
        return None
    try:
        state = state_at(reader, reader.anchor.monotonic(begin), progress)
    except GlovetrackError:
        return None  # for example for lack of images, which the part lacks too
    return engine_state.pack(state.engine, state.state) if state is not None else None
