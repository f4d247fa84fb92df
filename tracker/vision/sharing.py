"""Assigns blobs to hands in view of one camera: a marker belongs to one hand.

All gloves use the same few hues, so a blob near two hands may belong to either. The predicted
markers of each hand, and their occlusion by the other, are matched jointly for both hands, image by
image.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import pairwise
from typing import NamedTuple

import numpy as np

from tracker.kernels import kernel
from tracker.kernels.arrays import IntVector, Matrix, Stack, Vector
from tracker.messages import Array, BlobFrame, Blobs, CameraPose, IntArray
from tracker.vision.correspondence import FORBIDDEN, ExpectedPixels, GateParams, assigned
from tracker.vision.cpd import HuedPixels
from tracker.vision.other_cloth import without_hand
from tracker.vision.rig import StereoIntrinsics, StereoRig, projected
from tracker.vision.visibility import HandShape, MarkerRows, PosedHand, seen_from, visibility_at

UNASSIGNED = -1
"""Owner of a blob near no hand: every hand may use it."""
OTHERS = -1
"""Hue of a blob that belongs to another hand: no glove has it."""


class _Limits(NamedTuple):
    """`SharingParams` for kernels."""

    pixel_sd_px: float
    gate: float
    gate_px: float
    dummy_cost: float
    min_prior: float
    near: float


@dataclass(frozen=True)
class SharingParams:
    """Parameters of the assignment of blobs to hands."""

    placement_sd: float = 0.002  # m, of a marker on its segment
    pixel_sd_px: float = 1.0
    gate: GateParams = field(default_factory=GateParams)
    near: float = 72.0  # Mahalanobis² of a marker, within which a blob is assigned to a hand

    @cached_property
    def limits(self) -> _Limits:
        """The parameters for kernels."""
        g = self.gate
        return _Limits(self.pixel_sd_px, g.gate, g.gate_px, g.dummy_cost, g.min_prior, self.near)


class HandInView(NamedTuple):
    """A hand predicted in an image: markers (m rows) with hue (m,), numbered as the image's blobs,
    and sd (m,) m; its segments, which occlude; and the ids (m,) of these among the glove's
    ``total`` markers."""

    markers: MarkerRows
    hue: IntArray
    sd: Array
    body: PosedHand
    ids: IntArray
    total: int


class _Markers(NamedTuple):
    """Markers of all hands: predicted p_C (m, 3) m and its variance (m,) m², hue and the hand (m,)
    of each."""

    p_C: Matrix
    variance: Vector
    hue: IntVector
    hand: IntVector


def share(
    frame: BlobFrame,
    hands: Sequence[HandInView | None],
    rig: StereoRig,
    pose: CameraPose,
    params: SharingParams | None = None,
) -> list[BlobFrame]:
    """The frame for each hand: blobs of another hand get the hue `OTHERS`, and cloth at another
    hand is removed; rows are unchanged.

    A hand with unknown position is None: it may use the blobs that the others do not explain.
    """
    params = params or SharingParams()
    known = [(i, hand) for i, hand in enumerate(hands) if hand is not None]
    if not known:
        return [frame for _ in hands]
    prior, alone = _priors([hand for _, hand in known], rig, pose)
    owners = _owners(frame, known, prior, rig, pose, params)
    out = [
        replace(frame, left=_own(frame.left, owners[0], i), right=_own(frame.right, owners[1], i))
        for i in range(len(hands))
    ]
    for j in range(len(hands)):
        for i, hand in known:
            out[j] = out[j] if i == j else _away_from(hand.body, out[j], rig, pose)
    if len(known) > 1:
        for (i, hand), *p in zip(known, prior, alone, strict=True):
            out[i] = replace(out[i], unhidden=_unhidden(hand, *p))
    return out


def _priors(
    hands: Sequence[HandInView], rig: StereoRig, pose: CameraPose
) -> tuple[list[Array], list[Array]]:
    """(2, m) visibility priors of each hand's markers with mutual occlusion, and of each hand
    alone."""
    markers, body = _together(hands)
    uv = seen_from(markers.p_G, rig, pose)
    prior = visibility_at(uv, body, markers, rig, pose)
    if len(hands) == 1:
        return [prior], [prior]
    ends = np.cumsum([0, *(len(h.hue) for h in hands)]).tolist()
    parts = [slice(a, b) for a, b in pairwise(ends)]
    alone = [
        visibility_at(np.ascontiguousarray(uv[:, part]), hand.body, hand.markers, rig, pose)
        for hand, part in zip(hands, parts, strict=True)
    ]
    return [prior[:, part] for part in parts], alone


def _unhidden(hand: HandInView, prior: Array, alone: Array) -> Array:
    """(2, total) of the glove's markers: the factor that the other hand leaves of their prior
    (2, m) ``alone``."""
    out = np.ones((2, hand.total))
    out[:, hand.ids] = np.where(alone > 0.0, prior / np.maximum(alone, 1e-12), 1.0)
    return out


def _own(blobs: Blobs | None, owner: IntArray, hand: int) -> Blobs | None:
    if blobs is None:
        return None
    mine = (owner == hand) | (owner == UNASSIGNED)
    return blobs if mine.all() else replace(blobs, hue=np.where(mine, blobs.hue, OTHERS))


def _away_from(body: PosedHand, frame: BlobFrame, rig: StereoRig, pose: CameraPose) -> BlobFrame:
    """The frame without the cloth at a hand."""
    left = without_hand(frame.left, body, rig, pose, right=False)
    right = without_hand(frame.right, body, rig, pose, right=True)
    return replace(frame, left=left, right=right)


def _owners(
    frame: BlobFrame,
    known: Sequence[tuple[int, HandInView]],
    priors: Sequence[Array],
    rig: StereoRig,
    pose: CameraPose,
    params: SharingParams,
) -> list[IntArray]:
    """(n,) for the left and the right image the hand of each blob, `UNASSIGNED` where none is
    near; ``priors`` (2, m) of each hand's markers."""
    hands = [hand for _, hand in known]
    p_G, sd = np.concatenate([h.markers.p_G for h in hands]), np.concatenate([h.sd for h in hands])
    markers = _Markers(
        np.ascontiguousarray((p_G - pose.p_GC) @ pose.R_GC),
        sd**2 + params.placement_sd**2,
        np.concatenate([h.hue for h in hands]),
        np.concatenate([np.full(len(h.hue), i, np.int64) for i, h in known]),
    )
    prior = np.concatenate(priors, axis=1)
    out = []
    for c, (blobs, camera) in enumerate(((frame.left, rig.left), (frame.right, rig.right))):
        if blobs is None or len(blobs) == 0:
            out.append(np.zeros(0, np.int64))
            continue
        seen = HuedPixels(camera.rectify(np.array(blobs.uv)), blobs.hue)
        out.append(owners_in(seen, markers, prior[c], c, rig.intrinsics, params.limits))
    return out


