"""Images searched ahead of the engine: the same blobs in the same order for any number of
threads."""

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from tracker.messages import BlobFrame, Blobs, ImuSample, StereoFrame
from tracker.offline.detection import AHEAD, detected
from tracker.offline.simulate import SimulateOptions, simulate
from tracker.offline.track import make_detector, profile_of
from tracker.session.decode import Decoded
from tracker.session.images import PackedFrame
from tracker.session.reader import SessionReader
from tracker.vision.detector import detect_frame


@pytest.fixture(scope="module")
def session(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("images") / "in.mcap"
    simulate(path, SimulateOptions(seed=3, duration=1.0, fps=30))
    return path


def same(a: Blobs | None, b: Blobs | None) -> bool:
    assert a is not None and b is not None
    return np.array_equal(a.uv, b.uv) and np.array_equal(a.hue, b.hue)


@pytest.mark.long
def test_the_number_of_threads_has_no_effect(session: Path) -> None:
    with SessionReader(session) as reader:
        detector = make_detector(profile_of(reader.info), reader.info)
        plain = [
            detect_frame(detector, m) if isinstance(m, StereoFrame) else m
            for m in reader.messages((ImuSample, StereoFrame))
        ]
        ahead = list(
            detected(reader.packed_messages((ImuSample, StereoFrame)), lambda: detector, 3)
        )
    assert [type(m) for m in ahead] == [type(m) for m in plain]
    assert [m.t for m in ahead] == [m.t for m in plain]  # type: ignore[union-attr]
    frames = [(a, b) for a, b in zip(ahead, plain, strict=True) if isinstance(a, BlobFrame)]
    assert len(frames) > 25
    for a, b in frames:
        assert isinstance(b, BlobFrame)
        assert same(a.left, b.left) and same(a.right, b.right)


@pytest.mark.long
def test_the_queue_of_images_is_limited(session: Path) -> None:
    read = 0

    def counted(messages: Iterator[Decoded]) -> Iterator[Decoded]:
        nonlocal read
        for m in messages:
            read += isinstance(m, PackedFrame)
            yield m

    with SessionReader(session) as reader:
        detector = make_detector(profile_of(reader.info), reader.info)
        given = 0
        packed = reader.packed_messages((ImuSample, StereoFrame))
        for m in detected(counted(packed), lambda: detector, 2):
            given += isinstance(m, BlobFrame)
            assert read - given <= AHEAD + 1


def test_damaged_images_are_skipped_and_counted(session: Path) -> None:
    """Those whose damage is found only in decoding: every third right one, and one pair."""
    spoilt = 0

    def spoil(messages: Iterator[Decoded]) -> Iterator[Decoded]:
        nonlocal spoilt
        for m in messages:
            if isinstance(m, PackedFrame):
                cameras = ("left", "right") if m.index == 4 else ("right",)
                bad = {c: m.parts[c]._replace(data=b"no image") for c in cameras}
                if m.index % 3 == 0 or m.index == 4:
                    m = replace(m, parts={**m.parts, **bad})
                    spoilt += len(bad)
            yield m

    with SessionReader(session) as reader:
        detector = make_detector(profile_of(reader.info), reader.info)
        packed = reader.packed_messages((ImuSample, StereoFrame))
        found = [
            m for m in detected(spoil(packed), lambda: detector, 2) if isinstance(m, BlobFrame)
        ]
        assert len(reader.source.left_out) == spoilt > 5
    assert all(m.left is not None for m in found)
    assert [m.index for m in found if m.right is None] == [
        m.index for m in found if not m.index % 3
    ]
    assert 4 not in [m.index for m in found] and len(found) > 25
