"""Where a fingertip touches: the lowest point of its round end, and how the wearer's pulp differs.

In a touch, target = tip + base + R_GB offset - bias + noise: ``base`` leads to the lowest point of
a round end of the hand file's radius, so it rolls with the finger's inclination; ``offset``,
constant in the tip's frame, is how the wearer's pulp differs; ``bias`` is the tracker's constant
error. Turning the hand separates offset and bias, as far as the tracker's own error does not turn
with the finger. Errors are therefore stated with an offset that is held near zero by what is known
of pulps (`OFFSET_SD`), and the offset that fits best without that is stated next to them.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from extensions.touch.rest import CrossTouch
from tracker.messages import Array

OFFSET_SD = 0.0005  # m, each axis: how pulps differ from the hand file
FREE_SD = 0.020  # m: the same where nothing is known
PRESSED = 0.0005
"""m by which a pulp gives way under a light touch (Serina et al. 1997:
the pulp is soft at first contact and stiffens within about 1 N)."""
LEAST_NOISE = 0.0002  # m


@dataclass(frozen=True, eq=False)
class Fit:
    """offset, sd (3,) m in the tip's frame; bias (3,) m in G; residual (n, 3) m in G about it;
    ``noise`` m per axis."""

    offset: Array
    offset_sd: Array
    bias: Array
    residual: Array
    noise: float


@dataclass(frozen=True, eq=False)
class Pulp:
    """One finger: the fit that errors are stated with, and that with a ``free`` offset; ``total``
    (3,) m, the mean contact in the tip's frame, from the tip keypoint to the paper."""

    held: Fit
    free: Fit
    total: Array

    @property
    def offset(self) -> Array:
        """(3,) m in the tip's frame."""
        return self.held.offset

    @property
    def error(self) -> Array:
        """(n, 3) m in G: tracked contact less target."""
        return self.held.bias + self.held.residual


def base_contacts(touches: Sequence[CrossTouch], up_G: Array) -> Array:
    """(n, 3) m in G from the tip to the lowest point of its round end."""
    along = np.array([-1.0, 0.0, 0.0])
    out = [t.radius * (t.R_GB @ along) - (t.radius - PRESSED) * up_G for t in touches]
    return np.array(out)


def fit_pulp(touches: Sequence[CrossTouch], up_G: Array) -> Pulp:
    """For one finger's touches."""
    base = base_contacts(touches, up_G)
    held = _fit(touches, base, OFFSET_SD)
    R = np.array([t.R_GB for t in touches])
    total = np.mean(np.einsum("nji,nj->ni", R, base), axis=0) + held.offset
    return Pulp(held, _fit(touches, base, FREE_SD), total)


def _fit(touches: Sequence[CrossTouch], base: Array, offset_sd: float) -> Fit:
    """Offset and bias by least squares with a normal prior of the offset; the noise follows from
    the residuals by iteration."""
    R = np.array([t.R_GB for t in touches])
    y = (np.array([t.target_G - t.p_G for t in touches]) - base).reshape(-1)
    n, noise = len(touches), 0.002
    A = np.concatenate([R, -np.broadcast_to(np.eye(3), (n, 3, 3))], axis=2).reshape(3 * n, 6)
    prior = np.diag([1 / offset_sd**2] * 3 + [0.0] * 3)
    for _ in range(20):
        cov = np.linalg.inv(A.T @ A / noise**2 + prior)
        x = cov @ (A.T @ y) / noise**2
        off = (A @ x - y).reshape(n, 3)
        used = 6 - float(np.trace(cov[:3, :3])) / offset_sd**2
        noise = max(float(np.sqrt(np.sum(off**2) / max(3 * n - used, 1.0))), LEAST_NOISE)
    return Fit(x[:3], np.sqrt(np.diag(cov))[:3], x[3:], off, noise)
