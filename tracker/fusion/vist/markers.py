"""Stereo points and their matching with markers: the paper's visual pipeline (eqs. 1 to 6, 10)."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from tracker.base.records import record
from tracker.fusion.ablations.segment_pose import stereo_covariance
from tracker.fusion.chain.pixels import SeenBlobs
from tracker.fusion.chain.row_exposure import RowExposure, exposed
from tracker.fusion.output.completion import Completion
from tracker.fusion.vist.layout import V, VistLayout
from tracker.fusion.vist.params import VistMatch, VistNoise
from tracker.fusion.vist.points import jacobians, own_covariance, positions
from tracker.fusion.vist.state import VistState
from tracker.messages import Array, CameraPose, IntArray
from tracker.vision.correspondence import match_translation
from tracker.vision.rig import StereoRig
from tracker.vision.stereo import match_stereo
from tracker.vision.visibility import (
    HandShape,
    MarkerRows,
    PosedHand,
    both_cameras,
    seen_from,
    visibility,
)


@record("vist.prediction", shapes={"p_G": "m 3", "prior": "2 m", "H": "m 3 21", "cov": "m 3 3"})
@dataclass(frozen=True, eq=False)
class Expected:
    """Markers (m used ones) as predicted by a state.

    p_G (m, 3); prior (2, m) of being seen by the left and right camera; H (m, 3, 21) with respect
    to the own segment's errors; cov (m, 3, 3) m² of the prediction alone.
    """

    p_G: Array
    prior: Array
    H: Array
    cov: Array


@record("vist.previous")
@dataclass(frozen=True, eq=False)
class PreviousMarkers:
    """Markers as estimated after the image at ``t`` (s)."""

    t: float
    markers: Expected

    def at(self, t: float, speed: float) -> Expected:
        """The same positions, with the variance of a hand's motion since, at ``speed`` m/s (sd)."""
        gone = (speed * (t - self.t)) ** 2
        return replace(self.markers, cov=self.markers.cov + gone * np.eye(3))


@dataclass(frozen=True, eq=False)
class Matched:
    """k matched stereo points: marker (k,) among the used ones, left, right (k,) rows of the blobs,
    p_G (k, 3) m and noise cov (k, 3, 3) m² in G."""

    marker: IntArray
    left: IntArray
    right: IntArray
    p_G: Array
    cov: Array

    def __len__(self) -> int:
        return len(self.marker)

    def none(self) -> Matched:
        """A copy without matches."""
        return Matched(*(value[:0] for value in vars(self).values()))


