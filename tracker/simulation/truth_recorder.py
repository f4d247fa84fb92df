"""Records the ground truth of a simulated hand for each estimate of a recording."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np

from tracker.geometry import so3
from tracker.messages import Estimate, Event, Message, Validity
from tracker.session.writer import SessionRecorder
from tracker.simulation.demo import DemoSpec, ask, build_scene, hands_of
from tracker.simulation.posture_requests import PostureRequest, request_in
from tracker.simulation.scenario import Simulation, Truth
from tracker.simulation.two_hands import TwoHandsSimulation

AT_ONCE = 25
"""Batch size: evaluating the truth for many times costs no more than for one."""

built = lru_cache(1)(build_scene)


@dataclass(frozen=True)
class WithTruth:
    """Adds the truth of a `DemoSpec` that began at ``t_0`` (s) to its recording.

    It is sent to the writing process, in which `Prepare` may construct the simulation in advance.
    ``asked`` are the postures requested until then.
    """

    spec: DemoSpec
    t_0: float
    asked: tuple[PostureRequest, ...] = ()

    def __call__(self, recorder: SessionRecorder) -> TruthfulRecorder:
        scene = built(self.spec)
        for asked in self.asked:
            ask(scene, asked)
        return TruthfulRecorder(recorder, scene, self.t_0, self.spec.duration)


@dataclass(frozen=True)
class Prepare:
    """Constructs the simulation in advance for `WithTruth`."""

    spec: DemoSpec

    def __call__(self) -> None:
        built(self.spec)


class TruthfulRecorder:
    """Writes to ``inner``, and adds the true hand to each estimate."""

    def __init__(
        self,
        inner: SessionRecorder,
        scene: Simulation | TwoHandsSimulation,
        t_0: float,
        duration: float,
    ) -> None:
        self._inner, self._scene, last = inner, scene, duration - 0.1
        hands = hands_of(scene)
        self._truths = {side: HandsTruth(sim, t_0, last) for side, sim in hands.items()}
        self._main = inner.info.side

    def write(self, message: Message, overloaded: bool = False, side: str = "") -> bool:
        taken = self._inner.write(message, overloaded, side)
        if isinstance(message, Event) and (asked := request_in(message)) is not None:
            ask(self._scene, asked)
        if isinstance(message, Estimate):
            for truth in self._truths[side or self._main].beside(message):
                self._inner.write_truth(truth, side)
        return taken

    def close(self) -> None:
        for side, truths in self._truths.items():
            for truth in truths.rest():
                self._inner.write_truth(truth, side)
        self._inner.close()


class HandsTruth:
    """The truth of one simulated hand at the times of its estimates; its motion lasts ``last``
    s."""

    def __init__(self, simulation: Simulation, t_0: float, last: float) -> None:
        self._simulation, self._t_0, self._last = simulation, t_0, last
        self._waiting: list[Estimate] = []
        self._segments = simulation.glove.keypoint_segments(simulation.hand)

    def beside(self, estimate: Estimate) -> list[Estimate]:
        """The truth of this estimate and the preceding ones, in batches of `AT_ONCE`."""
        self._waiting.append(estimate)
        return self.rest() if len(self._waiting) >= AT_ONCE else []

    def rest(self) -> list[Estimate]:
        """The truth of the remaining estimates."""
        if not self._waiting:
            return []
        waiting, self._waiting = self._waiting, []
        t = np.array([e.t for e in waiting]) - self._t_0
        truths = self._simulation.truths(np.clip(t, 0.0, self._last))
        return [self._with_truth(e, true) for e, true in zip(waiting, truths, strict=True)]

    def _with_truth(self, estimate: Estimate, true: Truth) -> Estimate:
        """An estimate of the same structure with the true values."""
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
