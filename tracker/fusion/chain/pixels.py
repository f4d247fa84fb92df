"""Markers in the two images: prediction, correspondence, and the stacked pixel update.

A marker seen by one camera contributes two rows, one seen by both three (`pixel_rows`). Equation
numbers are those of docs/chain.md.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from tracker.fusion.chain.kinematics import marker_points
from tracker.fusion.chain.layout import ChainLayout, digit_of
from tracker.fusion.chain.params import NoiseParams
from tracker.fusion.chain.pixel_rows import point_rows
from tracker.fusion.chain.prediction import PosedRig, Prediction, expected, pixel_jacobians, viewed
from tracker.fusion.chain.row_exposure import (
    RowExposure,
    exposed,
    marker_velocities,
    with_velocity,
)
from tracker.fusion.chain.stamp_noise import StampNoise, common_noise, widened
from tracker.fusion.chain.state import ChainState
from tracker.fusion.output.completion import Completion
from tracker.kernels import kernel
from tracker.kernels.arrays import IntMatrix, IntVector, Matrix, Stack, Vector
from tracker.messages import Array, BlobFrame, Blobs, CameraPose, IntArray
from tracker.vision.colours import hue_rows
from tracker.vision.correspondence import ExpectedPixels, GateParams, assigned
from tracker.vision.cpd import HuedPixels
from tracker.vision.rig import StereoRig
from tracker.vision.visibility import HandShape, MarkerRows, PosedHand, visibility_at

GATE = GateParams()
GATE_SQUARED, GATE_PX = GATE.gate, GATE.gate_px
ALONE, LEAST_PRIOR = GATE.dummy_cost, GATE.min_prior
RIVAL, DISPUTED = 0.01, 2.0  # minimum prior of another marker, and limit on its larger cost
USUAL_LN_DET = 10.0  # of an innovation covariance in px⁴, for which the default gate is designed


class SeenBlobs(NamedTuple):
    """Blobs of one image in rectified pixels uv (n, 2), hue (n,) numbered as in the glove."""

    uv: Matrix
    hue: IntVector
    source: IntVector  # (n,) row in the original message

    @staticmethod
    def of(
        blobs: Blobs | None,
        hue_names: tuple[str, ...],
        hues: tuple[str, ...],
        rectify: Callable[[Array], Array],
    ) -> SeenBlobs:
        """Keeps the blobs whose hue is in the glove."""
        if blobs is None or len(blobs) == 0:
            return SeenBlobs(np.zeros((0, 2)), np.zeros(0, np.int64), np.zeros(0, np.int64))
        number = hue_rows(hue_names, hues).copy()
        uv, hue, keep = worn(np.array(blobs.uv), np.array(blobs.hue), number)
        return SeenBlobs(rectify(uv), hue, keep)


def seen_blobs(frame: BlobFrame, rig: StereoRig, hues: tuple[str, ...]) -> tuple[SeenBlobs, ...]:
    """The left and right image."""
    return (
        SeenBlobs.of(frame.left, frame.hue_names, hues, rig.left.rectify),
        SeenBlobs.of(frame.right, frame.hue_names, hues, rig.right.rectify),
    )


class Tally(NamedTuple):
    """Number of markers ``matched`` in at least one camera; ``expected`` is the sum of the
    priors."""

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
        self._digit = digit_of(layout)[layout.marker_segment]
        self._complete = Completion(layout)

    def wear(self, gains: Array, lateral: Array) -> None:
        """Sets a wearer's own synergies, as `Completion.wear`."""
        self._complete.wear(gains, lateral)

    def predict(
        self,
        state: ChainState,
        pose: CameraPose,
        unhidden: Array | None = None,
        exposure: RowExposure | None = None,
        stamp: StampNoise | None = None,
    ) -> Prediction:
        """Predicts the markers in the images; ``unhidden`` as in a `BlobFrame`, ``exposure`` for a
        camera with a rolling shutter, ``stamp`` of `stamp_noise`."""
        lay, rig, noise = self._layout, self._rig, self._noise.pixel
        view, markers, body = PosedRig.of(rig, pose), marker_points(state, lay), state.body
        p_GB, p_G, normal_G, p_C, uv = viewed(
            lay.skeleton, body, state.p, markers, lay.glove.marker_normal, view
        )
        delay = None
        if exposure is not None:
            v_C = marker_velocities(state, lay, markers, exposure, view)
            uv, p_C, delay = exposed(p_C, v_C, uv, rig)
        R_all, p_all, *_ = self._complete(state.R_GB, p_GB, state.scale3())
        seen = MarkerRows(p_G, normal_G, self._segment)
        prior = visibility_at(uv, PosedHand(self._shape, R_all, p_all), seen, rig, pose)
        if unhidden is not None:
            prior *= unhidden
        A = pixel_jacobians(p_C, view)
        rows, H, HP, cov, S = expected(
            lay.skeleton, lay.blocks, body, markers, state.P, prior, A, noise
        )
        found = Prediction(rows, uv, prior, H, HP, cov, A, S)
        if delay is not None:
            with_velocity(found, delay, state.P, noise.pixel_px)
        if stamp is not None:
            widened(found, stamp, noise.pixel_px)
        return found

    def stamp_noise(
        self, state: ChainState, pose: CameraPose, moving: RowExposure | None, sd: float
    ) -> StampNoise | None:
        """Of an image whose stamp has the standard deviation ``sd`` s; None where nothing is
        ``moving``."""
        if moving is None:
            return None
        lay, view = self._layout, PosedRig.of(self._rig, pose)
        v_C = marker_velocities(state, lay, marker_points(state, lay), moving, view)
        return StampNoise(sd, np.ascontiguousarray(v_C @ pose.R_GC.T))

    def row_shift(
        self, state: ChainState, pose: CameraPose, exposure: RowExposure | None
    ) -> Array | None:
        """(2, M, 2) rectified px from where markers are at the image's instant to where they are
        when their rows are exposed; None of a global shutter."""
        if exposure is None:
            return None
        lay, rig = self._layout, self._rig
        view, markers = PosedRig.of(rig, pose), marker_points(state, lay)
        *_, p_C, uv = viewed(
            lay.skeleton, state.body, state.p, markers, lay.glove.marker_normal, view
        )
        v_C = marker_velocities(state, lay, markers, exposure, view)
        return exposed(p_C, v_C, uv, rig).uv - uv

    def match(self, prediction: Prediction, seen: tuple[SeenBlobs, ...]) -> IntArray:
        """(2, M) row of `seen` for each marker, -1 for none."""
        left, right = seen
        return matched(prediction, left, right, self._layout.glove.marker_hue, self._digit)

    def rows(
        self,
        prediction: Prediction,
        seen: tuple[SeenBlobs, ...],
        match: IntArray,
        stamp: StampNoise | None = None,
    ) -> tuple[Array, Array, Array, Array]:
        """Stacked H (m, N), HP (m, N), innovation (m,), noise (m, m) of all matched markers."""
        left, right = seen
        H, HP, r, R = point_rows(prediction, match, left.uv, right.uv, self._noise.pixel)
        if stamp is not None:
            R += common_noise(prediction, match, stamp, len(r))
        return H, HP, r, R


