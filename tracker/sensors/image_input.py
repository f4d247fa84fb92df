"""Sources of image pairs, read with OpenCV: devices, files, folders, the network."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Protocol, runtime_checkable

import cv2
import numpy as np
from numpy.typing import NDArray

from tracker.base.clock import monotonic
from tracker.base.errors import DeviceError
from tracker.base.notices import Notice, notice
from tracker.sensors.camera_format import Capture, negotiate, report_of, set_format, shortfall
from tracker.sensors.camera_format import CaptureFormat as CaptureFormat
from tracker.sensors.camera_systems import CameraName as CameraName
from tracker.sensors.camera_systems import exposure_switch, is_device_path
from tracker.sensors.camera_systems import list_cameras as list_cameras

Image = NDArray[np.uint8]
Pair = tuple[Image, Image | None]
"""Left and right; a device with one camera has no right one."""
LEAST_PAIR = 1.9  # width over height
AT_ONCE = 0.01  # s: an image that is available sooner was queued
MOST_QUEUED = 20


class ImageInput(Protocol):
    """Returns BGR images (h, w, 3), left and right or a single one, without pacing."""

    name: str
    live: bool  # whether the source sends images in real time
    fps: float  # as granted by the device or stated in the file; 0 if unknown

    def open(self) -> None:
        """Raises DeviceError if the source cannot be opened."""

    def read(self) -> Pair | None:
        """Returns the next pair; None at the end or after a disconnection."""

    def close(self) -> None: ...


@runtime_checkable
class HasShortfalls(Protocol):
    """An image input that compares what was requested from its devices with what they grant."""

    def shortfalls(self) -> list[Notice]: ...


class StreamInput:
    """One stream of images: a device, a video file, a URL.

    With ``cameras`` 1 it is a single camera, which counts as the left one; with 2 each image
    contains both images side by side, as of a ZED Mini; with 0 the shape decides (`is_pair`).
    """

    def __init__(
        self,
        source: int | str,
        want: CaptureFormat | None = None,
        live: bool = True,
        cameras: int = 0,
    ) -> None:
        self.name, self.live, self._source = str(source), live, source
        self._want, self._cameras = want or CaptureFormat(), cameras
        self._capture: cv2.VideoCapture | None = None
        self.fps = self._want.fps

    def open(self) -> None:
        self._capture = open_capture(self._source, self._want)
        self.fps = _rate(self._capture, self._want.fps, self.live, self._source)

    def read(self) -> Pair | None:
        if self._capture is None:
            return None
        ok, read = self._capture.read()
        if not ok:
            return None
        image = np.asarray(read, np.uint8)
        two = is_pair(image) if self._cameras == 0 else self._cameras == 2
        return split(image) if two else (image, None)

    def stamp(self) -> float:
        """s, the driver's time stamp of the last image; NaN where there is none."""
        if self._capture is None or not self.live:
            return math.nan
        return float(self._capture.get(cv2.CAP_PROP_POS_MSEC)) / 1000

    def captures(self) -> list[cv2.VideoCapture]:
        """The open device, to access its controls."""
        return [] if self._capture is None else [self._capture]

    def shortfalls(self) -> list[Notice]:
        """The shortfall of the open device's grant against the request."""
        return _shortfalls(self.captures(), [self._want], [self._source])

    def close(self) -> None:
        if self._capture is not None:
            self._capture.release()
            self._capture = None


class TwoCameraInput:
    """Two separate cameras, or two streams. Both are grabbed before either is decoded, to be close
    in time."""

    def __init__(
        self,
        left: int | str,
        right: int | str,
        want: CaptureFormat | None = None,
        right_want: CaptureFormat | None = None,
        clock: Callable[[], float] = monotonic,
    ) -> None:
        """``right_want``: if the right camera's images differ in format from the left one's."""
        self.name = f"{left} and {right}"
        self.live = not all(isinstance(s, str) and Path(s).is_file() for s in (left, right))
        left_want = want or CaptureFormat()
        self._sources, self._wants = (left, right), (left_want, right_want or left_want)
        self._captures: list[cv2.VideoCapture] = []
        self._clock = clock
        self.fps = left_want.fps

    def open(self) -> None:
        try:
            for source, want in zip(self._sources, self._wants, strict=True):
                self._captures.append(open_capture(source, want))
        except DeviceError:
            self.close()
            raise
        granted = [
            _rate(capture, want.fps, self.live, source)
            for capture, want, source in zip(
                self._captures, self._wants, self._sources, strict=True
            )
        ]
        self.fps = min(granted)  # a pair is complete when the slower camera has delivered its image
        if self.live:
            # images of one camera, taken while the other started, would remain queued
            for k in (0, 1, 0):
                _drain(self._captures[k], self._clock)

    def read(self) -> Pair | None:
        if len(self._captures) != 2 or not all(c.grab() for c in self._captures):
            return None
        (ok_left, left), (ok_right, right) = (c.retrieve() for c in self._captures)
        return (left, right) if ok_left and ok_right else None

    def captures(self) -> list[cv2.VideoCapture]:
        """The open devices, for their controls."""
        return list(self._captures)

    def shortfalls(self) -> list[Notice]:
        """The shortfall of the open devices' grants against the request."""
        return _shortfalls(self._captures, self._wants, self._sources)

    def close(self) -> None:
        for capture in self._captures:
            capture.release()
        self._captures.clear()


