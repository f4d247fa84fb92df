"""Estimates with known contents, and a wait for other threads."""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np
import pytest

from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Estimate, Tracking, Validity
from tracker.streaming.publisher import Names

MakeEstimate = Callable[..., Estimate]


@pytest.fixture(scope="session")
def names(hand: HandModel, glove: GloveModel) -> Names:
    return Names.of(hand, glove)


@pytest.fixture(scope="session")
def make_estimate(hand: HandModel, glove: GloveModel) -> MakeEstimate:
    """A posed hand at ``t``; keypoints and angles of the given names are lost."""

    def make(
        t: float = 1.25,
        lost: tuple[str, ...] = (),
        angles: dict[str, float] | None = None,
        tracking: Tracking = Tracking.TRACKING,
    ) -> Estimate:
        q = np.zeros(len(hand.joint_names))
        for name, value in (angles or {}).items():
            q[hand.angle_index[name]] = value
        root = so3.exp(np.array([0.1, -0.2, 0.3]))
        R, p = hand.forward(q, root, np.array([0.5, 0.1, 0.2]))
        points = glove.keypoint_positions(hand, R, p)
        quats = so3.quat_from_matrix(R)[glove.keypoint_segments(hand)]
        gone = np.array([n in lost for n in glove.keypoint_names(hand)])
        points[gone], quats[gone] = np.nan, np.nan
        angle_gone = np.array([n in lost for n in hand.joint_names])
        q[angle_gone] = np.nan
        return Estimate(
            t=t,
            tracking=tracking,
            keypoints=points,
            keypoint_q=quats,
            keypoint_state=np.where(gone, int(Validity.LOST), int(Validity.MEASURED)),
            keypoint_sd=np.where(gone, np.nan, 0.002),
            angles=q,
            angle_state=np.where(angle_gone, int(Validity.LOST), int(Validity.MEASURED)),
            segment_R=R,
            segment_p=p,
        )

    return make


@pytest.fixture
def wait_for() -> Callable[[Callable[[], object]], None]:
    """Wait for a condition, at most a minute, as on a computer that is busy otherwise."""

    def wait(holds: Callable[[], object]) -> None:
        end = time.monotonic() + 60
        while not holds():
            assert time.monotonic() < end, "it did not happen within a minute"
            time.sleep(0.005)

    return wait
