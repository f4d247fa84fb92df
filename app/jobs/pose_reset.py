"""The pose reset: a key or a double tap, a countdown, and the alignment of both hands with the
pose."""

from __future__ import annotations

from PySide6.QtCore import QObject, QTimer, Signal
from PySide6.QtWidgets import QApplication

from app.engines.engine import EngineSetup
from app.engines.engine_host import EngineHost
from app.storage.settings import SettingsStore
from tracker.inertial.double_tap import DoubleTap

SECOND_MS = 1000
POLL_MS = 50  # between two checks for a double tap
POSE = "flat"


class PoseReset(QObject):
    """``left``: s until the reset; 0 without a countdown."""

    counted = Signal(int)  # `left` has changed

    def __init__(
        self, host: EngineHost, store: SettingsStore, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._host, self._store = host, store
        self.left = 0
        self._taps: dict[str, DoubleTap] = {}
        self._timer, self._poll_timer = QTimer(self), QTimer(self)
        self._timer.setInterval(SECOND_MS)
        self._timer.timeout.connect(self._count)
        self._poll_timer.timeout.connect(self._poll)
        host.running_changed.connect(self._running)
        host.closed.connect(self.cancel)

    @property
    def available(self) -> bool:
        """Whether a hand is tracked live."""
        setup = self._host.setup
        return self._host.running and setup is not None and setup.live is not None

    # --- by key

    def press(self) -> None:
        """Start the countdown, or cancel it."""
        if self.left:
            self.cancel()
        else:
            self.begin()

    def begin(self) -> None:
        """Start the countdown; a simulated wearer takes the pose."""
        if self.left or not self.available:
            return
        self._show(POSE)
        if self._store.value.pose_reset_countdown:
            self._set(self._store.value.pose_reset_countdown)
            self._timer.start()
        else:
            self._reset()

    def cancel(self) -> None:
        """Cancel the countdown, if any."""
        self._timer.stop()
        if self.left:
            self._set(0)
            self._show("")

    def _count(self) -> None:
        if self.left > 1:
            self._set(self.left - 1)
            return
        self._timer.stop()
        self._set(0)
        self._reset()

    def _set(self, left: int) -> None:
        self.left = left
        self.counted.emit(left)

    def _reset(self) -> None:
        """Reset all hands at once."""
        setup = self._host.setup
        for hand in setup.hands if setup is not None else ():
            if hand.live is not None:
                hand.live.hand.reset_pose()
        if self._store.value.pose_reset_sound:
            QApplication.beep()
        self._show("")

    def _show(self, pose: str) -> None:
        setup = self._host.setup
        live = setup.live if setup is not None else None
        if live is not None and live.wearer is not None:
            live.wearer.show(pose)

    # --- by double tap

    def _running(self, on: bool) -> None:
        if not on:
            self.cancel()
        self.listen()

    def listen(self) -> None:
        """Detect double taps, if enabled."""
        self._taps = {}
        if self.available and self._store.value.pose_reset_tap:
            self._poll_timer.start(POLL_MS)
        else:
            self._poll_timer.stop()

    def _poll(self) -> None:
        setup = self._host.setup
        if setup is None or self.left:
            return
        if sum(
            self._tapped(hand) for hand in setup.hands
        ):  # evaluates all hands, so that each processes its packets
            self.begin()

    def _tapped(self, hand: EngineSetup) -> bool:
        """Whether the back of this hand's glove was tapped twice since the last check."""
        root = hand.hand.segments[hand.hand.root].name
        if root not in hand.glove.imu_names:
            return False
        row, tap = hand.glove.imu_names.index(root), self._taps.setdefault(hand.side, DoubleTap())
        packets = hand.tracked.recent_imu()  # those processed before are skipped
        return sum(tap.feed(s.t, s.accel[row], s.gyro[row]) for s in packets) > 0
