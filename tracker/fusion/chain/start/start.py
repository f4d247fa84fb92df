"""Initialization and re-detection of the hand.

Gravity determines the elevation of each digit, but not the spread of the fingers. If it differs
from the hand file, the fingertips are off by the distance of two patches, where a neighbour's patch
of the same hue is equally close. So each digit is rotated about its base to where the points
support it best, before blobs are matched with markers.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from tracker.fusion.chain.digits import SupportPoints, posture_scores
from tracker.fusion.chain.kinematics import marker_positions, segment_positions
from tracker.fusion.chain.layout import ChainLayout, digit_of
from tracker.fusion.chain.params import ChainParams
from tracker.fusion.chain.pixels import SeenBlobs
from tracker.fusion.chain.prior import initial_covariance
from tracker.fusion.chain.profile import WearerProfile, wear
from tracker.fusion.chain.start.mono_start import (
    MonoParams,
    Rays,
    fix_size,
    vote_mono,
)
from tracker.fusion.chain.start.search import (
    Pose,
    SearchParams,
    StereoPoints,
    postures_from_gravity,
    vote,
)
from tracker.fusion.chain.state import ChainState, initial_state
from tracker.fusion.time.imu_buffer import ImuBuffer
from tracker.geometry import so3
from tracker.messages import Array, CameraPose, ImuSample
from tracker.vision.rig import StereoRig
from tracker.vision.stereo import all_pairs

TURNS = np.deg2rad([0, -5, 5, -10, 10, -15, 15, -20, 20, -25, 25])  # about the palm's normal
RADIUS = 0.010  # m, within which a point supports a marker: less than the distance of two fingers
BETTER = 0.5  # markers by which a rotated digit must be better supported


def spread(state: ChainState, layout: ChainLayout, seen: StereoPoints) -> Array:
    """R_GB (A, 3, 3) of ``state`` with each digit rotated laterally to where the points support
    it."""
    digit, glove = digit_of(layout), layout.glove
    origin, marker = segment_positions(state, layout), marker_positions(state, layout)
    turns = so3.exp(TURNS[:, None] * state.R_GB[0][:, 2])
    points = SupportPoints(seen.p_G, seen.hue, RADIUS)
    out = state.R_GB.copy()
    for d in range(int(digit.max(initial=-1)) + 1):
        segments = np.flatnonzero(digit == d)
        rows = np.flatnonzero(np.isin(layout.marker_segment, segments))
        base = origin[segments[0]]
        way = (seen.p_GC - base) / np.linalg.norm(seen.p_GC - base)
        R = state.R_GB[layout.marker_segment[rows]]
        normal = np.einsum("mij,mj->mi", R, glove.marker_normal[rows])
        score = posture_scores(
            np.ascontiguousarray(np.einsum("kij,mj->kmi", turns, marker[rows] - base)),
            np.ascontiguousarray(np.einsum("kij,mj->kmi", turns, normal)),
            np.eye(3), base, way, glove.marker_hue[rows], points,
        )  # fmt: skip
        best = int(np.argmax(score))
        if score[best] >= score[0] + BETTER:
            out[segments] = turns[best] @ out[segments]
    return out


LOOK_BACK = 0.3  # s of packets that are averaged for tilt
STILL_GYRO = 0.05  # rad/s: sd below which the mean gyro reading is a bias
REST_PACKETS = 20
STILL_BIAS_SD = 0.015  # rad/s, residual motion of a wearer at rest
CANDIDATES = 3  # s of packets over which tilt is averaged
SHIFT = 0.12  # m by which a hand may deviate from its predicted motion between two images
SHIFT_RADIUS = 0.015  # m, within which a point supports a marker of a shifted hand
MAX_BIAS = 0.2  # rad/s: a larger mean is motion (turn-on bias is at most 0.09)


class Starter:
    """Searches images for the hand of one layout."""

    def __init__(self, layout: ChainLayout, rig: StereoRig, params: ChainParams) -> None:
        self._layout, self._rig, self._params = layout, rig, params
        self._search, self._mono = SearchParams(), MonoParams()

    def first(
        self,
        buffer: ImuBuffer,
        seen: tuple[SeenBlobs, ...],
        pose: CameraPose,
        t: float,
        known: WearerProfile | None = None,
    ) -> ChainState | None:
        """The most likely of `candidates`, or None where the image does not clearly show a hand."""
        found = self.candidates(buffer, seen, pose, t, known)
        return found[0] if found else None

    def candidates(
        self,
        buffer: ImuBuffer,
        seen: tuple[SeenBlobs, ...],
        pose: CameraPose,
        t: float,
        known: WearerProfile | None = None,
    ) -> list[ChainState]:
        """Initial states, the most likely first.

        ``known`` is the wearer profile, if any.
        """
        packets = [s for s in buffer if t - LOOK_BACK <= s.t <= t + 0.05]
        if len(packets) < 5 or not self._shows_enough(seen, pose):
            return []
        state, postures = self._by_packets(packets, t, known)
        headings = np.arange(0, 2 * np.pi, np.deg2rad(self._search.heading_step_deg))
        out = []
        for best in self._best(state, postures, headings, seen, pose, self._search)[:CANDIDATES]:
            moved = state.copy()
            moved.R_GB, moved.p = best.R_GB, best.p
            if all(len(s.uv) for s in seen):
                moved.R_GB = spread(moved, self._layout, self.points(seen, pose))
            else:
                fix_size(moved, self._layout, pose.p_GC, self._mono.distance_sd)
            out.append(moved)
        return out

    def _shows_enough(self, seen: tuple[SeenBlobs, ...], pose: CameraPose) -> bool:
        """Whether `_best` could find a hand: postures by gravity take 5 ms, and most searched
        images show none."""
        counts = [len(s.uv) for s in seen]
        if min(counts) == 0:
            return max(counts) >= self._mono.min_support
        return len(self.points(seen, pose).p_G) >= self._search.min_points

    def by_gravity(
        self, buffer: ImuBuffer, known: WearerProfile | None = None
    ) -> ChainState | None:
        """A state at the newest packet, its root's IMU at G's origin and its heading zero.

        Of the postures that agree with gravity it is the flattest. None before there are enough
        packets to separate gravity from motion, or where the root's IMU is invalid.
        """
        newest = buffer.newest
        packets = [s for s in buffer if newest is not None and newest.t - LOOK_BACK <= s.t]
        if len(packets) < REST_PACKETS:
            return None
        state, postures = self._by_packets(packets, packets[-1].t, known)
        if not postures:
            return None
        state.R_GB = postures[0]
        return state

    def _by_packets(
        self, packets: Sequence[ImuSample], t: float, known: WearerProfile | None
    ) -> tuple[ChainState, list[Array]]:
        """A state at ``t`` (s) with the known calibration and gyro biases, and the articulations
        R_GB (A, 3, 3) that agree with gravity."""
        state = initial_state(self._layout)
        state.t = t
        state.P = initial_covariance(self._layout, self._params.prior)
        if known is not None:
            wear(state, self._layout, known)
        valid = np.all([s.valid for s in packets], axis=0)
        force = np.mean([s.accel for s in packets], axis=0)
        gyro = np.array([s.gyro for s in packets])
        if known is None:
            self._bias_at_rest(state, gyro, valid)
        return state, postures_from_gravity(self._layout, state.R_IB, force, valid)

    def again(
        self, state: ChainState, seen: tuple[SeenBlobs, ...], pose: CameraPose, matched: int
    ) -> Pose | None:
        """The hand with its present articulation anywhere in view, heading within 60°.

        ``matched`` markers agree with the present pose; another one must have clearly more.
        """
        headings = np.deg2rad(np.arange(-60, 61, 7.5))
        params = replace(self._search, radius=0.020, min_score=0.3)
        best = self._best(state, [state.R_GB], headings, seen, pose, params)
        if not best or best[0].support <= 1.3 * matched:
            return None
        return best[0]

    def shift(
        self, state: ChainState, seen: tuple[SeenBlobs, ...], pose: CameraPose
    ) -> Array | None:
        """(3,) m from the predicted position of the hand to the nearby one that most of its markers
        support; None where few agree."""
        points = self.points(seen, pose)
        there = marker_positions(state, self._layout)
        apart = points.p_G - there.mean(axis=0)
        reach = np.linalg.norm(there - there.mean(axis=0), axis=1).max() + SHIFT
        near = np.linalg.norm(apart, axis=1) <= reach
        points = StereoPoints(points.p_G[near], points.hue[near], points.p_GC)
        params = replace(self._search, radius=SHIFT_RADIUS, min_score=0.3)
        best = vote(state, self._layout, [state.R_GB], np.zeros(1), points, params)
        if not best or np.linalg.norm(best[0].p - state.p) > SHIFT:
            return None
        return best[0].p - state.p

    def points(self, seen: tuple[SeenBlobs, ...], pose: CameraPose) -> StereoPoints:
        """All pairs of blobs that may be one point."""
        left, right = seen
        pairs = all_pairs(left.uv, left.hue, right.uv, right.hue, self._rig)
        p_G = pairs.p_C @ pose.R_GC.T + pose.p_GC
        return StereoPoints(p_G, left.hue[pairs.left_index], pose.p_GC)

    def _best(
        self,
        state: ChainState,
        postures: list[Array],
        headings: Array,
        seen: tuple[SeenBlobs, ...],
        pose: CameraPose,
        params: SearchParams,
    ) -> list[Pose]:
        if any(len(s.uv) == 0 for s in seen):
            found = self._best_mono(state, postures, headings, seen, pose)
            return [] if found is None else [found]
        points = self.points(seen, pose)
        if len(points.p_G) < params.min_points:
            return []
        return vote(state, self._layout, postures, headings, points, params)

    def _best_mono(
        self,
        state: ChainState,
        postures: list[Array],
        headings: Array,
        seen: tuple[SeenBlobs, ...],
        pose: CameraPose,
    ) -> Pose | None:
        """As `_best`, with the one camera that sees anything."""
        camera = 1 if len(seen[0].uv) == 0 else 0
        rig = self._rig
        rays = Rays(
            (seen[camera].uv - [rig.cx, rig.cy]) / [rig.fx, rig.fy],
            seen[camera].hue,
            np.array([camera * rig.baseline, 0.0, 0.0]),
        )
        return vote_mono(state, self._layout, postures, headings, rays, pose, self._mono)

    def _bias_at_rest(self, state: ChainState, gyro: Array, valid: Array) -> None:
        """A still hand reveals the gyro biases: use them, with the residual motion of a person at
        rest."""
        if len(gyro) < REST_PACKETS:
            return  # tremor does not average out in a few packets
        sd, mean = gyro.std(axis=0), gyro.mean(axis=0)
        for j in np.flatnonzero(valid):
            if sd[j].max() < STILL_GYRO and np.abs(mean[j]).max() < MAX_BIAS:
                state.bg[j] = mean[j]
                rows = self._layout.blocks.bg + 3 * j + np.arange(3)
                state.P[rows, rows] = STILL_BIAS_SD**2
