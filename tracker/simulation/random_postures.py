"""The evaluation's motion: a new posture of the whole hand every few seconds (Lee et al. 2021)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from tracker.geometry import so3
from tracker.hand.model import HandModel
from tracker.messages import Array, CameraPose
from tracker.simulation.motion import Away, Poses, SimulatedMotion
from tracker.simulation.postures import posture, random_posture
from tracker.simulation.smooth import Oscillation, SmoothNoise, minimum_jerk, rng_for
from tracker.vision.rig import default_pose


@dataclass(frozen=True)
class PostureParams:
    """Distribution of motion and position."""

    holding: bool = False  # only grips, for an object in the hand
    first_hold: float = 1.5  # s flat and in view
    move_shortest: float = 0.5  # s
    move_longest: float = 1.0  # s
    near: float = 0.27  # m from the camera along its axis, centre of the palm
    far: float = 0.42
    wide: float = 0.30  # of the half image, left and right
    high: float = 0.25  # of the half image, up and down
    roll_deg: float = 45.0  # standard deviation, about the forearm
    pitch_deg: float = 26.0
    pitch_mean_deg: float = -3.0  # negative: fingers up
    yaw_deg: float = 18.0
    largest_deg: float = 55.0  # of roll and pitch
    lowest_deg: float = 30.0  # of fingers down: beyond it the arm occludes the hand
    palm_up: float = 0.15  # share of postures
    sway_deg: float = 1.2
    sway_mm: float = 2.5
    tremor_deg: float = 0.12
    tremor_mm: float = 0.12


class RandomPostures:
    """Random postures and wrist poses, minimum-jerk moves between them, sway and tremor.

    ``camera`` defines the working volume; the hand stays near the centre of its image.
    """

    follows_synergies = True

    def __init__(
        self,
        hand: HandModel,
        seed: int,
        period: float = 3.0,
        duration: float = 60.0,
        params: PostureParams | None = None,
        camera: CameraPose | None = None,
    ) -> None:
        self.duration = duration
        self._hand, self._params = hand, params or PostureParams()
        self._camera = camera or default_pose()
        rng = rng_for(seed, "postures")
        count = max(int(np.ceil((duration - self._params.first_hold) / period)), 0) + 1
        self._draw_keys(rng, count, period)
        self._sway = SmoothNoise(rng, (len(hand.joint_names) + 6,), 0.8)
        self._tremor = Oscillation(rng, len(hand.joint_names) + 6, 6.0, 11.0)

    def _draw_keys(self, rng: np.random.Generator, count: int, period: float) -> None:
        """Key k is held until ``start[k]``, when the move to key k + 1 begins."""
        p = self._params
        self._start = p.first_hold + period * np.arange(count - 1)
        longest = min(p.move_longest, period)
        self._move = rng.uniform(min(p.move_shortest, longest), longest, count - 1)
        rotations, positions = [np.eye(3)], [np.array([0.0, 0.0, (p.near + p.far) / 2])]
        angles = [posture(self._hand, {})]
        for _ in range(count - 1):
            angles.append(random_posture(self._hand, rng, self._params.holding))
            rotations.append(self._rotation(rng))
            positions.append(self._position(rng))
        self._angles, self._R = np.array(angles), _in_front(self._camera) @ np.array(rotations)
        centre_G = np.array(positions) @ self._camera.R_GC.T + self._camera.p_GC
        self._p = centre_G - self._R @ np.array([self._hand.length / 2, 0, 0])
        self._turn = so3.log(np.swapaxes(self._R[:-1], 1, 2) @ self._R[1:]).reshape(-1, 3)

    def _rotation(self, rng: np.random.Generator) -> Array:
        p = self._params
        largest = p.largest_deg
        roll = np.clip(rng.normal(0, p.roll_deg), -largest, largest)
        if rng.random() < p.palm_up:
            roll += 180.0
        pitch = np.clip(rng.normal(p.pitch_mean_deg, p.pitch_deg), -largest, p.lowest_deg)
        yaw, pitch, roll = np.deg2rad([rng.normal(0, p.yaw_deg), pitch, roll])
        return so3.rz(yaw) @ so3.ry(pitch) @ so3.rx(roll)

    def _position(self, rng: np.random.Generator) -> Array:
        """The centre of the palm in C; an image of 90° by 60° is 1 by 0.577 at unit distance."""
        p = self._params
        z = rng.uniform(p.near, p.far)
        x, y = rng.uniform(-p.wide, p.wide), 0.577 * rng.uniform(-p.high, p.high)
        return np.array([x * z, y * z, z])

    def poses(self, t: Array) -> Poses:
        t = np.asarray(t, float)
        if len(self._start) == 0:
            k, share = np.zeros(len(t), int), np.zeros(len(t))
            still = np.repeat(self._R[:1], len(t), axis=0)
            return self._with_sway(t, self._angles[k], still, self._p[k])
        k = np.clip(np.searchsorted(self._start, t, side="right") - 1, 0, None)
        share = minimum_jerk((t - self._start[k]) / self._move[k])
        blend = share[:, None]
        angles = self._angles[k] + blend * (self._angles[k + 1] - self._angles[k])
        R = self._R[k] @ so3.exp(blend * self._turn[k])
        p = self._p[k] + blend * (self._p[k + 1] - self._p[k])
        return self._with_sway(t, angles, R, p)

    def _with_sway(self, t: Array, angles: Array, R: Array, p: Array) -> Poses:
        """Add sway and tremor, since no hand is completely still."""
        a = self._params
        sway, tremor = self._sway(t), self._tremor(t)
        turn = np.deg2rad(a.sway_deg) * sway + np.deg2rad(a.tremor_deg) * tremor
        shift = 1e-3 * (a.sway_mm * sway[:, -3:] + a.tremor_mm * tremor[:, -3:])
        return Poses(angles + turn[:, :-6], R @ so3.exp(turn[:, -6:-3]), p + shift)


def _in_front(camera: CameraPose) -> Array:
    """The dorsum's rotation, palm down and fingers along the camera's view, seen from above."""
    forward = camera.R_GC[:, 2] * [1, 1, 0]
    if np.linalg.norm(forward) < 1e-6:  # straight down: fingers towards the image's top
        forward = -camera.R_GC[:, 1] * [1, 1, 0]
    x = forward / np.linalg.norm(forward)
    z = np.array([0.0, 0, 1])
    return np.column_stack([x, np.cross(z, x), z])


def leaving(
    motion: SimulatedMotion,
    spans: tuple[tuple[float, float], ...],
    camera: CameraPose | None = None,
) -> Away:
    """``motion`` outside both images during each (t0, t1): 0.8 m to the camera's right."""
    return Away(motion, spans, (camera or default_pose()).R_GC @ np.array([0.8, 0.0, 0.0]))
