"""Cameras through OpenCV, and detection of faults."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from http.server import BaseHTTPRequestHandler, HTTPServer
from pathlib import Path

import cv2
import numpy as np
import pytest

from tests.notices import raises
from tracker.base.errors import DeviceError
from tracker.base.notices import Notice, Severity, notice, plain, warning
from tracker.sensors.camera import StereoCamera
from tracker.sensors.image_input import (
    AT_ONCE,
    CaptureFormat,
    Image,
    Pair,
    SequenceInput,
    StreamInput,
    TwoCameraInput,
    list_cameras,
    open_capture,
    split,
)
from tracker.vision.rig import ideal_rig

RIG = ideal_rig(64, 48)
BLACK = np.zeros((48, 64, 3), np.uint8)


def image(n: int) -> Image:
    return np.random.default_rng(n).integers(30, 255, (48, 64, 3)).astype(np.uint8)


class Scripted:
    """Returns the pairs of a list, None for a failed read; opens only while ``plugged``."""

    name, live, fps = "bench", True, 0.0

    def __init__(self, pairs: list[Pair | None]) -> None:
        self.pairs, self.plugged, self.opened = pairs, True, 0

    def open(self) -> None:
        if not self.plugged:
            raise DeviceError("The camera bench cannot be opened.")
        self.opened += 1

    def read(self) -> Pair | None:
        return self.pairs.pop(0) if self.pairs else None

    def close(self) -> None: ...


class Bench:
    """A camera on a clock of its own, 0.1 s per image."""

    def __init__(self, pairs: list[Pair | None]) -> None:
        self.t, self.source = 100.0, Scripted(pairs)
        self.camera = StereoCamera(self.source, RIG, clock=lambda: self.t, sleep=self.sleep)
        self.notices: list[Notice | None] = []

    def sleep(self, dt: float) -> None:
        self.t += dt

    def read(self) -> object:
        self.t += 0.1
        frame = self.camera.read(0.05)
        self.notices += [e.notice for e in self.camera.drain_events()]
        return frame


def test_stamps_and_rate() -> None:
    bench = Bench([(image(n), image(n + 50)) for n in range(5)])
    frames = [bench.read() for _ in range(5)]
    assert [f.index for f in frames] == [0, 1, 2, 3, 4]
    assert [f.t_arrival - f.t for f in frames] == pytest.approx([0.035] * 5)
    assert bench.camera.fps == pytest.approx(10.0)
    assert np.array_equal(frames[2].right, image(52))


def test_a_missing_side_is_none_and_reported_once() -> None:
    pairs: list[Pair | None] = [(image(n), BLACK) for n in range(3)]
    bench = Bench([*pairs, (image(9), image(10))])
    frames = [bench.read() for _ in range(4)]
    assert [f.right is None for f in frames] == [True, True, True, False]
    assert all(f.left is not None for f in frames)
    assert bench.notices.count(warning("camera.black", side="right")) == 1
    assert bench.notices[-1] == notice("camera.image_back", side="right")


def test_two_missing_sides_give_no_frame() -> None:
    bench = Bench([(BLACK, BLACK)])
    assert bench.read() is None


def test_frozen_images_are_dropped() -> None:
    bench = Bench([(image(1), image(n)) for n in range(10)])
    frames = [bench.read() for _ in range(10)]
    assert frames[0] is not None
    assert frames[1:] == [None] * 9
    assert bench.camera.repeated == 9
    assert bench.notices.count(warning("camera.frozen", side="left")) == 1


def test_unplugged_and_back() -> None:
    bench = Bench([(image(0), image(1)), None])
    assert bench.read() is not None
    assert bench.read() is None
    bench.source.plugged = False
    for _ in range(30):
        assert bench.read() is None
    bench.source.plugged = True
    bench.source.pairs = [(image(n), image(n + 50)) for n in range(20)]
    start = bench.t
    while bench.read() is None:
        assert bench.t - start < 1.3
    assert bench.source.opened == 2
    refused = plain("The camera bench cannot be opened.", Severity.ERROR)
    connected, silent = (
        notice("camera.connected", camera="bench"),
        warning("camera.silent", camera="bench"),
    )
    assert bench.notices == [connected, silent, refused, connected]


def test_wrong_size_is_rejected() -> None:
    bench = Bench([(image(0)[:40], image(1))])
    assert bench.read() is None
    sizes = {"width": 64, "height": 40, "calibrated_width": 64, "calibrated_height": 48}
    assert bench.notices[-1] == warning("camera.side_size_misfit", side="left", **sizes)


def test_odd_width_has_no_halves() -> None:
    with raises(DeviceError, "images.no_halves"):
        split(np.zeros((10, 63, 3), np.uint8))


def pair_of_colours(left: int, right: int) -> Image:
    image = np.zeros((48, 128, 3), np.uint8)
    image[:, :64], image[:, 64:] = left, right
    return image


def video(path: Path, count: int = 5) -> Path:
    code = cv2.VideoWriter.fourcc(*"MJPG")
    writer = cv2.VideoWriter(str(path), code, 20.0, (128, 48))
    for n in range(count):
        writer.write(pair_of_colours(40 * n + 30, 200))
    writer.release()
    return path


def test_video_file_is_paced_and_ends(tmp_path: Path) -> None:
    t = [0.0]

    def sleep(dt: float) -> None:
        t[0] += dt

    source = StreamInput(str(video(tmp_path / "a.avi")), live=False)
    camera = StereoCamera(source, RIG, clock=lambda: t[0], sleep=sleep)
    frames = []
    while len(frames) < 5 and t[0] < 10:
        frame = camera.read(0.02)
        if frame is not None:
            frames.append(frame)
    assert [f.left.mean() for f in frames] == pytest.approx([30, 70, 110, 150, 190], abs=4)
    assert [f.right.mean() for f in frames] == pytest.approx([200] * 5, abs=4)
    assert np.diff([f.t for f in frames]) == pytest.approx([0.05] * 4, abs=1e-6)
    assert all(camera.read(0.02) is None for _ in range(5))
    assert camera.drain_events()[-1].code == "camera.file_end"


def test_two_captures_remain_independent(tmp_path: Path) -> None:
    a, b = str(video(tmp_path / "a.avi")), str(video(tmp_path / "b.avi", 2))
    source = TwoCameraInput(a, b)
    source.open()
    assert source.read() is not None
    assert source.read() is not None
    assert source.read() is None  # the second one has ended
    source.close()
    with raises(DeviceError, "camera.not_there"):
        TwoCameraInput(a, str(tmp_path / "none.avi")).open()


class Webcam:
    """A free-running camera on a clock that advances only while waiting: its queue has four images,
    and later ones are lost, as with Video4Linux."""

    def __init__(self, clock: list[float], phase: float) -> None:
        self.clock, self.next, self.queue, self.shown = clock, phase, [], -1.0

    def grab(self) -> bool:
        if not self._arrived() and not self.queue:
            self.clock[0] = self.next
            self._arrived()
        self.shown = self.queue.pop(0)
        return True

    def _arrived(self) -> bool:
        while self.next <= self.clock[0] + 1e-9:
            self.queue = (self.queue + [self.next])[:4]
            self.next += 1 / 30
        return bool(self.queue)

    def retrieve(self) -> tuple[bool, Image]:
        return True, np.zeros((2, 2, 3), np.uint8)

    def get(self, _what: int) -> float:
        return 30.0

    def release(self) -> None: ...


@pytest.mark.parametrize("phase", [0.001, 0.007, 0.030])
def test_two_webcams_do_not_lag_behind_one_another_permanently(phase, monkeypatch) -> None:
    """The right one takes a second to start, in which the left one's queue fills."""
    clock, cameras = [0.0], []

    def start(_source: object, _want: object) -> Webcam:
        clock[0] += 1.0
        for camera in cameras:
            camera._arrived()
        cameras.append(Webcam(clock, clock[0] + len(cameras) * phase))
        return cameras[-1]

    monkeypatch.setattr("tracker.sensors.image_input.open_capture", start)
    source = TwoCameraInput(0, 1, clock=lambda: clock[0])
    source.open()
    for _ in range(50):
        assert source.read() is not None
        # an image that was waited for briefly counts as queued
        assert abs(cameras[0].shown - cameras[1].shown) < 1 / 30 + AT_ONCE
        assert clock[0] - cameras[0].shown < 2 / 30


