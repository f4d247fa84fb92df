"""The assignment in one image, with arrays as arguments."""

from __future__ import annotations

import numpy as np

from tracker.messages import Array, IntArray
from tracker.vision.correspondence import ExpectedPixels, GateParams, assigned
from tracker.vision.cpd import HuedPixels


def assign_gated(
    uv: Array,
    hue: IntArray,
    predicted_uv: Array,
    S: Array,
    marker_hue: IntArray,
    prior: Array,
    params: GateParams | None = None,
) -> IntArray:
    """The blob (M,) of each marker of one image, -1 for none."""
    params = params or GateParams()
    likely = np.maximum(prior, params.min_prior)
    markers = ExpectedPixels(predicted_uv, S, marker_hue, likely)
    blobs = HuedPixels(uv, hue)
    return np.asarray(
        assigned(blobs, markers, params.gate, params.gate_px, params.dummy_cost), np.int64
    )
