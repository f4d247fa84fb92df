"""Errors of a trial's estimates: the four keypoints compared with the truth.

Errors are computed in G, with two exceptions: during an outage and without a camera, in the
dorsum's frame, since the position of an unseen hand is a double integral; and with a camera on the
head, in the camera's frame, as a wearer of glasses sees the hand: the estimate is transformed to C
with the pose that the tracker uses, the truth with the true pose.
"""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from extensions.evaluation.vist.cases import SETTLING, judged_in_outage
from extensions.evaluation.vist.metrics import DIGITS, Trial, WholeHandErrors
from tracker.engine.pipeline import Pipeline
from tracker.hand.names import MARKED_KEYPOINTS
from tracker.messages import (
    Array,
    BlobFrame,
    CameraPose,
    Estimate,
    Event,
    ImuSample,
    Tracking,
)
from tracker.simulation.scenario import Simulation, Truth

Fed = ImuSample | BlobFrame | Event


@dataclass(eq=False)
class TrialRecord:
    """Data recorded during a trial: an entry per packet, and counts."""

    estimates: list[Estimate] = field(default_factory=list)
    poses: list[CameraPose] = field(default_factory=list)  # of the camera, as used by the tracker
    seen: list[int] = field(default_factory=list)
    latest_seen: int = 0
    matches: int = 0
    wrong: int = 0
    core_s: float = 0.0
    fed: list[Fed] = field(default_factory=list)  # as the engine received it, if it is smoothed


@dataclass(frozen=True, eq=False)
class Judge:
    """Computes the errors of a trial.

    ``columns`` are the rows of the evaluated keypoints in an estimate, followed by those of joints.
    ``place`` is the frame: world, camera or dorsum. Evaluation starts at ``begin`` (s), after the
    hand has been found.
    """

    simulation: Simulation
    pipeline: Pipeline
    columns: list[int]
    place: str = "world"
    begin: float = 0.0

    def trial(self, record: TrialRecord, participant: int, outage: float) -> Trial:
        """The errors of a trial; ``outage``: duration in s of repeated outages, 0 for none."""
        t = np.array([e.t for e in record.estimates])
        rows = np.flatnonzero(self._judged(t, outage))
        estimates = [record.estimates[i] for i in rows]
        truths = self.simulation.truths(t[rows])
        unplaced = self.place == "dorsum"
        if unplaced:
            error = self._articulation(estimates, truths)
        else:
            error = self._place(estimates, truths, [record.poses[i] for i in rows])
        sd = np.array([e.keypoint_sd[self.columns] for e in estimates]).reshape(error.shape)
        n = len(MARKED_KEYPOINTS)
        wearer = self.simulation.wearer
        return Trial(
            participant=participant,
            hand_length=self.simulation.hand.length * float(wearer.scale[:, 0].mean()),
            t=t[rows],
            error=error[:, :n],
            sd=np.full_like(sd[:, :n], np.nan) if unplaced else sd[:, :n],
            joints=error[:, n:],
            seen=np.array(record.seen, np.int64)[rows],
            matches=record.matches,
            wrong_matches=record.wrong,
            core_s=record.core_s,
            duration=self.simulation.duration,
            angles=self._angles(estimates, truths),
            whole=self._whole(estimates, truths) if self.place == "world" else None,
        )

    def _whole(self, estimates: list[Estimate], truths: list[Truth]) -> WholeHandErrors:
        names = self.pipeline.keypoint_names
        shape = (len(estimates), len(names))
        given = np.array([e.keypoints for e in estimates]).reshape(*shape, 3)
        true = np.array([x.keypoints for x in truths]).reshape(*shape, 3)
        return WholeHandErrors(
            tuple(names),
            np.linalg.norm(given - true, axis=2),
            np.array([e.keypoint_sd for e in estimates]).reshape(shape),
            np.array([e.keypoint_state for e in estimates], np.int64).reshape(shape),
        )

    def _angles(self, estimates: list[Estimate], truths: list[Truth]) -> Array:
        """Errors (n, j) rad of the joint angles of the evaluated digits."""
        names = self.pipeline.hand.joint_names
        rows = [i for i, name in enumerate(names) if name.startswith(DIGITS)]
        given = np.array([e.angles[rows] for e in estimates]).reshape(-1, len(rows))
        true = np.array([x.angles[rows] for x in truths]).reshape(-1, len(rows))
        return np.abs(given - true)

    def _judged(self, t: Array, outage: float) -> NDArray[np.bool_]:
        """(n,) whether each instant is evaluated. Some recordings are short."""
        ok = t > max(min(SETTLING, self.simulation.duration / 3), self.begin)
        if outage:
            ok &= np.array([judged_in_outage(x, outage) for x in t])
        return ok

    def _place(
        self, estimates: list[Estimate], truths: list[Truth], poses: list[CameraPose]
    ) -> Array:
        """Errors (n, k) m in G or C."""
        shape = (len(estimates), len(self.columns), 3)
        given = np.array([e.keypoints[self.columns] for e in estimates]).reshape(shape)
        true = np.array([x.keypoints[self.columns] for x in truths]).reshape(shape)
        if self.place == "camera":
            for i, (e, pose) in enumerate(zip(estimates, poses, strict=True)):
                given[i] = _in_camera(given[i], pose)
                true[i] = _in_camera(true[i], self.simulation.scene.pose(e.t))
        return np.linalg.norm(given - true, axis=2)

    def _articulation(self, estimates: list[Estimate], truths: list[Truth]) -> Array:
        """Errors (n, k) m in the dorsum's frame, from segment poses, since keypoints are lost."""
        scale = self._scales()
        hand, glove = self.pipeline.hand, self.pipeline.glove
        out = np.full((len(estimates), len(self.columns)), np.nan)
        for i, (e, truth) in enumerate(zip(estimates, truths, strict=True)):
            if e.tracking == Tracking.SEARCHING:
                continue
            given = glove.keypoint_positions(hand, e.segment_R, e.segment_p, scale)[self.columns]
            given = (given - e.segment_p[0]) @ e.segment_R[0]
            true = (truth.keypoints[self.columns] - truth.p_GB[0]) @ truth.R_GB[0]
            out[i] = np.linalg.norm(given - true, axis=1)
        return out

    def _scales(self) -> Array:
        """Learned scales (S, 3); segments without a scale in the engine have the mean."""
        calibration, hand = self.pipeline.calibration(), self.pipeline.hand
        scale = np.full((len(hand.segments), 3), float(np.nanmean(calibration.scale[:, 0])))
        for name, row in zip(calibration.segments, calibration.scale, strict=True):
            scale[hand.index[name]] = row
        return scale


def _in_camera(p_G: Array, pose: CameraPose) -> Array:
    """Points (k, 3) m in C for points in G."""
    return (p_G - pose.p_GC) @ pose.R_GC
