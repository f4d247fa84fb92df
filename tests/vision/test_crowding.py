"""Images with very many blobs: a bounded number is used, and the hand is still found."""

from __future__ import annotations

import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tracker.engine.pipeline import Pipeline
from tracker.messages import BlobFrame, Blobs, ImuSample, Tracking
from tracker.offline.simulate import SimulateOptions, simulate
from tracker.session.reader import SessionReader
from tracker.vision.crowding import MOST_BLOBS, thinned

SECONDS = 2.0


def crowd(blobs: Blobs, n: int, seed: int = 0) -> Blobs:
    """``blobs`` preceded by ``n`` others at one position, of any hue and with the highest score."""
    rng = np.random.default_rng(seed)
    uv = np.array([300.0, 200.0]) + rng.normal(0, 3, (n, 2))
    return Blobs(
        np.vstack([uv, blobs.uv]),
        np.vstack([np.full((n, 2), 8.0), blobs.size]),
        np.r_[rng.integers(0, 6, n), blobs.hue],
        np.r_[np.ones(n), blobs.score],
    )


def frame(left: Blobs, right: Blobs | None) -> BlobFrame:
    return BlobFrame(0.0, 0.0, ("a", "b", "c", "d", "e", "f"), left, right)


def spread(n: int) -> Blobs:
    rng = np.random.default_rng(1)
    uv = rng.uniform(0, 600, (n, 2))
    return Blobs(uv, np.full((n, 2), 8.0), rng.integers(0, 6, n), rng.uniform(0, 0.9, n))


def test_ordinary_images_are_used_unchanged() -> None:
    ordinary = frame(spread(MOST_BLOBS), None)
    found, ignored = thinned(ordinary)
    assert found is ordinary and ignored == 0


def test_a_crowd_is_thinned_and_other_blobs_are_kept() -> None:
    few, many = spread(100), spread(2000)
    found, ignored = thinned(frame(crowd(few, 900), many))
    assert found.left is not None and found.right is not None
    assert len(found.left) == len(found.right) == MOST_BLOBS
    assert ignored == 1000 + 2000 - 2 * MOST_BLOBS
    stayed = {tuple(uv) for uv in found.left.uv}
    assert all(tuple(uv) in stayed for uv in few.uv)
    assert np.array_equal(found.left.uv[-100:], few.uv)  # in the original order
    assert np.array_equal(found.left.score[-100:], few.score)


@pytest.fixture(scope="module")
def session(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("crowd") / "in.mcap"
    simulate(path, SimulateOptions(seed=41, duration=SECONDS, images=False))
    return path


@pytest.mark.long
def test_900_blobs_in_one_place_are_processed_faster_than_real_time(session: Path) -> None:
    with SessionReader(session) as reader:
        info = reader.info
        messages = list(reader.messages((ImuSample, BlobFrame)))
    pipeline = Pipeline(info.hand, info.glove, info.rig)
    reported, tracking, used = [], [], 0.0
    for m in messages:
        if isinstance(m, BlobFrame):
            assert m.left is not None and m.right is not None
            m = replace(m, left=crowd(m.left, 900), right=crowd(m.right, 900))
        began = time.thread_time()
        if isinstance(m, BlobFrame):
            pipeline.feed_frame(m)
        elif isinstance(m, ImuSample):
            tracking.append(pipeline.feed_imu(m).tracking)
        used += time.thread_time() - began
        reported += pipeline.source_notices.drain()
    assert used < SECONDS
    assert tracking[-1] == Tracking.TRACKING
    frames = sum(isinstance(m, BlobFrame) for m in messages)
    assert pipeline.blob_limit.ignored >= frames * 2 * (900 - MOST_BLOBS)
    assert [(n.code, n.values["limit"]) for n in reported] == [("images.crowded", MOST_BLOBS)]
