"""One person in one glove: deviations of the true hand from the files used by the tracker."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any, NamedTuple

import numpy as np

from tracker.geometry import so3
from tracker.glove.model import GloveModel
from tracker.hand.model import HandModel
from tracker.messages import Array, IntArray
from tracker.simulation.kinematics import angles_from_many, forward_many
from tracker.simulation.motion import SimulatedMotion
from tracker.simulation.smooth import SmoothNoise, rng_for

# ---- flexion of people's end joints: a personal linear relation, with deviations from posture to
# posture
#
# Numbers and their sources: extensions/evaluation/docs/evaluation.md, "Simulated people".

WAVES = 24
POSTURES_ALIKE = 0.7
"""rad, all joints together: postures that are closer than this have related deviations."""
SOFT_LIMIT = np.deg2rad(4.0)
"""Within this distance of a joint's limits, tissue yields instead of stopping the joint."""


@dataclass(frozen=True)
class EndJointParams:
    """For one kind of end joint: standard deviations over people, unless stated otherwise."""

    ratio_mean: float  # difference of the mean ratio over people from the hand file's
    ratio: float
    middle_deg: float  # angle of the preceding joint at which people agree with the hand file
    offset_deg: float
    posture_deg: float  # median over people, from posture to posture
    posture_spread: float  # of the logarithm of the line above
    drift_deg: float  # with time, in the same posture


