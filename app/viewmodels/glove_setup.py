"""Steps of the glove set-up: instructions for the wearer, and tables of the results.

Time is that of the samples, so a run is a function of its samples.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import Enum

import numpy as np

from app.viewmodels.names import display_name
from app.viewmodels.states import BAD, GOOD, IDLE, WARN, StateLook
from app.words import local, notice_text, tr
from tracker.base.notices import Notice
from tracker.calibration.still import StillParams, StillPose, still_pose
from tracker.calibration.wiggle import WiggleResult, WiggleTest, imu_motion, moving
from tracker.messages import Array, ImuSample

READY = 1.5  # s to read the instruction
STEP_TIMEOUT = 10.0  # s without motion after which the step is repeated
GLANCE = 0.5  # s over which current motion is evaluated
FULL_DPS = 200.0
"""Angular rate at the full length of a bar."""


class SetUpPhase(Enum):
    """State of a run."""

    READY = "ready"
    WAITING = "waiting"
    RECORDING = "recording"
    DONE = "done"


class WiggleRun:
    """Leads through the steps of a wiggle test without keyboard or mouse."""

    def __init__(self, test: WiggleTest) -> None:
        self.test, self.step, self.phase = test, 0, SetUpPhase.READY
        self.share = 0.0
        self._since: float | None = None
        self._hint: Notice | None = None

    @property
    def part(self) -> str:
        """The part to be moved now; "rest" at the end."""
        return "rest" if self.phase == SetUpPhase.DONE else self.test.steps[self.step].part

    @property
    def words(self) -> str:
        """The instruction for the wearer."""
        if self.phase == SetUpPhase.DONE:
            return notice_text(self.test.result().summary)
        asked = notice_text(self._hint or self.test.steps[self.step].instruction)
        if self.phase == SetUpPhase.RECORDING:
            asked = tr("continue…")
        return tr("{} of {}: {}").format(self.step + 1, len(self.test.steps), asked)

    def look(self, recent: Sequence[ImuSample]) -> None:
        """Continue with the latest samples."""
        if not recent or self.phase == SetUpPhase.DONE:
            return
        now = recent[-1].t
        if self._since is None:
            self._since = now
        waited = now - self._since
        if self.phase == SetUpPhase.READY and waited >= READY:
            self._enter(SetUpPhase.WAITING, now)
        elif self.phase == SetUpPhase.WAITING:
            if moving(imu_motion(last(recent, GLANCE)), self.test.params):
                self._enter(SetUpPhase.RECORDING, now)
            elif waited > STEP_TIMEOUT:
                self._hint = self.test.add(self.step, recent)
                self._enter(SetUpPhase.READY, now)
        elif self.phase == SetUpPhase.RECORDING:
            self.share = min(1.0, waited / self.test.params.duration)
            if self.share >= 1.0:
                self._finish_step([s for s in recent if s.t >= now - waited], now)

    def _finish_step(self, samples: Sequence[ImuSample], now: float) -> None:
        self._hint = self.test.add(self.step, samples)
        if self._hint is None:
            self.step += 1
        done = self.step == len(self.test.steps)
        self._enter(SetUpPhase.DONE if done else SetUpPhase.READY, now)

    def _enter(self, phase: SetUpPhase, now: float) -> None:
        self.phase, self._since, self.share = phase, now, 0.0


class StillRun:
    """Waits until the hand has been still for long enough, at most ``STEP_TIMEOUT`` s."""

    def __init__(self, names: Sequence[str], params: StillParams | None = None) -> None:
        self._names, self._params = names, params or StillParams()
        self._begin: float | None = None
        self.pose: StillPose | None = None
        self.done = False
        self.share = 0.0

    def look(self, recent: Sequence[ImuSample]) -> None:
        """Evaluate the latest samples."""
        if not recent or self.done:
            return
        now = recent[-1].t
        if self._begin is None:
            self._begin = now
        waited = now - self._begin
        self.share = min(1.0, waited / self._params.duration)
        if waited < self._params.duration:
            return
        self.pose = still_pose(last(recent, self._params.duration), self._names, self._params)
        self.done = self.pose.ok or waited > STEP_TIMEOUT

    @property
    def words(self) -> str:
        if self.pose is None:
            return tr("Lay the hand flat on the table, palm down, and hold it still.")
        if self.pose.problem is None:
            return tr("Measured.")
        problem = notice_text(self.pose.problem)
        return problem if self.done else tr("Waiting for rest. {}").format(problem)


def last(samples: Sequence[ImuSample], span: float) -> list[ImuSample]:
    """The samples of the last ``span`` s."""
    return [s for s in samples if s.t >= samples[-1].t - span] if samples else []


@dataclass(frozen=True)
class GloveRow:
    """Cells of a table row, and the look of the last one."""

    texts: tuple[str, ...]
    look: StateLook


def still_rows(pose: StillPose) -> list[GloveRow]:
    """IMU, bias x y z, its uncertainty, noise, gravity, state."""
    rows = []
    for imu in pose.imus:
        bias = " ".join(f"{local(v):+.2f}" for v in np.rad2deg(imu.gyro_bias))
        texts = (
            display_name(imu.name),
            bias,
            f"{local(np.rad2deg(imu.gyro_bias_sd)):.3f}",
            f"{local(1000 * np.rad2deg(imu.gyro_noise)):.1f}",
            f"{local(float(np.linalg.norm(imu.accel))):.2f}",
            notice_text(imu.problem) if imu.problem is not None else tr("good"),
        )
        rows.append(GloveRow(texts, BAD if imu.problem is not None else GOOD))
    return rows


WIGGLE_LOOKS = {
    "right": GOOD,
    "elsewhere": BAD,
    "turned": BAD,
    "silent": BAD,
    "still": WARN,
    "unclear": WARN,
}


def wiggle_rows(result: WiggleResult) -> list[GloveRow]:
    """IMU, state, explanation."""
    return [
        GloveRow(
            (display_name(r.name), r.state, notice_text(r.what)), WIGGLE_LOOKS.get(r.state, IDLE)
        )
        for r in result.rows
    ]


def motion_rows(samples: Sequence[ImuSample]) -> tuple[Array, list[int]]:
    """Bar length (n,) 0..1 of each IMU, and the rows of those that are moving."""
    motion = imu_motion(last(samples, GLANCE))
    return np.clip(np.nan_to_num(np.rad2deg(motion)) / FULL_DPS, 0, 1), moving(motion)
