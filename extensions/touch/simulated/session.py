"""A session of a simulated touch test: images of the sheet, tracked hands, cues and the ruler."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path

from extensions.touch.protocol import ruler
from extensions.touch.simulated.images import sheet_frames
from extensions.touch.simulated.trial import SHEET_IMAGES, SimulatedTrial
from tracker.base.clock import ClockAnchor
from tracker.glove import library
from tracker.messages import Calibration, Estimate, Event, Message
from tracker.session.description import SessionInfo, describe
from tracker.session.writer import new_session

EPOCH_NS = 1_735_689_600 * 10**9  # 2025-01-01, as other simulated sessions


def session_info(trial: SimulatedTrial) -> SessionInfo:
    """What the session is about; the rig is the calibration that the tracker has."""
    return describe(
        *library.texts(library.DEFAULT_GLOVE),
        ClockAnchor(EPOCH_NS, 0),
        rig=trial.rig,
        simulated=True,
        notes=f"touch test, seed {trial.seed}",
    )


def write_session(
    out: Path,
    trial: SimulatedTrial,
    estimates: Iterable[Estimate],
    calibration: Calibration | None = None,
    more: Iterable[Event] = (),
    force: bool = False,
) -> None:
    """Write what the window would have recorded; ``more`` are further events."""
    events = [ruler(trial.ruler, 0.01), *trial.motion.events, *more]
    frames = sheet_frames(trial.sheet, trial.true_rig, SHEET_IMAGES, trial.seed, start=0.0)
    tail = [] if calibration is None else [calibration]
    messages: list[tuple[float, Message]] = [
        *((f.t, f) for f in frames),
        *((e.t, e) for e in events),
        *((e.t, e) for e in estimates),
        *((trial.motion.duration, c) for c in tail),
    ]
    with new_session(out, session_info(trial), force) as recorder:
        for _, message in sorted(messages, key=lambda pair: pair[0]):
            recorder.write(message)
