"""A simulated laboratory whose clock, axes and markers have known faults."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Protocol

import ezc3d
import numpy as np

from tracker.geometry import so3
from tracker.messages import Array
from tracker.session.description import SessionInfo


class Wearer(Protocol):
    """See conftest."""

    info: SessionInfo

    def points(self, t: Array) -> tuple[Array, Array]: ...


RATE = 120.0  # Hz


@dataclass(frozen=True, eq=False)
class Laboratory:
    """Session time = offset + (1 + drift) t; x_G = R x_L + p; markers at ``markers`` (K, 3) m from
    their keypoints in the segments' axes; ``noise`` m per coordinate."""

    offset: float = 0.0
    drift: float = 0.0
    R_GL: Array = field(default_factory=lambda: np.eye(3))
    p_GL: Array = field(default_factory=lambda: np.zeros(3))
    markers: Array | None = None
    noise: float = 0.0

    def record(self, wearer: Wearer, duration: float) -> tuple[Array, Array]:
        """Times (N,) s of the laboratory and markers (N, K, 3) m in L."""
        t = np.arange(0.0, duration, 1 / RATE)
        x, R_GB = wearer.points(self.offset + (1 + self.drift) * t)
        if self.markers is not None:
            x = x + np.einsum("nkij,kj->nki", R_GB, self.markers)
        noise = np.random.default_rng(9).normal(0, self.noise, x.shape)
        return t, (x - self.p_GL) @ self.R_GL + noise


FAULTY = Laboratory(
    offset=0.037,
    drift=80e-6,
    R_GL=so3.exp(np.deg2rad(3.0) * np.array([0.6, -0.64, 0.48])),
    p_GL=np.array([0.4, -0.2, 1.1]),
    noise=0.0003,
)


def markers(wearer: Wearer) -> Array:
    """Offsets of 5 mm in random directions."""
    d = np.random.default_rng(3).normal(size=(len(wearer.info.keypoint_names), 3))
    return 0.005 * d / np.linalg.norm(d, axis=1)[:, None]


def write_c3d(path: Path, names: tuple[str, ...], points: Array, rate: float = RATE) -> Path:
    """Write a C3D file with ezc3d: points (N, K, 3) in m, stored in mm."""
    file = ezc3d.c3d()
    file["parameters"]["POINT"]["UNITS"]["value"] = ["mm"]
    file["parameters"]["POINT"]["RATE"]["value"] = [rate]
    file["parameters"]["POINT"]["LABELS"]["value"] = list(names)
    data = np.ones((4, len(names), len(points)))
    data[:3] = 1e3 * points.transpose(2, 1, 0)
    file["data"]["points"] = data
    file.write(str(path))
    return path
