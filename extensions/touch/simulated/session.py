"""A session of a simulated touch test: images of the sheet, tracked hands, cues and the ruler."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np

from extensions.touch.protocol import PINCHES, TouchCue, ruler
from extensions.touch.simulated.images import placed_sheet, sheet_frames
from extensions.touch.simulated.trial import SHEET_IMAGES, SimulatedTrial
from extensions.touch.simulated.wearer import (
    APPROACH,
    AWAY,
    HOVER,
    OUT,
    PulpParams,
    Touches,
    Touching,
)
from tracker.base.clock import ClockAnchor
from tracker.glove import library
from tracker.messages import Array, Calibration, Estimate, Event, Message
from tracker.session.description import SessionInfo, describe
from tracker.session.writer import new_session
from tracker.simulation.gestures import OPEN, pinch
from tracker.simulation.posture_requests import MOVE, PostureRequest
from tracker.simulation.postures import posture
from tracker.simulation.scenario import Simulation
from tracker.simulation.smooth import rng_for

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


# ---- the demo's wearer takes the touch test: the postures for one cue, as the dialog asks for it

STAY = 1.0  # s out of view longer than asked for
PINCH_EVERY = 2 * MOVE + 0.05  # s


class Follower:
    """Plans (`app.engines.protocols.Plan`) of a wearer before the room ``touch_sheet``."""

    def __init__(self) -> None:
        self._touches: Touches | None = None
        self._last: tuple[TouchCue, Touching] | None = None

    def away(self, simulation: Simulation, t: float) -> Sequence[PostureRequest]:
        """Take the hand out of view of the sheet."""
        angles = posture(simulation.hand, OPEN)
        return [_held(t, angles, np.eye(3), self._middle(simulation) + OUT)]

    def cue(self, cue: TouchCue, simulation: Simulation, t: float) -> Sequence[PostureRequest]:
        """Carry out ``cue``."""
        if cue.what == "pinch":
            return self._pinches(simulation, t)
        if cue.what == "still":
            angles = posture(simulation.hand, OPEN)
            return [_held(t, angles, np.eye(3), self._middle(simulation) + HOVER)]
        return self._touch(cue, simulation, t)

    def _touch(self, cue: TouchCue, simulation: Simulation, t: float) -> Sequence[PostureRequest]:
        """Lift the finger from the last cross, go over the next one, and down."""
        touches, out = self._of(simulation), []
        if self._last is not None:
            out.append(_over(touches, *self._last, t, HOVER))
            t += MOVE
        on = touches.touch(cue)
        if cue.how == "away":
            out.append(_over(touches, cue, on, t, HOVER + OUT))
            t += MOVE + AWAY + STAY
        out.append(_over(touches, cue, on, t, HOVER))
        lasts = APPROACH["fast" if cue.how == "fast" else "slow"]
        out.append(_over(touches, cue, on, t + MOVE, np.zeros(3))._replace(move=lasts))
        self._last = (cue, on)
        return out

    def _pinches(self, simulation: Simulation, t: float) -> Sequence[PostureRequest]:
        hand, p = simulation.hand, self._middle(simulation) + 2 * HOVER
        closed = pinch(hand, "index", simulation.wearer)
        opened = closed.copy()
        opened[[k for k, n in enumerate(hand.joint_names) if n.startswith("index")]] *= 0.5
        out, self._last = [], None
        for k in range(PINCHES):
            for n, angles in enumerate((closed, opened)):
                at = t + k * PINCH_EVERY + n * PINCH_EVERY / 2
                out.append(_held(at, angles, np.eye(3), p))
        return out

    def _of(self, simulation: Simulation) -> Touches:
        if self._touches is None:
            rng = rng_for(simulation.seed, "live touches")
            sheet = placed_sheet(simulation.seed, rig=simulation.rig)
            self._touches = Touches(simulation.wearer, sheet, rng, PulpParams())
        return self._touches

    def _middle(self, simulation: Simulation) -> Array:
        """(3,) m in G: the dorsum of a hand in the middle of the sheet."""
        return self._of(simulation).sheet.middle - np.array([0.12, 0.0, 0.0])


def _over(touches: Touches, cue: TouchCue, on: Touching, t: float, above: Array) -> PostureRequest:
    """The hand of a touch, ``above`` (3,) m from the cross."""
    at = np.array([t])
    angles, R = on.angles[None], on.R_GB[None]
    p = touches.root(cue.finger, at, angles, R, (on.contact + above)[None])[0]
    return _held(t, on.angles, on.R_GB, p)


def _held(t: float, angles: Array, R_GB: Array, p_GB: Array) -> PostureRequest:
    return PostureRequest(
        float(t), tuple(angles.tolist()), place=(*R_GB.ravel().tolist(), *p_GB.tolist())
    )
