"""Blobs shared out between hands before one camera: a marker belongs to one hand.

All gloves wear the same few hues, so a blob near two hands may be either's. What each hand expects
of its own markers, and hides of the other's, decides for both at once, image by image.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import NamedTuple

import numpy as np

from tracker.messages import Array, BlobFrame, Blobs, CameraPose, IntArray
from tracker.vision.correspondence import FORBIDDEN, GateParams, assign_gated
from tracker.vision.rig import Camera, StereoRig
from tracker.vision.visibility import HandShape, MarkerRows, PosedHand, visibility

EVERYONE = -1
"""Owner of a blob that no hand expects: each may look at it."""
OTHERS = -1
"""Hue of a blob that belongs to another hand: no glove wears it."""


@dataclass(frozen=True)
class SharingParams:
    """How a blob finds its hand."""

    placement_sd: float = 0.002  # m, of a marker on its segment
    pixel_sd_px: float = 1.0
    gate: GateParams = field(default_factory=GateParams)
    near: float = 72.0  # Mahalanobis² of a marker, within which a blob has its hand at least


class HandInView(NamedTuple):
    """A hand as it is expected in an image: markers (m rows) with hue (m,), numbered as the image's
    blobs, and sd (m,) m; its segments, which hide what is behind them; and which ids (m,) of the
    glove's ``total`` markers they are."""

    markers: MarkerRows
    hue: IntArray
    sd: Array
    body: PosedHand
    ids: IntArray
    total: int


class _Markers(NamedTuple):
    """Markers of all hands in one image: uv (m, 2) rectified px, S (m, 2, 2) px², hue, prior (m,)
    and the hand (m,) of each."""

    uv: Array
    S: Array
    hue: IntArray
    prior: Array
    hand: IntArray


def share(
    frame: BlobFrame,
    hands: Sequence[HandInView | None],
    rig: StereoRig,
    pose: CameraPose,
    params: SharingParams | None = None,
) -> list[BlobFrame]:
    """The frame for each hand: of blobs that are another's the hue is `OTHERS`; rows stay.

    A hand whose place is unknown is None: it may look at what the others do not explain.
    """
    params = params or SharingParams()
    known = [(i, hand) for i, hand in enumerate(hands) if hand is not None]
    if not known:
        return [frame for _ in hands]
    prior = _priors([hand for _, hand in known], rig, pose)
    left, right = _expected(known, prior, rig, pose, params)
    owners = (
        owners_of(frame.left, left, rig.left, params),
        owners_of(frame.right, right, rig.right, params),
    )
    out = [
        replace(frame, left=_own(frame.left, owners[0], i), right=_own(frame.right, owners[1], i))
        for i in range(len(hands))
    ]
    for (i, hand), p in zip(known, prior, strict=True):
        if len(known) > 1:
            out[i] = replace(out[i], unhidden=_unhidden(hand, p, rig, pose))
    return out


def _priors(hands: Sequence[HandInView], rig: StereoRig, pose: CameraPose) -> list[Array]:
    """(2, m) of each hand's markers to be seen: hands hide one another."""
    markers, body = _together(hands)
    prior = visibility(body, markers, rig, pose)
    return np.split(prior, np.cumsum([len(h.hue) for h in hands])[:-1], axis=1)


def _unhidden(hand: HandInView, prior: Array, rig: StereoRig, pose: CameraPose) -> Array:
    """(2, total) of the glove's markers: what of their ``prior`` (2, m) the other hand leaves."""
    alone = visibility(hand.body, hand.markers, rig, pose)
    out = np.ones((2, hand.total))
    out[:, hand.ids] = np.where(alone > 0.0, prior / np.maximum(alone, 1e-12), 1.0)
    return out


def _own(blobs: Blobs | None, owner: IntArray, hand: int) -> Blobs | None:
    if blobs is None:
        return None
    mine = (owner == hand) | (owner == EVERYONE)
    return blobs if mine.all() else replace(blobs, hue=np.where(mine, blobs.hue, OTHERS))


