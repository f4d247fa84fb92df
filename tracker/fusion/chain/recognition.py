"""Matches blobs to markers, near the prediction or anywhere in the image.

The measurement rows are in `pixels`; how a hand is found without a prior, in `start`.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from scipy.linalg import block_diag

from tracker.base.records import record
from tracker.fusion.ablations.segment_pose import by_segment, fit_pose, softened, stereo_covariance
from tracker.fusion.chain.digits import SeenPoints
from tracker.fusion.chain.filter import Rows
from tracker.fusion.chain.kinematics import marker_positions
from tracker.fusion.chain.layout import ChainLayout, digit_of
from tracker.fusion.chain.params import ChainParams, NoiseParams
from tracker.fusion.chain.pixels import USUAL_LN_DET, PixelModel, SeenBlobs, Tally, seen_blobs
from tracker.fusion.chain.prediction import PosedRig, Prediction
from tracker.fusion.chain.reports import frame_result
from tracker.fusion.chain.row_exposure import RowExposure, root_velocities
from tracker.fusion.chain.stamp_noise import StampNoise
from tracker.fusion.chain.state import ChainState
from tracker.fusion.chain.support import LIKELY, Evidence, evidence
from tracker.fusion.time.imu_buffer import ImuBuffer
from tracker.geometry import so3
from tracker.messages import Array, BlobFrame, CameraPose, FrameResult, IntArray, Tracking
from tracker.vision.correspondence import misfit
from tracker.vision.rig import StereoRig
from tracker.vision.stereo import StereoMatches, all_pairs


class LooseRows:
    """Update rows of loose coupling for one glove seen by one rig."""

    def __init__(self, layout: ChainLayout, rig: StereoRig, noise: NoiseParams) -> None:
        self._layout, self._rig, self._noise = layout, rig, noise

    def __call__(
        self,
        state: ChainState,
        prediction: Prediction,
        seen: tuple[SeenBlobs, ...],
        match: IntArray,
        pose: CameraPose,
    ) -> tuple[Array, Array, Array, Array]:
        """H (6 s, N), HP (6 s, N), innovation (6 s,) m and rad, noise (6 s, 6 s) of the s segments
        whose pose is determined by the markers (M,) matched in both images."""
        lay, N = self._layout, self._layout.blocks.size
        H, HP, r, R = [np.zeros((0, N))], [np.zeros((0, N))], [np.zeros(0)], [np.zeros((0, 0))]
        both = np.flatnonzero(np.all(match[:, prediction.rows] >= 0, axis=0))
        marker = prediction.rows[both]
        p_G, cov = self._stereo(seen, match[:, marker], pose)
        model_G = marker_positions(state, lay)[marker]
        for segment, rows in by_segment(lay.marker_segment[marker]):
            shape = model_G[rows] @ state.R_GB[segment]
            there = fit_pose(shape, p_G[rows], cov[rows])
            if there is None:
                continue
            H_s = np.zeros((6, N))
            H_s[:3] = prediction.H[both[rows]].mean(axis=0)
            H_s[3:, lay.blocks.theta + 3 * segment : lay.blocks.theta + 3 * segment + 3] = np.eye(3)
            rotation = so3.log(state.R_GB[segment].T @ there.R_GB)
            r_s = np.concatenate([there.centre_G - model_G[rows].mean(axis=0), rotation])
            HP_s = H_s @ state.P
            H.append(H_s)
            HP.append(HP_s)
            r.append(r_s)
            R.append(softened(there.cov, r_s, HP_s @ H_s.T, self._noise.huber))
        return np.concatenate(H), np.concatenate(HP), np.concatenate(r), block_diag(*R)

    def _stereo(
        self, seen: tuple[SeenBlobs, ...], match: IntArray, pose: CameraPose
    ) -> tuple[Array, Array]:
        """p_G (k, 3) m and covariance (k, 3, 3) m² of markers matched (2, k) in both images."""
        p_C = self._rig.triangulate(seen[0].uv[match[0]], seen[1].uv[match[1]])
        good = np.isfinite(p_C[:, 2])
        p_C[~good] = (0.0, 0.0, 1.0)
        cov = stereo_covariance(self._rig, p_C, pose.R_GC, self._noise.pixel_px, self._noise.marker)
        cov[~good] = np.eye(3)  # behind the camera: sd of 1 m
        return p_C @ pose.R_GC.T + pose.p_GC, cov


@record("chain.previous")
@dataclass(frozen=True, eq=False)
class PreviousPrediction:
    """Markers as estimated after the image at ``t`` (s)."""

    t: float
    markers: Prediction

    def at(self, t: float, speed: float) -> Prediction:
        """The same positions, with the variance of a hand's motion since, at ``speed`` m/s (sd)."""
        gone = (speed * (t - self.t)) ** 2
        A = self.markers.A[:, self.markers.rows]
        S = self.markers.S + gone * A @ np.swapaxes(A, -1, -2)
        return self.markers._replace(S=np.ascontiguousarray(S))


