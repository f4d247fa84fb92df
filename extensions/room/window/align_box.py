"""The alignment in the dialog: the guided movement, its residual, and *Save*."""

from __future__ import annotations

from collections.abc import Sequence
from enum import Enum
from pathlib import Path

import numpy as np
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import (
    QComboBox,
    QGroupBox,
    QHBoxLayout,
    QLabel,
    QProgressBar,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from app.engines.engine import EngineSetup
from app.engines.engine_host import EngineHost
from app.jobs.remote import RemoteControl
from app.platform.tasks import JobProgress, TaskOwner
from app.words import error_text, tr
from extensions.room import alignment_file
from extensions.room.alignment import Alignment, AlignmentError, Moved, solve
from extensions.room.movement import PoseTrack, moved_by
from extensions.room.osc_poses import RoomPose
from extensions.room.placement import is_named
from extensions.room.window.listening import PoseDoor, pose_door
from extensions.room.window.source_form import ALIGNMENT
from tracker.base.clock import monotonic
from tracker.base.errors import GlovetrackError
from tracker.base.files import make_folder
from tracker.base.notices import failure
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import ImuSample

TICK_MS = 100


class AlignBox(QGroupBox):
    """``wanted``, called before the movement, returns whether the source is ready."""

    def __init__(
        self,
        host: EngineHost,
        remote: RemoteControl,
        folder: Path,
        tasks: TaskOwner,
        parent: QWidget | None = None,
    ) -> None:
        """``folder``: for alignments that have no file yet."""
        super().__init__(parent)
        self._host, self._remote, self._folder, self._tasks = host, remote, folder, tasks
        self._source = ""
        self._door: PoseDoor | None = None
        self._run: GuidedMovement | None = None
        self._found: tuple[str, Alignment] | None = None
        self.wanted = lambda: True
        self.setTitle(self.tr("Alignment: where the tracker is on the hand"))
        self._lay_out()
        self._timer = QTimer(self)
        self._timer.setInterval(TICK_MS)
        self._timer.timeout.connect(self.tick)

    def _lay_out(self) -> None:
        self.hands = QComboBox()
        self.hands.setAccessibleName(self.tr("Hand"))
        self.start_button = QPushButton(self.tr("&Start the movement"))
        self.start_button.clicked.connect(self.start)
        self.save_button = QPushButton(self.tr("&Save"))
        self.save_button.setToolTip(self.tr("Store the alignment and use it from now on"))
        self.save_button.clicked.connect(self.save)
        self.save_button.setEnabled(False)
        row = QHBoxLayout()
        for widget in (self.hands, self.start_button, self.save_button):
            row.addWidget(widget)
        row.addStretch(1)
        self.words, self.counts = QLabel(), QLabel()
        self.words.setWordWrap(True)
        self.counts.setProperty("role", "faint")
        self.progress = QProgressBar()
        self.progress.setAccessibleName(self.tr("Progress of the movement"))
        column = QVBoxLayout(self)
        column.addLayout(row)
        for each in (self.words, self.progress, self.counts):
            column.addWidget(each)

    def use(self, source: str) -> None:
        """Align trackers of another source."""
        self.stop()
        self._source, self._found = source, None
        self.save_button.setEnabled(False)
        self.progress.setValue(0)
        self.counts.clear()
        used = self._remote.settings.options(self._remote.kinds[source]).alignment
        text = self.tr("In use: {}").format(used) if used else self.tr("No alignment is in use.")
        self.show_result(text)

    def show_result(self, text: str) -> None:
        self.words.setText(text)

    def show_hands(self) -> None:
        """Offer the hands that are tracked live."""
        running = self._run is not None
        sides = [hand.side for hand in self._live_hands()]
        if [self.hands.itemData(k) for k in range(self.hands.count())] != sides:
            self.hands.clear()
            names = {"right": self.tr("Right hand"), "left": self.tr("Left hand")}
            for side in sides:
                self.hands.addItem(names[side], side)
        self.hands.setEnabled(not running and len(sides) > 1)
        self.start_button.setEnabled(not running and bool(sides))
        self.start_button.setToolTip(
            "" if sides else self.tr("Connect the glove and start tracking first")
        )

    def _live_hands(self) -> tuple[EngineSetup, ...]:
        setup = self._host.setup
        if setup is None or setup.live is None or not self._host.running:
            return ()
        return setup.hands

    # --- the movement

    def start(self) -> None:
        """Begin to collect packets and poses."""
        side = self.hands.currentData()
        hand = next((h for h in self._live_hands() if h.side == side), None)
        if hand is None or not self.wanted():
            return
        door = pose_door(self._remote.door(self._source))
        options = self._remote.settings.options(self._remote.kinds[self._source])
        name = str(getattr(options, side))
        if door is None or not name:
            self.show_result(self.tr("Choose the tracker on this hand first."))
            return
        self._found = None
        self.save_button.setEnabled(False)
        self._run = GuidedMovement(hand.hand, hand.glove, name, options.delay_ms / 1e3)
        self._door = door
        self._run.start(monotonic())
        door.taker.tap(self._run.pose)
        self._timer.start()
        self.show_hands()
        self.tick()

    def tick(self) -> None:
        """Refresh; called by the timer."""
        run, now = self._run, monotonic()
        side = self.hands.currentData()
        hand = next((h for h in self._live_hands() if h.side == side), None)
        if run is None or hand is None:
            self.stop()
            return
        run.tick(now, hand.tracked.recent_imu())
        self.show_result(run.words(now))
        self.progress.setValue(round(100 * run.share))
        self.counts.setText(self.tr("{} packets of the glove, {} poses").format(*run.counts))
        if run.phase == MovementPhase.DONE:
            self._end(run, side)

    def _end(self, run: GuidedMovement, side: str) -> None:
        self.stop()
        try:
            moved = run.moved()
        except GlovetrackError as error:
            self.show_result(error_text(error))
            return
        self.show_result(self.tr("Computing the alignment…"))

        def job(_progress: JobProgress, moved: Moved = moved) -> tuple[str, Alignment]:
            return side, solve(moved)

        title = self.tr("Aligning the tracker")
        self._tasks.run(title, job, done=self._show_found, failed=self.show_result)

    def _show_found(self, found: tuple[str, Alignment]) -> None:
        self._found = found
        self.show_result(residual_text(found[1]))
        self.save_button.setEnabled(True)

    def stop(self) -> None:
        """End the movement; nothing of it remains."""
        self._timer.stop()
        if self._door is not None:
            self._door.taker.untap()
        self._door = self._run = None
        self.show_hands()

    # --- the file

    def save(self) -> None:
        """Store the alignment next to the other hand's, and use it."""
        if self._found is None:
            return
        side, found = self._found
        kind = self._remote.kinds[self._source]
        used = self._remote.settings.options(kind).alignment
        path = Path(used) if used else self._folder / f"{self._source}.toml"
        try:
            known = alignment_file.read(path) if path.exists() else {}
            make_folder(path.parent)
            alignment_file.write(path, {**known, side: found}, force=True)
        except GlovetrackError as error:
            self.show_result(error_text(error))
            return
        self._remote.set_option(self._source, ALIGNMENT, str(path))
        self.save_button.setEnabled(False)
        self.show_result(self.tr("Saved, and in use: {}").format(path))


# ---- the guided movement of an alignment: what to do now, and what was measured meanwhile

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
