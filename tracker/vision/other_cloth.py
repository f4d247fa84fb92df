"""Removes the cloth of one hand from what another hand is measured by (docs/two-gloves.md).

Gloves are made of the same cloth. Tiles of an image that the other hand covers say nothing about
this one: they count as unknown, like tiles outside the image.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from tracker.messages import Array, Blobs, CameraPose, Cloth
from tracker.vision.cloth import TILE
from tracker.vision.rig import NEAREST, Camera, StereoRig
from tracker.vision.visibility import PosedHand

MARGIN = 0.008  # m about the other hand's segments: cloth, folds, and the error of its pose
ALONG = 4  # discs along each segment
ACROSS = 3  # discs across a segment that is broader than thick


def without_hand(
    blobs: Blobs | None, other: PosedHand, rig: StereoRig, pose: CameraPose, right: bool
) -> Blobs | None:
    """The blobs with only that cloth which is not at the ``other`` hand."""
    if blobs is None or blobs.cloth is None:
        return blobs
    centres, radius = _discs(other)
    p_C = (centres - pose.p_GC) @ pose.R_GC
    ahead = p_C[:, 2] > 3 * NEAREST
    if not ahead.any():
        return blobs
    camera: Camera = rig.right if right else rig.left
    uv = camera.unrectify(rig.project(p_C[ahead], right=right))
    size = (radius[ahead] + MARGIN) * rig.fx / p_C[ahead, 2]
    return replace(blobs, cloth=_without(blobs.cloth, uv, size))


def _without(cloth: Cloth, uv: Array, size: Array) -> Cloth:
    """Without the tiles that touch a disc, at uv (k, 2) px with a radius (k,) px."""
    rows, columns = np.divmod(cloth.tile, cloth.columns)
    middle = TILE * (np.stack([columns, rows], axis=1) + 0.5)
    apart = np.maximum(np.abs(middle[:, None] - uv) - TILE / 2, 0.0)
    free = ((apart**2).sum(axis=2) > size**2).all(axis=1)
    bright = None if cloth.bright is None else cloth.bright[free]
    return replace(cloth, tile=cloth.tile[free], bits=cloth.bits[free], bright=bright)


def _discs(hand: PosedHand) -> tuple[Array, Array]:
    """Spheres that together contain a hand: centres (k, 3) m in G and radii (k,) m."""
    length, radius, width = hand.shape
    x = np.linspace(0.0, 1.0, ALONG)[:, None] * length
    y = np.linspace(-1.0, 1.0, ACROSS)[:, None] * np.maximum(width / 2 - radius, 0.0)
    local = np.zeros((ALONG, ACROSS, len(length), 3))
    local[..., 0], local[..., 1] = x[:, None], y[None]
    centres = hand.p_GB + np.einsum("sij,absj->absi", hand.R_GB, local)
    # Between two centres, the spheres are thinner than the segment.
    step = np.maximum(length / (ALONG - 1), 2 * np.abs(y[-1]) / (ACROSS - 1)) / 2
    reach = np.broadcast_to(np.hypot(radius, step), centres.shape[:-1])
    return centres.reshape(-1, 3), reach.reshape(-1)
