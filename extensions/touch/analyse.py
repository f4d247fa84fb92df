"""The touch test of a recorded session."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

from extensions.touch.lengths import pinch_closure, stillness
from extensions.touch.pose import find_sheet
from extensions.touch.protocol import cues_of, ruler_of
from extensions.touch.rest import find_free_touches, find_touches
from extensions.touch.result import TouchResult, evaluate
from extensions.touch.track import tip_tracks
from tracker.base.errors import ConfigError
from tracker.base.notices import failure
from tracker.messages import Calibration, Estimate, Event, StereoFrame
from tracker.session.images import PackedFrame
from tracker.session.reader import SessionReader

EVERY = 0.5  # s between images that are searched for the sheet
MOST_IMAGES = 120


def analyse(
    path: Path,
    ruler: float | None = None,
    side: str = "",
    watch: Callable[[float], None] = lambda share: None,
) -> TouchResult:
    """The result of one hand. ``ruler`` m replaces what the session has of the printed line.

    Raises ConfigError without the sheet, or without touches; FileError for a file that is not a
    session or has no stereo camera.
    """
    with SessionReader(path, side=side, watch=watch) as reader:
        info, rig = reader.info, reader.rig()
        if info.moving_camera:
            raise ConfigError(failure("touch.moving_camera"))
        estimates: list[Estimate] = []
        events: list[Event] = []
        calibration: Calibration | None = None
        for message in reader.messages((Estimate, Event, Calibration)):
            if isinstance(message, Estimate):
                estimates.append(message)
            elif isinstance(message, Event):
                events.append(message)
            elif isinstance(message, Calibration):
                calibration = message
        length = ruler_of(events) if ruler is None else ruler
        pose = find_sheet(_images(reader), rig, length)
    if not estimates:
        raise ConfigError(failure("touch.no_estimates"))
    tracks = tip_tracks(estimates, info.hand, info.glove, calibration)
    cued = cues_of(events)
    if any(c.cue.what == "touch" for c in cued):
        touches, missed = find_touches(tracks, cued, pose)
    else:
        touches, missed = find_free_touches(tracks, pose), []
    result = evaluate(touches, missed, pose, rig.pose.p_GC)
    pulps = {f.finger: f.pulp for f in result.fingers}
    about = {
        "name": path.stem,
        "participant": info.participant,
        "engine": info.engine,
        "version": info.version,
        "glove": info.glove.name,
        "side": info.side,
        "simulated": "true" if info.simulated else "false",
    }
    return replace(
        result,
        closure=pinch_closure(tracks, cued, pulps),
        still=tuple(stillness(tracks, cued)),
        session=about,
    )


def _images(reader: SessionReader) -> Iterator[StereoFrame]:
    """Some images of the session."""
    period = max(EVERY, reader.duration / MOST_IMAGES)
    due = -float("inf")
    for message in reader.packed_messages((StereoFrame,)):
        if not isinstance(message, PackedFrame) or message.t < due:
            continue
        due = message.t + period
        frame = message.unpack()
        if frame is not None:
            yield frame
