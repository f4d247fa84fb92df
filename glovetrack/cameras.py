"""The parts of a camera driver: a plug-in under ``glovetrack.cameras``.

A `CameraDriver` lists cameras and opens one as an `ImageInput`, which returns one `Pair` of images
at a time; see ``docs/camera-plugins.md``. Errors of a device are `DeviceError`.
"""

from tracker.base.errors import DeviceError
from tracker.sensors.camera_plugins import CameraDriver
from tracker.sensors.image_input import CaptureFormat, ImageInput, Pair

__all__ = ["CameraDriver", "CaptureFormat", "DeviceError", "ImageInput", "Pair"]
