"""The posture of a finger without sensors, as probabilities on a grid (docs/chain.md, "Fingers in
the cloth").

Images of a finger are ambiguous: it may be bent behind another one, or be taken for it. A grid
keeps all its postures until later images decide. Postures are those of
`tracker.vision.finger_cloth`.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from tracker.kernels import kernel
from tracker.kernels.arrays import IntVector, Matrix, Vector, Written
from tracker.messages import Array
from tracker.vision.finger_cloth import (
    ASIDE,
    BEND,
    FLEXION,
    JOINT_X,
    JOINT_Y,
    Finger,
    FingerImages,
    finger_joints,
    finger_likelihoods,
)

AXES = (
    1e-3 * np.array([-9.0, -3.0, 3.0, 9.0]),
    1e-3 * np.array([-4.0, 0.0, 4.0]),
    np.deg2rad(np.arange(-20.0, 101.0, 13.3)),
    np.deg2rad(np.arange(-20.0, 21.0, 10.0)),
    np.deg2rad(np.arange(2.0, 116.0, 14.0)),
)
SHAPE = tuple(len(a) for a in AXES)
FLEXIONS, ASIDES, BENDS = SHAPE[FLEXION], SHAPE[ASIDE], SHAPE[BEND]
KNUCKLES = SHAPE[JOINT_X] * SHAPE[JOINT_Y]
CELLS = FLEXIONS * ASIDES * BENDS  # of each position of the knuckle
CELL = np.array([a[1] - a[0] for a in AXES])
GRID = np.stack(np.meshgrid(*AXES, indexing="ij"), axis=-1).reshape(-1, len(AXES))
KNUCKLE = np.ascontiguousarray(GRID[::CELLS, :FLEXION])  # (12, 2) m
POSTURE = np.ascontiguousarray(GRID[:CELLS, FLEXION:])  # (450, 3) rad
JOINT_SD = 1e-3 * np.array([4.0, 2.0])  # m: hand files differ from hands in where knuckles are
FLEXION_SD, BEND_SD = np.deg2rad(24.0), np.deg2rad(26.0)  # rad, about the neighbouring finger's
ASIDE_SD = np.deg2rad(5.0)  # rad
MOST_BEND, MORE_BEND = np.deg2rad([75.0, 105.0]), np.array([0.6, 3.0])
BEND_LIMIT_SD = np.deg2rad(12.0)
"""Bends up to which all are alike, with the knuckle straight, rad, and more of them per flexion
there, of which the lower one is valid; sd beyond. Fingers that are bent as far as they can be bend
the knuckle too, and never backwards: in recordings of people, 99 % of the fingers whose knuckle is
bent by 10 to 20 degrees have bends below 46, and by 20 to 30 degrees, below 71."""
LEAST_FLEXION, BACKWARDS_SD = np.deg2rad([-12.0, 9.0])
"""Flexion of the knuckle down to which all are alike, and sd below, rad: in recordings of people,
1 % of the ring and little fingers are bent backwards by more than 12.6 degrees, and 0.4 % by more
than 20."""
INDEPENDENT = 0.5  # probability that a finger does not follow its neighbour: people point
STAYS = 0.6  # share of the probabilities that is still valid after `PERIOD`
MOVES = np.deg2rad([12.0, 5.0, 12.0])  # rad in `PERIOD`, flexion, abduction and bend
JOINT_STAYS = 0.995  # as `STAYS`, of where the knuckle is
PERIOD = 0.1  # s
POSTURES = 16  # that are evaluated with the knuckle elsewhere
LEAST_KNUCKLE = 0.003  # probability of a position of the knuckle that is evaluated
KEPT, UNLIKELY = 16, 6.0  # cells that are divided, and ln of their least probability, relative
IMPROBABLE = 10.0  # ln, below the most probable one, of cells that one image decides
ATTRACTS = 4.0  # ln of the likelihood ratio, maximum, for the posture of a hidden finger
TINY = 1e-12


class FingerFit(NamedTuple):
    """posterior (G,) of the cells of `GRID`; postures (n, 5) at the end of the divisions and their
    weights (n,); evidence, ln of the highest likelihood ratio of a finger to none; follows, ln of
    the likelihood ratio of a finger that follows its neighbour to one that does not; whole, ln of
    the mean likelihood ratio of all postures; hidden (5,), the posture if the finger is hidden."""

    posterior: Array
    postures: Array
    weights: Array
    evidence: float
    follows: float
    whole: float
    hidden: Array


def _halves(share: tuple[float, ...]) -> Array:
    """(n, 5) offsets in a cell that is divided along the axes whose share is not 0."""
    steps = [(-s, s) if s else (0.0,) for s in share]
    return CELL * np.stack(np.meshgrid(*steps, indexing="ij"), axis=-1).reshape(-1, len(share))


ONCE, AGAIN = _halves((0.25, 0.0, 0.25, 0.25, 0.25)), _halves((0.0, 0.25, 0.125, 0.0, 0.125))
"""Offsets of the first and the second division."""


def _share(values: Array, sd: Array) -> Array:
    p: Array = np.exp(-0.5 * ((values / sd) ** 2).sum(axis=1))
    return p / p.sum()


KNUCKLE_P = _share(KNUCKLE, JOINT_SD)  # (12,)
ASIDE_P = _share(AXES[ASIDE][:, None], ASIDE_SD)  # (5,)
FLEXION_AT, ASIDE_AT, BEND_AT = (AXES[a] for a in (FLEXION, ASIDE, BEND))


def _possible() -> Array:
    """(flexions, bends) of a finger: 1 where it bends as far, less beyond (`MOST_BEND`,
    `LEAST_FLEXION`)."""
    limit = np.min(MOST_BEND + MORE_BEND * FLEXION_AT[:, None], axis=1)
    beyond = np.maximum((BEND_AT - limit[:, None]) / BEND_LIMIT_SD, 0.0)
    backwards = np.maximum((LEAST_FLEXION - FLEXION_AT) / BACKWARDS_SD, 0.0)
    return np.asarray(np.exp(-0.5 * (beyond**2 + backwards[:, None] ** 2)))


POSSIBLE = _possible()


@kernel
def _near(at: Vector, middle: float, sd: float) -> Vector:
    """(n,) of a normal distribution at the values of an axis."""
    p = np.exp(-0.5 * ((at - middle) / sd) ** 2)
    return p / p.sum()


@kernel(wide=True)
def prior(neighbour: Vector, independent: float) -> Vector:
    """(G,) of a finger that follows one in the posture ``neighbour`` (5,), or not: the latter with
    the probability ``independent``."""
    out = np.empty(KNUCKLES * CELLS)
    flexion = _near(FLEXION_AT, neighbour[FLEXION], FLEXION_SD)
    bend = _near(BEND_AT, neighbour[BEND], BEND_SD)
    together, n = 0.0, 0
    for f in range(FLEXIONS):
        for b in range(BENDS):
            together += flexion[f] * bend[b] * POSSIBLE[f, b]
    together = (1.0 - independent) / together
    alone = independent / POSSIBLE.sum()
    for k in range(KNUCKLES):
        for f in range(FLEXIONS):
            for a in range(ASIDES):
                p = KNUCKLE_P[k] * ASIDE_P[a]
                for b in range(BENDS):
                    out[n] = p * POSSIBLE[f, b] * (together * flexion[f] * bend[b] + alone)
                    n += 1
    return out


@kernel
def _spread(n: int, sd: float) -> Matrix:
    """(n, n) matrix that convolves with a normal distribution of ``sd`` cells; what leaves the grid
    stays at its edge."""
    reach = int(np.ceil(3 * sd)) + 1
    out, narrow = np.zeros((n, n)), max(sd, 1e-3)
    for i in range(n):
        total = 0.0
        for to in range(-reach, n + reach):
            p = np.exp(-0.5 * ((to - i) / narrow) ** 2)
            out[min(max(to, 0), n - 1), i] += p
            total += p
        out[:, i] /= total
    return out


@kernel
def _moved(p: Vector, along: Matrix, across: Matrix, bent: Matrix) -> Vector:
    """(450,) probabilities of postures after a motion with the matrices `_spread` of flexion,
    abduction and bend."""
    one, two = np.zeros((FLEXIONS * ASIDES, BENDS)), np.zeros((FLEXIONS, ASIDES * BENDS))
    for i in range(FLEXIONS * ASIDES):
        for b in range(BENDS):
            q = p[i * BENDS + b]
            for c in range(BENDS):
                one[i, c] += bent[c, b] * q
    for f in range(FLEXIONS):
        for a in range(ASIDES):
            for to in range(ASIDES):
                for c in range(BENDS):
                    two[f, to * BENDS + c] += across[to, a] * one[f * ASIDES + a, c]
    out = np.zeros(CELLS)
    for to in range(FLEXIONS):
        for f in range(FLEXIONS):
            for i in range(ASIDES * BENDS):
                out[to * ASIDES * BENDS + i] += along[to, f] * two[f, i]
        for i in range(ASIDES * BENDS):
            out[to * ASIDES * BENDS + i] *= POSSIBLE[to, i % BENDS]
    return out


@kernel(wide=True)
def aged(posterior: Vector, before: Vector, dt: float) -> Vector:
    """(G,) the ``posterior`` of ``dt`` s ago, where ``before`` is the prior alone (eq. 72).

    The knuckle remains where it is; the finger moves, and after a while follows its neighbour.
    """
    out = np.empty(KNUCKLES * CELLS)
    root = np.sqrt(dt / PERIOD)
    along = _spread(FLEXIONS, MOVES[0] * root / CELL[FLEXION])
    across = _spread(ASIDES, MOVES[1] * root / CELL[ASIDE])
    bent = _spread(BENDS, MOVES[2] * root / CELL[BEND])
    stays, joint_stays = STAYS ** (dt / PERIOD), JOINT_STAYS ** (dt / PERIOD)
    for k in range(KNUCKLES):
        first, end = k * CELLS, (k + 1) * CELLS
        moved, alone = _moved(posterior[first:end], along, across, bent), before[first:end]
        here, at_first = moved.sum(), alone.sum()
        kept = stays / max(here, TINY**2)
        joint = joint_stays * here + (1.0 - joint_stays) * at_first
        for i in range(CELLS):
            mixed = kept * moved[i] + (1.0 - stays) / at_first * alone[i]
            out[first + i] = joint * mixed
    return out / out.sum()


@kernel
def highest(values: Vector, most: int) -> IntVector:
    """(k,) rows of the highest values, at most ``most`` and at least one, in descending order, of
    equal ones the first."""
    rows, n = np.empty(most, np.int64), 0
    for i in range(len(values)):
        v = values[i]
        if n == most and v <= values[rows[n - 1]]:
            continue
        j = min(n, most - 1)
        n = j + 1
        while j > 0 and values[rows[j - 1]] < v:
            rows[j] = rows[j - 1]
            j -= 1
        rows[j] = i
    return rows[:n]


@kernel
def _put_posture(out: Written[Vector], knuckle: int, posture: int) -> None:
    """A cell of the grid."""
    out[:FLEXION] = KNUCKLE[knuckle]
    out[FLEXION:] = POSTURE[posture]


@kernel
def _in_both(tried: Matrix, log_prior: Vector, images: FingerImages, share: float) -> Vector:
    """(n,) ln of the likelihood ratios of postures (n, 5), times ``share``. Those that the first
    image makes improbable count it twice, and are not evaluated in the second one."""
    windows, maps, depth = images.windows, images.maps, images.depth
    if len(windows) < 2:
        return share * finger_likelihoods(tried, images)
    finger, rig, disparity = images.finger, images.rig, images.disparity
    one = FingerImages(finger, rig, windows[:1], maps[:1], depth, disparity, images.inside)
    other = FingerImages(finger, rig, windows[1:], maps[1:], depth[:0], disparity, images.inside)
    first = share * finger_likelihoods(tried, one)
    expected = 2.0 * first + log_prior
    rows = np.nonzero(expected > expected.max() - IMPROBABLE)[0]
    left = np.empty((len(rows), tried.shape[1]))
    for i in range(len(rows)):
        left[i] = tried[rows[i]]
    second, out = share * finger_likelihoods(left, other), 2.0 * first
    for i in range(len(rows)):
        out[rows[i]] = first[rows[i]] + second[i]
    return out


@kernel
def _coarse(before: Vector, images: FingerImages, share: float) -> tuple[Matrix, IntVector]:
    """ln of the likelihood ratios of all cells (12, 450): of each posture with the knuckle where it
    most probably is; of the likeliest, with the knuckle anywhere it may be. And the latter postures
    (n,)."""
    table = before.reshape(KNUCKLES, CELLS)
    tried, mass = np.empty((CELLS, len(CELL))), np.empty(KNUCKLES)
    for k in range(KNUCKLES):
        mass[k] = table[k].sum()
    knuckle = int(np.argmax(mass))
    for i in range(CELLS):
        _put_posture(tried[i], knuckle, i)
    log_prior = np.log(table[knuckle] + TINY)
    values = _in_both(tried, log_prior, images, share)
    best = highest(values + log_prior, POSTURES)
    out, again = np.empty((KNUCKLES, CELLS)), np.empty((len(best), len(CELL)))
    for k in range(KNUCKLES):
        out[k] = values
        if k != knuckle and mass[k] >= LEAST_KNUCKLE:
            for j in range(len(best)):
                _put_posture(again[j], k, best[j])
            there = share * finger_likelihoods(again, images)
            for j in range(len(best)):
                out[k, best[j]] = there[j]
    return out, best


@kernel
def _exp(likely: Matrix, different: IntVector, shift: float) -> Matrix:
    """exp(likely - shift) of (12, 450) numbers whose rows differ in the columns ``different``."""
    out = np.empty(likely.shape)
    first = np.exp(likely[0] - shift)
    for k in range(KNUCKLES):
        out[k] = first
        for i in different:
            out[k, i] = np.exp(likely[k, i] - shift)
    return out


@kernel
def _divided(postures: Matrix, offsets: Matrix) -> Matrix:
    out = np.empty((len(postures) * len(offsets), len(CELL)))
    for i in range(len(postures)):
        for j in range(len(offsets)):
            out[i * len(offsets) + j] = postures[i] + offsets[j]
    return out


@kernel
def _likeliest(p: Vector) -> IntVector:
    """(k,) rows of the most probable ones, at most `KEPT`, in their order."""
    order = highest(p, KEPT)
    n = len(order)
    while p[order[n - 1]] <= p[order[0]] * np.exp(-UNLIKELY):
        n -= 1
    return order[:n]


@kernel
def _finest(
    likely: Written[Matrix], ratios: Written[Matrix], before: Vector, images: FingerImages,
    share: float, most: float,
) -> tuple[Matrix, Vector, float]:  # fmt: skip
    """Divides the most probable cells twice: the postures (n, 5) at the end, their weights (n,) and
    the highest ln of their likelihood ratios. A divided cell has the mean of its parts, in
    ``likely`` and in ``ratios``, which is exp(likely - most)."""
    at = _likeliest(ratios.reshape(-1) * (before + TINY))
    cells, prior_ = np.empty((len(at), len(CELL))), np.empty(len(at) * len(ONCE))
    for i in range(len(at)):
        _put_posture(cells[i], at[i] // CELLS, at[i] % CELLS)
        prior_[i * len(ONCE) : (i + 1) * len(ONCE)] = np.log(before[at[i]] + TINY)
    postures = _divided(cells, ONCE)
    values = share * finger_likelihoods(postures, images)
    for i in range(len(at)):
        parts = values[i * len(ONCE) : (i + 1) * len(ONCE)]
        highest_part = parts.max()
        mean = highest_part + np.log(np.exp(parts - highest_part).mean())
        likely[at[i] // CELLS, at[i] % CELLS] = mean
        ratios[at[i] // CELLS, at[i] % CELLS] = np.exp(mean - most)
    logs = values + prior_
    kept = _likeliest(np.exp(logs - logs.max()))
    cells, last_prior = np.empty((len(kept), len(CELL))), np.empty(len(kept) * len(AGAIN))
    for i in range(len(kept)):
        cells[i] = postures[kept[i]]
        last_prior[i * len(AGAIN) : (i + 1) * len(AGAIN)] = prior_[kept[i]]
    postures = _divided(cells, AGAIN)
    values = finger_likelihoods(postures, images)
    logs = share * values + last_prior
    weights = np.exp(logs - logs.max())
    return postures, weights / weights.sum(), values.max()


@kernel
def _unless_refuted(
    neighbour: Vector, there: float, follows: Vector, likely: Matrix, attracted: Matrix
) -> Vector:
    """(5,) the posture of a hidden finger: its ``neighbour``'s (5,), where the ln of the likelihood
    ratio is ``there``, displaced to where the image does not refute it (eq. 73); ``attracted`` is
    exp of `likely`, limited.

    Without an outline, the cloth at a posture may be that of other parts, so it is weak evidence
    for the finger. That there is no cloth is strong evidence against it.
    """
    best = min(likely.max(), ATTRACTS)
    refuted = 1.0 - np.exp(min(min(there, ATTRACTS) - best, 0.0))
    out, total, left = neighbour.copy(), 0.0, np.zeros(3)
    for k in range(KNUCKLES):
        for i in range(CELLS):
            q = follows[k * CELLS + i] * attracted[k, i]
            total += q
            for j in range(3):
                left[j] += q * POSTURE[i, j]
    if total > TINY**2:
        for j in range(3):
            out[FLEXION + j] += refuted * (left[j] / total - neighbour[FLEXION + j])
    return out


@kernel(wide=True)
def fitted(
    before: Vector, neighbour: Vector, images: FingerImages, share: float
) -> tuple[Vector, Matrix, Vector, Vector]:
    """The fields of `FingerFit`, as in `fit`; the last four in one array (8,)."""
    likely, different = _coarse(before, images, share)
    most = likely.max()
    ratios = _exp(likely, different, most)
    postures, weights, evidence = _finest(likely, ratios, before, images, share, most)
    follows, alone = prior(neighbour, 0.0), prior(neighbour, 1.0)
    flat, unit = ratios.reshape(-1), np.exp(most - likely.max())
    to_alone = np.log(unit * (follows * flat).sum() + TINY)
    to_alone -= np.log(unit * (alone * flat).sum() + TINY)
    posterior = before * flat
    at = np.empty((KNUCKLES, len(CELL)))
    attracted, limit, height = np.empty(likely.shape), np.exp(ATTRACTS), np.exp(most)
    for k in range(KNUCKLES):
        at[k] = neighbour
        at[k, :FLEXION] += KNUCKLE[k]
        for i in range(CELLS):
            attracted[k, i] = min(ratios[k, i] * height, limit)
    there = share * finger_likelihoods(at, images).max()
    hidden = _unless_refuted(neighbour, there, follows, likely, attracted)
    total = posterior.sum()
    numbers = np.empty(3 + len(hidden))
    numbers[0], numbers[1], numbers[3:] = evidence, to_alone, hidden
    numbers[2] = most + np.log(total + TINY**2)
    return posterior / total, postures, weights, numbers


def fit(before: Array, neighbour: Array, images: FingerImages, share: float) -> FingerFit:
    """The finger after an image: ``before`` (G,) it; ``neighbour`` (5,) is the posture in which it
    follows its neighbour; of the likelihood ratios in ``images``, the ``share`` is independent of
    earlier images."""
    posterior, postures, weights, numbers = fitted(before, neighbour, images, share)
    evidence, follows, whole = numbers[:3].tolist()
    return FingerFit(posterior, postures, weights, evidence, follows, whole, numbers[3:])


@kernel
def summary(postures: Matrix, weights: Vector, finger: Finger) -> tuple[Vector, Vector, Vector]:
    """Of postures (n, 5) with weights (n,): their mean (5,); the variance (4,) m² per axis of the
    finger's joints and tip; the sd (3,) rad of flexion, abduction and bend."""
    mean, spread = np.zeros((1, len(CELL))), np.zeros(3)
    for i in range(len(postures)):
        mean[0] += weights[i] * postures[i]
    joints, at = finger_joints(postures, finger), finger_joints(mean, finger)[0]
    variance = np.zeros(len(at))
    for i in range(len(postures)):
        for j in range(3):
            spread[j] += weights[i] * (postures[i, FLEXION + j] - mean[0, FLEXION + j]) ** 2
        for j in range(len(at)):
            for x in range(3):
                variance[j] += weights[i] * (joints[i, j, x] - at[j, x]) ** 2 / 3
    return mean[0], variance, np.sqrt(spread)


@kernel
def variance_about(posterior: Vector, finger: Finger, posture: Vector) -> Vector:
    """(4,) m² per axis of a finger's joints and tip relative to those in a posture (5,), for a
    ``posterior`` (G,), with the knuckle in its nominal position."""
    at = np.zeros((CELLS + 1, len(CELL)))
    at[CELLS] = posture
    at[:CELLS, FLEXION:] = POSTURE
    joints = finger_joints(at, finger)
    out = np.zeros(joints.shape[1])
    for i in range(CELLS):
        weight = 0.0
        for k in range(KNUCKLES):
            weight += posterior[k * CELLS + i]
        for j in range(len(out)):
            for x in range(3):
                out[j] += weight * (joints[i, j, x] - joints[CELLS, j, x]) ** 2 / 3
    return out
