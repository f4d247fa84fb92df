"""Parameters of the chain filter; defaults tuned on simulated people."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import NamedTuple

from tracker.glove.model import GloveModel


class RandomWalks(NamedTuple):
    """Densities per √s of the random walks in the state, as in `NoiseParams`."""

    accel: float
    accel_gain: float
    free_accel: float
    gyro: float
    free_rotation: float
    free_root_rotation: float
    gyro_bias: float
    mounting: float
    accel_bias: float
    scale: float
    offset: float
    slip: float
    slip_most: float


class PixelNoise(NamedTuple):
    """Standard deviations of a marker in an image, as in `NoiseParams`."""

    marker: float
    pixel_px: float
    huber: float


@dataclass(frozen=True)
class NoiseParams:
    """Continuous noises (per √s) and measurement standard deviations."""

    gyro: float = 0.01  # rad/√s: far above the data sheet, covers scale error and cloth
    accel: float = 0.06  # m/s²·√s
    accel_gain: float = 0.01  # √s, relative to the hand's acceleration: scale and axes
    gyro_bias: float = 2e-4  # rad/s/√s
    accel_bias: float = 2e-3  # m/s²/√s
    scale: float = 1e-4  # 1/√s
    mounting: float = 0.01  # rad/√s: not zero, because cloth moves
    free_rotation: float = 0.3  # rad/√s: a segment without an IMU, relative to its parent
    free_root_rotation: float = 0.5  # rad/√s: the hand while its own IMU is invalid
    free_accel: float = 1.0  # m/s²·√s: its position, likewise
    offset: float = 1e-4  # m/√s: joints
    slip: float = 4e-4  # m/√s: markers, with the cloth
    slip_most: float = 0.0011  # m: markers whose sd exceeds this do not slip
    marker: float = 0.0025  # m, placement and cloth beyond the offset states
    pixel_px: float = 1.0
    huber: float = 2.0

    @cached_property
    def random_walks(self) -> RandomWalks:
        return RandomWalks(*(float(getattr(self, name)) for name in RandomWalks._fields))

    @cached_property
    def pixel(self) -> PixelNoise:
        return PixelNoise(self.marker, self.pixel_px, self.huber)


@dataclass(frozen=True)
class PriorParams:
    """Standard deviations at the start."""

    position: float = 0.020  # m
    velocity: float = 1.0  # m/s: a hand that comes back into the image is fast
    first_velocity: float = 0.3  # m/s: a hand that re-enters the image is fast
    found_velocity: float = 0.3  # m/s: a hand shown to the camera at a start is slower
    returned: float = 0.4  # m/s, from two successive searches
    rotation: float = 0.12  # rad
    mounting: float = 0.0873  # rad, 5° per axis
    gyro_bias: float = 0.03  # rad/s
    accel_bias: float = 0.3  # m/s²
    common_length: float = 0.07
    common_girth: float = 0.07
    alike: float = 0.6  # correlation of these two: long hands tend to be broad
    own_length: float = 0.04
    own_girth: float = 0.03
    joint: float = 0.0015  # m
    axis: float = 0.06  # rad: joints are oblique, constantly
    thumb_axis: float = 0.09  # rad
    marker: float = 0.0011  # m, along the cloth
    marker_normal: float = 0.0004  # m, normal to it


@dataclass(frozen=True)
class ConstraintParams:
    """Anatomy as pseudo-measurements, applied once per image.

    The standard deviations are for one use per ``period``.
    """

    rotation: float = 0.15  # rad: no twist, no abduction of a hinge, without images
    rotation_seen: float = 0.30  # rad: the same with an image
    stiff_abduction: float = 0.30  # rad, of a joint that hardly abducts
    synergy: float = 0.13  # rad, for a segment seen only by markers
    limit: float = 0.05  # rad, beyond a joint's limit
    tilt: float = 0.6  # m/s², a finger's accelerometer against the chain's
    tilt_kinematic: float = 0.15  # relative to the kinematic part
    period: float = 0.03  # s between two uses of tilt, or of anatomy without images


@dataclass(frozen=True)
class MatchParams:
    """Correspondence and the state of tracking."""

    lost_after: float = 0.2  # s without enough matches before images are searched again
    min_markers: int = 4
    least_markers: int = 2  # enough where no more are visible
    coast_limit: float = 1.0  # s for which the inertial position is usable
    max_frame_delay: float = 0.12  # s, after which the filter continues without the image
    search_period: float = 0.10  # s between two searches
    misfit_px: float = 3.0  # median, of a hand that re-enters the image


@dataclass(frozen=True)
class BundleParams:
    """Calibration over keyframes in the background, at growing intervals."""

    enabled: bool = True
    keyframes: int = 40
    least_keyframes: int = 15
    least_blobs: int = 16  # in both images together
    apart: float = 0.35  # rad, all joints together, between two keyframes
    first_after: float = 12.0  # s of tracking; the next after twice as long, and so on
    sweeps: int = 5
    slip: float = 0.0015  # m, of the cloth under a marker
    rotation: float = 0.10  # rad: no twist, no abduction of a hinge
    orientation: float = 0.15  # rad, of a keyframe's segments about the filter's estimate
    wobble: float = 0.02  # rad, of an IMU on soft tissue


@dataclass(frozen=True)
class SynergyParams:
    """Standard deviations of the population, except ``posture``; angles in degrees.

    ``posture`` is the individual variation of a distal joint from posture to posture. ``ratio`` is
    that of a line through ``middle``, the flexion of the joint before at which people agree best.
    ``slope`` is the mean ratio of people, from which ``ratio`` deviates, whatever the hand file's
    is: its line counts at ``middle``.
    """

    slope: float = 0.40
    ratio: float = 0.35
    middle_deg: float = 40.0
    offset_deg: float = 5.0
    aside_deg: float = 3.0
    posture_deg: float = 12.5
    thumb_slope: float = 0.0
    thumb_ratio: float = 0.50
    thumb_middle_deg: float = 20.0
    thumb_offset_deg: float = 8.0
    thumb_aside_deg: float = 5.0
    thumb_posture_deg: float = 17.0


@dataclass(frozen=True)
class GuidedParams:
    """Standard deviations of the relations that hold during a pose; lengths in m.

    Those of joints come with the pose (`tracker.hand.poses`).
    """

    enabled: bool = True
    gap: float = 0.010  # between two touching pads: skin is soft, some people leave a gap, and
    pad: float = 0.010  # on the pads: without a profile, a thumb is known no better
    table: float = 0.003  # distance of fingertips and palm from one plane
    gate: float = 0.997  # share of correctly held poses that pass
    flexion: float = 2.0  # times the pose's own: free motion determines mountings better
    by_will: float = 0.2  # rad, of a joint held differently from its natural position
    sample_period: float = 0.2  # s
    moving: float = 0.12  # rad, all joints together, from the posture held longest


@dataclass(frozen=True)
class ClothParams:
    """Measurement of fingers without sensors by the glove's cloth, where colours were learned."""

    fingers: bool = True