@kernel(nogil=False)
def worn(uv: Matrix, hue: IntVector, number: IntVector) -> tuple[Matrix, IntVector, IntVector]:
    """uv, hue and row of the blobs uv (n, 2) px, hue (n,) that are finite and have a number >= 0.

    ``number`` (k,) is the glove's number for each hue.
    """
    keep, count = np.empty(len(uv), np.int64), 0
    for i in range(len(uv)):
        known = 0 <= hue[i] < len(number) and number[hue[i]] >= 0
        if known and np.isfinite(uv[i, 0] + uv[i, 1]):
            keep[count] = i
            count += 1
    rows = keep[:count].copy()
    return uv[rows], number[hue[rows]], rows


@kernel(nogil=False)
def counted(match: IntMatrix, prior: Matrix) -> tuple[int, float]:
    """Number of markers of match (2, M) seen by any camera; the sum of the larger of its priors
    (2, M)."""
    either, expected = 0, 0.0
    for j in range(match.shape[1]):
        either += match[0, j] >= 0 or match[1, j] >= 0
        expected += max(prior[0, j], prior[1, j])
    return either, expected


@kernel(nogil=False)
def matched(
    prediction: Prediction,
    left: SeenBlobs,
    right: SeenBlobs,
    marker_hue: IntVector,
    marker_digit: IntVector,
) -> IntMatrix:
    """(2, M) row of the blobs of left and right for each marker, -1 for none; marker_digit (M,).

    Limits as in `tracker.vision.correspondence.GateParams`; costs as in eq. 23. The cost of leaving
    a marker unmatched grows with the innovation covariance, or a filter with a large covariance
    would match nothing. A blob that is equally close to another digit's marker is not used, except
    with a large covariance.
    """
    rows, S = prediction.rows, prediction.S
    digit = marker_digit[rows]
    out = np.full((2, prediction.uv.shape[1]), -1)
    for c in range(2):
        blobs = HuedPixels(right.uv, right.hue) if c else HuedPixels(left.uv, left.hue)
        if len(blobs.uv) == 0 or len(rows) == 0:
            continue
        prior = np.maximum(prediction.prior[c][rows], LEAST_PRIOR)
        markers = ExpectedPixels(prediction.uv[c][rows], S[c], marker_hue[rows], prior)
        unsure = max(0.0, median_ln_det(S[c]) - USUAL_LN_DET)
        found = assigned(blobs, markers, GATE_SQUARED, GATE_PX, ALONE + unsure)  # eq. 24
        for i in range(len(rows)):
            disputed = unsure == 0.0 and _is_disputed(i, found, blobs.uv, markers, digit)
            if found[i] >= 0 and not disputed:
                out[c, rows[i]] = found[i]
    return out


@kernel
def _is_disputed(
    i: int, found: IntVector, uv: Matrix, markers: ExpectedPixels, digit: IntVector
) -> bool:
    """Whether the blob of marker ``i`` would fit an unmatched marker of another digit equally well,
    if both were visible: the occlusion order of a bent hand is not observable at this scale."""
    if found[i] < 0:
        return False
    own = _distance(uv[found[i]], markers.uv[i], markers.S[i])
    for k in range(len(found)):
        rival = found[k] < 0 and markers.prior[k] >= RIVAL and digit[k] != digit[i]
        if (
            rival
            and markers.hue[k] == markers.hue[i]
            and _distance(uv[found[i]], markers.uv[k], markers.S[k]) < own + DISPUTED
        ):
            return True
    return False


@kernel
def _distance(uv: Vector, expected: Vector, S: Matrix) -> float:
    """Mahalanobis² + ln det S between a blob and a marker (2,) px each."""
    a, b, c = S[0, 0], S[0, 1], S[1, 1]
    det = a * c - b * b
    du, dv = uv[0] - expected[0], uv[1] - expected[1]
    return float((c * du * du - 2.0 * b * du * dv + a * dv * dv) / det + np.log(det))


@kernel
def median_ln_det(S: Stack) -> float:
    """Median of ln det of S (n, 2, 2) px²."""
    out = np.empty(len(S))
    for k in range(len(S)):
        out[k] = np.log(S[k, 0, 0] * S[k, 1, 1] - S[k, 0, 1] * S[k, 1, 0])
    return float(np.median(out))
