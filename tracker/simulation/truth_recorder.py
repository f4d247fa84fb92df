"""What a simulated hand truly did, written beside each estimate of a recording."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from tracker.geometry import so3
from tracker.messages import Estimate, Event, Message, Validity
from tracker.session.writer import SessionRecorder
from tracker.simulation.asked import Asked, asked_in
from tracker.simulation.demo import DemoSpec, ask, build
from tracker.simulation.scenario import Simulation, Truth

AT_ONCE = 25
"""Truth for many instants costs no more than for one."""

built = lru_cache(1)(build)


@dataclass(frozen=True)
class WithTruth:
    """Puts the truth of a `DemoSpec` that began at ``t_0`` (s) into a recording of it.

    It travels to the process that writes, where `prepare` may build the simulation beforehand.
    ``asked`` is what the wearer was asked for until then.
    """

    spec: DemoSpec
    t_0: float
    asked: tuple[Asked, ...] = ()

    def __call__(self, recorder: SessionRecorder) -> TruthfulRecorder:
        simulation = built(self.spec)
        for asked in self.asked:
            ask(simulation, asked)
        return TruthfulRecorder(recorder, simulation, self.t_0, self.spec.duration)


@dataclass(frozen=True)
class Prepare:
    """Builds the simulation, for `WithTruth` to find."""

    spec: DemoSpec

    def __call__(self) -> None:
        built(self.spec)


class TruthfulRecorder:
    """Writes into ``inner``, and beside each estimate what the hand truly did."""

    def __init__(
        self, inner: SessionRecorder, simulation: Simulation, t_0: float, duration: float
    ) -> None:
        self._inner, self._simulation, self._t_0 = inner, simulation, t_0
        self._last = duration - 0.1
        self._waiting: list[Estimate] = []
        self._segments = simulation.glove.keypoint_segments(simulation.hand)

    def write(self, message: Message, overloaded: bool = False) -> bool:
        taken = self._inner.write(message, overloaded)
        if isinstance(message, Event) and (asked := asked_in(message)) is not None:
            ask(self._simulation, asked)
        if isinstance(message, Estimate):
            self._waiting.append(message)
            if len(self._waiting) >= AT_ONCE:
                self._write_truths()
        return taken

    def _write_truths(self) -> None:
        t = np.array([e.t for e in self._waiting]) - self._t_0
        truths = self._simulation.truths(np.clip(t, 0.0, self._last))
        for estimate, true in zip(self._waiting, truths, strict=True):
            self._inner.write_truth(self._with_truth(estimate, true))
        self._waiting.clear()

    def _with_truth(self, estimate: Estimate, true: Truth) -> Estimate:
        """The estimate's shape with the true values."""
        return replace(
            estimate,
            keypoints=true.keypoints.copy(),
            angles=true.angles.copy(),
            segment_R=true.R_GB.copy(),
            segment_p=true.p_GB.copy(),
            keypoint_q=so3.quat_from_matrix(true.R_GB)[self._segments],
            keypoint_state=np.full(len(true.keypoints), Validity.MEASURED, np.int64),
            angle_state=np.full(len(true.angles), Validity.MEASURED, np.int64),
        )

    def close(self) -> None:
        if self._waiting:
            self._write_truths()
        self._inner.close()