class MarkerModel:
    """Prediction and correspondence for one glove seen by one rig: "Visual information extraction"
    of Lee et al. 2021, doi:10.1126/scirobotics.abe1315.
    """

    def __init__(
        self, layout: VistLayout, rig: StereoRig, noise: VistNoise, match: VistMatch
    ) -> None:
        self._layout, self._rig, self._noise, self._match = layout, rig, noise, match
        self._shape = HandShape.of(layout.hand)
        self._complete = Completion(layout.chain)
        self._hand_segment = layout.chain.glove.marker_segment(layout.hand)

    def expect(
        self, state: VistState, pose: CameraPose, rows: RowExposure | None = None
    ) -> Expected:
        """Predicted marker positions, and the probability that each camera sees them (eqs. 4
        and 5). With the ``rows`` of a rolling shutter, each position is that at the exposure of the
        marker's own row, relative to the camera pose of the image."""
        lay = self._layout
        segment, glove = lay.chain.marker_segment, lay.chain.glove
        p_G = positions(state, segment, lay.marker_lever)
        R_GB = state.R_GB
        normal_G = np.einsum("mij,mj->mi", R_GB[segment], glove.marker_normal)
        R_all, p_all, *_ = self._complete(R_GB, state.p_GB(lay), state.scale)
        markers = MarkerRows(p_G, normal_G, self._hand_segment)
        # eqs. 4 and 5
        prior = visibility(PosedHand(self._shape, R_all, p_all), markers, self._rig, pose)
        H = jacobians(state, segment, lay.marker_lever)
        if rows is not None:
            p_G, delay = self._when_exposed(state, p_G, pose, rows)
            H[:, :, V : V + 3] += delay[:, None, None] * np.eye(3)
        return Expected(p_G, prior, H, own_covariance(state, H, segment))

    def row_shift(self, state: VistState, pose: CameraPose, rows: RowExposure) -> Array:
        """(2, M, 2) px from where the glove's markers are at the image's instant to where they are
        when their rows are exposed; NaN of markers without a state."""
        lay = self._layout
        p_G = positions(state, lay.chain.marker_segment, lay.marker_lever)
        moved, _ = self._when_exposed(state, p_G, pose, rows)
        out = np.full((2, len(lay.glove.markers), 2), np.nan)
        out[:, lay.used_markers] = seen_from(moved, self._rig, pose) - seen_from(
            p_G, self._rig, pose
        )
        return out

    def _when_exposed(
        self, state: VistState, p_G: Array, pose: CameraPose, rows: RowExposure
    ) -> tuple[Array, Array]:
        """Markers (m, 3) m in G moved on to the exposure of their rows, and how much later (m,) s
        that is."""
        lay, segment = self._layout, self._layout.chain.marker_segment
        imu, parent = lay.imu_of, lay.chain.parent
        w_G = np.einsum("nij,nj->ni", state.R_GI, rows.gyro[imu] - state.bg)
        for i in np.flatnonzero(~rows.valid[imu]):
            w_G[i] = w_G[parent[i]] if parent[i] >= 0 else 0.0
        v_G = state.v_GI[segment] + np.cross(w_G[segment], p_G - state.p_GI[segment])
        v_G -= rows.v_GC + np.cross(rows.w_GC, p_G - pose.p_GC)
        p_C, v_C = (np.ascontiguousarray(x @ pose.R_GC) for x in (p_G - pose.p_GC, v_G))
        delay = exposed(p_C, v_C, seen_from(p_G, self._rig, pose), self._rig).delay
        moved: Array = p_G + delay[:, None] * v_G
        return moved, delay

    def match(self, guide: Expected, seen: tuple[SeenBlobs, ...], pose: CameraPose) -> Matched:
        """Matches the image's stereo points with markers. ``guide`` is the reference: the markers
        as predicted now, or as estimated after the previous image."""
        left, right = seen
        i, j = (self._candidates(seen[c], guide, pose, bool(c)) for c in range(2))
        z = self._depth(guide, pose)
        stereo = match_stereo(
            left.uv[i], left.hue[i], right.uv[j], right.hue[j], self._rig, z_hint=z
        )
        left_row, right_row = i[stereo.left_index], j[stereo.right_index]
        p_G = stereo.p_C @ pose.R_GC.T + pose.p_GC
        cov = self.noise(stereo.p_C, pose)
        hue = self._layout.chain.glove.marker_hue
        likely = both_cameras(guide.prior)  # eq. 6
        likely = np.where(likely > self._match.min_prior, likely, 0.0)
        # eqs. 1 to 3
        found = match_translation(p_G, left.hue[left_row], guide.p_G, hue, likely, cov).marker
        keep = np.flatnonzero(found >= 0)
        keep = keep[self._near(p_G[keep], cov[keep], found[keep], guide)]
        return Matched(
            found[keep],
            left_row[keep],
            right_row[keep],
            p_G[keep],
            cov[keep],
        )

    def _candidates(
        self, seen: SeenBlobs, guide: Expected, pose: CameraPose, right: bool
    ) -> IntArray:
        """Rows of blobs near a marker of their hue. With one common parallax, coloured objects
        elsewhere in the room would outvote the hand."""
        p_C = (guide.p_G - pose.p_GC) @ pose.R_GC
        uv = self._rig.project(p_C, right)
        sd = np.sqrt(np.trace(guide.cov, axis1=1, axis2=2) / 3)
        radius = self._rig.fx * (3 * sd + self._match.reach) / np.maximum(p_C[:, 2], 0.05)
        far2 = np.sum((seen.uv[:, None] - uv[None]) ** 2, axis=2)
        same = seen.hue[:, None] == self._layout.chain.glove.marker_hue[None]
        with np.errstate(invalid="ignore"):
            near = same & (far2 < radius**2) & (guide.prior[int(right)] > 0)
        return np.flatnonzero(near.any(axis=1))

    def _depth(self, guide: Expected, pose: CameraPose) -> float | None:
        """Predicted depth of the hand, m; None where it is behind the camera."""
        z = (guide.p_G - pose.p_GC) @ pose.R_GC[:, 2]
        z_mean = float(np.median(z))
        return z_mean if z_mean > 0.05 else None

    def _near(self, p_G: Array, cov: Array, marker: IntArray, guide: Expected) -> Array:
        """(k,) bool: within the gate of the innovation."""
        r = p_G - guide.p_G[marker]
        S = guide.cov[marker] + cov
        d2 = np.einsum("ki,ki->k", r, np.linalg.solve(S, r[..., None])[..., 0])
        return d2 < self._match.gate

    def noise(self, p_C: Array, pose: CameraPose) -> Array:
        """(k, 3, 3) m² in G of triangulated points p_C (k, 3) m."""
        noise = self._noise
        return stereo_covariance(self._rig, p_C, pose.R_GC, noise.pixel_px, noise.marker)
