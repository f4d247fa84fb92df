"""The pipe of images that a simulated rig offers, read by OpenCV as any camera's stream."""

import threading
from pathlib import Path

import numpy as np
import pytest

from tracker.errors import FileError
from tracker.messages import StereoFrame
from tracker.sensors.image_input import CaptureFormat, StreamInput
from tracker.simulation.rig_device import ImagePipe

WIDTH, HEIGHT = 320, 240
LEFT, RIGHT = 60, 180  # grey of the two images


def pair() -> StereoFrame:
    left, right = (np.full((HEIGHT, WIDTH, 3), grey, np.uint8) for grey in (LEFT, RIGHT))
    return StereoFrame(0.0, 0.0, left, right, 0)


def test_images_without_a_reader_are_lost_and_with_one_come_in_two_halves(tmp_path: Path) -> None:
    pipe = ImagePipe(tmp_path / "camera.mjpeg")
    assert not pipe.put(pair())
    done = threading.Event()

    def send() -> None:
        while not done.wait(0.005):
            pipe.put(pair())

    sender = threading.Thread(target=send)
    sender.start()
    try:
        source = StreamInput(str(pipe.path), CaptureFormat(2 * WIDTH, HEIGHT, timeout_ms=30_000))
        source.open()
        read = source.read()
        source.close()
    finally:
        done.set()
        sender.join()
        pipe.close()
    assert read is not None
    left, right = read
    assert right is not None and left.shape == right.shape == (HEIGHT, WIDTH, 3)
    assert abs(float(left.mean()) - LEFT) < 2 and abs(float(right.mean()) - RIGHT) < 2  # JPEG
    assert not pipe.path.exists()


def test_a_pipe_that_cannot_be_made_is_said(tmp_path: Path) -> None:
    with pytest.raises(FileError, match="cannot be made"):
        ImagePipe(tmp_path / "nowhere" / "camera.mjpeg")