def test_opencv_does_not_open_a_missing_file(tmp_path: Path, monkeypatch) -> None:
    """It would be tried 2.5 times a second, and OpenCV logs a warning each time."""

    def asked() -> None:
        raise AssertionError("OpenCV was asked")

    monkeypatch.setattr("tracker.sensors.image_input.cv2.VideoCapture", asked)
    for source in (str(tmp_path / "none.avi"), "/dev/video97"):
        with raises(DeviceError, "camera.not_there"):
            open_capture(source, CaptureFormat())
    with pytest.raises(AssertionError):
        open_capture("rtsp://127.0.0.1:1/none", CaptureFormat())


def test_image_sequence(tmp_path: Path) -> None:
    paths = [tmp_path / f"{n}.png" for n in range(4)]
    for n, path in enumerate(paths):
        cv2.imwrite(str(path), image(n))
    source = SequenceInput(paths[:2], paths[2:])
    pairs = [source.read(), source.read()]
    assert all(p is not None for p in pairs)
    assert np.array_equal(pairs[1][1], image(3))
    assert source.read() is None
    with raises(DeviceError, "images.unequal_sequences"):
        SequenceInput(paths[:2], paths[:1])
    paths[0].write_text("no image")
    source.open()
    with raises(DeviceError, "images.not_readable"):
        source.read()


class Mjpeg(BaseHTTPRequestHandler):
    """Ten JPEG images as multipart/x-mixed-replace, then the end."""

    def do_GET(self) -> None:
        self.send_response(200)
        self.send_header("Content-Type", "multipart/x-mixed-replace; boundary=frame")
        self.end_headers()
        for n in range(10):
            data = cv2.imencode(".jpg", pair_of_colours(20 * n + 30, 220))[1].tobytes()
            self.wfile.write(b"--frame\r\nContent-Type: image/jpeg\r\n")
            self.wfile.write(f"Content-Length: {len(data)}\r\n\r\n".encode() + data + b"\r\n")

    def log_message(self, format: str, *args: object) -> None: ...


@pytest.fixture
def stream() -> Iterator[str]:
    server = HTTPServer(("127.0.0.1", 0), Mjpeg)
    thread = threading.Thread(target=server.serve_forever, kwargs={"poll_interval": 0.02})
    thread.start()
    yield f"http://127.0.0.1:{server.server_port}/stream.mjpg"
    server.shutdown()
    thread.join()
    server.server_close()


def test_http_stream(stream: str) -> None:
    source = StreamInput(stream, CaptureFormat(timeout_ms=3000))
    source.open()
    pairs = [source.read() for _ in range(8)]
    source.close()
    means = [p[0].mean() for p in pairs if p is not None]
    assert means == pytest.approx([30 + 20 * n for n in range(8)], abs=4)


def test_named_discovery_never_fails() -> None:
    assert all(c.name for c in list_cameras())