FINGER = EndJointParams(-0.27, 0.30, 40.0, 5.0, 11.0, 0.3, 3.0)
THUMB = EndJointParams(-0.80, 0.50, 20.0, 8.0, 16.0, 0.3, 3.0)
AS_IN_FILE = EndJointParams(0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


class EndJoints:
    """The end joints of one person: deviations from the hand file's synergies."""

    def __init__(
        self,
        hand: HandModel,
        rng: np.random.Generator,
        finger: EndJointParams,
        thumb: EndJointParams,
        correlation: float,
    ) -> None:
        """``correlation`` is that of the drift, s."""
        driven = [s for s in hand.synergies if s.angle.split("_")[1] in ("dip", "ip")]
        self.angle = np.array([hand.angle_index[s.angle] for s in driven], np.int64)
        self._source = np.array([hand.angle_index[s.of] for s in driven], np.int64)
        kinds = [thumb if s.angle.startswith("thumb") else finger for s in driven]
        of = {name: np.array([getattr(k, name) for k in kinds]) for name in _FIELDS}
        self.ratio = of["ratio_mean"] + rng.normal(0, of["ratio"])
        self.offset: Array = rng.normal(0, np.deg2rad(of["offset_deg"]))
        self._middle = np.deg2rad(of["middle_deg"])
        self._drift = SmoothNoise(rng, (len(driven),), correlation)
        self._drift_sd = np.deg2rad(of["drift_deg"])
        self.posture_sd: Array = np.deg2rad(of["posture_deg"]) * np.exp(
            rng.normal(0, of["posture_spread"])
        )
        self._draw_postures(hand, rng)
        self._low, self._high = hand.angle_limits[self.angle].T

    def _draw_postures(self, hand: HandModel, rng: np.random.Generator) -> None:
        """Random Fourier features of the joints that people move voluntarily."""
        n = len(self.angle)
        self._omega = rng.normal(0, 1 / POSTURES_ALIKE, (n, WAVES, len(hand.joint_names)))
        self._omega[:, :, self.angle] = 0.0
        self._phase = rng.uniform(0, 2 * np.pi, (n, WAVES))
        self._amplitude = rng.normal(0, np.sqrt(2.0 / WAVES), (n, WAVES))

    def deviation(self, t: Array, angles: Array) -> Array:
        """(n, d) rad to add to the angles (n, J) rad of ``angle`` at the times t (n,) s, where
        these follow the hand file's synergies."""
        source, before = angles[:, self._source], angles[:, self.angle]
        line = self.ratio * (source - self._middle) + self.offset
        off = self.posture_sd * self._in_posture(angles) + self._drift_sd * self._drift(t)
        return self._within(before + line + off) - self._within(before)

    def _in_posture(self, angles: Array) -> Array:
        """(n, d) of unit variance over people and postures."""
        phase = np.einsum("dwj,nj->ndw", self._omega, angles) + self._phase
        return np.asarray(np.sum(self._amplitude * np.cos(phase), axis=2))

    def _within(self, x: Array) -> Array:
        """Angles (n, d) rad, smoothly kept within the joints' limits."""
        above = self._low + SOFT_LIMIT * np.logaddexp(0.0, (x - self._low) / SOFT_LIMIT)
        return self._high - SOFT_LIMIT * np.logaddexp(0.0, (self._high - above) / SOFT_LIMIT)


_FIELDS = tuple(EndJointParams.__dataclass_fields__)


# ---- one person in one glove: deviations of the true hand from the files used by the tracker


@dataclass(frozen=True)
class WearerParams:
    """Standard deviations over people and fittings, unless stated otherwise.

    Sources: extensions/evaluation/docs/evaluation.md, "Simulated people".
    """

    common_size: float = 0.06  # of everything, a factor
    largest_size: float = 0.15  # the common size stays within 1 ± this
    length: float = 0.04  # of a segment on its own, a factor
    breadth: float = 0.05  # of the whole hand's girth, given its size
    girth: float = 0.03  # of a segment on its own
    joint_offset: float = 0.0015  # m, of the fingers' first joints in the dorsum
    axis_deg: float = 3.0  # oblique joint axes, about each axis
    thumb_axis_deg: float = 5.0
    twist_per_flexion: float = 0.05  # twist coupled to flexion
    finger_end: EndJointParams = FINGER
    thumb_end: EndJointParams = THUMB
    synergy_time: float = 2.0  # s, correlation of the end joints' drift
    mounting_deg: float = 4.33  # about each axis: 7.5° in all
    wobble_deg: float = 1.2  # about each axis, with posture and time
    imu_place: float = 0.001  # m along each axis
    marker_place: float = 0.00125  # m, tangential, in all
    slip: float = 0.001  # m, of the cloth on a segment, in all
    slip_time: float = 4.0  # s, correlation

    @classmethod
    def none(cls) -> WearerParams:
        """People who match the files exactly."""
        kept: dict[str, Any] = {
            "finger_end": AS_IN_FILE,
            "thumb_end": AS_IN_FILE,
            "synergy_time": cls.synergy_time,
            "slip_time": cls.slip_time,
        }
        return cls(**dict.fromkeys((f.name for f in fields(cls)), 0.0) | kept)


class TrueHand(NamedTuple):
    """The hand at n times: angles (n, J) rad, R_GB (n, S, 3, 3), p_GB (n, S, 3) m."""

    angles: Array
    R_GB: Array
    p_GB: Array


class Wearer:
    """The true hand and fitting; every array in the order of the hand's segments or the glove's.

    The hand is drawn from ``seed``, and so is the fitting of the glove, unless ``fitting`` is
    another seed: the same person after putting the glove on again.
    """

    def __init__(
        self,
        hand: HandModel,
        glove: GloveModel,
        seed: int,
        params: WearerParams | None = None,
        fitting: int | None = None,
    ) -> None:
        self.hand, self.glove, self.params = hand, glove, params or WearerParams()
        self._column = np.array(hand.axis_columns, np.int64)
        self._parent = np.array(hand.parent, np.int64)
        p = self.params
        self._breadth = float(rng_for(seed, "breadth").normal(0, p.breadth))
        self._draw_hand(rng_for(seed, "hand"))
        self.end_joints = EndJoints(
            hand, rng_for(seed, "synergy"), p.finger_end, p.thumb_end, p.synergy_time
        )
        fitting = seed if fitting is None else fitting
        self._draw_imus(rng_for(fitting, "imu"))
        self._draw_markers(rng_for(fitting, "markers"))

    @classmethod
    def exact(cls, hand: HandModel, glove: GloveModel) -> Wearer:
        """A wearer who matches the files exactly."""
        return cls(hand, glove, 0, WearerParams.none())

    @classmethod
    def random(
        cls,
        hand: HandModel,
        glove: GloveModel,
        seed: int,
        params: WearerParams | None = None,
        fitting: int | None = None,
    ) -> Wearer:
        """A random wearer, drawn from ``seed``, with a fitting drawn from ``fitting``."""
        return cls(hand, glove, seed, params, fitting)

    def _draw_hand(self, rng: np.random.Generator) -> None:
        p, n = self.params, len(self.hand.segments)
        common = np.clip(rng.normal(0, p.common_size), -p.largest_size, p.largest_size)
        length = (1 + common) * (1 + rng.normal(0, p.length, n))
        broad = (1 + common) * (1 + self._breadth)
        girth = broad * (1 + rng.normal(0, p.girth, n))
        self.scale: Array = np.column_stack([length, girth, girth])
        origin = np.array([s.origin for s in self.hand.segments]) * self.scale[self._parent]
        on_root = self._parent == self.hand.root
        origin += on_root[:, None] * rng.normal(0, p.joint_offset, (n, 3))
        self._origin = origin
        rest = np.array([s.R_rest for s in self.hand.segments])
        thumb = np.array([s.name.startswith("thumb") for s in self.hand.segments])
        axis_deg = np.where(thumb, p.thumb_axis_deg, p.axis_deg)[:, None]
        self._R_rest = rest @ so3.exp(rng.normal(0, np.deg2rad(axis_deg), (n, 3)))
        self._twist = rng.normal(0, p.twist_per_flexion, n) * (self._column[:, 1] >= 0)

    def _draw_imus(self, rng: np.random.Generator) -> None:
        p, glove, n = self.params, self.glove, len(self.glove.imus)
        self.imu_segment: IntArray = glove.imu_segment(self.hand)
        nominal = np.array([i.position for i in glove.imus]).reshape(-1, 3)
        offset = rng.normal(0, p.imu_place, (n, 3))
        self.imu_position: Array = nominal * self.scale[self.imu_segment] + offset
        mounting = rng.normal(0, np.deg2rad(p.mounting_deg), (n, 3))
        R_BI = np.array([i.R_BI for i in glove.imus]).reshape(-1, 3, 3)
        self.imu_R_BI: Array = R_BI @ so3.exp(mounting)
        self._wobble_time = SmoothNoise(rng, (n, 3), 1.0)
        self._wobble_axis = rng.normal(0, 1.5, (n, 3, len(self.hand.joint_names)))
        self._wobble_axis *= self._own_angles()[:, None, :]
        self._wobble_phase = rng.uniform(0, 2 * np.pi, (n, 3))

    def _own_angles(self) -> Array:
        """(n, J) 1 if an angle rotates the IMU's own segment."""
        own = np.zeros((len(self.imu_segment), len(self.hand.joint_names)))
        for i, s in enumerate(self.imu_segment):
            for column in self._column[s]:
                if column >= 0:
                    own[i, column] = 1.0
        return own

    def _draw_markers(self, rng: np.random.Generator) -> None:
        p, glove = self.params, self.glove
        self.marker_segment: IntArray = glove.marker_segment(self.hand)
        scale = self.scale[self.marker_segment]
        self.marker_normal: Array = glove.marker_normal
        self._tangents = tangents(self.marker_normal)
        offset = rng.normal(0, p.marker_place / np.sqrt(2), (len(scale), 2))
        self._marker_base = glove.marker_position * scale
        self._marker_offset = offset
        self._slip = SmoothNoise(rng, (len(self.hand.segments), 2), p.slip_time)

    @property
    def hand_length(self) -> float:
        """m, as a ruler measures it."""
        path = list(self.hand.length_path)
        lengths = np.array([self.hand.segments[row].length for row in path])
        return float(lengths @ self.scale[path, 0])

    def truth(self, motion: SimulatedMotion, t: Array) -> TrueHand:
        """Segment poses at the times t (n,) s, with angles as defined in the hand file."""
        R, p, _ = self.segments(motion, t)
        count = len(self.hand.joint_names)
        rest = np.array([s.R_rest for s in self.hand.segments])
        return TrueHand(angles_from_many(self._parent, rest, self._column, R, count), R, p)

    def segments(self, motion: SimulatedMotion, t: Array) -> tuple[Array, Array, Array]:
        """R_GB (n, S, 3, 3), p_GB (n, S, 3) and the angles (n, J) about the person's own axes."""
        t = np.asarray(t, float)
        poses = motion.poses(t)
        angles = poses.angles
        ends = self.end_joints
        if motion.follows_synergies and len(ends.angle):
            angles = angles.copy()
            angles[:, ends.angle] += ends.deviation(t, angles)
        R, p = forward_many(
            self._parent,
            self._origin,
            self._R_rest,
            self._column,
            self._twist,
            np.ascontiguousarray(angles),
            np.ascontiguousarray(poses.R_GB),
            np.ascontiguousarray(poses.p_GB),
        )
        return R, p, angles

    def beyond_synergies(self, angles: Array, t: float) -> Array:
        """(J,) rad by which the wearer's distal joints deviate at ``t`` (s) from angles (J,) of a
        motion that follows synergies."""
        out, ends = np.zeros_like(angles), self.end_joints
        if len(ends.angle):
            out[ends.angle] = ends.deviation(np.array([t]), angles[None])[0]
        return out

    def imus(self, motion: SimulatedMotion, t: Array) -> tuple[Array, Array]:
        """R_GI (n, I, 3, 3) and p_GI (n, I, 3) m of all IMUs, with the wobble of soft tissue."""
        R, p, angles = self.segments(motion, t)
        R_GB, p_GB = R[:, self.imu_segment], p[:, self.imu_segment]
        p_GI = p_GB + np.einsum("tnij,nj->tni", R_GB, self.imu_position)
        return R_GB @ self.imu_R_BI @ so3.exp(self._wobble(t, angles)), p_GI

    def _wobble(self, t: Array, angles: Array) -> Array:
        """(n, I, 3) rad: half of the variance depends on posture, half on time."""
        phase = np.einsum("nkj,tj->tnk", self._wobble_axis, angles) + self._wobble_phase
        unit = np.cos(phase) + np.sqrt(0.5) * self._wobble_time(np.asarray(t, float))
        return np.deg2rad(self.params.wobble_deg) * unit

    def markers(self, t: float) -> Array:
        """(M, 3) m: position of each marker's centre in its segment's B at the time t (s)."""
        return self.markers_at(np.array([t]))[0]

    def markers_at(self, t: Array) -> Array:
        """(n, M, 3) m: `markers` at the times t (n,) s."""
        slip = self._slip(t)[:, self.marker_segment] * self.params.slip / np.sqrt(2)
        moved = np.einsum("mki,nmk->nmi", self._tangents, self._marker_offset + slip)
        return np.ascontiguousarray(self._marker_base + moved)

    def keypoints(self, R: Array, p: Array) -> Array:
        """(K, 3) m in G of the glove's keypoints on the true hand, from R (S, 3, 3), p (S, 3)."""
        return self.glove.keypoint_positions(self.hand, R, p, self.scale)


def tangents(normal: Array) -> Array:
    """(M, 2, 3): along the bone as closely as the surface allows, and around it."""
    along = np.tile([1.0, 0, 0], (len(normal), 1))
    along[np.abs(normal[:, 0]) > 0.9] = [0, 0, 1.0]
    along -= np.sum(along * normal, axis=1, keepdims=True) * normal
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    return np.stack([along, np.cross(normal, along)], axis=1)
