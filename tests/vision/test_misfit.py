"""Distance of matched blobs from their predictions, against NumPy's median."""

from __future__ import annotations

import numpy as np
import pytest

from tracker.vision.correspondence import misfit


@pytest.mark.parametrize("seed", range(20))
def test_misfit_is_the_median_distance_in_both_images(seed: int) -> None:
    rng = np.random.default_rng(seed)
    left, right = rng.uniform(0, 700, (9, 2)), rng.uniform(0, 700, (6, 2))
    uv = rng.uniform(0, 700, (2, 8, 2))
    match = np.stack([rng.permutation(9)[:8], np.append(rng.permutation(6), [-1, -1])])
    match[rng.random(match.shape) < 0.5] = -1
    apart = [
        np.linalg.norm(side[m[m >= 0]] - at[m >= 0], axis=1)
        for side, m, at in zip((left, right), match, uv, strict=True)
    ]
    assert misfit(left, right, match, uv) == np.median(np.concatenate(apart))


def test_without_matches_the_misfit_is_infinite() -> None:
    nothing = np.full((2, 4), -1)
    assert misfit(np.zeros((0, 2)), np.zeros((3, 2)), nothing, np.zeros((2, 4, 2))) == np.inf
