"""Blobs that may belong to either of two hands."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from tests.cloth_masks import cloth_of
from tracker.messages import BlobFrame, Blobs
from tracker.vision.cloth import INSIDE, NOTHING, cloth_at, cloth_map
from tracker.vision.rig import ideal_rig
from tracker.vision.sharing import OTHERS, HandInView, share, taken_twice
from tracker.vision.visibility import HandShape, MarkerRows, PosedHand

RIG = ideal_rig()
TO_CAMERA = -RIG.pose.R_GC[:, 2]


def at(x: float, y: float, z: float) -> np.ndarray:
    """A point of C in G."""
    return RIG.pose.R_GC @ np.array([x, y, z]) + RIG.pose.p_GC


def hand(points: np.ndarray, sd: float = 0.003, away: float = 0.05) -> HandInView:
    """Markers that face the camera, on a short thin bone ``away`` m behind them."""
    shape = HandShape(np.array([0.01]), np.array([0.005]), np.zeros(1))
    body = PosedHand(shape, np.eye(3)[None], points[:1] - away * TO_CAMERA)
    rows = MarkerRows(points, np.tile(TO_CAMERA, (len(points), 1)), np.zeros(len(points), np.int64))
    n = len(points)
    return HandInView(rows, np.zeros(n, np.int64), np.full(n, sd), body, np.arange(n), n)


def seen(points: np.ndarray) -> BlobFrame:
    p_C = (points - RIG.pose.p_GC) @ RIG.pose.R_GC
    sides = []
    for right in (False, True):
        n = len(points)
        uv = RIG.project(p_C, right)
        sides.append(Blobs(uv, np.full((n, 2), 15.0), np.zeros(n, np.int64), np.ones(n)))
    return BlobFrame(0.0, 0.0, ("red",), *sides)


def mine(frame: BlobFrame) -> list[bool]:
    assert frame.left is not None
    return [bool(h != OTHERS) for h in frame.left.hue]


def test_a_marker_belongs_to_one_hand() -> None:
    a, b = at(-0.05, 0.0, 0.35), at(0.05, 0.0, 0.35)
    left, right = share(seen(np.array([a, b])), [hand(a[None]), hand(b[None])], RIG, RIG.pose)
    assert mine(left) == [True, False] and mine(right) == [False, True]


def test_two_adjacent_markers_go_to_the_hands_that_fit_both_best() -> None:
    """The second blob is nearer to the first hand's marker than to its own, but that is matched."""
    a, b = at(0.0, 0.0, 0.35), at(0.012, 0.0, 0.35)
    blobs = np.array([at(-0.001, 0.0, 0.35), at(0.005, 0.0, 0.35)])
    left, right = share(seen(blobs), [hand(a[None]), hand(b[None])], RIG, RIG.pose)
    assert mine(left) == [True, False] and mine(right) == [False, True]


def test_a_marker_behind_the_other_hand_is_not_matched() -> None:
    """Both predict a marker at the same pixels; the nearer hand's bone occludes the farther
    one's."""
    near, far = at(0.0, 0.0, 0.30), at(0.0, 0.0, 0.40)
    upper = hand(near[None], away=0.005)
    lower = hand(far[None])
    left, right = share(seen(near[None]), [lower, upper], RIG, RIG.pose)
    assert mine(left) == [False] and mine(right) == [True]


def test_a_hand_being_searched_for_may_not_use_the_others_blobs() -> None:
    own, free = at(0.0, 0.0, 0.35), at(0.15, 0.0, 0.35)
    known, unknown = share(seen(np.array([own, free])), [hand(own[None]), None], RIG, RIG.pose)
    assert mine(unknown) == [False, True]
    assert mine(known) == [True, True], "what no one expects is everyone's"


def test_without_a_known_hand_an_image_is_unchanged() -> None:
    frame = seen(np.array([at(0.0, 0.0, 0.35)]))
    assert all(own is frame for own in share(frame, [None, None], RIG, RIG.pose))


def test_rows_and_missing_sides_are_preserved() -> None:
    a, b = at(-0.05, 0.0, 0.35), at(0.05, 0.0, 0.35)
    frame = seen(np.array([a, b]))
    one = BlobFrame(0.0, 0.0, ("red",), frame.left, None)
    left, _ = share(one, [hand(a[None]), hand(b[None])], RIG, RIG.pose)
    assert left.right is None and left.left is not None and frame.left is not None
    assert np.array_equal(left.left.uv, frame.left.uv)


@pytest.mark.parametrize("seed", range(20))
def test_blobs_matched_by_two_hands_are_counted_once_each(seed: int) -> None:
    rng = np.random.default_rng(seed)
    a, b = rng.integers(-1, 9, int(rng.integers(0, 12))), rng.integers(-1, 9, 7)
    assert taken_twice(a, b) == len(np.intersect1d(a[a >= 0], b[b >= 0]))


def test_cloth_at_the_other_hand_is_unknown() -> None:
    a, b = at(-0.05, 0.0, 0.35), at(0.05, 0.0, 0.35)
    everywhere = cloth_of(np.ones((RIG.left.height, RIG.left.width), bool))
    frame = seen(np.array([a, b]))
    assert frame.left is not None
    frame = replace(frame, left=replace(frame.left, cloth=everywhere))
    hands = [hand(a[None], away=0.0), hand(b[None], away=0.0)]
    for k, own in enumerate(share(frame, hands, RIG, RIG.pose)):
        assert own.left is not None and own.left.cloth is not None and own.right is not None
        cloth = cloth_map(own.left.cloth)
        classes = [cloth_at(cloth, *uv) for uv in own.left.uv]
        assert classes == [[INSIDE, NOTHING], [NOTHING, INSIDE]][k]
        assert len(own.left.cloth.tile) > 0.9 * len(everywhere.tile)
    alone = share(frame, [hands[0], None], RIG, RIG.pose)
    assert alone[0].left is not None and alone[0].left.cloth is everywhere
