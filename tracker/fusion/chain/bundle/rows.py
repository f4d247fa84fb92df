"""What one keyframe says of its pose and of the calibration: whitened rows."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tracker.fusion.chain.bundle.keyframes import Keyframe
from tracker.fusion.chain.constraints import Constraints
from tracker.fusion.chain.kinematics import marker_jacobians, marker_positions
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import ChainParams
from tracker.fusion.chain.pixel_rows import stack_rows
from tracker.fusion.chain.prediction import PosedRig, pixel_jacobians
from tracker.fusion.chain.state import ChainState
from tracker.fusion.chain.tilt import tilt_rows
from tracker.messages import Array
from tracker.vision.rig import StereoRig


class KeyframeRows:
    """Pixels, anatomy and the fingers' accelerometers of a keyframe, each divided by its noise.

    A marker's placement is a state here, so what is left of its noise is the cloth's slip.
    """

    def __init__(self, layout: ChainLayout, rig: StereoRig, params: ChainParams) -> None:
        self._layout, self._rig, self._params = layout, rig, params
        anatomy = replace(params.constraint, rotation=params.bundle.rotation)
        self._constraints = Constraints(layout, anatomy)

    def __call__(self, state: ChainState, frame: Keyframe) -> tuple[Array, Array]:
        """H (m, N) and residual r (m,), both of unit noise, at ``state``."""
        H_px, r_px = self._pixels(state, frame)
        H_c, r_c, variance = self._constraints.rows(state)
        parts = [(H_px, r_px), _scaled(H_c, r_c, variance)]
        tilt = tilt_rows(state, self._layout, self._params.constraint, frame.packets)
        if tilt is not None:
            parts.append(_scaled(*tilt))
        return np.concatenate([H for H, _ in parts]), np.concatenate([r for _, r in parts])

    def _pixels(self, state: ChainState, frame: Keyframe) -> tuple[Array, Array]:
        lay, rig, noise = self._layout, self._rig, self._params.noise
        rows = np.flatnonzero(np.isfinite(frame.uv[..., 0]).any(axis=0))
        p_G = marker_positions(state, lay)[rows]
        p_C = (p_G - frame.pose.p_GC) @ frame.pose.R_GC
        uv = np.stack([rig.project(p_C), rig.project(p_C, right=True)])
        H = marker_jacobians(state, lay, rows)
        A = pixel_jacobians(p_C, PosedRig.of(rig, frame.pose))
        slip = noise.pixel._replace(marker=self._params.bundle.slip)
        residual = np.ascontiguousarray(frame.uv[:, rows] - uv)
        H_px, _, r, R = stack_rows(H, np.zeros_like(H), A, residual, slip)
        L = np.linalg.cholesky(R)
        return np.linalg.solve(L, H_px), np.linalg.solve(L, r)


def _scaled(H: Array, r: Array, variance: Array) -> tuple[Array, Array]:
    sd = np.sqrt(variance)
    return H / sd[:, None], r / sd
