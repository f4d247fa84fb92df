"""The guided movement of an alignment: what to do now, and what was measured meanwhile."""

from __future__ import annotations

from collections.abc import Sequence
from enum import Enum

import numpy as np

from app.words import tr
from extensions.room.alignment import Alignment, AlignmentError, Moved
from extensions.room.movement import PoseTrack, moved_by
from extensions.room.osc_poses import RoomPose
from extensions.room.placement import is_named
from tracker.base.notices import failure
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import ImuSample

STILL_S, TURN_S = 2.0, 15.0
EACH_S = 5.0  # s of each kind of turn that is asked for


class MovementPhase(Enum):
    WAITING = "waiting"
    STILL = "still"
    TURNING = "turning"
    DONE = "done"


class GuidedMovement:
    """Collects packets of the glove and poses of the tracker ``name`` from `start` on.

    `pose` may be called from another thread; all else is called from one. Times are in s of the
    monotonic clock; ``delay`` is taken off the poses'.
    """

    def __init__(self, hand: HandModel, glove: GloveModel, name: str, delay: float) -> None:
        self._hand, self._glove, self._name, self._delay = hand, glove, name, delay
        self.phase, self.share = MovementPhase.WAITING, 0.0
        self._begun = 0.0
        self._samples: list[ImuSample] = []
        self._poses: list[tuple[float, RoomPose]] = []

    def start(self, t: float) -> None:
        self._begun, self.phase = t, MovementPhase.STILL
        self._samples, self._poses = [], []

    def pose(self, pose: RoomPose, t: float) -> None:
        if self.phase in (MovementPhase.STILL, MovementPhase.TURNING) and is_named(
            self._name, pose.name
        ):
            self._poses.append((t - self._delay, pose))

    def tick(self, t: float, packets: Sequence[ImuSample]) -> None:
        """``packets``: the glove's last ones, those before among them."""
        if self.phase not in (MovementPhase.STILL, MovementPhase.TURNING):
            return
        last = self._samples[-1].t if self._samples else self._begun
        self._samples += [p for p in packets if p.t > last]
        elapsed = t - self._begun
        self.share = min(elapsed / (STILL_S + TURN_S), 1.0)
        if elapsed >= STILL_S + TURN_S:
            self.phase = MovementPhase.DONE
        elif elapsed >= STILL_S:
            self.phase = MovementPhase.TURNING

    def cancel(self) -> None:
        self.phase = MovementPhase.WAITING

    @property
    def counts(self) -> tuple[int, int]:
        """Packets of the glove and poses of the tracker so far."""
        return len(self._samples), len(self._poses)

    def words(self, t: float) -> str:
        """What to do now."""
        if self.phase == MovementPhase.STILL:
            return tr("Rest the wrist on the edge of a table and hold the hand still.")
        turns = (
            tr("Keep the wrist there. Turn the palm up and down."),
            tr("Keep the wrist there. Move the fingers up and down."),
            tr("Keep the wrist there. Move the fingers left and right."),
        )
        k = int((t - self._begun - STILL_S) / EACH_S)
        return turns[min(max(k, 0), len(turns) - 1)]

    def moved(self) -> Moved:
        """The whole movement. Raises AlignmentError where nothing measured it."""
        poses = [(t, p) for t, p in self._poses if np.isfinite(p.q).all()]
        poses = [each for k, each in enumerate(poses) if k == 0 or each[0] > poses[k - 1][0]]
        if not self._samples:
            raise AlignmentError(failure("room.no_packets"))
        if not poses:
            if self._poses:
                raise AlignmentError(failure("room.only_positions", name=self._name))
            raise AlignmentError(failure("room.not_received", name=self._name))
        track = PoseTrack(
            np.array([t for t, _ in poses]),
            np.array([p.p for _, p in poses]),
            np.array([p.q for _, p in poses]),
        )
        return moved_by(self._samples, track, self._hand, self._glove)


def residual_text(found: Alignment) -> str:
    """How well a movement determined the alignment."""
    x, y, z = 1e3 * found.p_BT
    lines = (
        tr("The tracker is {:.0f}, {:.0f}, {:.0f} mm from the wrist.").format(x, y, z),
        tr("The rotations agree within {:.1f}°, and the wrist was at rest within {:.1f} mm (rms).")
        .format(np.rad2deg(found.rotation_rms), 1e3 * found.position_rms),
        tr("The poses are {:.0f} ms late.").format(1e3 * found.delay),
    )  # fmt: skip
    return "\n".join(lines)