FOLLOWED_PX = 4.0  # median residual of one camera's blobs
EXPLAINED_SHARE = 0.4  # of one camera's blobs matched, for a measured hand
STRANGE_PX = 5.0  # the same for the blobs of two cameras
STRANGE_SHARE = 0.2  # ratio of unmatched blobs on a hand to matched ones
STRANGE_START = 0.25  # the same, above which a hand that was just found is not measured
UNMATCHED = -2  # owner of a blob without a marker
FEW_SHARE = 0.8  # of the expected markers, below which hues may be exchanged
VISIBLE = 0.5  # prior of a marker at which a blob of any hue is looked for
AT_MARKER_PX = 10.0  # maximum distance of that blob


class SeenImage(NamedTuple):
    """An exposure: blobs of both sides in rectified pixels, and the camera pose; the motion during
    the exposure of a rolling shutter, and the blobs without the camera's rotation during it."""

    frame: BlobFrame
    blobs: tuple[SeenBlobs, ...]
    pose: CameraPose
    exposure: RowExposure | None
    unturned: tuple[SeenBlobs, ...]
    moving: RowExposure | None = None  # while the image's instant is uncertain

    @property
    def most_blobs(self) -> int:
        """Number of blobs in the side with more of them."""
        return max(len(s.uv) for s in self.blobs)

    @property
    def is_mono(self) -> bool:
        """Whether only one camera sees any blobs."""
        return any(len(s.uv) == 0 for s in self.blobs)


class Recognised(NamedTuple):
    """The predicted markers, and match (2, M) the row of each marker's blob, -1 for none.

    ``shift`` (3,) m in G: the prediction is that of the hand moved by it; the covariance and what
    the rows correct are those of the hand before.
    """

    prediction: Prediction
    match: IntArray
    shift: Array | None = None

    @property
    def tally(self) -> Tally:
        """Matched and expected markers."""
        return Tally.of(self.prediction, self.match)

    def nothing(self) -> Recognised:
        """The same prediction, with no matches."""
        return self._replace(match=np.full_like(self.match, -1))

    @property
    def in_both(self) -> bool:
        """Whether any marker is matched in both cameras."""
        return bool(np.all(self.match >= 0, axis=0).any())

    def misfit_px(self, image: SeenImage) -> float:
        """Median distance of the matched blobs from their predictions."""
        left, right = image.blobs
        return misfit(left.uv, right.uv, self.match, self.prediction.uv)

    def is_unsure(self, image: SeenImage) -> bool:
        """Whether the innovation covariance exceeds the one the gates are designed for, in the
        camera that sees anything."""
        S = self.prediction.S[1 if len(image.blobs[0].uv) == 0 else 0]
        return len(S) > 0 and float(np.median(np.log(np.linalg.det(S)))) > USUAL_LN_DET


@record("chain.recognition")
@dataclass(eq=False)
class RecognitionSavedState:
    """The part of the recognition that changes."""

    previous: PreviousPrediction | None = None  # only where correspondence is based on it


