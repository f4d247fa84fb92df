"""Which blob is which marker, near where the filter expects them or anywhere in the image.

What markers say of the state is in `pixels`; how a hand is found from nothing, in `start`.
"""

from __future__ import annotations

from dataclasses import dataclass
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
from tracker.fusion.chain.prediction import Prediction
from tracker.fusion.chain.reports import frame_result
from tracker.fusion.chain.state import ChainState
from tracker.fusion.chain.support import LIKELY, Evidence, evidence
from tracker.geometry import so3
from tracker.messages import Array, BlobFrame, CameraPose, FrameResult, IntArray, Tracking
from tracker.vision.correspondence import misfit
from tracker.vision.rig import StereoRig
from tracker.vision.stereo import StereoMatches, all_pairs


class LooseRows:
    """Rows of an update for one glove seen by one rig."""

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
        whose pose the markers (M,) matched in both images tell."""
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
        cov[~good] = np.eye(3)  # behind the camera: a metre of doubt
        return p_C @ pose.R_GC.T + pose.p_GC, cov


@record("chain.previous")
@dataclass(frozen=True, eq=False)
class PreviousPrediction:
    """Markers after the image at ``t`` (s) as the filter then had them."""

    t: float
    markers: Prediction

    def at(self, t: float, speed: float) -> Prediction:
        """The same positions, less certain by what a hand of ``speed`` m/s (sd) goes meanwhile."""
        gone = (speed * (t - self.t)) ** 2
        A = self.markers.A[:, self.markers.rows]
        S = self.markers.S + gone * A @ np.swapaxes(A, -1, -2)
        return self.markers._replace(S=np.ascontiguousarray(S))


FOLLOWED_PX = 4.0  # median, of one camera's blobs from where they were expected
EXPLAINED_SHARE = 0.4  # of one camera's blobs, that are the hand's where it is called measured
STRANGE_PX = 5.0  # the same of two cameras' blobs
STRANGE_SHARE = 0.2  # of blobs on a hand, that are no marker's, to those that are
NOBODY = -2  # whose blob one is that no marker is matched with


class SeenImage(NamedTuple):
    """An exposure: blobs of both sides in rectified pixels, and where the camera was."""

    frame: BlobFrame
    blobs: tuple[SeenBlobs, ...]
    pose: CameraPose

    @property
    def most_blobs(self) -> int:
        """In one of its sides."""
        return max(len(s.uv) for s in self.blobs)

    @property
    def is_mono(self) -> bool:
        """Only one camera sees anything."""
        return any(len(s.uv) == 0 for s in self.blobs)


class Recognised(NamedTuple):
    """Markers as they are expected, and match (2, M) the row of each one's blob, -1 for none."""

    prediction: Prediction
    match: IntArray

    @property
    def tally(self) -> Tally:
        """How many of how many."""
        return Tally.of(self.prediction, self.match)

    def nothing(self) -> Recognised:
        """The same expectation, with no blob recognised."""
        return self._replace(match=np.full_like(self.match, -1))

    @property
    def in_both(self) -> bool:
        """Whether some marker is seen by both cameras."""
        return bool(np.all(self.match >= 0, axis=0).any())


@record("chain.recognition")
@dataclass(eq=False)
class RecognitionKept:
    """All of the recognition that changes."""

    previous: PreviousPrediction | None = None  # only where correspondence is made from it