def _shortfalls(
    captures: Sequence[Capture], wants: Sequence[CaptureFormat], sources: Sequence[int | str]
) -> list[Notice]:
    """Only for devices; files and addresses have nothing to grant."""
    found = [
        shortfall(want, report_of(capture))
        for capture, want, source in zip(captures, wants, sources, strict=False)
        if not isinstance(source, str) or is_device_path(source)
    ]
    return list(dict.fromkeys(what for what in found if what is not None))


class SequenceInput:
    """Numbered image files, one for each side and exposure; ``right`` is None of one camera."""

    live = False

    def __init__(
        self, left: Sequence[Path], right: Sequence[Path] | None, fps: float = 30.0
    ) -> None:
        if not left or (right is not None and len(left) != len(right)):
            raise DeviceError(
                notice("images.unequal_sequences", left=len(left), right=len(right or ()))
            )
        self.name, self.fps = str(left[0].parent), fps
        others: Sequence[Path | None] = [None] * len(left) if right is None else right
        self._pairs, self._next = list(zip(left, others, strict=True)), 0

    def open(self) -> None:
        self._next = 0

    def read(self) -> Pair | None:
        if self._next >= len(self._pairs):
            return None
        left, right = self._pairs[self._next]
        self._next += 1
        return _image(left), None if right is None else _image(right)

    def close(self) -> None:
        self._next = len(self._pairs)


def _drain(capture: cv2.VideoCapture, clock: Callable[[], float]) -> None:
    """Discards images that are queued in a camera, until the next one is not yet available."""
    for _ in range(MOST_QUEUED):
        requested = clock()
        if not capture.grab() or clock() - requested > AT_ONCE:
            return


def is_pair(image: Image) -> bool:
    """Whether an image (h, w, 3) is wide enough for two beside each other: single ones have at most
    16:9, two squares 2:1."""
    return image.shape[1] > LEAST_PAIR * image.shape[0]


def split(image: Image) -> tuple[Image, Image]:
    """The halves of a side-by-side image (h, 2w, 3). Raises DeviceError for an odd width."""
    width = image.shape[1]
    if width % 2:
        raise DeviceError(notice("images.no_halves", width_px=width))
    half = width // 2
    return np.ascontiguousarray(image[:, :half]), np.ascontiguousarray(image[:, half:])


def open_capture(source: int | str, want: CaptureFormat) -> cv2.VideoCapture:
    """Returns an open, configured capture. Raises DeviceError if the source cannot be opened."""
    timeouts = [
        cv2.CAP_PROP_OPEN_TIMEOUT_MSEC,
        want.timeout_ms,
        cv2.CAP_PROP_READ_TIMEOUT_MSEC,
        want.timeout_ms,
    ]
    if isinstance(source, str) and _is_missing(source):
        raise DeviceError(notice("camera.not_there", camera=source))
    capture = cv2.VideoCapture()
    # Only FFMPEG knows the timeouts, and another backend refuses to open with them.
    is_device = not isinstance(source, str) or is_device_path(source)
    if isinstance(source, str) and not is_device:
        capture.open(source, want.backend or cv2.CAP_FFMPEG, timeouts)
    else:
        capture.open(source, want.backend)
    if not capture.isOpened():
        raise DeviceError(notice("camera.not_opened", camera=source))
    _apply(capture, want, is_device)
    return capture


def _is_missing(source: str) -> bool:
    """Checks that a file or device exists; addresses and numbered images are left to OpenCV.

    Opening is retried continually, and each time OpenCV would write a warning to the terminal.
    """
    return not any(sign in source for sign in ("://", "%", "!")) and not Path(source).exists()


def _rate(capture: cv2.VideoCapture, wanted: float, live: bool, source: int | str) -> float:
    """Expected images per second; 0 if unknown.

    A webcam may grant 30 instead of a requested 60, and then loses none of them. For a live
    stream, FFMPEG's figure is a guess; for a film it is the film's own.
    """
    granted = float(capture.get(cv2.CAP_PROP_FPS))
    if live and isinstance(source, str) and not is_device_path(source):
        return 0.0
    return granted if granted > 0 or not live else wanted


def _apply(capture: Capture, want: CaptureFormat, is_device: bool) -> None:
    """Sets the format, then the locks. A file or an address has no formats to choose from."""
    if is_device:
        negotiate(capture, want)
    else:
        set_format(capture, want)
    put = capture.set
    by_hand, _ = exposure_switch()
    locks = (
        (cv2.CAP_PROP_AUTO_EXPOSURE, by_hand, cv2.CAP_PROP_EXPOSURE, want.exposure),
        (None, 0.0, cv2.CAP_PROP_GAIN, want.gain),
        (cv2.CAP_PROP_AUTO_WB, 0.0, cv2.CAP_PROP_WB_TEMPERATURE, want.white_balance),
    )
    for automatic, manual, prop, locked in locks:
        if locked is None:
            continue
        if automatic is not None:
            put(automatic, manual)
        put(prop, locked)


def _image(path: Path) -> Image:
    image = cv2.imread(str(path), cv2.IMREAD_COLOR)
    if image is None:
        raise DeviceError(notice("images.not_readable", path=path))
    return np.asarray(image, np.uint8)
