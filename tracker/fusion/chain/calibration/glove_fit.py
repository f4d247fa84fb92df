"""Fits a glove file to a glove: marker positions and IMU mountings, from many postures.

It is the keyframe calibration (docs/chain.md, eqs. 45 to 47) with the priors of a glove that was
measured roughly. Hand size, joints and axes are those of the wearer and remain outside the file.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np

from tracker.base.errors import ConfigError
from tracker.base.notices import notice
from tracker.fusion.chain.bundle.keyframes import Keyframe, Keyframes
from tracker.fusion.chain.bundle.solver import Bundle, BundleWork
from tracker.fusion.chain.layout import ChainLayout
from tracker.fusion.chain.params import BundleParams, ChainParams
from tracker.fusion.chain.profile import WearerProfile
from tracker.fusion.chain.state import ChainState
from tracker.geometry import so3
from tracker.messages import Array, IntArray
from tracker.vision.rig import StereoRig

MARKER, MARKER_NORMAL = 0.003, 0.001  # m, prior sd along the cloth and normal to it
MOUNTING = 0.2  # rad about each axis
MOST_SHIFT = 0.02  # m of a marker along an axis
LEAST_POSTURES = 20
SWEEPS = 8
COLLECT = BundleParams(first_after=np.inf, keyframes=120, apart=0.2, least_blobs=12)
"""Settings that collect postures without a solution while tracking."""


class GloveFit(NamedTuple):
    """Of M markers and n IMUs: marker positions (M, 3) m in B as in a glove file, their offsets
    from the file (M, 3) m with standard deviations (M, 3), in how many postures each marker was
    ``seen`` (M,); mountings R_BI (n, 3, 3), their rotation from the file (n, 3) rad about the axes
    of I, and its standard deviations (n, 3)."""

    position: Array
    offset: Array
    offset_sd: Array
    seen: IntArray
    R_BI: Array
    turn: Array
    turn_sd: Array


def fit_glove(
    layout: ChainLayout, rig: StereoRig, frames: Sequence[Keyframe], state: ChainState
) -> GloveFit:
    """The fit to postures ``frames``, from the calibration of ``state`` on.

    Raises ConfigError if there are too few postures, or if none of them agrees with the glove.
    """
    if len(frames) < LEAST_POSTURES:
        raise ConfigError(
            notice("fit_glove.few_postures", postures=len(frames), least=LEAST_POSTURES)
        )
    params = _rough(ChainParams())
    bundle = Bundle(layout, rig, params, MOST_SHIFT)
    work = BundleWork(next_at=-np.inf, pause=1.0, keyframes=Keyframes(list(frames)))
    solved: WearerProfile | None = None
    for _ in range(1 + SWEEPS * len(frames)):
        solved = bundle.step(work, state)
    if solved is None:
        raise ConfigError(notice("fit_glove.not_fitted", most_mm=1e3 * MOST_SHIFT))
    return _fit(layout, solved, frames)


def _rough(params: ChainParams) -> ChainParams:
    prior = replace(params.prior, marker=MARKER, marker_normal=MARKER_NORMAL, mounting=MOUNTING)
    bundle = replace(params.bundle, sweeps=SWEEPS, least_keyframes=LEAST_POSTURES)
    return replace(params, prior=prior, bundle=bundle)


def _fit(layout: ChainLayout, solved: WearerProfile, frames: Sequence[Keyframe]) -> GloveFit:
    at, n = layout.blocks, layout.n_dynamic
    sd = np.sqrt(np.diag(solved.P))
    scale = solved.scale[layout.marker_segment][:, [0, 1, 1]]
    offset = solved.marker / scale  # a file's positions grow with the segment
    seen = np.sum([np.isfinite(f.uv[..., 0]).any(axis=0) for f in frames], axis=0)
    return GloveFit(
        position=layout.glove.marker_position + offset,
        offset=offset,
        offset_sd=sd[at.marker - n : at.axis - n].reshape(-1, 3) / scale,
        seen=np.asarray(seen, np.int64),
        R_BI=solved.R_IB.swapaxes(1, 2),
        turn=so3.log(layout.R_IB @ solved.R_IB.swapaxes(1, 2)),
        turn_sd=sd[at.phi - n : at.ba - n].reshape(-1, 3),
    )