class Recognition:
    """For one glove seen by one rig."""

    def __init__(self, layout: ChainLayout, rig: StereoRig, params: ChainParams) -> None:
        self._layout, self._rig, self._params = layout, rig, params
        self._pixels = PixelModel(layout, rig, params.noise)
        self._loose = LooseRows(layout, rig, params.noise)
        self.digit = digit_of(layout)
        self.kept = RecognitionKept()

    def wear(self, gains: Array, lateral: Array) -> None:
        """From now on with a wearer's own synergies, as `Completion.wear`."""
        self._pixels.wear(gains, lateral)

    def image(self, frame: BlobFrame) -> SeenImage:
        """What of a frame can be the glove's."""
        blobs = seen_blobs(frame, self._rig, self._layout.glove.hues)
        return SeenImage(frame, blobs, frame.pose or self._rig.pose)

    def follow(self, state: ChainState, image: SeenImage) -> Recognised:
        """Blobs near where ``state`` expects markers, or where the last image left them."""
        prediction = self._pixels.predict(state, image.pose, image.frame.unhidden)
        compared, previous = prediction, self.kept.previous
        if previous is not None:
            compared = previous.at(image.frame.t, self._params.prior.velocity)
        return Recognised(prediction, self._pixels.match(compared, image.blobs))

    def look(self, state: ChainState, image: SeenImage) -> Recognised:
        """Blobs near where ``state`` expects markers, whatever was before."""
        prediction = self._pixels.predict(state, image.pose, image.frame.unhidden)
        return Recognised(prediction, self._pixels.match(prediction, image.blobs))

    def evidence(self, image: SeenImage, found: Recognised) -> Evidence:
        """How well the image supports what was expected."""
        left, right = image.blobs
        lay, digit = self._layout, self.digit
        of_marker, hue = digit[lay.marker_segment], lay.glove.marker_hue
        digits = int(digit.max(initial=-1)) + 1
        return Evidence(
            *evidence(found.prediction, found.match, left, right, hue, of_marker, digits)
        )

    def pairs(self, image: SeenImage) -> StereoMatches:
        """All stereo points that its blobs may be."""
        left, right = image.blobs
        return all_pairs(left.uv, left.hue, right.uv, right.hue, self._rig)

    def free_points(
        self, image: SeenImage, pairs: StereoMatches, found: Recognised, digit: int
    ) -> SeenPoints:
        """Those ``pairs`` of an image of whose blobs no marker but those of ``digit`` is matched
        with."""
        left, right = self._owners(image, found)
        ends = left[pairs.left_index], right[pairs.right_index]
        free = np.ones(len(pairs), bool)
        for owner in ends:
            free &= (owner == digit) | (owner == NOBODY)
        fresh = ((ends[0] == NOBODY) | (ends[1] == NOBODY))[free]
        p_G = pairs.p_C[free] @ image.pose.R_GC.T + image.pose.p_GC
        hue = image.blobs[0].hue[pairs.left_index[free]]
        return SeenPoints(p_G, hue, fresh, image.pose.p_GC)

    def _owners(self, image: SeenImage, found: Recognised) -> list[IntArray]:
        """Of each side's blobs the digit whose marker it is matched with, -1 for the root's."""
        digit, out = self.digit[self._layout.marker_segment], []
        for seen, match in zip(image.blobs, found.match, strict=True):
            owner = np.full(len(seen.uv), NOBODY)
            owner[match[match >= 0]] = digit[match >= 0]
            out.append(owner)
        return out

    def is_all_known(self, image: SeenImage, found: Recognised) -> bool:
        """Whether every blob is a marker's."""
        return not any(np.any(owner == NOBODY) for owner in self._owners(image, found))

    def misfit_px(self, image: SeenImage, found: Recognised) -> float:
        """Median distance of the recognised blobs from where they were expected."""
        left, right = image.blobs
        return misfit(left.uv, right.uv, found.match, found.prediction.uv)

    def is_unsure(self, image: SeenImage, found: Recognised) -> bool:
        """Whether markers were expected less surely than gates are made for, by the camera that
        sees something."""
        S = found.prediction.S[1 if len(image.blobs[0].uv) == 0 else 0]
        return len(S) > 0 and float(np.median(np.log(np.linalg.det(S)))) > USUAL_LN_DET

    def is_likely(self, image: SeenImage, found: Recognised, seen: Evidence, is_sure: bool) -> bool:
        """Whether an image supports the hand so well that it may be called measured; ``is_sure``:
        whether it is already. Two cameras are asked no more than a part of the markers.

        One camera tells distance by how far markers are apart, posture and size taken for granted:
        while these do not fit, distance and its speed are wrong by more than the filter believes,
        so its blobs must be where they were expected. And a hand that leaves most of the image's
        blobs to no marker, and finds fewer of its markers than a start asks for, is there by
        chance.
        """
        if not image.is_mono:
            return seen.is_likely
        explains = is_sure or seen.matched >= EXPLAINED_SHARE * image.most_blobs or seen.is_start
        return seen.is_likely and explains and self.misfit_px(image, found) <= FOLLOWED_PX

    def is_followed(self, image: SeenImage, found: Recognised) -> bool:
        """Whether two cameras' recognised blobs are where they were expected, or the blobs on the
        hand are recognised.

        A hand that is another than it seems, as where hues are exchanged, is dragged along by some
        of its blobs, and does not explain the others.
        """
        misfit_px = self.misfit_px(image, found)
        return misfit_px <= STRANGE_PX or self._strangers(image, found) <= STRANGE_SHARE

    def _strangers(self, image: SeenImage, found: Recognised) -> float:
        """Blobs on the hand that are no marker's, for each that is one."""
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
        """What the recognised blobs say of ``state``."""
        if self._params.coupling == "loose":
            return self._loose(state, found.prediction, image.blobs, found.match, image.pose)
        return self._pixels.rows(found.prediction, image.blobs, found.match)

    def finish(
        self, state: ChainState, image: SeenImage, found: Recognised, tracking: Tracking
    ) -> FrameResult:
        """After the image has corrected ``state``: remember it if need be, and report it."""
        frame = image.frame
        if self._params.guide == "previous":
            self.kept.previous = PreviousPrediction(
                frame.t, self._pixels.predict(state, image.pose)
            )
        return frame_result(frame, self._rig, tracking, found.prediction, image.blobs, found.match)
