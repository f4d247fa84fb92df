"""The extended Kalman filter of the paper: prediction, marker correction, anatomy."""

from __future__ import annotations

import numpy as np

from tracker.fusion.kalman import update_with
from tracker.fusion.vist.anatomy import Anatomy
from tracker.fusion.vist.layout import ERRORS, P, V, VistLayout
from tracker.fusion.vist.loose import loose_rows
from tracker.fusion.vist.markers import Expected, Matched
from tracker.fusion.vist.params import VistParams
from tracker.fusion.vist.points import in_joint_rows, jacobians, own_covariance
from tracker.fusion.vist.rest import rest_rows
from tracker.fusion.vist.state import VistState, inject
from tracker.messages import Array


class VistFilter:
    """Updates a `VistState`; holds nothing that changes.

    Lee et al. 2021, doi:10.1126/scirobotics.abe1315, "Correction with visual information" (eq. 10)
    and "Correction with anatomical constraints".
    """

    def __init__(self, layout: VistLayout, params: VistParams) -> None:
        self._layout, self._params = layout, params
        self._anatomy = Anatomy(layout, params.constraint)

    def constrain(self, state: VistState) -> None:
        """Anatomy alone, while no image comes."""
        H, r, variance = self._anatomy.rows(state)
        self._update(state, H, r, np.diag(variance))

    def rest(self, state: VistState) -> None:
        """The hand is known to keep still."""
        self._update(state, *rest_rows(state, self._layout))

    def correct(
        self, state: VistState, expected: Expected, matched: Matched, often: float = 1.0
    ) -> None:
        """Eq. 10 and the constraints in one stacked update, linearised at one state.

        ``often`` multiplies all noise: what is wrong with a marker's position or a joint's axis is
        the same in the next image, so more images a second tell no more. The innovation uses
        the predicted markers themselves; the shift that correspondence found only served the
        assignment.
        """
        H, r, variance = self._anatomy.rows(state)
        R = np.diag(variance * often)
        if len(matched):
            H_m, r_m, R_m = self._seen_rows(state, expected, matched)
            R_m *= often
            H, r = np.concatenate([H_m, H]), np.concatenate([r_m, r])
            both = np.zeros((len(r), len(r)))
            both[: len(R_m), : len(R_m)] = R_m
            both[len(R_m) :, len(R_m) :] = R
            R = both
        self._update(state, H, r, R)

    def _seen_rows(
        self, state: VistState, expected: Expected, matched: Matched
    ) -> tuple[Array, Array, Array]:
        if self._params.coupling == "loose":
            return loose_rows(state, self._layout, matched, self._params.noise.huber)
        return self.marker_rows(expected, matched)

    def marker_rows(self, expected: Expected, matched: Matched) -> tuple[Array, Array, Array]:
        """H (3 k, 21 n), innovation (3 k,) m and noise (3 k, 3 k) m² of k matched markers."""
        lay, k = self._layout, len(matched)
        segment = lay.chain.marker_segment[matched.marker]
        H = in_joint_rows(expected.H[matched.marker], segment, lay.size).reshape(-1, lay.size)
        r = matched.p_G - expected.p_G[matched.marker]  # eq. 10
        S = expected.cov[matched.marker] + matched.cov
        distance = np.sqrt(np.einsum("ki,ki->k", r, np.linalg.solve(S, r[..., None])[..., 0]) / 3)
        weight = np.maximum(1.0, distance / self._params.noise.huber) ** 2
        R = np.zeros((k, 3, k, 3))
        R[np.arange(k), :, np.arange(k), :] = matched.cov * weight[:, None, None]
        return H, r.ravel(), R.reshape(3 * k, 3 * k)

    def _update(self, state: VistState, H: Array, r: Array, R: Array) -> None:
        HP = H @ state.P
        if state.held_back.any():  # a known error of the nominal state: the update takes it back
            back = np.zeros((self._layout.n, ERRORS))
            back[:, P : P + 3], back[:, V : V + 3] = state.held_back
            dx, _ = update_with(state.P, HP, HP @ H.T, H @ back.ravel(), R)
            state.held_back = state.held_back - np.stack([dx[P : P + 3], dx[V : V + 3]])
        dx, state.P = update_with(state.P, HP, HP @ H.T, r, R)
        inject(state, dx)

    def tip_sd(self, state: VistState) -> Array:
        """(n,) m: root of the mean variance of each segment's far end."""
        segment = np.arange(self._layout.n)
        cov = own_covariance(state, jacobians(state, segment, self._layout.tip_lever), segment)
        return np.sqrt(np.maximum(np.trace(cov, axis1=1, axis2=2) / 3, 0.0))
