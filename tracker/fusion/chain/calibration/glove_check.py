"""Detects a glove that does not match its file: markers elsewhere, IMUs mounted differently.

Each new posture gives information about the calibration (docs/chain.md, eq. 46), which is compared
with the calibrations that are usual and with those of unusual gloves (eqs. 75, 76). It affects no
estimate, and it is not part of a saved state: after `ChainEngine.set_state` it starts again.
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from tracker.base.notices import Outbox, warning
from tracker.fusion.chain.bundle.keyframes import Keyframe, keyframe_of
from tracker.fusion.chain.bundle.solver import (
    MOST_MISFIT,
    KeyframePose,
    KeyframeRows,
    off_nominal,
    pose_prior,
    without_pose,
)
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import ChainParams, PriorParams
from tracker.fusion.chain.prior import initial_covariance
from tracker.fusion.chain.profile import WearerProfile
from tracker.fusion.chain.recognition import Recognised, SeenImage
from tracker.fusion.chain.state import ChainState
from tracker.fusion.time.imu_buffer import ImuBuffer
from tracker.geometry.kernels import relative_rotations
from tracker.messages import Array, IntArray
from tracker.vision.rig import StereoRig

APART = 0.15  # rad, all joints together, between two postures
LEAST_BLOBS = 10  # in both images together
SLIP = 0.001  # m, of the cloth under a marker
LEAST_POSTURES = 16
CHECKS = (11.0, 17.0, 30.0, 60.0)  # s after the first posture

WIDER = 1.5  # ratio of marker offsets of an unusual glove to usual ones
SHIFT = 0.004  # m, of neighbouring markers together
TURN = 0.26  # rad, 15° per axis, of an IMU
SURE_OF_ALL, SURE_OF_SOME, SURE_OF_IMU = 1.0, 5.5, 4.0
"""ln B from which on a glove is unusual. Its largest values for eight usual people, 19 s each, are
-4.1, 4.0 and 0.4."""

WIDE = 2.5  # ratio of marker offsets to usual ones, for their estimates
CLEAR = 2.0  # standard deviations of an offset that is reported
LEAST_OFFSET = 0.002  # m, likewise
NAMED = 3  # markers that are named if none of them is off so clearly


class Unusual(NamedTuple):
    """What does not match: ids of ``markers`` and their mean offset (m), and the rows of ``imus``
    with their angles (rad)."""

    markers: tuple[int, ...]
    offset: float
    imus: tuple[int, ...]
    angles: tuple[float, ...]


class GloveEvidence:
    """Information N (C, C) and b (C,) on the calibration, relative to the files."""

    def __init__(self, layout: ChainLayout, prior: PriorParams) -> None:
        self._layout, self._prior = layout, prior
        at, n = layout.blocks, layout.n_dynamic
        self._markers = np.arange(at.marker - n, at.axis - n).reshape(-1, 3)
        self._imus = np.arange(at.phi - n, at.ba - n).reshape(-1, 3)
        self._together = neighbours(layout.marker_segment)
        self.N = np.zeros((at.size - n, at.size - n))
        self.b = np.zeros(at.size - n)

    def add(self, N: Array, g: Array, off: Array) -> None:
        """Adds a posture that was linearised at the deviation ``off`` (C,) from the files."""
        self.N += N
        self.b += g + N @ off

    def unusual(self, known: WearerProfile | None = None) -> Unusual | None:
        """What does not match the file; None for a usual glove. ``known``: the wearer's profile,
        which is the prior instead of the population."""
        usual, b = self._covariance(self._prior), self.b
        if known is not None:
            usual, b = known.P, b - self.N @ off_nominal(known, self._layout)
        A = np.linalg.inv(self.N + np.linalg.inv(usual))
        F, s = self.N - self.N @ A @ self.N, b - self.N @ (A @ b)  # eq. 75
        all_of_them = gain(F, s, self._markers.ravel(), self._wider())
        some = shift_gains(F, s, self._markers, self._together).max(initial=0.0)
        turned = np.eye(3) * np.sqrt(TURN**2 - self._prior.mounting**2)
        imus = np.array([gain(F, s, rows, turned) for rows in self._imus])
        odd_imus = np.flatnonzero(imus > SURE_OF_IMU)
        are_markers_odd = all_of_them > SURE_OF_ALL or some > SURE_OF_SOME
        if not (are_markers_odd or len(odd_imus)):
            return None
        markers, offset = self._offsets() if are_markers_odd else ((), 0.0)
        angles = self._angles(odd_imus)
        return Unusual(markers, offset, tuple(int(j) for j in odd_imus), angles)

    # ---- alternatives

    def _wider(self) -> Array:
        """Root of the additional covariance of all markers, along the cloth."""
        out = np.zeros((self._markers.size, self._markers.size))
        sd = self._prior.marker * np.sqrt(WIDER**2 - 1)
        for k, normal in enumerate(self._layout.glove.marker_normal):
            along = np.eye(3) - np.outer(normal, normal) / (normal @ normal)
            out[3 * k : 3 * k + 3, 3 * k : 3 * k + 3] = sd * along
        return out

    # ---- estimates

    def _covariance(self, prior: PriorParams) -> Array:
        n = self._layout.n_dynamic
        return initial_covariance(self._layout, prior)[n:, n:]

    def _wide(self) -> tuple[Array, Array]:
        """The calibration (C,) and its covariance if markers and IMUs may be far off."""
        prior = self._prior
        wide = replace(prior, marker=WIDE * prior.marker, mounting=max(TURN, prior.mounting))
        P = np.linalg.inv(self.N + np.linalg.inv(self._covariance(wide)))
        return P @ self.b, P

    def _offsets(self) -> tuple[tuple[int, ...], float]:
        """The markers that are clearly off, and their mean offset (m)."""
        x, P = self._wide()
        offset = np.linalg.norm(x[self._markers], axis=1)
        toward = x[self._markers] / np.maximum(offset, 1e-9)[:, None]
        blocks = np.array([P[np.ix_(rows, rows)] for rows in self._markers])
        sd = np.sqrt(np.einsum("mi,mij,mj->m", toward, blocks, toward))
        clear = np.flatnonzero((offset > LEAST_OFFSET) & (offset > CLEAR * sd))
        if not len(clear):
            clear = np.sort(np.argsort(-offset / np.maximum(sd, 1e-9))[:NAMED])
        return tuple(int(m) for m in clear), float(offset[clear].mean())

    def _angles(self, imus: IntArray) -> tuple[float, ...]:
        if not len(imus):
            return ()
        x, _ = self._wide()
        return tuple(float(np.linalg.norm(x[self._imus[j]])) for j in imus)


def neighbours(segment: IntArray) -> Array:
    """(q, M) 0 or 1: the groups of successive markers of one ``segment`` (M,)."""
    out = []
    for a in np.unique(segment):
        ids = np.flatnonzero(segment == a)
        for first in range(len(ids)):
            for end in range(first + 1, len(ids) + 1):
                row = np.zeros(len(segment))
                row[ids[first:end]] = 1.0
                out.append(row)
    return np.array(out).reshape(-1, len(segment))


def gain(F: Array, s: Array, rows: IntArray, C: Array) -> float:
    """ln B (eq. 76) of an additional covariance C Cᵀ of the parameters ``rows`` (k,); C (k, q)."""
    M = np.eye(C.shape[1]) + C.T @ F[np.ix_(rows, rows)] @ C
    v = C.T @ s[rows]
    return float(0.5 * (v @ np.linalg.solve(M, v) - np.linalg.slogdet(M)[1]))


def shift_gains(F: Array, s: Array, markers: IntArray, groups: Array) -> Array:
    """(q,) `gain` of each of the ``groups`` (q, M) of markers with rows ``markers`` (M, 3), if a
    group is shifted as a whole by `SHIFT`; all at once."""
    between = F[markers[:, None, :, None], markers[None, :, None, :]]
    of_groups = np.tensordot(groups, between, 1)  # (q, M, 3, 3)
    M = np.eye(3) + SHIFT**2 * np.einsum("qn,qnij->qij", groups, of_groups)
    v = SHIFT * groups @ s[markers]
    x = np.linalg.solve(M, v[:, :, None])[:, :, 0]
    out: Array = 0.5 * (np.einsum("qi,qi->q", v, x) - np.linalg.slogdet(M)[1])
    return out


class GloveCheck:
    """Collects postures of a chain filter and posts a notice if the glove does not match its file,
    once. Images of one camera are not used."""

    def __init__(self, layout: ChainLayout, rig: StereoRig, params: ChainParams) -> None:
        self._layout, self._prior = layout, params.prior
        bundle = replace(params.bundle, least_blobs=LEAST_BLOBS, slip=SLIP)
        self._bundle = bundle
        self._rows = KeyframeRows(layout, rig, replace(params, bundle=bundle))
        self._moves, self._stiff = pose_prior(layout, bundle.orientation)
        self.notices = Outbox()
        self.restart()

    def restart(self) -> None:
        """Discards all postures: another wearer, glove or hand."""
        self._evidence = GloveEvidence(self._layout, self._prior)
        self._postures: Array = np.empty((0, len(self._layout.names) - 1, 3))
        self._first, self._checks = np.inf, list(CHECKS)
        self._known: WearerProfile | None = None

    def image(
        self,
        state: ChainState,
        image: SeenImage,
        found: Recognised,
        buffer: ImuBuffer,
        known: WearerProfile | None,
    ) -> None:
        """Takes an image after it has corrected the state; ``known`` is the wearer's profile."""
        if not self._checks or image.is_mono:
            return
        if known is not self._known:
            self.restart()
            self._known = known
        self._first = min(self._first, state.t)
        frame = self._new_posture(state, image, found, buffer)
        if frame is not None:
            self._add(state, frame)
        if state.t - self._first >= self._checks[0] and len(self._postures) >= LEAST_POSTURES:
            self._check(state.t)

    def _new_posture(
        self, state: ChainState, image: SeenImage, found: Recognised, buffer: ImuBuffer
    ) -> Keyframe | None:
        relative = relative_rotations(state.R_GB, self._layout.parent)
        apart = np.sum((self._postures - relative) ** 2, axis=(1, 2))
        if len(apart) and apart.min() < APART**2:
            return None
        around = buffer.around(state.t)
        if around is None:
            return None
        return keyframe_of(
            state, image.blobs, found.match, image.pose, around, relative, self._bundle
        )

    def _add(self, state: ChainState, frame: Keyframe) -> None:
        H, r = self._rows(state, frame)
        self._postures = np.concatenate([self._postures, frame.relative[None]])
        if r @ r > MOST_MISFIT * len(r):  # another hand
            return
        pose = KeyframePose(self._moves, self._stiff, np.zeros(len(self._moves)))
        N, g, _ = without_pose(H, r, pose, self._layout.n_dynamic)
        self._evidence.add(N, g, off_nominal(state, self._layout))

    def _check(self, t: float) -> None:
        while self._checks and t - self._first >= self._checks[0]:
            del self._checks[0]
        found = self._evidence.unusual(self._known)
        if found is None:
            return
        self._checks, side = [], self._layout.glove.side
        if found.markers:
            ids, mm = spans(found.markers), 1e3 * found.offset
            self.notices.post(warning("glove.markers_off", side=side, markers=ids, offset_mm=mm))
        for imu, angle in zip(found.imus, found.angles, strict=True):
            name = self._layout.glove.imu_names[imu].replace("_", " ")
            deg = float(np.rad2deg(angle))
            self.notices.post(warning("glove.imu_off", side=side, imu=name, angle_deg=deg))


def spans(ids: tuple[int, ...]) -> tuple[str, ...]:
    """Ids in ascending order as texts, successive ones joined: ``3``, ``12–15``."""
    out: list[list[int]] = []
    for k in ids:
        if out and out[-1][-1] == k - 1:
            out[-1].append(k)
        else:
            out.append([k])
    return tuple(str(s[0]) if len(s) == 1 else f"{s[0]}–{s[-1]}" for s in out)
