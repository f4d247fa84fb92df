"""Learns the change of the IMUs' biases with the temperature at the end of recordings and runs."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QObject, QTimer

from app.engines.engine import EngineSetup
from app.engines.engine_host import EngineHost
from app.jobs.own_gloves import own_model, save_own
from app.storage.settings import SettingsStore
from app.words import error_text
from tracker.base.clock import monotonic
from tracker.base.errors import GlovetrackError
from tracker.base.notices import Notice, notice, warning
from tracker.calibration.drift_learning import WarmthCollector, learn_drift
from tracker.glove.imu_values import with_drift
from tracker.glove.model import ImuDrift
from tracker.messages import Event

POLL_MS = 4000
"""The last 10 s of packets are available."""


class DriftLearner(QObject):
    """Only for gloves that report a number: what is learned belongs to one glove.

    The result is used from the next start on, so that a recording contains the glove file that was
    used from its beginning to its end.
    """

    def __init__(self, host: EngineHost, store: SettingsStore, parent: QObject) -> None:
        super().__init__(parent)
        self._host, self._store = host, store
        self._collected: dict[str, WarmthCollector] = {}
        self._timer = QTimer(self)
        self._timer.setInterval(POLL_MS)
        self._timer.timeout.connect(self.poll)
        host.running_changed.connect(self._running)
        host.recording.finished.connect(lambda _path: self.learn())

    def _running(self, on: bool) -> None:
        if on:
            self._collected = {}
            self._timer.start()
        else:
            self._timer.stop()
            self.learn()

    def _gloves(self) -> list[EngineSetup]:
        setup = self._host.setup
        hands = setup.hands if setup is not None and not setup.simulated else ()
        return [h for h in hands if h.live is not None and h.connection.number is not None]

    def poll(self) -> None:
        """Take the packets since the last call."""
        for hand in self._gloves():
            collected = self._collected.setdefault(hand.side, WarmthCollector())
            for sample in hand.tracked.recent_imu():
                collected.add(sample)

    def learn(self) -> None:
        """Improve the gloves' own files by what was collected, and report it."""
        self.poll()
        for hand in self._gloves():
            self._learn(hand, self._collected[hand.side])

    def _learn(self, hand: EngineSetup, collected: WarmthCollector) -> None:
        names = hand.glove.imu_names
        rests = dict(zip(names, collected.rests(), strict=False))
        try:
            found = learn_drift(rests, _known(hand))
            if found.contradicted:
                self._report(
                    warning(
                        "imu_drift.contradicted",
                        glove=hand.connection.number,
                        imus=found.contradicted,
                    )
                )
            if found.contradicted or not found.drift:
                return
            path = save_own(self._store, hand, lambda text: with_drift(text, found.drift))
        except GlovetrackError as error:
            self._host.error.emit(error_text(error))
            return
        self._collected[hand.side] = WarmthCollector()  # it is included in later results
        self._report(
            notice(
                "imu_drift.learned",
                glove=hand.connection.number,
                imus=len(found.drift),
                before=float(np.rad2deg(found.sd_before)),
                after=float(np.rad2deg(found.sd_after)),
                file=path.name,
            )
        )

    def _report(self, what: Notice) -> None:
        self._host.happened.emit(Event.of(monotonic(), "device", what))


def _known(hand: EngineSetup) -> dict[str, ImuDrift | None]:
    """The current content of the glove's file, which after a recording is newer than the one in
    use."""
    return {imu.name: imu.drift for imu in own_model(hand).imus}
