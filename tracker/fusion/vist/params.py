"""Parameters of the paper's filter; defaults tuned on simulated people."""

from __future__ import annotations

from dataclasses import dataclass, field

from tracker.fusion.chain.params import MatchParams


@dataclass(frozen=True)
class VistNoise:
    """Continuous noises (per √s) of eq. 9 and standard deviations of a marker (eq. 10)."""

    gyro: float = 0.01  # rad/√s: far above the data sheet, covers scale error and cloth
    accel: float = 0.1  # m/s²·√s
    gyro_bias: float = 2e-4  # rad/s/√s
    accel_bias: float = 2e-3  # m/s²/√s
    scale: float = 1e-4  # 1/√s
    mounting: float = 4e-3  # rad/√s: not zero, because cloth moves
    silent_rotation: float = 1.0  # rad/√s, of a segment whose IMU is invalid
    silent_accel: float = 10.0  # m/s²·√s, likewise for its position
    marker: float = 0.0025  # m: a persistent placement error treated as white, hence twice its size
    pixel_px: float = 1.0
    huber: float = 3.0  # standard deviations, beyond which a marker's weight is reduced


@dataclass(frozen=True)
class VistPrior:
    """Standard deviations at the start."""

    position: float = 0.020  # m
    velocity: float = 0.3  # m/s
    rotation: float = 0.12  # rad
    gyro_bias: float = 0.026  # rad/s, 1.5 °/s
    accel_bias: float = 0.3  # m/s²
    mounting: float = 0.0873  # rad, 5° per axis
    common_length: float = 0.06  # relative, of the whole hand
    common_girth: float = 0.06
    own_length: float = 0.015  # relative, of one segment in addition
    own_girth: float = 0.02


@dataclass(frozen=True)
class VistConstraint:
    """Anatomy as pseudo-measurements, applied once per image."""

    position: float = 0.0015  # m: two segments meet at their joint
    rotation: float = 0.06  # rad: no twist, no abduction of a hinge
    period: float = 0.03  # s between two uses while no image arrives


@dataclass(frozen=True)
class VistMatch:
    """Correspondence. ``guide`` ("imu": eqs. 1 to 6): `tracker.fusion.ablations.variants`."""

    guide: str = "imu"
    gate: float = 30.0  # Mahalanobis² of three degrees of freedom
    reach: float = 0.02  # m beyond three standard deviations, within which blobs are candidates
    min_prior: float = 0.01  # markers less likely to be seen by both cameras are ignored


@dataclass(frozen=True)
class VistParams:
    """The vist engine's settings. ``coupling``: `tracker.fusion.ablations.variants`."""

    coupling: str = "tight"
    noise: VistNoise = field(default_factory=VistNoise)
    prior: VistPrior = field(default_factory=VistPrior)
    constraint: VistConstraint = field(default_factory=VistConstraint)
    match: VistMatch = field(default_factory=VistMatch)
    tracking: MatchParams = field(default_factory=lambda: MatchParams(min_markers=3))
