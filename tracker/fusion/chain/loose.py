"""Loose coupling in the chain: poses of segments instead of markers correct it."""

from __future__ import annotations

import numpy as np
from scipy.linalg import block_diag

from tracker.fusion.ablations.segment_pose import by_segment, fit_pose, softened, stereo_covariance
from tracker.fusion.chain.kinematics import marker_positions
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import NoiseParams
from tracker.fusion.chain.pixels import SeenBlobs
from tracker.fusion.chain.prediction import Prediction
from tracker.fusion.chain.state import ChainState
from tracker.geometry import so3
from tracker.messages import Array, CameraPose, IntArray
from tracker.vision.rig import StereoRig


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