class Recognition:
    """For one glove seen by one rig."""

    def __init__(
        self,
        layout: ChainLayout,
        rig: StereoRig,
        params: ChainParams,
        buffer: ImuBuffer | None = None,
    ) -> None:
        """``buffer`` is what a camera with a rolling shutter reads rates from."""
        self._layout, self._rig, self._params = layout, rig, params
        self._buffer = buffer or ImuBuffer(len(layout.glove.imus))
        self._pixels = PixelModel(layout, rig, params.noise)
        self._loose = LooseRows(layout, rig, params.noise)
        self.digit = digit_of(layout)
        self.saved = RecognitionSavedState()

    def wear(self, gains: Array, lateral: Array) -> None:
        """Sets a wearer's own synergies, as `Completion.wear`."""
        self._pixels.wear(gains, lateral)

    def image(self, frame: BlobFrame) -> SeenImage:
        """The blobs of a frame whose hue is in the glove."""
        blobs = seen_blobs(frame, self._rig, self._layout.glove.hues)
        pose, rig = frame.pose or self._rig.pose, self._rig
        exposure, unturned = RowExposure.of(frame, rig, self._buffer), blobs
        if exposure is not None:
            left, right = (
                side._replace(uv=exposure.turned_back(side.uv, bool(c), rig, pose))
                for c, side in enumerate(blobs)
            )
            unturned = left, right
        moving = RowExposure.of_stamp(frame, self._buffer)
        return SeenImage(frame, blobs, pose, exposure, unturned, moving)

    def _predict(self, state: ChainState, image: SeenImage) -> Prediction:
        stamp, unhidden = self._stamp(state, image), image.frame.unhidden
        return self._pixels.predict(state, image.pose, unhidden, image.exposure, stamp)

    def _stamp(self, state: ChainState, image: SeenImage) -> StampNoise | None:
        return self._pixels.stamp_noise(state, image.pose, image.moving, image.frame.stamp_sd)

    def follow(self, state: ChainState, image: SeenImage) -> Recognised:
        """Matches blobs near the markers predicted by ``state``, or near those of the previous
        image."""
        prediction = self._predict(state, image)
        compared, previous = prediction, self.saved.previous
        if previous is not None:
            compared = previous.at(image.frame.t, self._params.prior.velocity)
        return Recognised(prediction, self._pixels.match(compared, image.blobs))

    def look(self, state: ChainState, image: SeenImage) -> Recognised:
        """Matches blobs near the markers predicted by ``state``, independent of earlier images."""
        prediction = self._predict(state, image)
        return Recognised(prediction, self._pixels.match(prediction, image.blobs))

    def evidence(self, image: SeenImage, found: Recognised) -> Evidence:
        """How well the image supports the prediction."""
        left, right = image.blobs
        lay, digit = self._layout, self.digit
        of_marker, hue = digit[lay.marker_segment], lay.glove.marker_hue
        digits = int(digit.max(initial=-1)) + 1
        return Evidence(
            *evidence(found.prediction, found.match, left, right, hue, of_marker, digits)
        )

    def pairs(self, state: ChainState, image: SeenImage) -> StereoMatches:
        """All stereo points that blob pairs may form. For a rolling shutter, they are moved to the
        image's instant with the velocity of the root of ``state``."""
        left, right = image.blobs
        pairs = all_pairs(left.uv, left.hue, right.uv, right.hue, self._rig)
        if image.exposure is None:
            return pairs
        uv = np.stack([left.uv[pairs.left_index], right.uv[pairs.right_index]])
        view = PosedRig.of(self._rig, image.pose)
        v_C = root_velocities(state, self._layout, pairs.p_C, image.exposure, view)
        delay = self._rig.row_delays(uv).mean(axis=0)
        return replace(pairs, p_C=pairs.p_C - delay[:, None] * v_C)

    def free_points(
        self, image: SeenImage, pairs: StereoMatches, found: Recognised, digit: int
    ) -> SeenPoints:
        """Those ``pairs`` of an image whose blobs are not matched with a marker outside
        ``digit``."""
        left, right = self._owners(image, found)
        ends = left[pairs.left_index], right[pairs.right_index]
        free = np.ones(len(pairs), bool)
        for owner in ends:
            free &= (owner == digit) | (owner == UNMATCHED)
        fresh = ((ends[0] == UNMATCHED) | (ends[1] == UNMATCHED))[free]
        p_G = pairs.p_C[free] @ image.pose.R_GC.T + image.pose.p_GC
        hue = image.blobs[0].hue[pairs.left_index[free]]
        return SeenPoints(p_G, hue, fresh, image.pose.p_GC)

    def _owners(self, image: SeenImage, found: Recognised) -> list[IntArray]:
        """For each side's blobs, the digit of the matched marker, -1 for the root's."""
        digit, out = self.digit[self._layout.marker_segment], []
        for seen, match in zip(image.blobs, found.match, strict=True):
            owner = np.full(len(seen.uv), UNMATCHED)
            owner[match[match >= 0]] = digit[match >= 0]
            out.append(owner)
        return out

    def is_all_known(self, image: SeenImage, found: Recognised) -> bool:
        """Whether every blob is matched."""
        return not any(np.any(owner == UNMATCHED) for owner in self._owners(image, found))

    def is_likely(self, image: SeenImage, found: Recognised, seen: Evidence, is_sure: bool) -> bool:
        """Whether an image supports the hand well enough for the state MEASURED; ``is_sure``:
        whether it has that state already. With two cameras, a share of the markers is required;
        and until the hand is sure, few other blobs on it, as a wrong hand at the blobs of another
        one has.

        One camera measures distance by the spacing of markers, given posture and size: while these
        are wrong, the errors of distance and its rate exceed the covariance, so its residuals must
        be small. And a hand that leaves most of the image's blobs unmatched, and has fewer matches
        than a start requires, is a chance match.
        """
        if not image.is_mono:
            own = is_sure or self._strangers(image, found) <= STRANGE_START
            return seen.is_likely and own
        explains = is_sure or seen.matched >= EXPLAINED_SHARE * image.most_blobs or seen.is_start
        return seen.is_likely and explains and found.misfit_px(image) <= FOLLOWED_PX

    def is_followed(self, image: SeenImage, found: Recognised) -> bool:
        """Whether two cameras' matched blobs are near their predictions, or the blobs on the hand
        are matched.

        A wrong hand, for instance with exchanged hues, is pulled along by some of its blobs, and
        leaves the others unmatched.
        """
        misfit_px = found.misfit_px(image)
        return misfit_px <= STRANGE_PX or self._strangers(image, found) <= STRANGE_SHARE

    def _strangers(self, image: SeenImage, found: Recognised) -> float:
        """Ratio of unmatched blobs on the hand to matched ones."""
        own = others = 0
        prediction = found.prediction
        for c, (side, match) in enumerate(zip(image.blobs, found.match, strict=True)):
            uv = prediction.uv[c][prediction.prior[c] >= LIKELY]
            if len(uv) == 0:
                continue
            on = np.all((side.uv >= uv.min(axis=0)) & (side.uv <= uv.max(axis=0)), axis=1)
            matched = match[match >= 0]
            on[matched] = False
            own, others = own + len(matched), others + int(np.count_nonzero(on))
        return others / max(own, 1)

    def rows(self, state: ChainState, image: SeenImage, found: Recognised) -> Rows:
        """Measurement rows of the matched blobs for ``state``."""
        if self._params.coupling == "loose":
            return self._loose(state, found.prediction, image.blobs, found.match, image.pose)
        stamp = self._stamp(state, image)
        H, HP, r, R = self._pixels.rows(found.prediction, image.blobs, found.match, stamp)
        if found.shift is not None:
            r = r + H[:, :3] @ found.shift
        return H, HP, r, R

    def finish(
        self, state: ChainState, image: SeenImage, found: Recognised, tracking: Tracking
    ) -> FrameResult:
        """After the image has corrected ``state``: store it if required, and report it."""
        frame = image.frame
        if self._params.guide == "previous":
            self.saved.previous = PreviousPrediction(
                frame.t, self._pixels.predict(state, image.pose, exposure=image.exposure)
            )
        result = frame_result(
            frame, self._rig, tracking, found.prediction, image.blobs, found.match
        )
        if tracking == Tracking.TRACKING and _misses_many(found.tally):
            result = replace(result, hues=self._hues(image, found))
        shift = self._pixels.row_shift(state, image.pose, image.exposure)
        return result if shift is None else replace(result, row_shift=shift)

    def _hues(self, image: SeenImage, found: Recognised) -> Array:
        """(h, h): see `FrameResult`."""
        glove, prediction = self._layout.glove, found.prediction
        out = np.zeros((len(glove.hues), len(glove.hues)))
        for c, side in enumerate(image.blobs):
            markers = np.flatnonzero(prediction.prior[c] >= VISIBLE)
            if not len(markers) or not len(side.uv):
                continue
            apart = np.linalg.norm(prediction.uv[c][markers, None] - side.uv, axis=2)
            nearest, near = apart.argmin(axis=1), apart.min(axis=1) <= AT_MARKER_PX
            np.add.at(out, (glove.marker_hue[markers[near]], side.hue[nearest[near]]), 1.0)
        return out

    def at_once(self, state: ChainState, image: SeenImage, found: Recognised) -> SeenImage:
        """The image with recognised blobs where they would be, had all rows been exposed at the
        image's own instant."""
        shift = self._pixels.row_shift(state, image.pose, image.exposure)
        if shift is None:
            return image
        sides = []
        for c, side in enumerate(image.blobs):
            uv, marker = side.uv.copy(), np.flatnonzero(found.match[c] >= 0)
            uv[found.match[c, marker]] -= shift[c, marker]
            sides.append(side._replace(uv=uv))
        return image._replace(blobs=(sides[0], sides[1]), exposure=None)


def _misses_many(tally: Tally) -> bool:
    return tally.matched < FEW_SHARE * tally.expected
