"""Detects hues whose names are exchanged in the colours, for instance red called blue.

Then there are enough blobs, but no hand among them, or one that is found by mistake and lost again.
The same packets and images are tried with the names in other orders, one after another.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from tracker.base.notices import Outbox, warning
from tracker.engine.pipeline import Pipeline
from tracker.messages import BlobFrame, ImuSample, Tracking
from tracker.vision.hue_orders import moved, orders

PATIENCE = 2.5  # s without a hand, before other names are tried: after the mirrored glove is
FOUND = 3.0  # s for which our hand has to be tracked to be the right one
TRIAL = 0.5  # s without a hand, after which the next order is tried
SURE = 1.0  # s for which a hand has to be tracked with other names


class HueWatch:
    """Fed with what a hand's ``pipeline`` is fed with; costs nothing while that finds the hand."""

    def __init__(self, pipeline: Pipeline, notices: Outbox, patience: float = PATIENCE) -> None:
        self._pipeline, self._notices, self._patience = pipeline, notices, patience
        self._trial: Pipeline | None = None
        self._orders: Iterator[tuple[str, ...]] | None = None
        self._names: tuple[str, ...] = ()
        self._order: tuple[str, ...] = ()
        self._waited = self._followed = self._missing = self._sure = 0.0
        self._over = False

    @property
    def is_trying(self) -> bool:
        """Whether other names are being tried."""
        return self._trial is not None

    def packet(self, sample: ImuSample, tracking: Tracking, step: float, try_next: bool) -> None:
        """Takes a packet, ``step`` s after the last one, and the state of tracking after it;
        ``try_next``: there are enough blobs, and nothing else is being tried."""
        self._followed = self._followed + step if tracking == Tracking.TRACKING else 0.0
        if self._followed >= FOUND:
            self._restart()
        elif self._trial is not None:
            self._try(self._trial, sample, step)
        elif try_next and not self._over and tracking != Tracking.TRACKING:
            self._waited += step
            if self._waited >= self._patience:
                self._next()

    def frame(self, blobs: BlobFrame) -> None:
        """What was found in an image."""
        self._names = blobs.hue_names
        if self._trial is not None and len(self._order) == len(blobs.hue_names):
            self._trial.feed_frame(replace(blobs, hue_names=self._order))
            self._trial.take_results()

    def _restart(self) -> None:
        self._trial, self._orders, self._over = None, None, False
        self._waited = self._followed = self._missing = self._sure = 0.0

    def _next(self) -> None:
        """Begins with the next order of the names, if there is one."""
        if self._orders is None:
            self._orders = orders(self._names)
        order = next(self._orders, None)
        self._missing = self._sure = 0.0
        if order is None:
            self._trial, self._over = None, True
            return
        own = self._pipeline
        self._order = order
        self._trial = Pipeline(own.hand, own.glove, own.calibrated_rig, own.settings)

    def _try(self, trial: Pipeline, sample: ImuSample, step: float) -> None:
        found = trial.feed_imu(sample).tracking == Tracking.TRACKING
        self._sure = self._sure + step if found else 0.0
        self._missing = 0.0 if found else self._missing + step
        if self._sure >= SURE:
            hues = moved(self._names, self._order)
            self._notices.post(warning("colours.exchanged", hues=hues))
            self._trial, self._over = None, True
        elif self._missing >= TRIAL:
            self._next()