def owners_of(
    blobs: Blobs | None, markers: _Markers, camera: Camera, params: SharingParams
) -> IntArray:
    """(n,) the hand of each blob of one image, `EVERYONE` where none is near."""
    if blobs is None or len(blobs) == 0:
        return np.zeros(0, np.int64)
    uv = camera.rectify(np.array(blobs.uv))
    owner = np.full(len(uv), EVERYONE, np.int64)
    if len(markers.hue) == 0:  # each hand that is known lies wholly under another
        return owner
    # 1. The markers of all hands compete for all blobs.
    row = assign_gated(
        uv, blobs.hue, markers.uv, markers.S, markers.hue, markers.prior, params.gate
    )
    found = row >= 0
    owner[row[found]] = markers.hand[found]
    # 2. What is no one's marker for sure stays with the hand that is likeliest to have it there.
    rest = np.flatnonzero(owner == EVERYONE)
    cost = _costs(uv[rest], blobs.hue[rest], markers, params)
    nearest = cost.argmin(axis=1)
    near = cost[np.arange(len(rest)), nearest] < FORBIDDEN
    owner[rest[near]] = markers.hand[nearest[near]]
    return owner


def _costs(uv: Array, hue: IntArray, markers: _Markers, params: SharingParams) -> Array:
    """(n, m) Mahalanobis² + ln det S - 2 ln p, FORBIDDEN between hues and far away."""
    apart = uv[:, None] - markers.uv
    inverse = np.linalg.inv(markers.S)
    d2 = np.einsum("nmi,mij,nmj->nm", apart, inverse, apart)
    prior = np.maximum(markers.prior, params.gate.min_prior)
    cost = d2 + np.log(np.linalg.det(markers.S)) - 2.0 * np.log(prior)
    out: Array = np.where((d2 < params.near) & (hue[:, None] == markers.hue), cost, FORBIDDEN)
    return out


def _expected(
    known: Sequence[tuple[int, HandInView]],
    priors: Sequence[Array],
    rig: StereoRig,
    pose: CameraPose,
    params: SharingParams,
) -> tuple[_Markers, _Markers]:
    """The markers of all hands in the left and the right image, with their ``priors`` (2, m)."""
    hands = [hand for _, hand in known]
    number = np.concatenate([np.full(len(h.hue), i, np.int64) for i, h in known])
    hue = np.concatenate([h.hue for h in hands])
    prior = np.concatenate(priors, axis=1)
    p_C = (np.concatenate([h.markers.p_G for h in hands]) - pose.p_GC) @ pose.R_GC
    variance = np.concatenate([h.sd for h in hands]) ** 2 + params.placement_sd**2
    out = []
    for c in range(2):
        uv = rig.project(p_C, right=bool(c))
        J = _jacobians(p_C - [rig.baseline * c, 0.0, 0.0], rig)
        S = variance[:, None, None] * J @ J.swapaxes(1, 2) + params.pixel_sd_px**2 * np.eye(2)
        there = np.isfinite(uv[:, 0])
        out.append(_Markers(uv[there], S[there], hue[there], prior[c][there], number[there]))
    return out[0], out[1]


def _jacobians(p_C: Array, rig: StereoRig) -> Array:
    """(m, 2, 3) of rectified pixels against points (m, 3) in the camera's own frame."""
    x, y, z = p_C.T
    none = np.zeros(len(p_C))
    return np.stack(
        [
            np.stack([rig.fx / z, none, -rig.fx * x / z**2], axis=1),
            np.stack([none, rig.fy / z, -rig.fy * y / z**2], axis=1),
        ],
        axis=1,
    )


def _together(hands: Sequence[HandInView]) -> tuple[MarkerRows, PosedHand]:
    """All markers, and the bodies of all hands as one, whose segments stand one after the other."""
    before = np.cumsum([0, *(len(h.body.p_GB) for h in hands)])
    segment = [h.markers.segment + n for h, n in zip(hands, before, strict=False)]
    markers = MarkerRows(
        np.concatenate([h.markers.p_G for h in hands]),
        np.concatenate([h.markers.normal_G for h in hands]),
        np.concatenate(segment),
    )
    parts = zip(*(h.body.shape for h in hands), strict=True)
    shape = HandShape(*(np.concatenate(part) for part in parts))
    body = PosedHand(
        shape,
        np.concatenate([h.body.R_GB for h in hands]),
        np.concatenate([h.body.p_GB for h in hands]),
    )
    return markers, body
