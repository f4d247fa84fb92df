"""Names of hues that are exchanged in the colours, corrected while the hand is tracked.

Red called blue leaves red and blue markers unmatched, but the others may still show the hand. Then
blobs called blue are where red markers are expected, which names the exchange.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from tracker.base.notices import Notice, warning
from tracker.base.records import record
from tracker.messages import Array, BlobFrame, Event, IntArray

KIND = "hue_names"
LASTS = 2.0  # s, time constant with which older images count less
LEAST = 10.0  # blobs of another name at a hue's markers
CLEAR = 3.0  # ratio of them to the blobs with the name, and to those of any third one


@record("hue_names", shapes={"order": "int 0 | int h", "counts": "0 | h h"})
@dataclass(eq=False)
class HueNamesSavedState:
    """order (h,): row of the glove's hue that blobs with the name of each of its hues really have;
    counts (h, h) blobs of the latter names at markers of each hue. Empty before the first."""

    order: IntArray = field(default_factory=lambda: np.zeros(0, np.int64))
    counts: Array = field(default_factory=lambda: np.zeros((0, 0)))
    t: float = -np.inf  # s, of the last image


class HueNames:
    """For a glove with these ``hues``, in its order."""

    def __init__(self, hues: tuple[str, ...]) -> None:
        self._hues = hues
        self.saved = HueNamesSavedState()

    @property
    def is_corrected(self) -> bool:
        """Whether names were corrected before."""
        return bool(len(self.saved.order))

    @property
    def as_found(self) -> tuple[str, ...]:
        """The name that blobs of each of the glove's hues have in the colours."""
        if not len(self.saved.order):
            return self._hues
        return tuple(self._hues[k] for k in np.argsort(self.saved.order))

    @property
    def names(self) -> tuple[str, ...]:
        """What blobs with the name of each of the glove's hues really have."""
        return self.called(self._hues)

    def called(self, names: tuple[str, ...]) -> tuple[str, ...]:
        """The corrected ``names``, of the glove's hues."""
        rows = (self._hues.index(name) for name in names)
        order = self.saved.order
        return tuple(self._hues[int(order[k])] if len(order) else self._hues[k] for k in rows)

    def corrected(self, frame: BlobFrame) -> BlobFrame:
        """The frame with the right names."""
        if not len(self.saved.order):
            return frame
        right = {name: self._hues[k] for name, k in zip(self._hues, self.saved.order, strict=True)}
        return replace(frame, hue_names=tuple(right.get(n, n) for n in frame.hue_names))

    def learn(self, t: float, counts: Array | None) -> Notice | None:
        """Adds an image of ``t`` (s) that the hand was tracked in: counts (h, h) blobs at markers
        of each hue, by their present names; None where nothing was missed. Returns what is to be
        reported after a correction."""
        now, h = self.saved, len(self._hues)
        if counts is None or len(counts) != h:
            return None
        before = now.counts if len(now.counts) else np.zeros((h, h))
        kept = float(np.exp(-max(t - now.t, 0.0) / LASTS)) if np.isfinite(now.t) else 0.0
        self.saved = now = replace(now, counts=kept * before + counts, t=t)
        other = exchange(now.counts)
        if other is None:
            return None
        order = now.order if len(now.order) else np.arange(h)
        return self._use(np.argsort(other)[order])

    def use(self, names: Sequence[str]) -> None:
        """Blobs with the name of each of the glove's hues have these ``names`` instead; ignored
        where those are not the glove's."""
        if sorted(names) == sorted(self._hues):
            self._use(np.array([self._hues.index(n) for n in names], np.int64))

    def _use(self, order: IntArray) -> Notice | None:
        rows = np.arange(len(order))
        before = self.saved.order if len(self.saved.order) else rows
        self.saved = HueNamesSavedState(order=np.asarray(order, np.int64))
        if np.array_equal(order, before) or np.array_equal(order, rows):
            return None  # fitted meanwhile: they are as in the colours again
        return _report([self._hues[k] for k in np.flatnonzero(order != rows)])


def exchange(counts: Array) -> IntArray | None:
    """(h,) row of the name that blobs at markers of each hue have, if it is another order of the
    names; None where it is not, or not clear."""
    rows = np.arange(len(counts))
    names = np.where(counts.max(axis=1) >= 1.0, counts.argmax(axis=1), rows)
    moved = names != rows
    if not moved.any() or len(np.unique(names)) < len(names):
        return None
    most = counts[rows, names]
    others = counts.copy()
    others[rows, names] = 0.0
    sure = (most >= LEAST) & (most >= CLEAR * others.max(axis=1))
    return names if sure[moved].all() else None


def hue_names_event(hues: Sequence[str], names: Sequence[str], t: float) -> Event:
    """From ``t`` (s) on, blobs with the name of each of the glove's ``hues`` have these ``names``
    instead."""
    moved = [hue for hue, name in zip(hues, names, strict=True) if hue != name]
    return Event.of(t, KIND, _report(moved), {"names": ",".join(names)})


def hue_names_of(event: Event) -> tuple[str, ...] | None:
    """The names in an event; None for any other event."""
    names = event.data.get("names") if event.kind == KIND else None
    return tuple(names.split(",")) if isinstance(names, str) else None


def _report(moved: Sequence[str]) -> Notice:
    return warning("colours.exchanged_here", hues=tuple(moved))
