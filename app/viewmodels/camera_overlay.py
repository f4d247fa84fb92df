"""The overlay of a camera image, from one stereo exposure and its tracking results."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from app.engines.snapshot import Snapshot
from app.viewmodels.states import GREY, VALIDITY
from app.widgets.image_shapes import Crosses, Ellipses, ImageLabels, ImageLines, Rings, Shapes
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


def overlay(view: Snapshot, layers: Layers, colours: dict[str, str], right: bool) -> list[Shapes]:
    """All shapes for one side, of all hands; ``colours`` maps hue names to display colours."""
    shapes: list[Shapes] = []
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
) -> list[Shapes]:
    """A ring per blob in its hue: solid if a marker is assigned, dashed if not, filled (``pairs``)
    if the same marker is matched in the other image, too."""
    names = view.blobs.hue_names if view.blobs is not None else ()
    results = [hand.result for hand in view.hands if hand.result is not None]
    paired = set[int]().union(*(_paired(result, right) for result in results if pairs))
    filled = np.zeros(len(blobs), bool)
    filled[[i for i in paired if i < len(blobs)]] = True
    of_hues = [colours.get(name, WHITE) for name in names]
    shown = [of_hues[hue] for hue in blobs.hue.tolist()]
    radius = blobs.size.max(axis=1) / 2 + 2 if len(blobs) else np.zeros(0)
    own = _claimed(results, len(blobs), right)
    return [Rings(blobs.uv, radius, shown, 2.0, ~own, filled)] if len(blobs) else []


def _paired(result: FrameResult, right: bool) -> set[int]:
    """Blobs of a side whose marker was matched on both sides."""
    both = (result.match_left >= 0) & (result.match_right >= 0)
    return set((result.match_right if right else result.match_left)[both].tolist())


def _claimed(results: Sequence[FrameResult], count: int, right: bool) -> NDArray[np.bool_]:
    """(n,) whether each blob is assigned to a marker of any hand; all True without results."""
    if not results:
        return np.ones(count, bool)
    taken = np.concatenate([r.match_right if right else r.match_left for r in results])
    out = np.zeros(count, bool)
    out[taken[(taken >= 0) & (taken < count)]] = True
    return out


def _rejected(rejected: RejectedBlobs) -> list[Shapes]:
    count = len(rejected.reason)
    if count == 0:
        return []
    reasons = [tr(REASONS.get(reason, reason)) for reason in rejected.reason]
    return [
        Crosses(rejected.uv, ["#FF8A65"] * count, diagonal=True),
        ImageLabels(rejected.uv, reasons, "#FFB199", least_zoom=REASON_ZOOM),
    ]


def _predicted(
    view: Snapshot, result: FrameResult, colours: dict[str, str], right: bool
) -> list[Shapes]:
    """The predicted position of each marker, with its id and (left) the 2σ ellipse."""
    uv = result.predicted_right if right else result.predicted_left
    known: NDArray[np.bool_] = np.asarray(np.isfinite(uv).all(axis=1))
    opaque = result.visible >= VISIBLE
    shown = [colours.get(marker.hue, WHITE) for marker in view.setup.glove.markers]
    out: list[Shapes] = [] if known.all() else _outside(view, ~known, shown, right)
    for clear in (False, True):
        rows = np.flatnonzero(known & (opaque == clear))
        if len(rows):
            places, of = uv[rows], [shown[row] for row in rows]
            out.append(Crosses(places, of, opacity=1.0 if clear else DIM))
            if clear:
                ids = [str(row) for row in rows]
                out.append(ImageLabels(places, ids, WHITE, least_zoom=ID_ZOOM))
    return out if right else out + _ellipses(result, known & opaque)


def _marker_pixels(view: Snapshot, right: bool) -> Array:
    """(M, 2) px of every marker of the estimate, inside or outside the image."""
    glove, estimate = view.setup.glove, view.estimate_at_frame
    if estimate is None or estimate.tracking != Tracking.TRACKING:
        return np.full((len(glove.markers), 2), np.nan)
    segment = glove.marker_segment(view.setup.hand)
    R, p = estimate.segment_R[segment], estimate.segment_p[segment]
    return project(view, p + np.einsum("mij,mj->mi", R, glove.marker_position), right)


def _outside(
    view: Snapshot, unknown: NDArray[np.bool_], colours: Sequence[str], right: bool
) -> list[Shapes]:
    """Dim crosses at the edge of the image, in the directions of ``unknown`` (M,) markers."""
    camera = view.setup.camera.rig.right if right else view.setup.camera.rig.left
    uv = _marker_pixels(view, right)
    edge = np.clip(uv, EDGE_PX, [camera.width - EDGE_PX, camera.height - EDGE_PX])
    # those inside the image have no prediction for another reason
    rows = np.flatnonzero(unknown & np.isfinite(uv).all(axis=1) & (edge != uv).any(axis=1))
    if len(rows) == 0:
        return []
    return [
        Crosses(edge[rows], [colours[row] for row in rows.tolist()], diagonal=True, opacity=DIM)
    ]


def _ellipses(result: FrameResult, wanted: NDArray[np.bool_]) -> list[Shapes]:
    """The 2σ ellipses of the ``wanted`` (M,) covariances, px²."""
    cov = result.predicted_cov
    rows = np.flatnonzero(wanted & np.isfinite(cov).all(axis=(1, 2)))
    if len(rows) == 0:
        return []
    values, vectors = np.linalg.eigh(cov[rows])
    axes = 2 * np.sqrt(np.maximum(values[:, ::-1], 0))
    angle = np.arctan2(vectors[:, 1, 1], vectors[:, 0, 1])
    return [Ellipses(result.predicted_left[rows], axes, angle, WHITE, 0.8)]


def _residuals(result: FrameResult, blobs: Blobs, right: bool) -> list[Shapes]:
    """A line from each prediction to the matched blob."""
    match = result.match_right if right else result.match_left
    uv = result.predicted_right if right else result.predicted_left
    drawn = np.flatnonzero((match >= 0) & (match < len(blobs)) & np.isfinite(uv).all(axis=1))
    ends = np.concatenate([uv[drawn], blobs.uv[match[drawn]]], axis=1)
    solid = np.zeros(len(drawn), bool)
    return [ImageLines(ends, [WHITE] * len(drawn), 1.0, solid)] if len(drawn) else []


@lru_cache(maxsize=4)
def _joined(keypoints: tuple[str, ...]) -> IntArray:
    """(n, 2) rows of keypoints at the ends of each bone."""
    return np.array(bones(keypoints), np.int64).reshape(-1, 2)


def _skeleton(view: Snapshot, right: bool) -> list[Shapes]:
    estimate = view.estimate_at_frame
    if estimate is None:
        return []
    pixels = project(view, estimate.keypoints, right)
    joined = _joined(tuple(view.setup.glove.keypoint_names(view.setup.hand)))
    ends = pixels[joined].reshape(-1, 4)
    states = estimate.keypoint_state[joined].min(axis=1)
    drawn = np.isfinite(ends).all(axis=1)
    if not drawn.any():
        return []
    states = states[drawn]
    of = [VALIDITY[s].colour if s != Validity.LOST else GREY for s in states.tolist()]
    return [ImageLines(ends[drawn], of, 2.5, states != Validity.MEASURED, 0.85)]


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
