"""The overlay of a camera image, from one stereo exposure and its tracking results."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from app.engines.snapshot import Snapshot
from app.viewmodels.states import GREY, VALIDITY
from app.widgets.image_shapes import Cross, Ellipse, ImageLabel, ImageLine, Ring, Shape
from app.words import mark, tr
from tracker.hand.names import bones
from tracker.messages import Array, Blobs, FrameResult, IntArray, RejectedBlobs, Tracking, Validity
from tracker.vision.rig import StereoRig

VISIBLE = 0.5
"""A marker is drawn opaque if the prior probability that it is visible is at least this."""
DIM = 0.35
EDGE_PX = 4.0
REASONS = {
    "size": mark("wrong size"),
    "convexity": mark("not convex"),
    "circularity": mark("not round"),
    "edge": mark("at the edge"),
}
WHITE = "#FFFFFF"
REASON_ZOOM, ID_ZOOM = 0.8, 0.4  # screen pixels per image pixel


@dataclass(frozen=True)
class Layers:
    """The parts of the overlay that the user has selected."""

    blobs: bool = True
    pairs: bool = True
    rejected: bool = True
    predicted: bool = True
    residuals: bool = True
    skeleton: bool = True


NO_LAYERS = Layers(False, False, False, False, False, False)


def overlay(view: Snapshot, layers: Layers, colours: dict[str, str], right: bool) -> list[Shape]:
    """All shapes for one side, of all hands; ``colours`` maps hue names to display colours."""
    shapes: list[Shape] = []
    if layers.skeleton:
        for hand in view.hands:
            shapes += _skeleton(hand, right)
    blobs, rejected = _side(view, right)
    if layers.rejected and rejected is not None:
        shapes += _rejected(rejected)
    for hand in view.hands:
        if hand.result is not None and layers.predicted:
            shapes += _predicted(hand, hand.result, colours, right)
        if blobs is not None and hand.result is not None and layers.residuals:
            shapes += _residuals(hand.result, blobs, right)
    if view.blobs is not None and blobs is not None and layers.blobs:
        shapes += _blobs(view, blobs, colours, right, layers.pairs)
    return shapes


def _side(view: Snapshot, right: bool) -> tuple[Blobs | None, RejectedBlobs | None]:
    if view.blobs is None:
        return None, None
    if right:
        return view.blobs.right, view.blobs.rejected_right
    return view.blobs.left, view.blobs.rejected_left


def _blobs(
    view: Snapshot,
    blobs: Blobs,
    colours: dict[str, str],
    right: bool,
    pairs: bool,
) -> list[Shape]:
    """A ring per blob in its hue: solid if a marker is assigned, dashed if not, filled (``pairs``)
    if the same marker is matched in the other image, too."""
    names = view.blobs.hue_names if view.blobs is not None else ()
    results = [hand.result for hand in view.hands if hand.result is not None]
    claimed = _claimed(results, len(blobs), right)
    paired = set[int]().union(*(_paired(result, right) for result in results if pairs))
    radii = (blobs.size.max(axis=1) / 2 + 2).tolist() if len(blobs) else []
    rows = zip(blobs.uv.tolist(), radii, blobs.hue.tolist(), claimed, strict=True)
    return [
        Ring(u, v, radius, colours.get(names[hue], WHITE), 2.0, not own, 1.0, i in paired)
        for i, ((u, v), radius, hue, own) in enumerate(rows)
    ]


def _paired(result: FrameResult, right: bool) -> set[int]:
    """Blobs of a side whose marker was matched on both sides."""
    both = (result.match_left >= 0) & (result.match_right >= 0)
    return set((result.match_right if right else result.match_left)[both].tolist())


def _claimed(results: Sequence[FrameResult], count: int, right: bool) -> list[bool]:
    """Whether each blob is assigned to a marker of any hand; all True without results."""
    if not results:
        return [True] * count
    matches = [result.match_right if right else result.match_left for result in results]
    taken = {i for match in matches for i in match.tolist()}
    return [i in taken for i in range(count)]


def _rejected(rejected: RejectedBlobs) -> list[Shape]:
    out: list[Shape] = []
    for (u, v), reason in zip(rejected.uv.tolist(), rejected.reason, strict=True):
        out.append(Cross(u, v, "#FF8A65", diagonal=True))
        out.append(
            ImageLabel(u, v, tr(REASONS.get(reason, reason)), "#FFB199", least_zoom=REASON_ZOOM)
        )
    return out


def _predicted(
    view: Snapshot, result: FrameResult, colours: dict[str, str], right: bool
) -> list[Shape]:
    """The predicted position of each marker, with its id and (left) the 2σ ellipse."""
    uv = result.predicted_right if right else result.predicted_left
    known: NDArray[np.bool_] = np.asarray(np.isfinite(uv).all(axis=1))
    pixels = _marker_pixels(view, right) if not known.all() else uv
    opaque = result.visible >= VISIBLE
    ellipses = _ellipses(result.predicted_cov, known & opaque) if not right else {}
    out: list[Shape] = []
    places, inside, clear = uv.tolist(), known.tolist(), opaque.tolist()
    for marker in view.setup.glove.markers:
        colour = colours.get(marker.hue, WHITE)
        if not inside[marker.id]:
            out += _outside(pixels[marker.id], colour, view, right)
            continue
        u, v = places[marker.id]
        if not clear[marker.id]:
            out.append(Cross(u, v, colour, opacity=DIM))
            continue
        out.append(Cross(u, v, colour))
        out.append(ImageLabel(u, v, str(marker.id), WHITE, 1.0, ID_ZOOM))
        if marker.id in ellipses:
            a, b, angle = ellipses[marker.id]
            out.append(Ellipse(u, v, a, b, angle, WHITE, 0.8))
    return out


def _marker_pixels(view: Snapshot, right: bool) -> Array:
    """(M, 2) px of every marker of the estimate, inside or outside the image."""
    glove, estimate = view.setup.glove, view.estimate_at_frame
    if estimate is None or estimate.tracking != Tracking.TRACKING:
        return np.full((len(glove.markers), 2), np.nan)
    segment = glove.marker_segment(view.setup.hand)
    R, p = estimate.segment_R[segment], estimate.segment_p[segment]
    return project(view, p + np.einsum("mij,mj->mi", R, glove.marker_position), right)


def _outside(uv: Array, colour: str, view: Snapshot, right: bool) -> list[Shape]:
    """A dim cross at the edge of the image, in the direction of the marker."""
    camera = view.setup.camera.rig.right if right else view.setup.camera.rig.left
    if not np.isfinite(uv).all():
        return []
    edge = np.clip(uv, EDGE_PX, [camera.width - EDGE_PX, camera.height - EDGE_PX])
    if np.array_equal(edge, uv):
        return []  # inside the image, but without a prediction
    return [Cross(float(edge[0]), float(edge[1]), colour, diagonal=True, opacity=DIM)]


def _ellipses(cov: Array, wanted: NDArray[np.bool_]) -> dict[int, tuple[float, float, float]]:
    """Half axes (px) and angle (rad) of the 2σ ellipses of the ``wanted`` covariances (M, 2, 2),
    px²."""
    rows = np.flatnonzero(wanted & np.isfinite(cov).all(axis=(1, 2)))
    values, vectors = np.linalg.eigh(cov[rows])
    axes = 2 * np.sqrt(np.maximum(values, 0))
    angle = np.arctan2(vectors[:, 1, 1], vectors[:, 0, 1])
    found = zip(rows.tolist(), axes.tolist(), angle.tolist(), strict=True)
    return {row: (a, b, turned) for row, (b, a), turned in found}


def _residuals(result: FrameResult, blobs: Blobs, right: bool) -> list[Shape]:
    """A line from each prediction to the matched blob."""
    match = result.match_right if right else result.match_left
    uv = result.predicted_right if right else result.predicted_left
    drawn = np.flatnonzero((match >= 0) & (match < len(blobs)) & np.isfinite(uv).all(axis=1))
    ends = np.concatenate([uv[drawn], blobs.uv[match[drawn]]], axis=1)
    return [ImageLine(u0, v0, u1, v1, WHITE, 1.0) for u0, v0, u1, v1 in ends.tolist()]


@lru_cache(maxsize=4)
def _joined(keypoints: tuple[str, ...]) -> IntArray:
    """(n, 2) rows of keypoints at the ends of each bone."""
    return np.array(bones(keypoints), np.int64).reshape(-1, 2)


def _skeleton(view: Snapshot, right: bool) -> list[Shape]:
    estimate = view.estimate_at_frame
    if estimate is None:
        return []
    pixels = project(view, estimate.keypoints, right)
    joined = _joined(tuple(view.setup.glove.keypoint_names(view.setup.hand)))
    ends = pixels[joined].reshape(-1, 4)
    states = estimate.keypoint_state[joined].min(axis=1)
    drawn = np.isfinite(ends).all(axis=1)
    out: list[Shape] = []
    for (u0, v0, u1, v1), state in zip(ends[drawn].tolist(), states[drawn].tolist(), strict=True):
        colour = VALIDITY[state].colour if state != Validity.LOST else GREY
        out.append(ImageLine(u0, v0, u1, v1, colour, 2.5, state != Validity.MEASURED, 0.85))
    return out


def hand_box(view: Snapshot, right: bool) -> tuple[float, float, float, float] | None:
    """Centre u, v and size w, h (px) of the hands in an image; None without a hand."""
    known = [hand for hand in view.hands if hand.estimate_at_frame is not None]
    points = [hand.estimate_at_frame.keypoints for hand in known if hand.estimate_at_frame]
    pixels = project(view, np.concatenate([*points, np.zeros((0, 3))]), right)
    pixels = pixels[np.isfinite(pixels).all(axis=1)]
    if len(pixels) == 0:
        return None
    low, high = pixels.min(axis=0), pixels.max(axis=0)
    (u, v), (w, h) = (low + high) / 2, high - low
    camera = view.setup.camera.rig.right if right else view.setup.camera.rig.left
    if not (0 <= u < camera.width and 0 <= v < camera.height):
        return None
    return float(u), float(v), float(w), float(h)


def project(view: Snapshot, p_G: Array, right: bool) -> Array:
    """Points (n, 3) of G to pixels (n, 2) of the image as recorded."""
    rig: StereoRig = view.setup.camera.rig
    pose = rig.pose
    if view.frame is not None and view.frame.pose is not None:
        pose = view.frame.pose
    p_C = (p_G - pose.p_GC) @ pose.R_GC
    camera = rig.right if right else rig.left
    rectified = rig.project(p_C, right=right)
    raw = np.full_like(rectified, np.nan)
    seen = np.isfinite(rectified).all(axis=1)
    raw[seen] = camera.unrectify(rectified[seen])
    return raw
