"""How far away the glove's cloth is, by its texture in both images (docs/chain.md, "Fingers in the
cloth").

The left window is compared with the right one at each of several disparities, in squares about each
sample. A finger in front of other cloth has no outline, but another distance from the cameras.
"""

from __future__ import annotations

import numpy as np

from tracker.kernels import kernel
from tracker.kernels.arrays import (
    ByteMatrix,
    Float32Stack,
    Int32Matrix,
    Int32Vector,
    Matrix,
    Written,
)
from tracker.messages import Array
from tracker.vision.cloth import INSIDE
from tracker.vision.finger_cloth import DEPTH_EVERY

NEAREST_LEVEL, LEVELS = 8, 15
"""Disparities, in samples relative to that of the windows' centre: from `NEAREST_LEVEL` on, each
one sample less."""
HALF = 2  # samples on each side of the square that is compared
SQUARE = (2 * HALF + 1) ** 2
ONE_BITS = 10
ONE = 1 << ONE_BITS  # counts a product in a sum of up to `SQUARE` products
FEWEST = 9  # samples of it that must be cloth in both images
NOISE = 2.0  # samples; cloth without texture has equal bits at random
GAIN = 8.0  # independent samples in a square
VISIBLE = 0.7  # probability that nothing is in front of a finger
MOST = 4.0  # ln of the likelihood ratio, at most


def _likelihoods() -> Array:
    """(SQUARE + 1, 2 SQUARE + 1) by the number of samples, and by how many more of them are equal
    than different, plus `SQUARE`: relative to squares of different surfaces, of a normal
    distribution with that correlation."""
    count, more = np.arange(SQUARE + 1)[:, None], np.arange(-SQUARE, SQUARE + 1)
    correlation = np.clip(more / (count + NOISE), 0.0, 0.95) * (count >= FEWEST)
    return np.asarray((1.0 - correlation**2) ** (-0.5 * GAIN), np.float32)


LIKELIHOOD = _likelihoods()


@kernel
def _add_row(sums: Written[Int32Vector], left: Int32Vector, right: Int32Vector, n: int) -> None:
    """Adds ``n`` times (1 or -1) the products of two rows to ``sums``, and their number `ONE`
    times."""
    once, many = np.int32(n), np.int32(n * ONE)
    for x in range(len(sums)):
        product = np.int32(left[x] * right[x])
        sums[x] += np.int32(once * product) + np.int32(many * np.int32(product * product))


@kernel(wide=True)
def matches(left: Int32Matrix, right: Int32Matrix) -> Float32Stack:
    """(LEVELS, n / 2, n / 2) likelihoods (`_likelihoods`) that squares about every second sample of
    the left window are seen by the right camera at each of the disparities. The textures (n, n) of
    the windows have 1 and -1, and 0 without cloth."""
    side, width = len(left), 2 * HALF + 1
    out = np.ones((LEVELS, side // DEPTH_EVERY, side // DEPTH_EVERY), np.float32)
    moved, sums = np.zeros((side, side), np.int32), np.zeros(side, np.int32)
    columns = np.empty(out[0].shape, np.uint64)  # of the cloth, by row
    count = np.zeros(len(columns), np.int64)
    for j in range(1, len(count) - 1):
        for i in range(1, len(count) - 1):
            columns[j, count[j]] = i
            count[j] += left[DEPTH_EVERY * j, DEPTH_EVERY * i] != 0
    likelihoods = LIKELIHOOD.reshape(-1)
    for k in range(LEVELS):
        shift = NEAREST_LEVEL - k
        first, end = max(shift, 0), min(side, side + shift)
        moved[:] = 0
        moved[:, first:end] = right[:, first - shift : end - shift]
        sums[:] = 0
        for last in range(side):
            _add_row(sums, left[last], moved[last], 1)
            if last >= width:
                _add_row(sums, left[last - width], moved[last - width], -1)
            j = (last - HALF) // DEPTH_EVERY
            if j < 1 or DEPTH_EVERY * j != last - HALF:
                continue
            to = out[k, j]
            for n in range(count[j]):
                i, total = columns[j, n], np.int32(0)
                start = np.uint64(DEPTH_EVERY) * i - np.uint64(HALF)
                for x in range(width):
                    total += sums[start + np.uint64(x)]
                products = (total + np.int32(ONE // 2)) >> np.int32(ONE_BITS)
                row = len(LIKELIHOOD[0]) * products
                to[i] = likelihoods[np.uint64(row + total - ONE * products + SQUARE)]
    return out


@kernel(wide=True)
def depth_evidence(
    likelihoods: Float32Stack, classes: ByteMatrix, known: Matrix, level: Matrix
) -> Float32Stack:
    """(LEVELS, n / 2 + 2, n / 2 + 2) ln of the likelihood ratio of a finger whose surface has one
    of the disparities to none (eq. 71), at every second sample; 0 in a border of one of these.
    ``likelihoods`` are `matches` and ``classes`` (n, n) those of the left window; ``known``
    (n / 2, n / 2) is the probability that other parts cover a sample, and ``level`` (n / 2, n / 2)
    the number of the disparity of their surface."""
    side = len(classes) // DEPTH_EVERY
    out = np.zeros((LEVELS, side + 2, side + 2), np.float32)
    here = np.empty(LEVELS)
    for y in range(side):
        for x in range(side):
            if classes[DEPTH_EVERY * y, DEPTH_EVERY * x] != INSIDE:
                continue
            total = 0.0
            for k in range(LEVELS):
                a, b = max(k - 1, 0), min(k + 1, LEVELS - 1)
                here[k] = 0.5 * likelihoods[k, y, x]
                here[k] += 0.25 * (likelihoods[a, y, x] + likelihoods[b, y, x])
                total += here[k]
            e, near = known[y, x], 0.0
            at = int(min(max(level[y, x], 0.0), LEVELS - 1.0) + 0.5)
            scale = 1.0 / (e * here[at] + (1.0 - e) * total / LEVELS)
            for k in range(LEVELS):
                hidden = near / k if k > 0 else here[k]
                finger = VISIBLE * here[k] + (1.0 - VISIBLE) * hidden
                if k > at:
                    finger = e * here[at] + (1.0 - e) * finger
                out[k, y + 1, x + 1] = min(max(np.log(finger * scale), -MOST), MOST)
                near += here[k]
    return out
