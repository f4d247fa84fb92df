"""Assignment of recorded patches to markers in a replay.

A session contains the detected patches and the estimated hand, but not their assignment. Each
marker is projected from the recorded hand into the image; the nearest free patch of its hue is
assigned to it. Nothing is estimated again, so there are no covariances of predictions.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import (
    Array,
    BlobFrame,
    Blobs,
    Estimate,
    FrameResult,
    IntArray,
    Tracking,
)
from tracker.vision.rig import StereoRig

REACH = 0.012  # m, the largest distance between a marker and its patch
AT_IMAGE = 0.02  # s between an image and the estimate used for it
FACING = 0.15  # least cosine between a visible marker's normal and the direction to the camera


class MarkerMatcher:
    """Matches patches to the markers of a glove."""

    def __init__(self, hand: HandModel, glove: GloveModel, rig: StereoRig) -> None:
        self._rig = rig
        self._segment = glove.marker_segment(hand)
        self._position = glove.marker_position
        self._normal = np.array([m.normal for m in glove.markers]).reshape(-1, 3)
        self._hues = [m.hue for m in glove.markers]

    def match(self, blobs: BlobFrame, estimates: Sequence[Estimate]) -> FrameResult:
        """Match with the estimate at the image; without a tracked one nothing is matched."""
        hand = min(estimates, key=lambda e: abs(e.t - blobs.t), default=None)
        nothing = FrameResult.nothing(
            blobs.t, hand.tracking if hand else Tracking.SEARCHING, len(self._hues)
        )
        if hand is None or abs(hand.t - blobs.t) > AT_IMAGE or hand.tracking != Tracking.TRACKING:
            return nothing
        pose = blobs.pose or self._rig.pose
        R, p = hand.segment_R[self._segment], hand.segment_p[self._segment]
        p_C = (p + np.einsum("mij,mj->mi", R, self._position) - pose.p_GC) @ pose.R_GC
        n_C = np.einsum("mij,mj->mi", R, self._normal) @ pose.R_GC
        away = -np.einsum("mi,mi->m", n_C, p_C) / np.linalg.norm(p_C, axis=1)
        seen = away > FACING
        reach_px = REACH * self._rig.fx / np.maximum(p_C[:, 2], 0.05)
        hues = blobs.hue_names
        left, right = self._pixels(p_C, False), self._pixels(p_C, True)
        match_left = self._match(left, seen, reach_px, blobs.left, hues)
        match_right = self._match(right, seen, reach_px, blobs.right, hues)
        return FrameResult(
            t=blobs.t,
            tracking=hand.tracking,
            predicted_left=left,
            predicted_right=right,
            predicted_cov=nothing.predicted_cov,
            visible=seen.astype(float),
            match_left=match_left,
            match_right=match_right,
            residual=np.hstack(
                [
                    _residual(left, match_left, blobs.left),
                    _residual(right, match_right, blobs.right),
                ]
            ),
            stereo_points=int(((match_left >= 0) & (match_right >= 0)).sum()),
        )

    def _pixels(self, p_C: Array, right: bool) -> Array:
        """(M, 2) px in the image as recorded; NaN outside."""
        camera = self._rig.right if right else self._rig.left
        flat = self._rig.project(p_C, right=right)
        raw = np.full_like(flat, np.nan)
        there = np.isfinite(flat).all(axis=1)
        raw[there] = camera.unrectify(flat[there])
        inside = (raw >= 0).all(axis=1) & (raw < [camera.width, camera.height]).all(axis=1)
        raw[~inside] = np.nan
        return raw

    def _match(
        self, uv: Array, seen: Array, reach_px: Array, blobs: Blobs | None, hues: Sequence[str]
    ) -> IntArray:
        """(M,) row of each marker's patch, -1 for none: nearest pairs first."""
        match = np.full(len(uv), -1, np.int64)
        if blobs is None or not len(blobs):
            return match
        away = np.linalg.norm(uv[:, None] - np.asarray(blobs.uv)[None], axis=2)
        same = np.array([[hue == hues[h] for h in blobs.hue] for hue in self._hues])
        allowed = same & (away <= reach_px[:, None]) & seen[:, None]
        pairs = np.argwhere(allowed)
        taken: set[int] = set()
        for marker, blob in pairs[np.argsort(away[allowed], kind="stable")].tolist():
            if match[marker] < 0 and blob not in taken:
                match[marker] = blob
                taken.add(blob)
        return match


def _residual(uv: Array, match: IntArray, blobs: Blobs | None) -> Array:
    """(M, 2) px from each marker to its blob; NaN for none."""
    out = np.full((len(match), 2), np.nan)
    matched = match >= 0
    if blobs is not None:
        out[matched] = blobs.uv[match[matched]] - uv[matched]
    return out
