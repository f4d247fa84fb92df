"""The posture of a finger without sensors, as probabilities on a grid (docs/chain.md, "Fingers in
the cloth").

Images of a finger are ambiguous: it may be bent behind another one, or be taken for it. A grid
keeps all its postures until later images decide. Postures are those of
`tracker.vision.finger_cloth`.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from tracker.kernels import kernel
from tracker.kernels.arrays import IntVector, Vector
from tracker.messages import Array
from tracker.vision.finger_cloth import (
    ASIDE,
    BEND,
    FLEXION,
    JOINT_X,
    JOINT_Y,
    Finger,
    finger_joints,
)

AXES = (
    1e-3 * np.array([-9.0, -3.0, 3.0, 9.0]),
    1e-3 * np.array([-4.0, 0.0, 4.0]),
    np.deg2rad(np.arange(-20.0, 101.0, 13.3)),
    np.deg2rad(np.arange(-20.0, 21.0, 10.0)),
    np.deg2rad(np.arange(2.0, 116.0, 14.0)),
)
SHAPE = tuple(len(a) for a in AXES)
CELL = np.array([a[1] - a[0] for a in AXES])
GRID = np.stack(np.meshgrid(*AXES, indexing="ij"), axis=-1).reshape(-1, len(AXES))
JOINT_SD = 1e-3 * np.array([4.0, 2.0])  # m: hand files differ from hands in where knuckles are
FLEXION_SD, BEND_SD = np.deg2rad(24.0), np.deg2rad(26.0)  # rad, about the neighbouring finger's
ASIDE_SD = np.deg2rad(5.0)  # rad
INDEPENDENT = 0.3  # probability that a finger does not follow its neighbour: people point
STAYS = 0.6  # share of the probabilities that is still valid after `PERIOD`
MOVES = np.deg2rad([12.0, 5.0, 12.0])  # rad in `PERIOD`, flexion, abduction and bend
JOINT_STAYS = 0.97  # as `STAYS`, of where the knuckle is
PERIOD = 0.1  # s
KNUCKLES = SHAPE[JOINT_X] * SHAPE[JOINT_Y]
KNUCKLE_AT = GRID[:: len(GRID) // KNUCKLES] * (1.0, 1.0, 0.0, 0.0, 0.0)
NOMINAL = GRID[: len(GRID) // KNUCKLES] * (0.0, 0.0, 1.0, 1.0, 1.0)
POSTURES = 30  # that are evaluated with the knuckle anywhere
KEPT, UNLIKELY = 16, 9.0  # cells that are divided, and ln of their least probability, relative
ATTRACTS = 4.0  # ln of the likelihood ratio, maximum, for the posture of a hidden finger
TINY = 1e-12


class FingerFit(NamedTuple):
    """posterior (G,) of the cells of `GRID`; postures (n, 5) at the end of the divisions and their
    weights (n,); evidence, ln of the highest likelihood ratio of a finger to none; follows, ln of
    the likelihood ratio of a finger that follows its neighbour to one that does not; hidden (5,),
    the posture if the finger is hidden."""

    posterior: Array
    postures: Array
    weights: Array
    evidence: float
    follows: float
    hidden: Array


def _halves(share: tuple[float, ...]) -> Array:
    """(n, 5) offsets in a cell that is divided along the axes whose share is not 0."""
    steps = [(-s, s) if s else (0.0,) for s in share]
    return CELL * np.stack(np.meshgrid(*steps, indexing="ij"), axis=-1).reshape(-1, len(share))


DIVISIONS = _halves((0.25, 0.0, 0.25, 0.25, 0.25)), _halves((0.0, 0.25, 0.125, 0.0, 0.125))


def _alone() -> Array:
    """(G,) of a finger that does not follow its neighbour."""
    joint = (GRID[:, [JOINT_X, JOINT_Y]] / JOINT_SD) ** 2
    p: Array = np.exp(-0.5 * (joint.sum(axis=1) + (GRID[:, ASIDE] / ASIDE_SD) ** 2))
    return p / p.sum()


ALONE = _alone()


def following(neighbour: Array) -> Array:
    """(G,) of a finger that follows one in the posture ``neighbour`` (5,)."""
    of_flexion = np.exp(-0.5 * ((AXES[FLEXION] - neighbour[FLEXION]) / FLEXION_SD) ** 2)
    of_bend = np.exp(-0.5 * ((AXES[BEND] - neighbour[BEND]) / BEND_SD) ** 2)
    near = (ALONE.reshape(SHAPE) * of_flexion[:, None, None] * of_bend).reshape(-1)
    return np.asarray(near / near.sum())


def prior(neighbour: Array) -> Array:
    """(G,) of a finger that follows one in the posture ``neighbour`` (5,), or not."""
    return np.asarray((1 - INDEPENDENT) * following(neighbour) + INDEPENDENT * ALONE)


def aged(posterior: Array, before: Array, dt: float) -> Array:
    """(G,) the ``posterior`` of ``dt`` s ago, where ``before`` is the prior alone (eq. 71).

    The knuckle remains where it is; the finger moves, and after a while follows its neighbour.
    """
    periods = dt / PERIOD
    sd = MOVES * np.sqrt(periods) / CELL[[FLEXION, ASIDE, BEND]]
    flexions, *others = (
        _spread(SHAPE[a], float(s)) for a, s in zip((FLEXION, ASIDE, BEND), sd, strict=True)
    )
    moved_on = posterior.reshape(-1, SHAPE[ASIDE] * SHAPE[BEND]) @ np.kron(*others).T
    now = (flexions @ moved_on.reshape(KNUCKLES, SHAPE[FLEXION], -1)).reshape(SHAPE)
    alone = before.reshape(SHAPE)
    joints = now.sum(axis=(2, 3, 4), keepdims=True)
    first = alone.sum(axis=(2, 3, 4), keepdims=True)
    stays, joint_stays = STAYS**periods, JOINT_STAYS**periods
    moved = now / np.maximum(joints, TINY**2)
    mixed = stays * moved + (1.0 - stays) * alone / first
    out: Array = (joint_stays * joints + (1.0 - joint_stays) * first) * mixed
    return out.reshape(-1) / out.sum()


def _spread(n: int, sd: float) -> Array:
    """(n, n) matrix that convolves with a normal distribution of ``sd`` cells; what leaves the grid
    stays at its edge."""
    reach = int(np.ceil(3 * sd)) + 1
    to = np.arange(-reach, n + reach)[:, None]
    M = np.exp(-0.5 * ((to - np.arange(n)) / max(sd, 1e-3)) ** 2)
    M[reach] += M[:reach].sum(axis=0)
    M[reach + n - 1] += M[reach + n :].sum(axis=0)
    M = M[reach : reach + n]
    return np.asarray(M / M.sum(axis=0))


def fit(
    before: Array, neighbour: Array, likelihoods: Callable[[Array], Array], share: float
) -> FingerFit:
    """The finger after an image: ``before`` (G,) it; ``neighbour`` (5,) is the posture in which it
    follows its neighbour; ``likelihoods`` (n, 5) -> (n,) are ln of likelihood ratios, of which the
    ``share`` is independent of earlier images."""
    logs = np.log(before + TINY)
    likely = share * _coarse(logs, likelihoods, share)
    # Divide the most probable cells twice; a divided cell has the mean of its parts.
    at = _likeliest(likely + logs)
    postures, log_prior = GRID[at], logs[at]
    for level, offsets in enumerate(DIVISIONS):
        postures = (postures[:, None] + offsets).reshape(-1, len(CELL))
        log_prior = np.repeat(log_prior, len(offsets))
        values = likelihoods(postures)
        if level == 0:
            likely[at] = _mean_log((share * values).reshape(len(at), -1))
            kept = _likeliest(share * values + log_prior)
            postures, log_prior = postures[kept], log_prior[kept]
    weights = _normal(share * values + log_prior)
    ratios, follows = np.exp(likely - likely.max()), following(neighbour)
    to_none = float(np.log((follows @ ratios + TINY) / (ALONE @ ratios + TINY)))
    posterior = before * ratios / (before @ ratios)
    there = share * float(likelihoods(neighbour + KNUCKLE_AT).max())
    hidden = _unless_refuted(neighbour, there, follows, likely)
    return FingerFit(posterior, postures, weights, float(values.max()), to_none, hidden)


def _unless_refuted(neighbour: Array, there: float, follows: Array, likely: Array) -> Array:
    """(5,) the posture of a hidden finger: its ``neighbour``'s (5,), where the ln of the likelihood
    ratio is ``there``, displaced to where the image does not refute it (eq. 72).

    Without an outline, the cloth at a posture may be that of other parts, so it is weak evidence
    for the finger. That there is no cloth is strong evidence against it.
    """
    capped = np.minimum(likely, ATTRACTS)
    left = follows * np.exp(capped)
    refuted = 1.0 - np.exp(min(min(there, ATTRACTS) - float(capped.max()), 0.0))
    shift = refuted * (left @ GRID / (left.sum() + TINY**2) - follows @ GRID)
    shift[[JOINT_X, JOINT_Y]] = 0.0
    return np.asarray(neighbour + shift)


def variance_about(posterior: Array, finger: Finger, posture: Array) -> Array:
    """(4,) m² per axis of a finger's joints and tip relative to those in a posture (5,), for a
    ``posterior`` (G,), with the knuckle in its nominal position."""
    weights = posterior.reshape(KNUCKLES, -1).sum(axis=0)
    off = finger_joints(NOMINAL, finger) - finger_joints(posture[None], finger)
    return np.asarray(weights @ (off**2).sum(axis=2) / 3)


def _coarse(logs: Array, likelihoods: Callable[[Array], Array], share: float) -> Array:
    """(G,) ln of the likelihood ratios of all cells, for ln of their prior ``logs`` (G,): of each
    posture with the knuckle where it most probably is; of the likeliest, with the knuckle
    anywhere."""
    table, grid = logs.reshape(KNUCKLES, -1), GRID.reshape(KNUCKLES, -1, len(AXES))
    knuckle = int(np.argmax(np.exp(table).sum(axis=1)))
    values = np.repeat(likelihoods(grid[knuckle])[None], KNUCKLES, axis=0)
    postures = highest(share * values[0] + table[knuckle], POSTURES)
    tried = np.ascontiguousarray(grid[:, postures]).reshape(-1, len(AXES))
    values[:, postures] = likelihoods(tried).reshape(KNUCKLES, -1)
    return np.asarray(values.reshape(-1))


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


def _likeliest(logs: Array) -> Array:
    """(k,) rows of the highest values, at most `KEPT`, in their order."""
    order = highest(logs, KEPT)
    return np.asarray(order[logs[order] > logs[order[0]] - UNLIKELY])


def _mean_log(logs: Array) -> Array:
    """(k,) ln of the mean of exp of each row of (k, n)."""
    most = logs.max(axis=1)
    return np.asarray(most + np.log(np.exp(logs - most[:, None]).mean(axis=1)))


def _normal(logs: Array) -> Array:
    """exp, with the sum 1."""
    p = np.exp(logs - logs.max())
    return np.asarray(p / p.sum())
