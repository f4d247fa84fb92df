"""A simulated rig's devices: images readable by OpenCV, gloves that are plugged and unplugged."""

import re
import threading
from collections.abc import Iterator
from pathlib import Path

import cv2
import numpy as np
import pytest

from tests.notices import raises
from tracker.base.errors import FileError
from tracker.calibration.stereo.board import BoardSpec
from tracker.calibration.stereo.views import BoardFinder
from tracker.cli import main
from tracker.glove import library
from tracker.offline.simulate import GLOVES
from tracker.sensors.discovery import find_gloves
from tracker.sensors.image_input import CaptureFormat, Image, StreamInput, TwoCameraInput
from tracker.simulation import rig_device
from tracker.simulation.camera_device import NoSimulatedCamera
from tracker.simulation.demo import DemoSpec, HandTexts
from tracker.simulation.glove_process import GLOVE_IDS
from tracker.simulation.rig_device import (
    HeldBoard,
    ImagePipe,
    RigCamera,
    SimulatedRig,
    smaller_right,
)
from tracker.vision.rig import ideal_rig

WIDTH, HEIGHT = 320, 240
LEFT, RIGHT = 60, 180  # grey of the two images


def pair() -> tuple[Image, Image]:
    left, right = (np.full((HEIGHT, WIDTH, 3), grey, np.uint8) for grey in (LEFT, RIGHT))
    return left, right


def beside() -> Image:
    return np.hstack(pair())


def test_images_are_lost_without_a_reader_and_else_side_by_side(tmp_path: Path) -> None:
    pipe = ImagePipe(tmp_path / "camera.mjpeg")
    assert not pipe.put(beside())
    done = threading.Event()

    def send() -> None:
        while not done.wait(0.005):
            pipe.put(beside())

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


def test_a_pipe_that_cannot_be_created_is_reported(tmp_path: Path) -> None:
    with raises(FileError, "file.not_created"):
        ImagePipe(tmp_path / "nowhere" / "camera.mjpeg")


