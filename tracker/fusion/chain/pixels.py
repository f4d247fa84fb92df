"""Markers in the two images: prediction, correspondence, and the stacked pixel update.

A marker's placement error is common to both images: the noise of a stereo pair is
A A^T s_m² + I s_px² with A = [Pi_L; Pi_R] R_CG. Treating it as independent pixel noise would throw
the depth away. A marker that one camera sees gives two rows, one that both see gives four.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import NoiseParams
from tracker.fusion.chain.pixels_kernel import (
    counted,
    expected,
    marker_places,
    matched,
    pixel_jacobians,
    point_rows,
    worn,
)
from tracker.fusion.chain.state import ChainState
from tracker.fusion.output.completion import Completion
from tracker.messages import Array, BlobFrame, Blobs, CameraPose, IntArray
from tracker.vision.colours import hue_rows
from tracker.vision.correspondence import GateParams
from tracker.vision.rig import StereoRig
from tracker.vision.visibility import HandShape, MarkerRows, PosedHand, visibility_at

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
        uv, hue, keep = worn(blobs.uv, blobs.hue, hue_rows(hue_names, hues))
        return SeenBlobs(rectify(uv), hue, keep)


def seen_blobs(frame: BlobFrame, rig: StereoRig, hues: tuple[str, ...]) -> tuple[SeenBlobs, ...]:
    """Left and right."""
    return (
        SeenBlobs.of(frame.left, frame.hue_names, hues, rig.left.rectify),
        SeenBlobs.of(frame.right, frame.hue_names, hues, rig.right.rectify),
    )


@dataclass(frozen=True, eq=False)
class Prediction:
    """Markers as the filter expects them; n of them may be seen.

    rows (n,) marker ids; uv (2, M, 2) rectified; prior (2, M); A (2, M, 2, 3) = d uv / d p_G; and
    of the n rows H, HP (n, 3, N), cov (n, 3, 3) m² in G with the placement's, and the innovation
    covariance S (2, n, 2, 2) px².
    """

    rows: IntArray
    uv: Array
    prior: Array
    H: Array
    HP: Array
    cov: Array
    A: Array
    S: Array


class Tally(NamedTuple):
    """How many markers are ``matched`` in at least one lens; ``expected`` is the priors' sum."""

    matched: int
    expected: float

    @staticmethod
    def of(prediction: Prediction, match: IntArray) -> Tally:
        return Tally(*counted(match, prediction.prior))


class PixelModel:
    """Prediction and matching for one glove seen by one rig."""

    def __init__(self, layout: ChainLayout, rig: StereoRig, noise: NoiseParams) -> None:
        self._layout, self._rig, self._noise = layout, rig, noise
        self._shape = HandShape.of(layout.hand)
        self._segment = layout.glove.marker_segment(layout.hand)
        self._complete = Completion(layout)

    def predict(self, state: ChainState, pose: CameraPose) -> Prediction:
        """Where markers should be."""
        lay, glove, rig, noise = self._layout, self._layout.glove, self._rig, self._noise
        tree = lay.parent, lay.origin, lay.base_of, lay.root_lever
        body = *tree, state.joint, state.scale, state.R_GB
        marker = lay.marker_segment, glove.marker_position
        p_GB, p_G, normal_G, p_C, uv = marker_places(
            *body, state.p, *marker, glove.marker_normal, state.marker,
            pose.R_GC, pose.p_GC, rig.fx, rig.fy, rig.cx, rig.cy, rig.baseline,
        )  # fmt: skip
        R_all, p_all, *_ = self._complete(state.R_GB, p_GB, state.scale3())
        markers = MarkerRows(p_G, normal_G, self._segment)
        prior = visibility_at(uv, PosedHand(self._shape, R_all, p_all), markers, rig, pose)
        A = pixel_jacobians(p_C, pose.R_GC, rig.fx, rig.fy, rig.baseline)
        rows, H, HP, cov, S = expected(
            *body, *marker, state.marker, lay.theta, lay.scale, lay.joint, lay.marker,
            state.P, prior, MIN_PRIOR, A, noise.marker, noise.pixel_px,
        )  # fmt: skip
        return Prediction(rows, uv, prior, H, HP, cov, A, S)

    def match(self, prediction: Prediction, seen: tuple[SeenBlobs, ...]) -> IntArray:
        """(2, M) row of `seen` for each marker, -1 for none."""
        left, right = seen
        return matched(
            left.uv, left.hue, right.uv, right.hue,
            prediction.uv, prediction.rows, prediction.S, self._layout.glove.marker_hue,
            prediction.prior, GATE.gate, GATE.gate_px, GATE.dummy_cost, GATE.min_prior,
            USUAL_SPREAD,
        )  # fmt: skip

    def rows(
        self, prediction: Prediction, seen: tuple[SeenBlobs, ...], match: IntArray
    ) -> tuple[Array, Array, Array, Array]:
        """Stacked H (m, N), HP (m, N), innovation (m,), noise (m, m) of all matched markers."""
        p, noise = prediction, self._noise
        return point_rows(
            p.H, p.HP, p.cov, p.A, p.rows, p.uv, match, seen[0].uv, seen[1].uv,
            noise.marker, noise.pixel_px, noise.huber,
        )  # fmt: skip
