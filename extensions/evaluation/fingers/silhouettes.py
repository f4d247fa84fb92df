"""The true silhouette of a simulated hand as a map of its glove's cloth, the bound of what images
can show of fingers."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from tracker.hand.model import HandModel
from tracker.hand.names import CHAINS, FINGERS
from tracker.messages import Array, BlobFrame, CameraPose, Cloth
from tracker.vision.cloth import SIDE, STEP, TILE
from tracker.vision.rig import NEAREST, Camera, StereoRig

THUMB_JOINTS, FINGER_JOINTS = ("cmc", "mcp", "ip", "tip"), ("mcp", "pip", "dip", "tip")
CLOTH = 0.001  # m, of the glove on the skin
AT_WRIST = 0.35  # distance of metacarpals at the wrist, relative to that of their knuckles
PALM_RADIUS = 0.0135  # m
FROM_WRIST = 0.15  # share of a metacarpal's length at which its capsule starts


def capsules(keypoints: Array, names: Sequence[str], hand: HandModel) -> tuple[Array, Array]:
    """Ends (k, 2, 3) m in G and radii (k,) m of a hand with true ``keypoints`` (K, 3) m in G; the
    radii of digits are those of the hand file."""
    at = dict(zip(names, keypoints, strict=False))
    rows: list[tuple[Array, Array, float]] = []
    for digit, joints in (("thumb", THUMB_JOINTS), *((f, FINGER_JOINTS) for f in FINGERS)):
        for k, segment in enumerate(CHAINS[digit]):
            a, b = (at[f"{digit}_{joint}"] for joint in joints[k : k + 2])
            radius = hand.segments[hand.index[segment]].radius + CLOTH
            if joints[k + 1] == "tip":
                b = b - (b - a) * min(radius / np.linalg.norm(b - a), 1.0)
            rows.append((a, b, radius))
    wrist, knuckles = at["wrist"], np.array([at[f"{f}_mcp"] for f in FINGERS])
    middle = knuckles.mean(axis=0)
    across = knuckles[-1] - knuckles[0]
    width = np.linalg.norm(across)
    # The outer ones are as far inwards as they are thicker than the fingers.
    thicker = PALM_RADIUS - hand.segments[hand.index[CHAINS[FINGERS[-1]][0]]].radius
    for share in np.linspace(0.0, len(FINGERS) - 1.0, 2 * len(FINGERS) - 1):
        k = min(int(share), len(FINGERS) - 2)
        knuckle = knuckles[k] + (share - k) * (knuckles[k + 1] - knuckles[k])
        inwards = 1.0 - 2.0 * share / (len(FINGERS) - 1.0)
        knuckle = knuckle + inwards * thicker / width * across
        start = wrist + AT_WRIST * (knuckle - middle)
        rows.append((start + FROM_WRIST * (knuckle - start), knuckle, PALM_RADIUS))
    rows.append((at["thumb_cmc"], knuckles[0] + thicker / width * across, PALM_RADIUS))
    first, last, radii = zip(*rows, strict=True)
    return np.stack([np.array(first), np.array(last)], axis=1), np.array(radii)


def silhouette(ends: Array, radius: Array, rig: StereoRig, right: bool) -> NDArray[np.bool_]:
    """Which samples of a cloth map (rows, columns) the capsules with ends (k, 2, 3) m in C and
    radii (k,) m cover. Their axes are straight in the image as recorded."""
    camera: Camera = rig.right if right else rig.left
    rows, columns = (n // TILE * SIDE for n in (rig.left.height, rig.left.width))
    mask = np.zeros((rows, columns), bool)
    for capsule, r in zip(ends, radius, strict=True):
        z = capsule[:, 2]
        if z.min() <= 3 * NEAREST:
            continue
        (a, b), size = camera.unrectify(rig.project(capsule, right=right)), r * rig.fx / z.mean()
        low, high = np.minimum(a, b) - size, np.maximum(a, b) + size
        x0, y0 = np.clip(np.floor(low / STEP).astype(int), 0, (columns, rows))
        x1, y1 = np.clip(np.ceil(high / STEP).astype(int) + 1, 0, (columns, rows))
        y, x = STEP * np.mgrid[y0:y1, x0:x1]
        (du, dv), d = b - a, np.stack([x - a[0], y - a[1]])
        t = np.clip((d[0] * du + d[1] * dv) / (du**2 + dv**2 + 1e-9), 0.0, 1.0)
        mask[y0:y1, x0:x1] |= np.hypot(d[0] - t * du, d[1] - t * dv) <= size
    return mask


def as_cloth(mask: NDArray[np.bool_]) -> Cloth:
    """A map of all tiles, of samples (rows, columns)."""
    rows, columns = (n // SIDE for n in mask.shape)
    tiles = mask.reshape(rows, SIDE, columns, SIDE).transpose(0, 2, 1, 3).reshape(-1, SIDE**2)
    bits = (tiles * np.left_shift(np.int64(1), np.arange(SIDE**2))).sum(axis=1)
    return Cloth(columns, rows, np.arange(rows * columns), bits)


def with_silhouettes(
    frame: BlobFrame, hand: tuple[Array, Array], rig: StereoRig, pose: CameraPose
) -> BlobFrame:
    """The frame with the silhouette of a true ``hand`` (`capsules`) as its cloth."""
    ends, radius = (hand[0] - pose.p_GC) @ pose.R_GC, hand[1]
    left, right = (
        blobs and replace(blobs, cloth=as_cloth(silhouette(ends, radius, rig, bool(c))))
        for c, blobs in enumerate((frame.left, frame.right))
    )
    return replace(frame, left=left, right=right)