@pytest.fixture
def both(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[SimulatedRig]:
    """Two gloves; the camera's images are tested elsewhere."""
    monkeypatch.setattr(rig_device, "SimulatedCamera", lambda spec: NoSimulatedCamera())
    worn = (HandTexts(*library.texts(GLOVES[side])) for side in ("right", "left"))
    main, *others = worn
    devices = SimulatedRig(DemoSpec(*main, duration=5.0, others=tuple(others)), tmp_path)
    yield devices
    devices.close()
    assert not list(tmp_path.iterdir())


def test_both_gloves_are_serial_lines_with_their_numbers(both: SimulatedRig) -> None:
    assert set(both.files.gloves) == {"left", "right"}
    reports = find_gloves([str(path) for path in both.files.gloves.values()], timeout=10.0)
    numbers = {report.path: report.hello.glove_id for report in reports if report.hello}
    assert numbers == {str(both.files.gloves[side]): n for side, n in GLOVE_IDS.items()}


def test_the_rig_reports_its_devices_and_the_hand_lengths(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(rig_device, "SimulatedCamera", lambda spec: NoSimulatedCamera())
    monkeypatch.setattr("sys.stdin", None)
    assert main(["rig", str(tmp_path), "--hands", "both", "--duration", "0.2"]) == 0
    output = capsys.readouterr().out
    for side in GLOVE_IDS:
        assert str(tmp_path / f"glove_{side}") in output
        (length_mm,) = re.findall(rf"{side} hand +(\d+) mm", output)
        nominal_mm = 1000 * library.load(GLOVES[side])[0].length
        assert abs(int(length_mm) / nominal_mm - 1) < 0.12  # people: 5 %, at most 10


def test_a_glove_is_unplugged_and_plugged_by_commands(both: SimulatedRig) -> None:
    left, right = (both.files.gloves[side] for side in ("left", "right"))
    assert both.execute("unplug left\n") == "The left glove is unplugged."
    assert both.execute("unplug left") == "The left glove is unplugged already."
    assert not left.is_symlink() and right.exists()
    assert both.execute("plug left") == "The left glove is plugged."
    (report,) = find_gloves([str(left)], timeout=10.0)
    assert report.hello is not None and report.hello.glove_id == GLOVE_IDS["left"]
    assert both.execute("plug right") == "The right glove is plugged already."
    for nonsense in ("", "plug", "pull left", "plug middle", "board left"):
        assert both.execute(nonsense) == "Say plug or unplug, and left or right; or board, or hand."


def test_electrical_faults_are_started_by_commands(both: SimulatedRig) -> None:
    assert both.execute("fault left port busy") == "The left glove has the fault: port busy."
    (left,) = find_gloves([str(both.files.gloves["left"])])
    assert left.problem is not None and left.problem.code == "port.not_opened"
    assert both.execute("fault left\n") == "The left glove has the fault: none."
    (left,) = find_gloves([str(both.files.gloves["left"])])
    assert left.hello is not None
    assert both.execute("fault left on fire").startswith(
        "Say fault, left or right, and one of: brown"
    )


@pytest.mark.long
def test_a_board_is_shown_and_removed_by_commands(both: SimulatedRig) -> None:
    assert both.execute("board\n") == "The board is before the camera."
    assert both.execute("hand") == "The hand is before the camera."


@pytest.mark.long
def test_a_held_board_is_still_and_then_moves() -> None:
    board, spec = HeldBoard(ideal_rig(), seed=2), BoardSpec()
    first, again, later = (board.pair(t, k) for k, t in enumerate((0.0, 0.3, 1.0)))
    assert (first[0] != again[0]).any()  # a camera's noise: images are never identical
    finder = BoardFinder(spec)
    still = finder.look(*first).view, finder.look(*again).view
    assert still[0] is not None and still[1] is not None
    same = np.intersect1d(still[0].ids, still[1].ids)
    off = [v.left[np.isin(v.ids, same)] for v in still if v is not None]
    assert len(same) > 20 and np.abs(off[0] - off[1]).max() < 0.7  # px, at 2 grey levels of noise
    assert np.abs(first[0].astype(float) - later[0]).mean() > 10


@pytest.mark.long
def test_the_smaller_right_camera_matches_its_images(tmp_path: Path) -> None:
    """Corners found in its images are where its calibration projects those of the whole image."""
    rig = ideal_rig()
    small, finder = smaller_right(rig), BoardFinder(BoardSpec())
    left, right = HeldBoard(rig, seed=2).pair(0.0, 0)
    camera = RigCamera(tmp_path, apart=True)
    assert right is not None
    source = TwoCameraInput(*(str(path) for path in camera.paths), CaptureFormat(timeout_ms=30_000))
    done = threading.Event()

    def send() -> None:
        while not done.wait(0.02):
            camera.put((left, right))

    sender = threading.Thread(target=send)
    sender.start()
    try:
        source.open()
        read = source.read()
    finally:
        source.close()
        done.set()
        sender.join()
        camera.close()
    assert read is not None and read[1] is not None and read[0].shape == left.shape
    assert read[1].shape[:2] == (small.right.height, small.right.width) == (540, 960)
    whole, sent = (finder.look(image).view for image in (right, read[1]))
    assert whole is not None and sent is not None
    same = np.intersect1d(whole.ids, sent.ids)
    rays = [
        cv2.undistortPoints(view.left[np.isin(view.ids, same)], camera.K, camera.D)
        for view, camera in ((whole, rig.right), (sent, small.right))
    ]
    assert len(same) > 20
    # an error of half a pixel in the pixel origin would be 0.12 px of 480; noise is 0.3
    assert abs((rays[0] - rays[1]).mean(axis=(0, 1)) * 480).max() < 0.05


def test_two_webcams_with_different_image_sizes_are_one_input(tmp_path: Path) -> None:
    """Each has its own timing."""
    pipes = [ImagePipe(tmp_path / f"{name}.mjpeg") for name in ("left", "right")]
    sizes = (HEIGHT, WIDTH), (2 * HEIGHT, 2 * WIDTH)
    done = threading.Event()

    def send(pipe: ImagePipe, size: tuple[int, int], period: float) -> None:
        image = np.full((*size, 3), LEFT, np.uint8)
        while not done.wait(period):
            pipe.put(image)

    senders = [
        threading.Thread(target=send, args=args)
        for args in zip(pipes, sizes, (0.004, 0.007), strict=True)
    ]
    for sender in senders:
        sender.start()
    source = TwoCameraInput(*(str(p.path) for p in pipes), CaptureFormat(timeout_ms=30_000))
    try:
        source.open()
        read = [source.read() for _ in range(3)]
    finally:
        source.close()
        done.set()
        for sender in senders:
            sender.join()
        for pipe in pipes:
            pipe.close()
    for pair in read:
        assert pair is not None and pair[1] is not None
        assert (pair[0].shape[:2], pair[1].shape[:2]) == sizes