@dataclass(frozen=True)
class ChainParams:
    """The chain engine's settings. ``guide``, ``coupling``: `tracker.fusion.ablations.variants`."""

    guide: str = "imu"
    coupling: str = "tight"
    noise: NoiseParams = field(default_factory=NoiseParams)
    prior: PriorParams = field(default_factory=PriorParams)
    constraint: ConstraintParams = field(default_factory=ConstraintParams)
    match: MatchParams = field(default_factory=MatchParams)
    bundle: BundleParams = field(default_factory=BundleParams)
    synergy: SynergyParams = field(default_factory=SynergyParams)
    guided: GuidedParams = field(default_factory=GuidedParams)
    cloth: ClothParams = field(default_factory=ClothParams)


def with_measured_noise(params: ChainParams, glove: GloveModel) -> ChainParams:
    """Raises the noise to at least that measured for the glove's IMUs (the worst of them).

    The defaults are above an MPU-9250's data sheet, since they also cover scale errors and cloth:
    only worse IMUs change the filter. A glove file without noise changes nothing.
    """
    measured = [imu.noise for imu in glove.imus if imu.noise is not None]
    if not measured:
        return params
    larger = {
        name: max(getattr(params.noise, name), *(getattr(noise, name) for noise in measured))
        for name in ("gyro", "accel", "gyro_bias", "accel_bias")
    }
    return replace(params, noise=replace(params.noise, **larger))


def without_random_walks(params: ChainParams) -> ChainParams:
    """The same filter with a constant calibration, so that a frozen one does not drift."""
    noise = replace(
        params.noise, gyro_bias=0.0, accel_bias=0.0, scale=0.0, mounting=0.0, offset=0.0, slip=0.0
    )
    return replace(params, noise=noise)
