"""A limit on the blobs of an image, so that matching is faster than real time in any scene."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tracker.messages import Array, BlobFrame, Blobs, IntArray

MOST_BLOBS = 256
"""Per image. Two gloves have 74 markers, and a cluttered desk adds some tens; matching and the
search for a hand compare pairs of blobs: 900 of them took 1.5 s per second of a session."""
REPORT_INTERVAL = 10.0
"""s, in image timestamps, between two reports of ignored blobs."""
CELL = 32.0
"""px; blobs in a cell of this size with many others are ignored first."""


def thinned(frame: BlobFrame) -> tuple[BlobFrame, int]:
    """The frame with at most `MOST_BLOBS` in each image, and the number of blobs removed."""
    left, right = _thinned(frame.left), _thinned(frame.right)
    if left is frame.left and right is frame.right:
        return frame, 0
    count = _count(frame.left) + _count(frame.right) - _count(left) - _count(right)
    return replace(frame, left=left, right=right), count


class BlobLimit:
    """Limits the blobs of each image to `MOST_BLOBS` and counts the ignored ones."""

    def __init__(self) -> None:
        self.ignored = 0
        self._report_due = -np.inf  # s

    def limit(self, frame: BlobFrame) -> tuple[BlobFrame, bool]:
        """Returns the limited frame, and whether the ignored blobs should be reported now."""
        frame, ignored = thinned(frame)
        self.ignored += ignored
        if not ignored or frame.t < self._report_due:
            return frame, False
        self._report_due = frame.t + REPORT_INTERVAL
        return frame, True


def _count(blobs: Blobs | None) -> int:
    return 0 if blobs is None else len(blobs)


def _thinned(blobs: Blobs | None) -> Blobs | None:
    """The original order is preserved; returns ``blobs`` itself where there are few enough."""
    if blobs is None or len(blobs) <= MOST_BLOBS:
        return blobs
    rank = _rank_in_cell(blobs.uv, blobs.score)
    kept = np.sort(np.lexsort((-blobs.score, rank))[:MOST_BLOBS])
    return replace(
        blobs,
        uv=blobs.uv[kept],
        size=blobs.size[kept],
        hue=blobs.hue[kept],
        score=blobs.score[kept],
    )


def _rank_in_cell(uv: Array, score: Array) -> IntArray:
    """(n,) number of blobs in the same cell with a higher score, or an equal score and a lower
    index."""
    cell = np.floor(np.nan_to_num(uv) / CELL)
    order = np.lexsort((-score, cell[:, 1], cell[:, 0]))
    in_order = cell[order]
    begins = np.r_[True, (np.diff(in_order, axis=0) != 0).any(axis=1)]
    first = np.maximum.accumulate(np.where(begins, np.arange(len(uv)), 0))
    rank = np.empty(len(uv), np.int64)
    rank[order] = np.arange(len(uv)) - first
    return rank
