"""Images searched ahead of the engine: the same blobs in the same order, whatever the threads."""

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from tracker.errors import FileError
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


def test_threads_change_nothing(session: Path) -> None:
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


def test_no_more_than_a_few_images_wait(session: Path) -> None:
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


def test_a_damaged_image_is_told_in_words(session: Path) -> None:
    def spoilt(messages: Iterator[Decoded]) -> Iterator[Decoded]:
        for m in messages:
            if isinstance(m, PackedFrame):
                bad = {c: p._replace(data=b"no image") for c, p in m.parts.items()}
                m = PackedFrame(m.t, m.t_arrival, bad, m.pose, m.index)
            yield m

    with SessionReader(session) as reader:
        detector = make_detector(profile_of(reader.info), reader.info)
        packed = reader.packed_messages((ImuSample, StereoFrame))
        with pytest.raises(FileError, match="neither JPEG nor PNG"):
            list(detected(spoilt(packed), lambda: detector, 2))