@kernel(nogil=False)
def owners_in(
    seen: HuedPixels,
    markers: _Markers,
    prior: Vector,
    camera: int,
    rig: StereoIntrinsics,
    limits: _Limits,
) -> IntVector:
    """(n,) the hand of each blob of the left (0) or the right ``camera``, `UNASSIGNED` where none
    is near; prior (m,) that it sees each marker."""
    owner = np.full(len(seen.uv), UNASSIGNED)
    shift = rig.baseline if camera else 0.0
    uv = projected(markers.p_C, shift, rig.fx, rig.fy, rig.cx, rig.cy)
    rows = np.flatnonzero(np.isfinite(uv[:, 0]))
    if len(rows) == 0:  # each known hand is completely occluded by another
        return owner
    # 1. The markers of all hands compete for all blobs.
    there = ExpectedPixels(
        uv[rows],
        _innovations(markers, rows, shift, rig, limits.pixel_sd_px),
        markers.hue[rows],
        np.maximum(prior[rows], limits.min_prior),
    )
    found = assigned(seen, there, limits.gate, limits.gate_px, limits.dummy_cost)
    for k in range(len(rows)):
        if found[k] >= 0:
            owner[found[k]] = markers.hand[rows[k]]
    # 2. Unmatched blobs are assigned to the hand most likely to have a marker there.
    for i in range(len(owner)):
        if owner[i] == UNASSIGNED:
            k = _likeliest(seen.uv[i], seen.hue[i], there, limits.near)
            owner[i] = markers.hand[rows[k]] if k >= 0 else UNASSIGNED
    return owner


@kernel(nogil=False)
def taken_twice(a: IntVector, b: IntVector) -> int:
    """Number of blobs in both of two matches, in which -1 is none."""
    count = 0
    for i in range(len(a)):
        if a[i] < 0:
            continue
        is_new = True
        for k in range(i):
            is_new &= a[k] != a[i]
        for k in range(len(b)):
            if is_new and b[k] == a[i]:
                count += 1
                break
    return count


@kernel
def _innovations(
    markers: _Markers, rows: IntVector, shift: float, rig: StereoIntrinsics, pixel_sd_px: float
) -> Stack:
    """(k, 2, 2) px² of the markers ``rows`` (k,), seen from ``shift`` m to the right."""
    S = np.empty((len(rows), 2, 2))
    for k in range(len(rows)):
        x, y, z = markers.p_C[rows[k]]
        u, v = rig.fx / z, rig.fy / z
        u_z, v_z = -rig.fx * (x - shift) / z**2, -rig.fy * y / z**2
        variance = markers.variance[rows[k]]
        S[k, 0, 0] = variance * (u * u + u_z * u_z) + pixel_sd_px**2
        S[k, 1, 1] = variance * (v * v + v_z * v_z) + pixel_sd_px**2
        S[k, 0, 1] = S[k, 1, 0] = variance * u_z * v_z
    return S


@kernel
def _likeliest(uv: Vector, hue: int, markers: ExpectedPixels, near: float) -> int:
    """The marker of a blob's hue with the least Mahalanobis² + ln det S - 2 ln p, of those whose
    Mahalanobis² is below ``near``; -1 where there is none."""
    best, least = -1, FORBIDDEN
    for j in range(len(markers.uv)):
        if markers.hue[j] != hue:
            continue
        a, b, c = markers.S[j, 0, 0], markers.S[j, 0, 1], markers.S[j, 1, 1]
        det = a * c - b * b
        du, dv = uv[0] - markers.uv[j, 0], uv[1] - markers.uv[j, 1]
        d2 = (c * du * du - 2.0 * b * du * dv + a * dv * dv) / det
        if not d2 < near:
            continue
        cost = d2 + np.log(det) - 2.0 * np.log(markers.prior[j])
        if cost < least:
            best, least = j, cost
    return best


def _together(hands: Sequence[HandInView]) -> tuple[MarkerRows, PosedHand]:
    """All markers, and the bodies of all hands as one, with concatenated segments."""
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
