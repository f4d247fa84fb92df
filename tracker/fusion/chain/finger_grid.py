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

from tracker.messages import Array
from tracker.vision.finger_cloth import ASIDE, BEND, FLEXION, JOINT_X, JOINT_Y

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
INDEPENDENT = 0.4  # probability that a finger does not follow its neighbour: people point
STAYS = 0.45  # share of the probabilities that is still valid after `PERIOD`
MOVES = np.deg2rad([12.0, 5.0, 12.0])  # rad in `PERIOD`, flexion, abduction and bend
JOINT_STAYS = 0.97  # as `STAYS`, of where the knuckle is
PERIOD = 0.1  # s
KNUCKLES = SHAPE[JOINT_X] * SHAPE[JOINT_Y]
POSTURES = 40  # that are evaluated with the knuckle anywhere
KEPT, UNLIKELY = 24, 9.0  # cells that are divided, and ln of their least probability, relative
TINY = 1e-12


class FingerFit(NamedTuple):
    """posterior (G,) of the cells of `GRID`; postures (n, 5) at the end of the divisions and their
    weights (n,); evidence, ln of the highest likelihood ratio of a finger to none."""

    posterior: Array
    postures: Array
    weights: Array
    evidence: float


def _halves(share: tuple[float, ...]) -> Array:
    """(n, 5) offsets in a cell that is divided along the axes whose share is not 0."""
    steps = [(-s, s) if s else (0.0,) for s in share]
    return CELL * np.stack(np.meshgrid(*steps, indexing="ij"), axis=-1).reshape(-1, len(share))


DIVISIONS = _halves((0.25, 0.0, 0.25, 0.25, 0.25)), _halves((0.0, 0.25, 0.125, 0.125, 0.125))


def prior(flexion: float, bend: float) -> Array:
    """(G,) for a neighbouring finger with these flexions of its first and second joint, rad."""
    joint = (GRID[:, [JOINT_X, JOINT_Y]] / JOINT_SD) ** 2
    alone = np.exp(-0.5 * (joint.sum(axis=1) + (GRID[:, ASIDE] / ASIDE_SD) ** 2))
    off = (GRID[:, FLEXION] - flexion) / FLEXION_SD, (GRID[:, BEND] - bend) / BEND_SD
    near = alone * np.exp(-0.5 * (off[0] ** 2 + off[1] ** 2))
    return np.asarray((1 - INDEPENDENT) * near / near.sum() + INDEPENDENT * alone / alone.sum())


def aged(posterior: Array, before: Array, dt: float) -> Array:
    """(G,) the ``posterior`` of ``dt`` s ago, where ``before`` is the prior alone (eq. 71).

    The knuckle remains where it is; the finger moves, and after a while follows its neighbour.
    """
    periods = dt / PERIOD
    now, alone = posterior.reshape(SHAPE), before.reshape(SHAPE)
    for axis, moves in zip((FLEXION, ASIDE, BEND), MOVES, strict=True):
        now = _spread(now, axis, float(moves * np.sqrt(periods) / CELL[axis]))
    joints = now.sum(axis=(2, 3, 4), keepdims=True)
    first = alone.sum(axis=(2, 3, 4), keepdims=True)
    stays, joint_stays = STAYS**periods, JOINT_STAYS**periods
    moved = now / np.maximum(joints, TINY**2)
    mixed = stays * moved + (1.0 - stays) * alone / first
    out: Array = (joint_stays * joints + (1.0 - joint_stays) * first) * mixed
    return out.reshape(-1) / out.sum()


def _spread(p: Array, axis: int, sd: float) -> Array:
    """Convolves with a normal distribution of ``sd`` cells; what leaves the grid stays at its
    edge."""
    n, reach = p.shape[axis], int(np.ceil(3 * sd)) + 1
    steps = np.arange(-reach, reach + 1)
    weight = np.exp(-0.5 * (steps / max(sd, 1e-3)) ** 2)
    to = np.clip(np.arange(n)[:, None] + steps, 0, n - 1)
    M = np.zeros((n, n))
    np.add.at(M, (to, np.arange(n)[:, None]), weight / weight.sum())
    return np.moveaxis(np.tensordot(M, p, (1, axis)), 0, axis)


def fit(before: Array, likelihoods: Callable[[Array], Array], share: float) -> FingerFit:
    """The finger after an image: ``before`` (G,) it, ``likelihoods`` (n, 5) -> (n,) are ln of
    likelihood ratios, of which the ``share`` is independent of earlier images."""
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
    return FingerFit(_normal(likely + logs), postures, weights, float(values.max()))


def _coarse(logs: Array, likelihoods: Callable[[Array], Array], share: float) -> Array:
    """(G,) ln of the likelihood ratios of all cells, for ln of their prior ``logs`` (G,): of each
    posture with the knuckle where it most probably is; of the likeliest, with the knuckle
    anywhere."""
    table, grid = logs.reshape(KNUCKLES, -1), GRID.reshape(KNUCKLES, -1, len(AXES))
    knuckle = int(np.argmax(np.exp(table).sum(axis=1)))
    values = np.repeat(likelihoods(grid[knuckle])[None], KNUCKLES, axis=0)
    postures = np.argsort(-(share * values[0] + table[knuckle]), kind="stable")[:POSTURES]
    tried = np.ascontiguousarray(grid[:, postures]).reshape(-1, len(AXES))
    values[:, postures] = likelihoods(tried).reshape(KNUCKLES, -1)
    return np.asarray(values.reshape(-1))


def _likeliest(logs: Array) -> Array:
    """(k,) rows of the highest values, at most `KEPT`, in their order."""
    order = np.argsort(-logs, kind="stable")[:KEPT]
    return np.asarray(order[logs[order] > logs[order[0]] - UNLIKELY])


def _mean_log(logs: Array) -> Array:
    """(k,) ln of the mean of exp of each row of (k, n)."""
    most = logs.max(axis=1)
    return np.asarray(most + np.log(np.exp(logs - most[:, None]).mean(axis=1)))


def _normal(logs: Array) -> Array:
    """exp, with the sum 1."""
    p = np.exp(logs - logs.max())
    return np.asarray(p / p.sum())
