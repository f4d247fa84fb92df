"""Markers in the two pictures: prediction, correspondence, and the stacked pixel update.

A marker's placement error is common to both images: the noise of a stereo pair is
A A^T s_m² + I s_px² with A = [Pi_L; Pi_R] R_CG. Treating it as independent pixel noise would throw
the depth away. A marker that one camera sees gives two rows, one that both see gives four.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from tracker.fusion.chain_kinematics import marker_jacobians, marker_positions, turned
from tracker.fusion.layout import ChainLayout
from tracker.fusion.params import NoiseParams
from tracker.fusion.pixels_kernel import innovation_covariance, pixel_jacobians, spread, stack_rows
from tracker.fusion.sparse import times
from tracker.fusion.state import ChainState
from tracker.messages import Array, BlobFrame, Blobs, CameraPose, IntArray
from tracker.vision.correspondence import GateParams, HandShape, assign_gated, visibility
from tracker.vision.rig import StereoRig

SIDES = ("left", "right")
MIN_PRIOR = 0.01
GATE = GateParams()
USUAL_SPREAD = 10.0  # ln det of an innovation covariance in px⁴ that the default gate is made for


@dataclass(frozen=True, eq=False)
class SeenBlobs:
    """Blobs of one image in rectified pixels uv (n, 2), hue (n,) numbered as the glove's."""

    uv: Array
    hue: IntArray
    source: IntArray  # (n,) row in the original message

    @staticmethod
    def of(
        blobs: Blobs | None,
        hue_names: tuple[str, ...],
        hues: tuple[str, ...],
        rectify: Callable[[Array], Array],
    ) -> SeenBlobs:
        """Those of hues that the glove wears."""
        if blobs is None or len(blobs) == 0:
            return SeenBlobs(np.zeros((0, 2)), np.zeros(0, np.int64), np.zeros(0, np.int64))
        hue = _numbers(hue_names, hues)[blobs.hue]
        keep = np.flatnonzero((hue >= 0) & np.isfinite(blobs.uv.sum(axis=1)))
        return SeenBlobs(rectify(blobs.uv[keep]), hue[keep], keep)


@lru_cache(maxsize=16)
def _numbers(hue_names: tuple[str, ...], hues: tuple[str, ...]) -> IntArray:
    """Row of each of ``hue_names`` in ``hues``, -1 where it is not there."""
    return np.array([hues.index(h) if h in hues else -1 for h in hue_names], np.int64)


def seen_blobs(frame: BlobFrame, rig: StereoRig, hues: tuple[str, ...]) -> tuple[SeenBlobs, ...]:
    """Left and right."""
    return (
        SeenBlobs.of(frame.left, frame.hue_names, hues, rig.left.rectify),
        SeenBlobs.of(frame.right, frame.hue_names, hues, rig.right.rectify),
    )


@dataclass(frozen=True, eq=False)
class Prediction:
    """Markers as the filter expects them; n of them may be seen.

    rows (n,) marker ids; p_C (M, 3); uv (2, M, 2) rectified; prior (2, M); and of the n rows
    H (n, 3, N), HP (n, 3, N), A (2, n, 2, 3) = d uv / d p_G, S (2, n, 2, 2) innovation covariance.
    """

    rows: IntArray
    uv: Array
    prior: Array
    H: Array
    HP: Array
    A: Array
    S: Array


class PixelModel:
    """Prediction and matching for one glove seen by one rig."""

    def __init__(self, layout: ChainLayout, rig: StereoRig, noise: NoiseParams) -> None:
        self._layout, self._rig, self._noise = layout, rig, noise
        self._shape = HandShape.of(layout.hand)
        self._segment = layout.glove.marker_segment(layout.hand)

    def predict(
        self,
        state: ChainState,
        pose: CameraPose,
        R_all: Array,
        p_all: Array,
    ) -> Prediction:
        """Where markers should be. R_all, p_all: poses of all hand segments, for occlusion."""
        lay, glove = self._layout, self._layout.glove
        p_G = marker_positions(state, lay)
        normal_G = turned(state.R_GB, lay.marker_segment, glove.marker_normal)
        p_C = (p_G - pose.p_GC) @ pose.R_GC
        uv = np.stack([self._rig.project(p_C), self._rig.project(p_C, right=True)])
        prior = visibility(self._shape, self._rig, pose, p_G, normal_G, self._segment, R_all, p_all)
        prior[np.isnan(uv[..., 0])] = 0.0
        rows = np.flatnonzero(np.maximum(*prior) > MIN_PRIOR)
        H = marker_jacobians(state, lay, rows)
        HP = times(H.reshape(-1, lay.size), state.P).reshape(H.shape)
        rig, noise = self._rig, self._noise
        A = pixel_jacobians(p_C[rows], pose.R_GC, rig.fx, rig.fy, rig.baseline)
        S = innovation_covariance(H, HP, A, noise.marker, noise.pixel_px)
        return Prediction(rows, uv, prior, H, HP, A, S)

    def match(self, prediction: Prediction, seen: tuple[SeenBlobs, ...]) -> IntArray:
        """(2, M) row of `seen` for each marker, -1 for none."""
        glove = self._layout.glove
        out = np.full((2, len(glove.markers)), -1, np.int64)
        rows = prediction.rows
        for c in range(2):
            found = assign_gated(
                seen[c].uv,
                seen[c].hue,
                prediction.uv[c, rows],
                prediction.S[c],
                glove.marker_hue[rows],
                prediction.prior[c, rows],
                _gate(prediction.S[c]),
            )
            out[c, rows] = found
        return out

    def rows(
        self, prediction: Prediction, seen: tuple[SeenBlobs, ...], match: IntArray
    ) -> tuple[Array, Array, Array, Array]:
        """Stacked H (m, N), HP (m, N), innovation (m,), noise (m, m) of all matched markers."""
        p, noise = prediction, self._noise
        residual = np.full((2, len(p.rows), 2), np.nan)
        for c in range(2):
            hit = np.flatnonzero(match[c, p.rows] >= 0)
            marker = p.rows[hit]
            residual[c, hit] = seen[c].uv[match[c, marker]] - p.uv[c, marker]
        return stack_rows(p.H, p.HP, p.A, residual, noise.marker, noise.pixel_px, noise.huber)


def _gate(S: Array) -> GateParams:
    """The cost of no match grows with the spread, or an unsure filter would match nothing."""
    if len(S) == 0:
        return GATE
    return GateParams(dummy_cost=GATE.dummy_cost + max(0.0, spread(S) - USUAL_SPREAD))
